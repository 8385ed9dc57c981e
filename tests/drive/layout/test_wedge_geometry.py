"""Geometry from the radii alone: published angles, the triangle built point by point, clearances of real overlaps."""

import math

import numpy as np
import pytest

from asperity.drive.layout.existence import has_room, neighbour_gaps, refuse_impossible
from asperity.drive.layout.wedge_geometry import DriveGeometry, triangle
from asperity.drive.types.wedge import wedge_drive
from asperity.errors import InputError

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
POLAR, DIRECTION, WEDGE = 13.9248, 27.0831, 13.1582  # degrees, of the paper


def drive(**changes):
    return DriveGeometry(**(vars(PAPER) | changes))


def angles(geometry):
    sides = triangle(geometry)
    return [
        np.arctan2(getattr(sides, f"sin_{name}"), getattr(sides, f"cos_{name}"))
        for name in ("polar", "direction", "wedge")
    ]


def test_angles_of_the_paper():
    assert np.degrees(angles(PAPER)) == pytest.approx([POLAR, DIRECTION, WEDGE], abs=6e-5)


def test_triangle_reaches_the_roller_on_both_ways():
    """From the axis over the planet or straight: the roller's centre is the same point, and it touches three bodies."""
    rng = np.random.default_rng(2)
    geometry = drive(
        sun_radius=rng.uniform(3.8e-3, 4.4e-3, 50),
        planet_radius=rng.uniform(13.4e-3, 13.8e-3, 50),
        loading_roller_radius=rng.uniform(5e-3, 5.4e-3, 50),
    )
    polar, direction, wedge = angles(geometry)
    planet = np.stack([np.zeros(50), geometry.sun_radius + geometry.planet_radius])
    reach = geometry.planet_radius + geometry.loading_roller_radius
    roller = planet + reach * np.stack([np.sin(direction), np.cos(direction)])
    straight = (40e-3 - geometry.loading_roller_radius) * np.stack([np.sin(polar), np.cos(polar)])
    np.testing.assert_allclose(roller, straight, rtol=1e-9)
    np.testing.assert_allclose(np.hypot(*roller) + geometry.loading_roller_radius, 40e-3, rtol=1e-12)
    np.testing.assert_allclose(wedge, direction - polar, rtol=1e-12)


def test_open_triangle_is_nan_not_a_number_made_up():
    sides = vars(triangle(drive(ring_radius=60e-3)))
    assert all(math.isnan(float(sides[name])) for name in ("sin_polar", "sin_direction", "sin_wedge"))


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"loading_roller_radius": 41e-3}, "no place for"),
        ({"ring_radius": 42e-3}, "no place for"),
        ({"planet_radius": 18.5e-3}, "planet and ring overlap by 1 mm"),
        ({"planet_count": 8.0}, "neighbours of planet overlap"),
        ({"ring_radius": 40.9e-3}, "overlap"),
        ({"planet_count": 9.0}, "overlap"),
        ({"sun_radius": 16e-3, "planet_radius": 10e-3, "loading_roller_radius": 9e-3}, "pull|overlap|place"),
    ],
)
def test_rollers_that_do_not_fit_are_refused(changes, words):
    """Each case drawn by hand: too large, too small, planets in the ring or in each other, rollers in each other."""
    geometry = drive(**changes)
    made = wedge_drive(geometry, planet_count=geometry.planet_count)
    with pytest.raises(InputError, match=words):
        refuse_impossible(made)


def test_gaps_are_the_distances_between_the_circles():
    """The gaps between neighbours again from coordinates of all circles of a three-planet drive."""
    alpha, pitch = math.radians(POLAR), 2 * math.pi / 3
    made = wedge_drive(PAPER, planet_count=3)
    refuse_impossible(made)
    assert bool(has_room(made))

    def at(radius, angle):
        return radius * np.array([math.sin(angle), math.cos(angle)])

    planet, next_planet = at(17.5e-3, 0.0), at(17.5e-3, pitch)
    right, left, next_left = at(35e-3, alpha), at(35e-3, -alpha), at(35e-3, pitch - alpha)
    rollers = "right_loading_roller", "left_loading_roller"
    expected = {
        ("planet", "planet"): np.hypot(*(planet - next_planet)) - 27e-3,
        rollers: min(np.hypot(*(right - other)) for other in (left, next_left)) - 10e-3,
        ("planet", "ring"): 40e-3 - 17.5e-3 - 13.5e-3,
    }
    found = neighbour_gaps(made)
    for pair, gap in expected.items():
        assert float(found[pair]) == pytest.approx(gap, rel=1e-5), pair
