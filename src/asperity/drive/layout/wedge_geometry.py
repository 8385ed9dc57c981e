"""Geometry of the wedge drive, the paper's, from its radii alone: (A1)."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Real


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
