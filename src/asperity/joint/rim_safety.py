"""Strength of the ring and of hollow rollers: stresses along their rims at rest and under the torque."""

from __future__ import annotations

import functools
import operator

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.coupling import BodyInMachine
from asperity.body.rim_range import RimLoads, RimRange, fatigue_safety, rim_range, rim_stresses
from asperity.body.shapes import Annulus
from asperity.drive.geometry import triangle
from asperity.drive.mechanism import rest_state
from asperity.joint.contacts import joint_contacts
from asperity.joint.description import Joint, with_one_rank
from asperity.joint.elastic_bodies import machine_bodies
from asperity.joint.evaluation import JointResult
from asperity.joint.working_loads import working_forces
from asperity.materials import Material

#: Rims of a ring or of a hollow roller, in the order of every rim axis.
RIM_NAMES = ("inner", "outer")


class BodyRims(eqx.Module):
    """Stresses and safeties of one body. SI units; nan for a solid one.

    Parameters
    ----------
    stress, stress_at_rest : Array
        Largest hoop stress of each rim under the torque and at rest, tension positive, shape (2, ...) [Pa].
    mean, amplitude : Array
        Of the hoop stress that every point of a rim goes through under the torque, shape (2, ...) [Pa].
    yield_safety : Array
        Yield strength over the largest equivalent stress of both rims, at rest and under the torque, shape (...) [-].
    fatigue_safety : Array
        Safety of the worse rim against fatigue under the torque, shape (...) [-]; nan where the material has no
        fatigue strength.
    """

    stress: Array
    stress_at_rest: Array
    mean: Array
    amplitude: Array
    yield_safety: Array
    fatigue_safety: Array


class JointRims(eqx.Module):
    """Strength of the bodies of a joint that have two rims.

    Parameters
    ----------
    ring, planet, loading_roller : BodyRims
        One each; of the loading rollers the worse one.
    """

    ring: BodyRims
    planet: BodyRims
    loading_roller: BodyRims


#: Signs of the tangential forces on planet, right and left roller and ring, counter-clockwise, contact by contact.
_TURNS = ((1.0, -1.0, -1.0), (-1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0))


def joint_rims(joint: Joint, result: JointResult) -> JointRims:
    """Strength of ring and hollow rollers of a joint; pure.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        Its result.

    Returns
    -------
    JointRims
        Away from the contacts, whose own stresses are judged by yield, shakedown and rolling fatigue.

    Notes
    -----
    Exact plane elasticity with the file's ring support. The stress of a fit in the housing, of the pins' pressure on
    the bores and of rotation is not included.

    References
    ----------
    Equation (L3) of :doc:`/equations`.
    """
    joint = with_one_rank(joint)
    sides = triangle(joint.geometry)
    normal, tangential = working_forces(joint, result)
    rest = rest_state(geometry=joint.geometry, sides=sides, preload=joint.preload).normal_force
    shape = normal.shape
    states = ((normal, tangential), (jnp.broadcast_to(rest, shape), jnp.zeros(shape)))
    width = jnp.broadcast_to(jnp.asarray(result.diagnostics.hertz_half_width), shape)
    _, planet, right, left, ring = machine_bodies(joint, sides)
    bodies = joint.bodies
    rollers = [
        body_rims(member, bodies.loading_roller, states, width, turns)
        for member, turns in ((right, _TURNS[1]), (left, _TURNS[2]))
    ]
    return JointRims(
        ring=body_rims(ring, bodies.ring, states, width, _TURNS[3]),
        planet=body_rims(planet, bodies.planet, states, width, _TURNS[0]),
        loading_roller=worse_rims(*rollers),
    )


