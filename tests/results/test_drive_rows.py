"""Rows of geometry, size, mass and capacity of the paper's joint, by hand."""

import math

import numpy as np
import pytest

from asperity.results import RESULTS

SUN, PLANET, ROLLER, RING, WALL, LENGTH, STEEL = 4e-3, 13.5e-3, 5e-3, 40e-3, 60e-3, 5e-3, 7850.0


def corner(opposite, one, other):
    """Angle of a triangle by the law of cosines."""
    return math.acos((one**2 + other**2 - opposite**2) / (2.0 * one * other))


def test_angles(value):
    """Triangle of the axis, the planet's and the loading roller's centre: 17.5, 18.5 and 35 mm."""
    sides = (SUN + PLANET, PLANET + ROLLER, RING - ROLLER)
    polar, wedge = corner(sides[1], sides[0], sides[2]), corner(sides[0], sides[1], sides[2])
    assert value("polar_angle") == pytest.approx(polar, rel=1e-12)
    assert value("wedge_angle") == pytest.approx(wedge, rel=1e-12)
    assert value("direction_angle") == pytest.approx(polar + wedge, rel=1e-12)


def test_speeds(value):
    assert value("speed_ratio") == pytest.approx(-9.0, rel=1e-12)
    assert value("absolute_speed_ratio") == pytest.approx(9.0, rel=1e-12)
    assert abs(value("output_speed")) == pytest.approx(6000.0 * math.pi / 30.0 / 9.0, rel=1e-12)


def test_sizes_and_masses(value):
    planet, roller = (STEEL * math.pi * radius**2 * LENGTH for radius in (PLANET, ROLLER))
    sun = STEEL * math.pi * SUN**2 * LENGTH
    ring = STEEL * math.pi * ((RING + WALL) ** 2 - RING**2) * LENGTH
    assert value("body_mass") == pytest.approx([sun, planet, roller, roller, ring], rel=1e-12)
    assert value("mass") == pytest.approx(sun + 3.0 * planet + 6.0 * roller + ring, rel=1e-12)
    assert value("envelope_diameter") == pytest.approx(0.2, rel=1e-12)
    assert value("envelope_volume") == pytest.approx(math.pi * 0.1**2 * LENGTH, rel=1e-12)


def test_clearances(value):
    """Between neighbouring planets 2 * 17.5 mm sin 60 deg less their diameter, among the others."""
    gaps = value("clearance")
    planets = 2.0 * (SUN + PLANET) * math.sin(math.pi / 3.0) - 2.0 * PLANET
    assert np.any(np.isclose(gaps, planets, rtol=1e-12))
    # a planet and the ring: 40 - 17.5 - 13.5
    assert np.any(np.isclose(gaps, RING - SUN - 2.0 * PLANET, rtol=1e-12))


def test_capacity_is_that_of_slip(value):
    """The sun's contact of 1000 N slips first: about 3 * 9 * 4 mm * 0.12 * 1000 N, more as the torque wedges."""
    capacity = value("standing_torque_capacity")
    assert capacity == pytest.approx(27.0 * SUN * 120.0, rel=0.05)
    limits = RESULTS["standing_capacity_limit"].categories
    assert limits[int(value("standing_capacity_limit"))] == "gross_slip"
    assert int(value("standing_limiting_contact")) == 0
