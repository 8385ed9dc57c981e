"""Conditions for a drive to exist, used both for a single joint and for each point of a study.

The functions accept NumPy or JAX arrays and return the same kind: a single joint is checked after it is solved, which
needs no compilation.
"""

from __future__ import annotations

from types import ModuleType
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from asperity.drive.geometry import DriveGeometry
from asperity.drive.mechanism import Bearings
from asperity.types import Real


def _library_of(*values: Real) -> ModuleType:
    """JAX if any value is a JAX array, traced or not, otherwise NumPy."""
    return jnp if any(isinstance(value, jax.Array) for value in values) else np


class PinLock(NamedTuple):
    """Limits of a loading roller's pin.

    Parameters
    ----------
    too_thick : Any
        Whether the pin is at least as thick as its roller.
    grip : Real
        Pin friction coefficient times pin diameter over roller radius [-].
    push : Real
        Cosine of the steeper push angle [-]; the pin locks if the grip reaches it.
    locks : Any
        Whether it locks.
    """

    too_thick: Any
    grip: Real
    push: Real
    locks: Any




def pin_lock(*, geometry: DriveGeometry, bearings: Bearings) -> PinLock:
    r"""Whether the pins fit into the loading rollers and allow them to turn.

    .. math:: d < 2 R_w, \qquad \mu_b \frac{d}{2 R_w} < \cos\gamma

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    bearings : Bearings
        Friction coefficient and diameter of its pins.

    Returns
    -------
    PinLock
        Both conditions, and the two sides of the second.

    References
    ----------
    Zou et al. 2025, equations (3) and (4), with the pin's friction torque mu_b d F/2 of both bearings inserted: the pin
    force F is the push of the rollers divided by the cosine minus the grip.
    """
    left, right, roller = geometry.left_push_angle, geometry.right_push_angle, geometry.loading_roller_radius
    diameter, friction = bearings.pin_diameter, bearings.pin_friction_coefficient
    library = _library_of(left, right, roller, diameter, friction)
    grip = 0.5 * friction * diameter / roller
    push = library.cos(library.maximum(abs(left), abs(right)))
    return PinLock(too_thick=diameter >= 2.0 * roller, grip=grip, push=push, locks=grip >= push)


def smaller_body(*, geometry: DriveGeometry, ring_wall_thickness: Real) -> Any:
    """Upper limit of the contact half-width: radius or wall of the smaller body at each contact.

    Parameters
    ----------
    geometry : DriveGeometry
        The radii, shape (...) [m].
    ring_wall_thickness : Real
        Wall of the ring, shape (...) [m].

    Returns
    -------
    Any
        Lengths in the order of :data:`asperity.drive.geometry.CONTACT_NAMES`, shape (5, ...) [m].

    References
    ----------
    The bodies whose size enters the logarithms of :mod:`asperity.contact.hertz_line`.
    """
    lengths = (
        geometry.sun_radius,
        geometry.planet_radius,
        geometry.loading_roller_radius,
        ring_wall_thickness,
    )
    library = _library_of(*lengths)
    sun, planet, roller, wall = library.broadcast_arrays(*lengths)
    inner, outer = library.minimum(planet, roller), library.minimum(roller, wall)
    return library.stack([library.minimum(sun, planet), inner, inner, outer, outer])




def some_contact_slips(*, slip_ratio: Real) -> Any:
    """Whether a contact is in gross slip, that is, the torque exceeds the capacity.

    Parameters
    ----------
    slip_ratio : Real
        T/(mu N) of the contacts, shape (5, ...) [-]; see :func:`asperity.drive.capacity.slip_ratio`.

    Returns
    -------
    Any
        Truth values, shape (...); true also where a ratio is nan.
    """
    library = _library_of(slip_ratio)
    return ~library.all(library.asarray(slip_ratio) < 1.0, axis=0)
