"""Speeds of a rolling drive against the definitions of creepage, of rolling without it, and of the carrier's frame."""

import numpy as np
import pytest

from asperity.drive.geometry import DriveGeometry
from asperity.drive.rolling_speeds import rolling_speeds

GEOMETRY = DriveGeometry(4e-3, 13.5e-3, 5e-3, 40e-3, 3.0, 0.0, 0.0)
SUN_SPEED = 600.0
#: Large creepages of unequal size, equal in series on both sides of the planet.
CREEPAGE = np.array([0.20, 0.12, 0.04, 0.06, 0.0])
CREEPAGE[4] = 2 * np.tanh(sum(np.arctanh(CREEPAGE[[1, 3]] / 2)) - np.arctanh(CREEPAGE[2] / 2))


def test_without_creep_the_drive_turns_by_its_radii():
    found = rolling_speeds(geometry=GEOMETRY, creepage=np.zeros(5), sun_speed=SUN_SPEED)
    carrier = SUN_SPEED * 4 / 36
    assert float(found.output) == pytest.approx(carrier, rel=1e-14)
    np.testing.assert_allclose(found.driving, 40e-3 * carrier, rtol=1e-14)
    np.testing.assert_allclose(found.driven, 40e-3 * carrier, rtol=1e-14)
    np.testing.assert_allclose(found.body, carrier * 40 / np.array([4, 13.5, 5, 5, 40]), rtol=1e-14)


def test_creepage_is_the_difference_of_the_surface_speeds_over_their_mean():
    found = rolling_speeds(geometry=GEOMETRY, creepage=CREEPAGE, sun_speed=SUN_SPEED)
    driving, driven = np.asarray(found.driving), np.asarray(found.driven)
    np.testing.assert_allclose((driving - driven) / found.rolling, CREEPAGE, rtol=1e-12, atol=1e-15)
    np.testing.assert_allclose(found.rolling, (driving + driven) / 2, rtol=1e-14)


def test_every_body_turns_with_its_surfaces_in_the_frame_of_the_carrier():
    found = rolling_speeds(geometry=GEOMETRY, creepage=CREEPAGE, sun_speed=SUN_SPEED)
    carrier, driving, driven = float(found.output), np.asarray(found.driving), np.asarray(found.driven)
    sun, planet, right, left, ring = np.asarray(found.body) * np.array([4e-3, 13.5e-3, 5e-3, 5e-3, 40e-3])
    # the carrier turns against the sun, the ring stands
    assert sun == pytest.approx(4e-3 * (SUN_SPEED + carrier), rel=1e-14)
    assert ring == pytest.approx(40e-3 * carrier, rel=1e-14)
    np.testing.assert_allclose(driving, [sun, planet, planet, right, left], rtol=1e-14)
    np.testing.assert_allclose(driven, [planet, right, left, ring, ring], rtol=1e-14)
