"""Lives of a joint's bearings: by hand from its pin forces, Miner's sum, and what is absent."""

import dataclasses
import math

import jax
import numpy as np
import pytest
from asperity.drive.structure_loads import BEARING_NAMES
from asperity.joint.working_loads import bearing_speeds, working_loads

from asperity.compilation import call_compiled
from asperity.drive.bearing_life import RatedBearing
from asperity.joint.bearing_lives import BearingState, bearing_lives, lives_of_bearings
from asperity.joint.planar.solve import solve_planar
from asperity.joint.results import SolvedJoint
from asperity.joint.rolling_conditions import DutyPoint
from asperity.joint.strength_document import bearing_entries
from asperity.joint_file.planar_build import planar_joint_from_case

PIN = RatedBearing(1500.0, 1200.0, 2.0, 0.0, "roller")
HELD = RatedBearing(5000.0, 3000.0, 1.0, 400.0, "ball")


@pytest.fixture(scope="module")
def plain(case):
    return jax.tree.map(np.float64, planar_joint_from_case(case))


@pytest.fixture(scope="module")
def solution(plain):
    return solve_planar(plain)


@pytest.fixture(scope="module")
def joint(plain):
    return dataclasses.replace(plain, pin_bearing=PIN, carrier_bearing=HELD)


def test_lives_by_hand(joint, solution):
    found = bearing_lives(joint, solution.result)
    pins = np.asarray(working_loads(joint, solution.result).pin_resultant)
    speeds = bearing_speeds(joint, solution.result)
    expected = 1e6 * (1500.0 / (0.5 * pins)) ** (10.0 / 3.0) * 2.0 * np.pi / np.asarray(speeds.pin)
    assert np.asarray(found.life)[:2] == pytest.approx(expected, rel=1e-12)
    carrier = 1e6 * (5000.0 / 400.0) ** 3 * 2.0 * np.pi / float(speeds.carrier)
    assert float(found.life[3]) == pytest.approx(carrier, rel=1e-12)
    # 127.838 N at rest and 145.4 N under the torque on the left pin, on two bearings
    assert float(found.static_safety[1]) == pytest.approx(1200.0 / (0.5 * pins[1]), rel=1e-12)
    assert float(found.static_safety[0]) == pytest.approx(1200.0 / (0.5 * 127.838), rel=1e-5)
    assert float(found.load_ratio[3]) == pytest.approx(0.08)
    for values in vars(found).values():
        assert math.isnan(float(values[BEARING_NAMES.index("sun")]))
    assert np.all(np.isnan(np.asarray(found.duty_life)))


def test_a_bearing_that_stands_has_no_life_in_hours(joint, solution):
    standing = dataclasses.replace(joint, input_speed=np.float64(0.0))
    found = bearing_lives(standing, solution.result)
    assert np.all(np.isnan(np.asarray(found.life)))
    assert np.asarray(found.static_safety)[[0, 1, 3]].min() > 1.0
    entry = bearing_entries(SolvedJoint(standing, solution.result))[0]
    assert entry["life_hours"] is None
    assert "it stands" in entry["absent_because"][0]


def test_a_bearing_without_load_lives_for_ever(plain, solution):
    free = dataclasses.replace(plain, carrier_bearing=dataclasses.replace(HELD, outside_force=0.0))
    assert float(bearing_lives(free, solution.result).life[3]) == math.inf
    (entry,) = bearing_entries(SolvedJoint(free, solution.result))
    assert (entry["bearing"], entry["life_hours"], entry["static_safety"]) == ("carrier", None, None)
    assert "no load" in entry["absent_because"][0]


def duty(joint, *points):
    loads = tuple(DutyPoint(*point) for point in points)
    return dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=loads))


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


@pytest.mark.long
def test_the_loads_of_the_duty_are_those_of_joints_of_their_own(joint, solution):
    points = ((3.0, 300.0, 0.6), (-5.0, 600.0, 0.4))
    found = call_compiled(bearing_lives, duty(joint, *points), solution.result)
    damage = 0.0
    for torque, speed, share in points:
        alone = dataclasses.replace(joint, output_torque=np.float64(torque), sun_speed=np.float64(speed))
        damage = damage + share / np.asarray(bearing_lives(alone, solve_planar(alone).result).life)
    assert found.duty_life[[0, 1, 3]] == pytest.approx(1.0 / damage[[0, 1, 3]], rel=1e-9)
