"""Loads of the planetary example by hand."""

import math

import numpy as np
import pytest

from asperity.cli.solved_case import solved_planar
from asperity.joint.planar.loads_document import planar_loads_document, working_planar_loads


@pytest.fixture(scope="module")
def values(planetary):
    joint, solution, _ = planetary
    document = planar_loads_document(joint, solution)
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
    speed, _ = values["carrier pin", "planet", "speed, roller on pin"]
    assert speed == pytest.approx([0.0, 1500.0 * math.pi / 30.0 / 6.0 * 2.5], rel=1e-9)


@pytest.mark.slow
def test_the_loads_of_a_duty_are_cases_of_their_own(planar_case):
    """Torque of the ring over that of the carrier 5/6, at every load; speeds in proportion."""
    duty = "".join(
        f'[[duty]]\noutput_torque = "{torque} N*m"\nsun_speed = "{speed} rpm"\nshare = {share}\n\n'
        for torque, speed, share in ((11, 3000, 0.25), (-5, 0, 0.75))
    )
    joint, solution, _ = solved_planar(planar_case("planetary", replaced={"[model]": duty + "[model]"}))
    document = planar_loads_document(joint, solution)
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


def test_nothing_is_left_over(planetary):
    joint, solution, _ = planetary
    found = working_planar_loads(joint, solution.result)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-6)
    assert float(np.sum(found.moments)) == pytest.approx(0.0, abs=1e-9)