def branch_joint_rims(joint: Joint, working: Array, rest: Array) -> JointRims:
    """Strength of ring and hollow rollers of one joint whose branches differ; pure.

    Parameters
    ----------
    joint : Joint
        One joint.
    working, rest : Array
        Normal and tangential forces of the contacts of each branch, under the torque and at rest, shape (2, 5, n) [N].

    Returns
    -------
    JointRims
        As :func:`joint_rims`: of a free ring under all its forces, of a ring in a housing as if all branches were like
        one, and of rollers by themselves, the worst of the branches.

    References
    ----------
    Equations (I4) and (L3) of :doc:`/equations`.
    """
    sides, count = triangle(joint.geometry), working.shape[-1]
    width = jax.vmap(joint_contacts(joint).largest_half_width, in_axes=1, out_axes=1)(working[0])
    _, planet, right, left, ring = machine_bodies(joint, sides)
    bodies = joint.bodies

    def worst(member: BodyInMachine, material: Material, turns: tuple[float, ...]) -> BodyRims:
        each = [
            body_rims(
                member, material, tuple((s[0, :, b], s[1, :, b]) for s in (working, rest)), width[:, b], turns
            )
            for b in range(count)
        ]
        return functools.reduce(worse_rims, each)

    if joint.ring_support == "free":
        at = np.array(ring.contacts)
        turned = 2.0 * np.pi * np.arange(count)[:, None] / count
        angles = jnp.ravel(turned + jnp.asarray(ring.contact_angles))
        alone = BodyInMachine(ring.body, tuple(range(angles.size)), angles, None)
        states = tuple((s[0, at].T.ravel(), s[1, at].T.ravel()) for s in (working, rest))
        of_ring = body_rims(alone, bodies.ring, states, width[at].T.ravel(), _TURNS[3] * count, count)
    else:
        of_ring = worst(ring, bodies.ring, _TURNS[3])
    rollers = [
        worst(member, bodies.loading_roller, turns)
        for member, turns in ((right, _TURNS[1]), (left, _TURNS[2]))
    ]
    return JointRims(
        ring=of_ring,
        planet=worst(planet, bodies.planet, _TURNS[0]),
        loading_roller=worse_rims(*rollers),
    )


def body_rims(
    member: BodyInMachine,
    material: Material,
    states: tuple[tuple[Array, Array], ...],
    width: Array,
    turns: tuple[float, ...],
    sectors: int = 1,
) -> BodyRims:
    """Stresses of one body under the torque and at rest.

    Parameters
    ----------
    member : BodyInMachine
        The body and its contacts.
    material : Material
        What it is made of.
    states : tuple of tuple
        Normal and tangential forces of all contacts, under the torque and at rest, shape (contacts, ...) [N].
    width : Array
        Half-widths of all contacts, shape (contacts, ...) [m].
    turns : tuple of float
        Sign that makes the tangential force of each contact of the body one that acts on it counter-clockwise.
    sectors : int, optional
        Number of sectors that the contacts of a body of one sector belong to, where these differ.

    Returns
    -------
    BodyRims
        nan for a solid body.

    References
    ----------
    Equation (L3) of :doc:`/equations`.
    """
    batch = width.shape[1:]
    if not isinstance(member.body, Annulus):
        nothing = jnp.full(batch, jnp.nan)
        both = jnp.stack([nothing, nothing])
        return BodyRims(both, both, both, both, nothing, nothing)
    at, body = np.array(member.contacts), member.body
    signs = jnp.asarray(turns).reshape((-1,) + (1,) * len(batch))
    outward = 1.0 if body.loaded_rim == "inner" else -1.0

    def found(normal: Array, tangential: Array) -> RimRange:
        loads = RimLoads(
            angles=jnp.broadcast_to(member.contact_angles, (len(at), *batch)),
            radial=outward * normal[at],
            tangential=signs * tangential[at],
            half_widths=width[at],
            sectors=member.sectors,
        )
        return rim_range(body=body, stresses=rim_stresses(body=body, loads=loads, fineness=sectors))

    ranges = jax.vmap(found)(*map(jnp.stack, zip(*states, strict=True)))  # traced and compiled once
    working, resting = (jax.tree.map(operator.itemgetter(i), ranges) for i in range(2))
    strength = material.yield_strength if material.tensile_strength is None else material.tensile_strength
    safety = jnp.full(batch, jnp.nan)
    if material.fatigue_strength is not None:
        each = fatigue_safety(
            mean=working.mean,
            amplitude=working.amplitude,
            fatigue_strength=material.fatigue_strength,
            strength=strength,
        )
        safety = jnp.min(each, axis=0)
    return BodyRims(
        stress=working.largest,
        stress_at_rest=resting.largest,
        mean=working.mean,
        amplitude=working.amplitude,
        yield_safety=material.yield_strength / jnp.maximum(working.mises, resting.mises),
        fatigue_safety=safety,
    )


def worse_rims(right: BodyRims, left: BodyRims) -> BodyRims:
    """The worse of two bodies.

    Parameters
    ----------
    right, left : BodyRims
        Two bodies.

    Returns
    -------
    BodyRims
        The larger stresses and the smaller safeties; the range is that of the larger amplitude.

    References
    ----------
    Comparison.
    """
    takes_right = right.amplitude > left.amplitude
    mean, amplitude = (
        jnp.where(takes_right, getattr(right, name), getattr(left, name)) for name in ("mean", "amplitude")
    )
    largest, smallest = (jax.tree.map(choose, right, left) for choose in (jnp.maximum, jnp.minimum))
    return BodyRims(
        stress=largest.stress,
        stress_at_rest=largest.stress_at_rest,
        mean=mean,
        amplitude=amplitude,
        yield_safety=smallest.yield_safety,
        fatigue_safety=smallest.fatigue_safety,
    )
