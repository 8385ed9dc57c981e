"""Speeds from creepages against the rolling states, and by hand."""

import numpy as np
import pytest

from asperity.drive.planar.creeping import creeping_speeds
from asperity.drive.planar.layout import speeds
from asperity.drive.planar.state import surface_speeds


@pytest.mark.slow
@pytest.mark.parametrize("name", ["wedge", "planetary", "multiroller", "stepped"])
def test_without_creep_the_speeds_are_those_of_rolling(drives, name):
    drive = drives[name]
    speed, rolled = creeping_speeds(drive=drive, creepage=np.zeros(len(drive.contacts)))
    np.testing.assert_allclose(speed, speeds(drive), rtol=1e-12, atol=1e-14)
    for side in surface_speeds(drive=drive, speed=speed):
        np.testing.assert_allclose(rolled, side, rtol=1e-12)


def test_creepages_of_a_rolling_state_give_its_speeds(drives, solved):
    drive = drives["planetary"]
    _, state = solved("planetary", 8.0)
    speed, rolled = creeping_speeds(drive=drive, creepage=state.creepage)
    np.testing.assert_allclose(speed, state.speed, rtol=1e-12, atol=1e-14)
    one, two = surface_speeds(drive=drive, speed=state.speed)
    np.testing.assert_allclose(rolled, 0.5 * (one + two), rtol=1e-12)


def test_a_planetary_by_hand(drives):
    """Seen from the carrier each contact slows the following surface by (1 − xi/2)/(1 + xi/2)."""
    creep = np.array([0.02, -0.03])
    speed, _ = creeping_speeds(drive=drives["planetary"], creepage=creep)
    sun, carrier = speed[0], speed[-1]
    left = np.prod((1.0 - 0.5 * np.array([0.02, 0.03])) / (1.0 + 0.5 * np.array([0.02, 0.03])))
    # the ring, of five times the sun's radius, stands: 50 omega_c = 10 (omega_s - omega_c) left
    assert float(carrier / sun) == pytest.approx(10.0 * left / (50.0 + 10.0 * left), rel=1e-12)
