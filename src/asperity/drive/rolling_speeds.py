"""Speeds of the bodies of a drive that rolls, creep included."""

from __future__ import annotations

from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import DriveGeometry
from asperity.types import Real

#: Bodies of a branch, in the order of every body axis; sun and ring are shared by all branches.
BODY_NAMES = ("sun", "planet", "right_loading_roller", "left_loading_roller", "ring")

#: Places of the driving and the driven body of each contact in :data:`BODY_NAMES`.
DRIVING_BODY, DRIVEN_BODY = (0, 1, 1, 2, 3), (1, 2, 3, 4, 4)


class BodiesOfContacts(NamedTuple):
    """Which bodies the contacts of one branch of a drive join.

    Parameters
    ----------
    names : tuple of str
        Names of the bodies, in the order of every body axis.
    shared : tuple of bool
        Whether a body is one for all branches.
    driving, driven : tuple of int
        Places of the two bodies of each contact in the names.
    sectors : int, optional
        How many branches the contacts are listed of, one branch after the other: those of one kind pass over the same
        track of a shared body.
    """

    names: tuple[str, ...]
    shared: tuple[bool, ...]
    driving: tuple[int, ...]
    driven: tuple[int, ...]
    sectors: int = 1


#: Bodies of the drive of Zou et al. 2025.
WEDGE_DRIVE = BodiesOfContacts(BODY_NAMES, (True, False, False, False, True), DRIVING_BODY, DRIVEN_BODY)


class RollingSpeeds(eqx.Module):
    """Speeds of a rolling drive relative to the carrier. SI units.

    Parameters
    ----------
    driving, driven : Array
        Speeds of the two surfaces of each contact, shape (5, ...) [m/s].
    body : Array
        Angular velocities of the bodies of :data:`BODY_NAMES` relative to the carrier, shape (5, ...) [rad/s];
        positive.
    output : Array
        Angular velocity of the output relative to the ground, reduced by creep [rad/s]; positive.
    """

    driving: Array
    driven: Array
    body: Array
    output: Array

    @property
    def rolling(self) -> Array:
        """Rolling speed of each contact, the mean of both surfaces [m/s]."""
        return 0.5 * (self.driving + self.driven)


def rolling_speeds(*, geometry: DriveGeometry, creepage: Array, sun_speed: Real) -> RollingSpeeds:
    r"""Speeds of all bodies from sun to ring.

    .. math::
        v_{driven} = v_{driving}\,\frac{1-\xi/2}{1+\xi/2}, \qquad
        v_{sun} = R_s(\omega_s + \omega_c), \qquad v_{ring} = R_o\,\omega_c

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    creepage : Array
        Creepages of a rolling state, shape (5, ...) [-].
    sun_speed : Real
        Angular velocity of the sun, not negative [rad/s].

    Returns
    -------
    RollingSpeeds
        Proportional to the sun's speed.

    References
    ----------
    The definition of creepage: difference of the surface speeds over their mean. Equation (A2) of :doc:`/equations`
    without creep.
    """
    slower = (1.0 - 0.5 * creepage) / (1.0 + 0.5 * creepage)
    passed = slower[0] * slower[1] * slower[3]  # ring over sun surface, the same on the left side
    sun = geometry.sun_radius
    # R_o omega_c = passed R_s (omega_s + omega_c)
    carrier = passed * sun * sun_speed / (geometry.ring_radius - passed * sun)
    first = sun * (sun_speed + carrier)
    planet = first * slower[0]
    right, left = planet * slower[1], planet * slower[2]
    ring = right * slower[3]
    driven = jnp.stack(jnp.broadcast_arrays(planet, right, left, ring, left * slower[4]))
    roller = geometry.loading_roller_radius
    return RollingSpeeds(
        driving=jnp.stack(jnp.broadcast_arrays(first, planet, planet, right, left)),
        driven=driven,
        body=jnp.stack(
            jnp.broadcast_arrays(
                first / sun, planet / geometry.planet_radius, right / roller, left / roller, carrier
            )
        ),
        output=carrier,
    )
