r"""Loads that the forces of a drive put on its structure: carrier pins, carrier, shafts and the housing of the ring.

With equal branches the forces of the planets on the sun, of the loading rollers on the ring and of the rollers on the
carrier have no resultant: these three carry torques only. The planets float. What remains are the pins.
"""

from __future__ import annotations

import math
from typing import Literal

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import DriveGeometry, Triangle
from asperity.drive.mechanism import Bearings
from asperity.types import Real

#: Carrier pins of one branch, named after their loading rollers; the order of every pin axis.
PIN_NAMES = ("right", "left")

#: Rolling bearings of the drive, in the order of every bearing axis.
BEARING_NAMES = ("right_pin", "left_pin", "sun", "carrier")
#: How the carrier holds a pin.
PinSupport = Literal["both_ends", "one_end"]


class StructureLoads(eqx.Module):
    """Loads of the structure in one state of the drive. SI units.

    Parameters
    ----------
    pin_tangential : Array
        Force of a loading roller on its pin along the carrier's circle, positive in the sense in which a positive
        output torque is driven, right and left, shape (2, ...) [N].
    pin_radial : Array
        The same away from the carrier's axis [N].
    sun_torque : Array
        Torque of the shaft on the sun, friction of the sun's bearings included [N·m].
    carrier_torque : Array
        Torque of all pins on the carrier [N·m]: output torque and friction of the carrier's bearings.
    housing_torque : Array
        Torque of the ring on its housing, or of the loading rollers on the ring [N·m].
    """

    pin_tangential: Array
    pin_radial: Array
    sun_torque: Array
    carrier_torque: Array
    housing_torque: Array

    @property
    def pin_resultant(self) -> Array:
        """Force on a pin, right and left, shape (2, ...) [N]."""
        return magnitude(self.pin_radial, self.pin_tangential)


def magnitude(first: Real, second: Real) -> Array:
    r"""Length of a vector, :math:`\sqrt{x^2 + y^2}`, with finite derivatives at zero.

    Parameters
    ----------
    first, second : Real
        Components [any one unit].

    Returns
    -------
    Array
        Length [the same unit].

    References
    ----------
    Pythagoras, as in :func:`structure_loads`.
    """
    square = jnp.asarray(first**2 + second**2)
    nothing = square == 0.0  # an unknown length stays unknown
    return jnp.where(nothing, 0.0, jnp.sqrt(jnp.where(nothing, 1.0, square)))


def structure_loads(
    *, geometry: DriveGeometry, sides: Triangle, bearings: Bearings, normal: Array, tangential: Array
) -> StructureLoads:
    r"""Loads of the structure from the forces of the contacts, of a drive that stands or turns.

    .. math::
        F_l \cos\gamma_l = N_{pwl} \sin\beta + T_{pwl} \cos\beta + T_{wlo}, \qquad
        F_r \cos\gamma_r = N_{pwr} \sin\beta - T_{pwr} \cos\beta - T_{wro}

    .. math::
        M_c = m (R_o - R_w)(F_l \cos\gamma_l - F_r \cos\gamma_r), \qquad
        M_s = m R_s T_{sp} + 2 T_{Bs}, \qquad M_h = m R_o (T_{wro} + T_{wlo})

    Parameters
    ----------
    geometry : DriveGeometry
        The drive, with m planets.
    sides : Triangle
        Its triangle of centres.
    bearings : Bearings
        Friction of its bearings, with the sign that opposes the rotation.
    normal, tangential : Array
        Forces of the contacts ``sp, pwr, pwl, wro, wlo``, shape (5, ...) [N].

    Returns
    -------
    StructureLoads
        Of one branch's pins and of the whole drive.

    References
    ----------
    Zou et al. 2025, equations (1), (3), (4) and (5); (L1) of :doc:`/equations`.
    """
    sp, pwr, pwl, wro, wlo = tangential
    right = normal[1] * sides.sin_wedge - pwr * sides.cos_wedge - wro  # (4) t: F_cr cos g_r
    left = normal[2] * sides.sin_wedge + pwl * sides.cos_wedge + wlo  # (3) t: F_cl cos g_l
    count = geometry.planet_count
    # the roller pushes its pin against the carrier's force on the roller
    radial = (-right * jnp.tan(geometry.right_push_angle), -left * jnp.tan(geometry.left_push_angle))
    return StructureLoads(
        pin_tangential=jnp.stack(jnp.broadcast_arrays(-right, left)),
        pin_radial=jnp.stack(jnp.broadcast_arrays(*radial)),
        sun_torque=count * geometry.sun_radius * sp + 2.0 * bearings.sun_torque,  # (1)
        carrier_torque=jnp.asarray(count * sides.roller_orbit * (left - right)),  # (5)
        housing_torque=count * geometry.ring_radius * (wro + wlo),
    )


def pin_bending_moment(*, force: Real, free_length: Real, roller_length: Real, support: PinSupport) -> Array:
    r"""Largest bending moment of a carrier pin with the roller in the middle of its free length.

    .. math:: M = \frac{F (2l - b)}{8} \;\text{(held at both ends)}, \qquad M = \frac{F l}{2} \;\text{(at one end)}

    Parameters
    ----------
    force : Real
        Force F of the roller, spread evenly over its length [N].
    free_length : Real
        Length l of the pin between its two supports, or from its support to its end [m].
    roller_length : Real
        Length b of the roller, at most l [m].
    support : {"both_ends", "one_end"}
        How the carrier holds the pin.

    Returns
    -------
    Array
        Bending moment [N·m].

    Notes
    -----
    Ends that may turn: cheeks of the carrier that hold the ends stiffly reduce the moment in the middle.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    if support == "one_end":
        return jnp.asarray(0.5 * force * free_length)
    return jnp.asarray(0.125 * force * (2.0 * free_length - roller_length))


def pin_bending_stress(*, moment: Real, diameter: Real) -> Array:
    r"""Bending stress of a solid round pin, :math:`\sigma = 32 M/(\pi d^3)`.

    Parameters
    ----------
    moment : Real
        Bending moment M [N·m].
    diameter : Real
        Diameter d [m].

    Returns
    -------
    Array
        Stress at its surface [Pa]; nan for a pin without diameter.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    solid = jnp.asarray(diameter) > 0.0
    return jnp.where(solid, 32.0 * moment / (math.pi * jnp.where(solid, diameter, 1.0) ** 3), jnp.nan)
