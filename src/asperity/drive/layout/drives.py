"""Common roller drives, each from the radii of its rollers."""

from __future__ import annotations

import math

import numpy as np

from asperity.drive.layout.drive import CARRIER, Body, Closure, Contact, Drive
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.engine.arrays import xp
from asperity.types import Real

#: What the paper assumes of its drive: both contacts of a planet with its loading rollers have one coefficient (A3).
EQUAL_COEFFICIENTS = (("pwr", "pwl"),)
#: The body whose pin force a soft preload spring between two carriers keeps.
SPRING_LOADED_PINS = ("right_loading_roller",)


def wedge_drive(geometry: DriveGeometry, *, planet_count: Real, closure: Closure | None = None) -> Drive:
    """The planetary drive of Zou et al. 2025: two loading rollers in the wedges between each planet and the ring.

    Parameters
    ----------
    geometry : DriveGeometry
        Radii and push angles.
    planet_count : Real
        Number of planets.
    closure : Closure or None, optional
        The paper's assumptions, :data:`EQUAL_COEFFICIENTS` and :data:`SPRING_LOADED_PINS`; None for neither.

    Returns
    -------
    Drive
        Contacts ``sp, pwr, pwl, wro, wlo``; sun in, carrier out, ring grounded.

    References
    ----------
    Equation (A1) of :doc:`/equations`.
    """
    sides = triangle(geometry)
    x, y = sides.roller_orbit * sides.sin_polar, sides.roller_orbit * sides.cos_polar
    zero = xp.zeros_like(x)
    sun, planet, roller, ring = (
        xp.asarray(radius)
        for radius in (
            geometry.sun_radius,
            geometry.planet_radius,
            geometry.loading_roller_radius,
            geometry.ring_radius,
        )
    )
    return Drive(
        bodies=(
            Body("sun", "axis"),
            Body("planet", "free"),
            Body("right_loading_roller", "pin"),
            Body("left_loading_roller", "pin"),
            Body("ring", "axis"),
        ),
        contacts=(
            Contact("sp", "sun", "planet"),
            Contact("pwr", "planet", "right_loading_roller"),
            Contact("pwl", "planet", "left_loading_roller"),
            Contact("wro", "right_loading_roller", "ring", internal=True),
            Contact("wlo", "left_loading_roller", "ring", internal=True),
        ),
        centres=xp.stack(
            [
                xp.stack([zero, zero]),
                xp.stack([zero, zero + sides.planet_orbit]),
                xp.stack([x, y]),
                xp.stack([-x, y]),
                xp.stack([zero, zero]),
            ]
        ),
        first_radius=xp.stack([sun, planet, planet, roller, roller]),
        second_radius=xp.stack([planet, roller, roller, ring, ring]),
        # the right pin pushes counter-clockwise, so that outward is the other way round from the clockwise tangent
        push_angles=xp.stack([-xp.asarray(geometry.right_push_angle), xp.asarray(geometry.left_push_angle)]),
        sectors=planet_count,
        input="sun",
        output=CARRIER,
        grounded="ring",
        sense=-1,  # as the paper has it; so that a positive torque loads the right roller
        closure=Closure() if closure is None else closure,
    )


def planetary_drive(*, sun_radius: Real, planet_radius: Real, planet_count: Real) -> Drive:
    """The simple planetary drive: planets between a sun and a ring that presses them together.

    Parameters
    ----------
    sun_radius, planet_radius : Real
        Radii [m]; the ring's is the sun's and twice the planets'.
    planet_count : Real
        Number of planets.

    Returns
    -------
    Drive
        Contacts ``sp, pr``; sun in, carrier out, ring grounded; ratio 1 + R_r/R_s.

    References
    ----------
    Willis' equation with a fixed ring.
    """
    sun, planet = xp.asarray(sun_radius, dtype=float), xp.asarray(planet_radius, dtype=float)
    origin = xp.zeros(2)
    return Drive(
        bodies=(Body("sun", "axis"), Body("planet", "pin"), Body("ring", "axis")),
        contacts=(Contact("sp", "sun", "planet"), Contact("pr", "planet", "ring", internal=True)),
        centres=xp.stack([origin, xp.stack([0.0 * sun, sun + planet]), origin]),
        first_radius=xp.stack([sun, planet]),
        second_radius=xp.stack([planet, sun + 2.0 * planet]),
        push_angles=xp.zeros(1),
        sectors=planet_count,
        input="sun",
        output=CARRIER,
        grounded="ring",
    )


