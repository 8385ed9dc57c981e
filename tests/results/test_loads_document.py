"""Loads of the planetary example by hand."""

import math

import pytest

from asperity.joint_file.solved_document import solved_case
from asperity.results.loads_document import loads_document
from asperity.results.solved import solved_with_capacities


@pytest.fixture(scope="module")
def values(planetary):
    joint, solution, _ = planetary
    document = loads_document(solved_with_capacities(joint, solution), [])
    return {
        (row["part"], row["position"], row["quantity"]): (row["values"], row["unit"])
        for row in document["loads"]
    }


def test_pins_and_torques_by_hand(values):
    """10 N·m at the carrier with a ratio of 6: three pins on a circle of 30 mm."""
    pin, unit = values["carrier pin", "planet", "tangential force"]
    assert unit == "N"
    assert pin == pytest.approx([0.0, 10.0 / (3.0 * 30e-3)], rel=1e-9, abs=1e-9)
    for part, position, quantity, expected in (
        ("carrier", "on the axis, output", "torque of all pins", 10.0),
        ("sun", "on the axis, input", "torque of the rollers", -10.0 / 6.0),
        ("ring", "on the axis, grounded", "torque of the rollers", -10.0 * 5.0 / 6.0),
    ):
        found, unit = values[part, position, quantity]
        assert unit == "N*m"
        assert found == pytest.approx([0.0, expected], rel=1e-9, abs=1e-9)


def test_speeds_are_those_of_a_drive_that_creeps(planetary, values):
    """A planet rolls 50 mm of the ring in a radian of the carrier, less what the contact with the ring creeps."""
    _, solution, _ = planetary
    rolling = solution.result.rolling
    carrier, _ = values["carrier", "on the axis, output", "speed in the housing"]
    assert carrier == pytest.approx([0.0, float(rolling.output_speed)], rel=1e-9)
    ideal = 1500.0 * math.pi / 30.0 / 6.0
    assert carrier[1] == pytest.approx(ideal * (1.0 - float(rolling.speed_loss)), rel=1e-9)
    pin, _ = values["carrier pin", "planet", "speed, roller on pin"]
    creep = float(rolling.creepage[1])  # of the mean of both surfaces
    assert pin[1] == pytest.approx(carrier[1] * 2.5 * (1.0 + 0.5 * creep) / (1.0 - 0.5 * creep), rel=1e-9)
    sun, _ = values["sun", "on the axis, input", "speed in the housing"]
    assert sun == pytest.approx([0.0, 1500.0 * math.pi / 30.0], rel=1e-12)


@pytest.mark.slow
def test_the_loads_of_a_duty_are_cases_of_their_own(planar_case):
    """Torque of the ring over that of the carrier 5/6, at every load; speeds in proportion."""
    duty = "".join(
        f'[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n\n'
        for torque, speed, share in ((11, 3000, 0.25), (-5, 0, 0.75))
    )
    solved = solved_case(planar_case("planetary", replaced={"[model]": duty + "[model]"}))
    document = loads_document(solved, [])
    assert [case["name"] for case in document["cases"]] == [
        "without torque",
        "working torque",
        "duty 1",
        "duty 2",
    ]
    assert [case["share"] for case in document["cases"]] == [None, None, 0.25, 0.75]
    rows = {(row["part"], row["quantity"]): row["values"] for row in document["loads"]}
    assert rows["ring", "torque of the rollers"] == pytest.approx(
        [0.0, -50.0 / 6.0, -55.0 / 6.0, 25.0 / 6.0], rel=1e-9, abs=1e-9
    )
    one = 1500.0 * math.pi / 30.0
    assert rows["sun", "speed in the housing"] == pytest.approx([0.0, one, 2.0 * one, 0.0], rel=1e-9)


@pytest.mark.slow
def test_axial_forces_of_skewed_contacts(skewed_planetary):
    """Pins, shafts and the ring bear the thrust of their bodies, together none."""
    joint, solution, document = skewed_planetary
    thrust = document["rolling"]["axial_thrust_N"]
    found = loads_document(solved_with_capacities(joint, solution), [])
    rows = {row["part"]: row["values"] for row in found["loads"] if row["quantity"] == "axial force"}
    assert rows == {
        "carrier pin": pytest.approx([0.0, thrust["planet"]]),
        "carrier": pytest.approx([0.0, 3.0 * thrust["planet"]]),
        "sun": pytest.approx([0.0, thrust["sun"]]),
        "ring": pytest.approx([0.0, thrust["ring"]]),
    }
    assert abs(thrust["sun"]) > 1.0
    assert rows["carrier"][1] + rows["sun"][1] + rows["ring"][1] == pytest.approx(0.0, abs=1e-9)
