"""Geometry and kinematics of the planetary traction drive from its radii alone: (A1), (A2).

The five contacts of one branch, in the order of every array with a contact axis (the first axis): sun–planet ``sp``,
planet–right and planet–left loading roller ``pwr``, ``pwl``, right and left loading roller–outer ring ``wro``, ``wlo``.
"""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Real

#: The contacts of a branch in the order of the contact axis: name, driving and driven body.
CONTACT_BODIES: dict[str, tuple[str, str]] = {
    "sp": ("sun", "planet"),
    "pwr": ("planet", "loading_roller"),
    "pwl": ("planet", "loading_roller"),
    "wro": ("loading_roller", "ring"),
    "wlo": ("loading_roller", "ring"),
}
#: Names of the contacts of a branch, in the order of the contact axis.
CONTACT_NAMES = tuple(CONTACT_BODIES)


class DriveGeometry(Module):
    """Radii and arrangement of a planetary traction drive, SI units.

    Parameters
    ----------
    sun_radius, planet_radius, loading_roller_radius, ring_radius : Real
        Radii R_s, R_p, R_w of the rollers and inner radius R_o of the outer ring [m].
    planet_count : Real
        Number of planets [-], equally spaced.
    left_push_angle, right_push_angle : Real
        Directions gamma_l, gamma_r of the carrier pins' forces on the loading rollers, from the tangent [rad].
    """

    sun_radius: Real
    planet_radius: Real
    loading_roller_radius: Real
    ring_radius: Real
    planet_count: Real
    left_push_angle: Real
    right_push_angle: Real


class Triangle(Module):
    r"""The triangle sun centre – planet centre – loading roller centre, fixed by tangency alone (A1).

    Parameters
    ----------
    planet_orbit, roller_distance, roller_orbit : Real
        Centre distances OP = R_s + R_p, PW = R_p + R_w, OW = R_o − R_w [m].
    cos_polar, sin_polar : Real
        Of alpha, the polar angle of a loading roller from its planet [-].
    cos_direction, sin_direction : Real
        Of theta, the direction planet → loading roller from the radial line [-].
    cos_wedge, sin_wedge : Real
        Of beta = theta − alpha, the wedge angle [-].
    """

    planet_orbit: Real
    roller_distance: Real
    roller_orbit: Real
    cos_polar: Real
    sin_polar: Real
    cos_direction: Real
    sin_direction: Real
    cos_wedge: Real
    sin_wedge: Real


def triangle(geometry: DriveGeometry) -> Triangle:
    r"""Close the triangle of centres.

    .. math::
        \cos\alpha = \frac{OP^2 + OW^2 - PW^2}{2\,OP\,OW}, \quad
        \theta = \operatorname{atan2}(OW \sin\alpha,\; OW\cos\alpha - OP), \quad \beta = \theta - \alpha

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].

    Returns
    -------
    Triangle
        Distances and the sines and cosines of the three angles; nan where the triangle does not close.

    References
    ----------
    Equation (A1) of :doc:`/equations`.
    """
    planet_orbit = geometry.sun_radius + geometry.planet_radius
    roller_distance = geometry.planet_radius + geometry.loading_roller_radius
    roller_orbit = geometry.ring_radius - geometry.loading_roller_radius
    legs = 2.0 * planet_orbit * roller_orbit  # none where the loading roller is as large as the ring
    cos_polar = (planet_orbit**2 + roller_orbit**2 - roller_distance**2) / xp.where(legs == 0.0, xp.nan, legs)
    closes = xp.abs(cos_polar) < 1.0
    sin_polar = xp.sqrt(xp.where(closes, 1.0 - cos_polar**2, xp.nan))
    cos_direction = (roller_orbit * cos_polar - planet_orbit) / roller_distance
    sin_direction = roller_orbit * sin_polar / roller_distance
    return Triangle(
        planet_orbit=planet_orbit,
        roller_distance=roller_distance,
        roller_orbit=roller_orbit,
        cos_polar=cos_polar,
        sin_polar=sin_polar,
        cos_direction=cos_direction,
        sin_direction=sin_direction,
        cos_wedge=cos_direction * cos_polar + sin_direction * sin_polar,
        sin_wedge=sin_direction * cos_polar - cos_direction * sin_polar,
    )


def speed_ratio(geometry: DriveGeometry) -> Real:
    r"""Speed ratio sun over carrier with the ring fixed.

    .. math:: \frac{\omega_s}{\omega_c} = -\frac{R_o - R_s}{R_s}

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].

    Returns
    -------
    Real
        Ratio [-]; negative: the carrier turns opposite to the sun.

    References
    ----------
    Equation (A2) of :doc:`/equations`.
    """
    return -(geometry.ring_radius - geometry.sun_radius) / geometry.sun_radius


def carrier_speed(*, geometry: DriveGeometry, sun_speed: Real) -> Real:
    """Angular velocity of the carrier, equation (A2).

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].
    sun_speed : Real
        Angular velocity of the sun [rad/s].

    Returns
    -------
    Real
        Angular velocity of the carrier [rad/s]; of opposite sign.
    """
    return sun_speed / speed_ratio(geometry)


def contact_radii(geometry: DriveGeometry) -> tuple[Real, Real, Real]:
    """Radii and kind of the five contacts.

    Parameters
    ----------
    geometry : DriveGeometry
        The radii [m].

    Returns
    -------
    driving_radius, driven_radius : Real
        Radii of the driving and the driven body, shape (5, ...) [m].
    sign : Real
        +1 for the external contacts, −1 for those inside the ring, shape (5, 1, ...) [-].

    References
    ----------
    Zou et al. 2025, Table 2 and the two signs of equation (11).
    """
    names = ("sun", "planet", "loading_roller", "ring")
    values = xp.broadcast_arrays(*(getattr(geometry, f"{name}_radius") for name in names))
    radius = dict(zip(names, values, strict=True))
    driving, driven = (xp.stack([radius[body[side]] for body in CONTACT_BODIES.values()]) for side in (0, 1))
    inside = xp.array([body[1] == "ring" for body in CONTACT_BODIES.values()])
    sign = xp.where(inside, -1.0, 1.0).reshape((len(CONTACT_BODIES),) + (1,) * values[0].ndim)
    return driving, driven, sign
