"""Speeds from creepages against the rolling states, and by hand."""

import numpy as np
import pytest

from asperity.drive.layout.drive import creeping_speeds, driving_sense, speeds
from asperity.drive.state.state import surface_speeds


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


def test_a_wedge_drive_by_hand(drives):
    """Large creepages, equal in series on both sides of the planet; the first body of each contact is faster."""
    drive = drives["wedge"]
    creep = np.array([0.20, 0.12, 0.04, 0.06, 0.0])
    creep[4] = 2 * np.tanh(sum(np.arctanh(creep[[1, 3]] / 2)) - np.arctanh(creep[2] / 2))
    speed, rolled = creeping_speeds(drive=drive, creepage=driving_sense(drive) * creep)
    sun, ring, carrier = (float(speed[drive.members.index(name)]) for name in ("sun", "ring", "carrier"))
    assert (sun, ring) == pytest.approx((-1.0, 0.0), abs=1e-15)
    # seen from the carrier, which turns against the sun, the ring is slower by all contacts on the way
    left = np.prod((1.0 - 0.5 * creep[[0, 1, 3]]) / (1.0 + 0.5 * creep[[0, 1, 3]]))
    assert carrier == pytest.approx(4.0 * left / (40.0 - 4.0 * left), rel=1e-12)
    first = 4e-3 * (1.0 + carrier)
    slowed = first / (1.0 + 0.5 * creep[0])  # the rolling speed of the sun's contact
    assert abs(float(rolled[0])) == pytest.approx(slowed, rel=1e-12)
    one, two = (np.abs(side) for side in surface_speeds(drive=drive, speed=speed))
    np.testing.assert_allclose(2.0 * (one - two) / (one + two), creep, rtol=1e-11)