def two_row_multiroller(
    *,
    sun_radius: Real,
    first_row_radii: tuple[Real, Real],
    second_row_radii: tuple[Real, Real],
    roller_count: Real,
) -> Drive:
    """The multiroller drive with two rows of stepped rollers between sun and ring.

    Parameters
    ----------
    sun_radius : Real
        Radius s [m].
    first_row_radii, second_row_radii : tuple of Real
        Large and small radius x and y of each row's rollers [m]: the sun drives x of the first row, whose y drives x
        of the second, whose y drives the ring.
    roller_count : Real
        Rollers in each row; each second-row roller lies between two of the first row.

    Returns
    -------
    Drive
        Contacts ``sf, fsl, fsr, sr``; sun in, ring out, the carrier of the second row grounded; ratio
        :math:`(x_1/s)(x_2/y_1)(R/y_2)`.

    References
    ----------
    A. L. Nasvytis's multiroller drive as described in NASA's reports on it; the ratio follows from rolling without
    slip.
    """
    sun = xp.asarray(sun_radius, dtype=float)
    (x_1, y_1), (x_2, y_2) = (
        tuple(xp.asarray(radius, dtype=float) for radius in row)
        for row in (first_row_radii, second_row_radii)
    )
    orbit = sun + x_1
    half = xp.asarray(math.pi / roller_count)
    with np.errstate(invalid="ignore"):  # nan where the second row finds no place
        far = orbit * xp.cos(half) + xp.sqrt((y_1 + x_2) ** 2 - (orbit * xp.sin(half)) ** 2)
    origin = xp.zeros(2)
    second_centre = far * xp.stack([-xp.sin(half), xp.cos(half)])
    return Drive(
        bodies=(
            Body("sun", "axis"),
            Body("first_row", "free"),
            Body("second_row", "pin"),
            Body("ring", "axis"),
        ),
        contacts=(
            Contact("sf", "sun", "first_row", tracks=("", "large")),
            Contact("fsl", "first_row", "second_row", tracks=("small", "large")),
            Contact("fsr", "first_row", "second_row", sector=-1, tracks=("small", "large")),
            Contact("sr", "second_row", "ring", internal=True, tracks=("small", "")),
        ),
        centres=xp.stack([origin, xp.stack([0.0 * orbit, orbit]), second_centre, origin]),
        first_radius=xp.stack([sun, y_1, y_1, y_2]),
        second_radius=xp.stack([x_1, x_2, x_2, far + y_2]),
        push_angles=xp.zeros(1),
        sectors=roller_count,
        input="sun",
        output="ring",
        grounded=CARRIER,
    )


def stepped_planet_drive(*, sun_radius: Real, planet_radii: tuple[Real, Real], planet_count: Real) -> Drive:
    """A drive of high ratio: stepped planets roll in a fixed ring and in a driven ring of slightly different radii.

    Parameters
    ----------
    sun_radius : Real
        Radius s [m].
    planet_radii : tuple of Real
        Radii p_1 of the track in the fixed ring, which also touches the sun, and p_2 of that in the driven one [m].
    planet_count : Real
        Number of planets.

    Returns
    -------
    Drive
        Contacts ``sp, pr1, pr2``; sun in, second ring out, first ring grounded, the carrier a free cage; ratio
        :math:`(1 + R_1/s)/(1 - R_1 p_2/(R_2 p_1))`.

    References
    ----------
    Willis' equation applied to both rings.
    """
    sun = xp.asarray(sun_radius, dtype=float)
    one, two = (xp.asarray(radius, dtype=float) for radius in planet_radii)
    origin = xp.zeros(2)
    return Drive(
        bodies=(
            Body("sun", "axis"),
            Body("planet", "pin"),
            Body("held_ring", "axis"),
            Body("driven_ring", "axis"),
        ),
        contacts=(
            Contact("sp", "sun", "planet", tracks=("", "first")),
            Contact("pr1", "planet", "held_ring", internal=True, tracks=("first", "")),
            Contact("pr2", "planet", "driven_ring", internal=True, tracks=("second", "")),
        ),
        centres=xp.stack([origin, xp.stack([0.0 * sun, sun + one]), origin, origin]),
        first_radius=xp.stack([sun, one, two]),
        second_radius=xp.stack([one, sun + 2.0 * one, sun + one + two]),
        push_angles=xp.zeros(1),
        sectors=planet_count,
        input="sun",
        output="driven_ring",
        grounded="held_ring",
    )
