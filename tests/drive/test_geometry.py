"""Geometry from the radii alone: published angles, the triangle built point by point, clearances of real overlaps."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.geometry import (
    DriveGeometry,
    angles,
    carrier_speed,
    clearances,
    contact_radii,
    speed_ratio,
    triangle,
)

PAPER = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)


def drive(**changes):
    return DriveGeometry(**(vars(PAPER) | changes))


def test_angles_of_the_paper():
    found = angles(triangle(PAPER))
    degrees = [math.degrees(float(x)) for x in (found.polar, found.direction, found.wedge)]
    assert degrees == pytest.approx([13.9248, 27.0831, 13.1582], abs=6e-5)
    assert math.tan(float(found.wedge) / 2) == pytest.approx(0.1153, abs=6e-5)


def test_triangle_reaches_the_roller_on_both_ways():
    """From the axis over the planet or straight: the roller's centre is the same point, and it touches three bodies."""
    rng = np.random.default_rng(2)
    geometry = drive(
        sun_radius=rng.uniform(3.8e-3, 4.4e-3, 50),
        planet_radius=rng.uniform(13.4e-3, 13.8e-3, 50),
        loading_roller_radius=rng.uniform(5e-3, 5.4e-3, 50),
    )
    found = angles(triangle(geometry))
    planet = np.stack([np.zeros(50), geometry.sun_radius + geometry.planet_radius])
    reach = geometry.planet_radius + geometry.loading_roller_radius
    roller = planet + reach * np.stack([np.sin(found.direction), np.cos(found.direction)])
    straight = (40e-3 - geometry.loading_roller_radius) * np.stack([np.sin(found.polar), np.cos(found.polar)])
    np.testing.assert_allclose(roller, straight, rtol=1e-9)
    np.testing.assert_allclose(np.hypot(*roller) + geometry.loading_roller_radius, 40e-3, rtol=1e-12)
    np.testing.assert_allclose(found.wedge, found.direction - found.polar, rtol=1e-12)
    side = triangle(geometry)
    np.testing.assert_allclose(side.sin_wedge, np.sin(found.wedge), rtol=1e-12)
    np.testing.assert_allclose(side.cos_wedge, np.cos(found.wedge), rtol=1e-12)


def test_open_triangle_is_nan_not_a_number_made_up():
    assert all(math.isnan(float(x)) for x in vars(angles(triangle(drive(ring_radius=60e-3)))).values())


def test_kinematics_of_the_paper():
    assert speed_ratio(PAPER) == pytest.approx(-9.0, rel=1e-15)
    assert carrier_speed(geometry=PAPER, sun_speed=628.3185307179587) == pytest.approx(-69.81317007977318)


def test_speed_ratio_from_rolling_without_slip():
    """In the carrier's frame every rolling contact hands the surface speed on, and the fixed ring turns backwards."""
    carrier = float(carrier_speed(geometry=PAPER, sun_speed=100.0))
    assert (100.0 - carrier) * 4e-3 == pytest.approx(-carrier * 40e-3, rel=1e-14)


def test_contact_radii_name_driver_and_driven():
    driving, driven, sign = contact_radii(PAPER)
    np.testing.assert_allclose(driving, [4e-3, 13.5e-3, 13.5e-3, 5e-3, 5e-3])
    np.testing.assert_allclose(driven, [13.5e-3, 5e-3, 5e-3, 40e-3, 40e-3])
    np.testing.assert_array_equal(sign, [1, 1, 1, -1, -1])
    batch = contact_radii(drive(sun_radius=jnp.linspace(3e-3, 4e-3, 7)))
    assert [part.shape for part in batch] == [(5, 7), (5, 7), (5, 1)]


def test_the_papers_rollers_fit():
    for clearance in clearances(PAPER):
        assert float(clearance.gap) > 0, clearance.name


@pytest.mark.parametrize(
    ("changes", "word"),
    [
        ({"loading_roller_radius": 41e-3}, "the loading roller must be smaller"),
        ({"ring_radius": 42e-3}, "the loading roller must reach"),
        ({"planet_radius": 18.5e-3}, "the planet must not touch the ring"),
        ({"planet_count": 8.0}, "neighbouring planets"),
        ({"ring_radius": 40.9e-3}, "the two loading rollers"),
        ({"planet_count": 9.0}, "loading rollers of neighbouring"),
        ({"planet_count": 13.0}, "a loading roller must not"),
        (
            {"sun_radius": 16e-3, "planet_radius": 10e-3, "loading_roller_radius": 9e-3},
            "the loading rollers must lie outside",
        ),
    ],
)
def test_each_overlap_is_named(changes, word):
    """Each case drawn by hand so that the named condition fails."""
    named = [float(c.gap) for c in clearances(drive(**changes)) if c.condition.startswith(word)]
    assert len(named) == 1
    assert not named[0] > 0


def test_clearances_are_the_distances_between_the_circles():
    """Every gap again from coordinates of all circles of a three-planet drive."""
    found = angles(triangle(PAPER))
    alpha, pitch = float(found.polar), 2 * math.pi / 3

    def at(radius, angle):
        return radius * np.array([math.sin(angle), math.cos(angle)])

    planet, next_planet = at(17.5e-3, 0.0), at(17.5e-3, pitch)
    right, left, next_left = at(35e-3, alpha), at(35e-3, -alpha), at(35e-3, pitch - alpha)
    expected = {
        "neighbouring planets": np.hypot(*(planet - next_planet)) - 27e-3,
        "the two loading rollers": np.hypot(*(right - left)) - 10e-3,
        "loading rollers of neighbouring": np.hypot(*(right - next_left)) - 10e-3,
        "a loading roller must not": np.hypot(*(right - next_planet)) - 18.5e-3,
        "the planet must not touch": 40e-3 - 17.5e-3 - 13.5e-3,
    }
    for word, gap in expected.items():
        (clearance,) = (c for c in clearances(PAPER) if c.condition.startswith(word))
        assert float(clearance.gap) == pytest.approx(gap, rel=1e-9), word
