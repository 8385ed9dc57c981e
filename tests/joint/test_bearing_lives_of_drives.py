"""Lives of the bearings of drives: by hand from the printed loads, and Miner's sum."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.drive.structure.bearing_life import RatedBearing
from asperity.engine.control import at_once
from asperity.joint.bearing_lives import joint_bearing_lives
from asperity.joint.solve import solve_joint
from asperity.results.document import joint_document
from asperity.results.loads_document import bearing_entries, loads_document
from asperity.results.solved import solved_with_capacities
from asperity.rolling.conditions import DutyPoint

PIN = RatedBearing(1500.0, 1200.0, 2.0, 0.0, "roller")
HELD = RatedBearing(5000.0, 3000.0, 1.0, 400.0, "ball")


@pytest.fixture(scope="module")
def rated(planetary):
    joint, solution, _ = planetary
    return dataclasses.replace(joint, pin_bearing=PIN, output_bearing=HELD), solution


@pytest.mark.slow
def test_lives_by_hand_from_the_printed_loads_and_speeds(rated):
    joint, solution = rated
    solved = solved_with_capacities(joint, solution)
    entries = bearing_entries(solved)
    document = loads_document(solved, entries)
    printed = {(row["part"], row["quantity"]): row["values"][1] for row in document["loads"]}
    pin, carrier = document["bearings"]
    assert (pin["bearing"], carrier["bearing"]) == ("planet_pin", "carrier")
    half = 0.5 * printed["carrier pin", "resultant force"]
    turns_an_hour = 3600.0 / (2.0 * math.pi)
    speed = printed["carrier pin", "speed, roller on pin"]
    assert pin["load_N"] == pytest.approx(half, rel=1e-12)
    assert pin["life_hours"] == pytest.approx(
        1e6 * (1500.0 / half) ** (10.0 / 3.0) / (speed * turns_an_hour), rel=1e-12
    )
    assert pin["static_safety"] == pytest.approx(1200.0 / half, rel=1e-12)
    speed = printed["carrier", "speed in the housing"]
    assert carrier["life_hours"] == pytest.approx(
        1e6 * (5000.0 / 400.0) ** 3 / (speed * turns_an_hour), rel=1e-12
    )
    assert carrier["load_over_dynamic_rating"] == pytest.approx(0.08)
    assert any("ISO 281" in note for note in document["notes"])
    whole = joint_document(solved_with_capacities(joint, solution), inputs={}, assumptions=())
    assert whole["bearings"] == entries
    limits = {(each["name"], each["contact"]) for each in whole["diagnostics"] if "contact" in each}
    assert {("bearing_static_safety", "planet_pin"), ("bearing_load_ratio", "carrier")} <= limits


def test_a_drive_that_stands_has_no_lives_in_hours(rated):
    joint, solution = rated
    standing = dataclasses.replace(joint, input_speed=np.float64(0.0))
    found = joint_bearing_lives(standing, solution.result, solution.laws)
    assert np.all(np.isnan(np.asarray(found.life)))
    assert np.isnan(np.asarray(found.load)[1])  # the input has no ratings
    assert float(found.static_safety[0]) == pytest.approx(1200.0 / (0.5 * 10.0 / 3.0 / 30e-3), rel=1e-6)


@pytest.mark.long
def test_the_loads_of_the_duty_are_those_of_joints_of_their_own(rated):
    joint, solution = rated
    points = ((3.0, 300.0, 0.6), (-5.0, 600.0, 0.3), (12.0, 0.0, 0.1))
    duty = tuple(DutyPoint(*map(np.float64, point)) for point in points)
    loaded = dataclasses.replace(joint, rolling=dataclasses.replace(joint.rolling, duty=duty))
    found = at_once(joint_bearing_lives, loaded, solution.result, solution.laws)
    damage, largest = 0.0, 0.0
    for torque, speed, share in points:
        alone = dataclasses.replace(joint, output_torque=np.float64(torque), input_speed=np.float64(speed))
        solved = solve_joint(alone)
        lives = joint_bearing_lives(alone, solved.result, solved.laws)
        damage = damage + share * np.nan_to_num(1.0 / np.asarray(lives.life))  # one that stands has no damage
        largest = np.maximum(largest, np.asarray(lives.load))
    assert found.duty_life[[0, 2]] == pytest.approx(1.0 / damage[[0, 2]], rel=1e-9)
    assert found.static_safety[0] == pytest.approx(1200.0 / largest[0], rel=1e-9)
    assert found.load_ratio[0] == pytest.approx(largest[0] / 1500.0, rel=1e-9)
