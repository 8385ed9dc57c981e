"""Loads of the paper's joint in the state in which it works: rolling where it turns, at rest where it stands."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.working_loads import (
    loads_without_torque,
    member_speeds,
    pin_speeds,
    working_loads,
)

WEDGE, DIRECTION = np.radians(13.1582), np.radians(27.0831)  # of the paper's drive


@pytest.fixture(scope="module")
def joint(solved_example):
    return solved_example.joint


@pytest.fixture(scope="module")
def result(solved_example):
    return solved_example.solution.result


def moment(joint, loads, member):
    return abs(float(loads.moments[joint.drive.members.index(member)]))


def test_a_turning_joint_has_the_forces_of_rolling(joint, result):
    """Smooth bodies with Carter's creep have T = 25.4224 and 20.8739 N; the asperities shift them a little."""
    loads = working_loads(joint, result)
    right = 657.80 * np.sin(WEDGE) - 25.4224 * (np.cos(WEDGE) + 1.0)
    left = 464.95 * np.sin(WEDGE) + 20.8739 * (np.cos(WEDGE) + 1.0)
    assert np.abs(loads.pin) == pytest.approx([right, left], rel=2.5e-2)
    standing = np.abs(result.forces.pins)
    assert np.all(np.abs(np.abs(loads.pin) / standing - 1.0) > 5e-3)
    assert moment(joint, loads, "carrier") == pytest.approx(5.0, rel=1e-9)
    assert moment(joint, loads, "ring") == pytest.approx(5.0 + 5.0 / 9.0, rel=1e-9)


def test_a_standing_joint_has_the_forces_of_the_balance(joint, result):
    loads = working_loads(dataclasses.replace(joint, input_speed=np.float64(0.0)), result)
    assert np.abs(loads.pin) == pytest.approx(np.abs(result.forces.pins), rel=1e-12)


def test_the_preload_alone_pushes_both_pins_alike(joint, result):
    """N_pw = N_0/(2 cos theta) = 561.5 N, of which sin beta stays on the pin; the paper's angles."""
    loads = loads_without_torque(joint, result)
    pin = 1000.0 / (2.0 * np.cos(DIRECTION)) * np.sin(WEDGE)
    assert np.abs(loads.pin) == pytest.approx([pin, pin], rel=1e-5)
    assert np.asarray(loads.moments) == pytest.approx(np.zeros(len(joint.drive.members)), abs=1e-9)


def test_speeds_of_the_bearings(joint, result):
    """Relative to the carrier the rollers turn (R_s/R_w)(1 + 1/9) times the sun's speed, less creep."""
    speeds = member_speeds(joint, result)
    sun = 6000.0 * np.pi / 30.0
    loss = float(result.rolling.speed_loss)
    places = [joint.drive.members.index(name) for name in ("sun", "carrier")]
    assert np.abs(speeds)[places] == pytest.approx([sun, sun / 9.0 * (1.0 - loss)], rel=1e-12)
    expected = sun * 4.0 / 5.0 * (1.0 + 1.0 / 9.0)
    assert np.asarray(pin_speeds(joint.drive, speeds)) == pytest.approx([expected] * 2, rel=3e-3)
