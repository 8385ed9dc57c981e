"""Lives of a joint's bearings: by hand from its pin forces, and Miner's sum."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.drive.structure.bearing_life import RatedBearing
from asperity.joint.bearing_lives import BearingState, joint_bearing_lives, lives_of_bearings

PIN = RatedBearing(1500.0, 1200.0, 2.0, 0.0, "roller")
HELD = RatedBearing(5000.0, 3000.0, 1.0, 400.0, "ball")


def test_lives_by_hand(solved_paper):
    joint, solution = solved_paper
    rated = dataclasses.replace(joint, pin_bearing=PIN, output_bearing=HELD)
    found = joint_bearing_lives(rated, solution.result, solution.laws)
    # without torque N_pw sin(beta) = 1000/(2 cos 27.0831 deg) sin 13.1582 deg = 127.838 N on two bearings
    assert float(found.static_safety[0]) == pytest.approx(1200.0 / (0.5 * 127.838), rel=1e-5)
    # relative to the carrier the rollers turn (R_s/R_w)(1 + 1/9) times as fast as the sun, less creep
    sun = 6000.0 * math.pi / 30.0
    turns = 1e6 * (1500.0 / np.asarray(found.load[:2])) ** (10.0 / 3.0)
    roller = sun * 4.0 / 5.0 * (1.0 + 1.0 / 9.0)
    assert np.asarray(found.life)[:2] == pytest.approx(turns * 2.0 * math.pi / roller, rel=3e-3)
    carrier = sun / 9.0 * (1.0 - float(solution.result.rolling.speed_loss))
    assert float(found.life[3]) == pytest.approx(
        1e6 * (5000.0 / 400.0) ** 3 * 2.0 * math.pi / carrier, rel=1e-12
    )
    assert float(found.load_ratio[3]) == pytest.approx(0.08)
    for values in vars(found).values():
        assert math.isnan(float(values[2]))  # the sun has none
    assert np.all(np.isnan(np.asarray(found.duty_life)))


def test_miners_sum_and_the_largest_load():
    """Two bearings at each pin: 50 and 60 N on each under the first load, 300 and 200 N under the second."""
    forces = np.array([[100.0, 120.0, 0.0, 0.0], [600.0, 400.0, 0.0, 0.0]])
    speeds = np.array([[500.0, 500.0, 600.0, 60.0], [0.0, 100.0, 200.0, 20.0]])
    found = lives_of_bearings(
        (PIN, PIN, None, HELD),
        working=BearingState(forces[0], speeds[0]),
        rest=np.zeros(4),
        duty=BearingState(forces, speeds),
        shares=np.array([0.7, 0.3]),
    )
    first = 0.7 * 500.0 / (2e6 * np.pi * (1500.0 / 50.0) ** (10 / 3))  # the second load does not turn it
    assert float(found.duty_life[0]) == pytest.approx(1.0 / first, rel=1e-12)
    damage = [
        share * speed / (2e6 * np.pi * (1500.0 / load) ** (10 / 3))
        for share, speed, load in ((0.7, 500.0, 60.0), (0.3, 100.0, 200.0))
    ]
    assert float(found.duty_life[1]) == pytest.approx(1.0 / sum(damage), rel=1e-12)
    assert float(found.static_safety[0]) == pytest.approx(1200.0 / 300.0)
    assert float(found.load_ratio[0]) == pytest.approx(300.0 / 1500.0)
