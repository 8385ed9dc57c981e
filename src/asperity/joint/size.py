"""How large and how heavy the rolling parts of a joint are."""

from __future__ import annotations

import functools
import math

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.joint.description import Joint
from asperity.joint.masses import loading_roller_mass, planet_mass, roller_mass
from asperity.types import Real


class JointSize(eqx.Module):
    """Size and mass of sun, planets, loading rollers and ring; carrier, shafts and housing are not counted.

    Parameters
    ----------
    envelope_diameter : Array
        Outer diameter of the ring [m].
    envelope_length : Array
        Length of the longest rolling part [m].
    envelope_volume : Array
        Volume of the cylinder that encloses the rolling parts [m^3].
    mass : Array
        Mass of the rolling parts [kg].
    """

    envelope_diameter: Array
    envelope_length: Array
    envelope_volume: Array
    mass: Array


def joint_size(joint: Joint) -> JointSize:
    r"""Envelope and mass of the rolling parts.

    .. math::
        d = 2 (R_o + h), \quad L = \max(B_{sp}, L_p, L_w, B_{wro}, B_{wlo}), \quad V = \tfrac\pi4 d^2 L

        m = \pi \left[\rho_s R_s^2 B_{sp} + n \rho_p (R_p^2 - d_p^2/4) L_p + 2 n \rho_w (R_w^2 - d_w^2/4) L_w
        + \rho_o \left((R_o + h)^2 - R_o^2\right) \max(B_{wro}, B_{wlo})\right]

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.

    Returns
    -------
    JointSize
        Envelope [m, m^3] and mass [kg], in the broadcast shape.

    Notes
    -----
    The sun is as long as its contact line, the ring as its longer one; planets and loading rollers have the lengths
    of the joint and bores d. Loading rollers number two to a planet.
    """
    geometry, bodies = joint.geometry, joint.bodies
    lengths = joint.contact_lengths if len(joint.contact_lengths) == 5 else joint.contact_lengths * 5
    sun_length, ring_length = lengths[0], jnp.maximum(lengths[3], lengths[4])
    longest: Real = functools.reduce(
        jnp.maximum, (sun_length, joint.planet_length, joint.loading_roller_length, ring_length)
    )
    outer = geometry.ring_radius + joint.ring_wall_thickness
    count = geometry.planet_count
    sun = roller_mass(density=bodies.sun.density, radius=geometry.sun_radius, length=sun_length, bore=0.0)
    ring = roller_mass(
        density=bodies.ring.density, radius=outer, length=ring_length, bore=2.0 * geometry.ring_radius
    )
    diameter = 2.0 * outer
    return JointSize(
        envelope_diameter=jnp.asarray(diameter),
        envelope_length=jnp.asarray(longest),
        envelope_volume=jnp.asarray(0.25 * math.pi * diameter**2 * longest),
        mass=jnp.asarray(sun + count * (planet_mass(joint) + 2.0 * loading_roller_mass(joint)) + ring),
    )
