"""Layouts of the common drives from the radii of their rollers, by hand."""

import math

import numpy as np
import pytest

from asperity.drive.layout.drive import gaps


def test_planetary(drives):
    drive = drives["planetary"]
    np.testing.assert_allclose(drive.centres, [[0.0, 0.0], [0.0, 30e-3], [0.0, 0.0]], atol=1e-18)
    np.testing.assert_allclose(drive.first_radius, [10e-3, 20e-3])
    np.testing.assert_allclose(drive.second_radius, [20e-3, 50e-3])
    assert (drive.input, drive.output, drive.grounded, drive.sense) == ("sun", "carrier", "ring", 1)


def test_second_row_of_the_multiroller_lies_between_two_rollers_of_the_first(drives):
    """Four rollers: the second row at 45 degrees; Pythagoras over half the distance of the first row's centres."""
    drive = drives["multiroller"]
    half = 32.0 * math.sin(math.pi / 4.0)
    far = 32.0 * math.cos(math.pi / 4.0) + math.sqrt(34.0**2 - half**2)  # 48.005 mm
    assert far == pytest.approx(48.0046, abs=1e-4)
    np.testing.assert_allclose(
        np.asarray(drive.centres) * 1e3,
        [[0.0, 0.0], [0.0, 32.0], [-far * math.sqrt(0.5), far * math.sqrt(0.5)], [0.0, 0.0]],
        atol=1e-12,
    )
    np.testing.assert_allclose(np.asarray(drive.first_radius) * 1e3, [10.0, 9.0, 9.0, 14.0])
    np.testing.assert_allclose(np.asarray(drive.second_radius) * 1e3, [22.0, 25.0, 25.0, far + 14.0])


def test_rings_of_the_stepped_planet(drives):
    drive = drives["stepped"]
    np.testing.assert_allclose(np.asarray(drive.second_radius) * 1e3, [20.0, 50.0, 48.0])
    np.testing.assert_allclose(np.asarray(drive.first_radius) * 1e3, [10.0, 20.0, 18.0])
    np.testing.assert_allclose(np.asarray(drive.centres[1]) * 1e3, [0.0, 30.0])


def test_wedge_rollers_touch_planet_and_ring(drives):
    """Right roller first: 18.5 mm from the planet's centre and 35 mm from the axis, on the side of +x."""
    drive = drives["wedge"]
    sun, planet, right, left, ring = np.asarray(drive.centres) * 1e3
    np.testing.assert_allclose([sun, ring], 0.0, atol=1e-15)
    np.testing.assert_allclose(planet, [0.0, 17.5])
    y = (35.0**2 + 17.5**2 - 18.5**2) / (2.0 * 17.5)  # the law of cosines
    np.testing.assert_allclose(right, [math.sqrt(35.0**2 - y**2), y], rtol=1e-12)
    np.testing.assert_allclose(left, right * [-1.0, 1.0], rtol=1e-15)
    np.testing.assert_allclose(gaps(drive), 0.0, atol=1e-15)
    assert drive.sense == -1
