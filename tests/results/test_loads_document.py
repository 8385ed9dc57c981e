"""Loads of the planetary example by hand."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.drive.structure.bearing_life import RatedBearing
from asperity.joint.bearing_lives import BearingLives
from asperity.joint.rim_safety import BodyRims
from asperity.joint_file.solved_document import solved_case
from asperity.results.loads_document import bearing_entries, loads_document, rim_entry
from asperity.results.solved import solved_with_capacities


@pytest.fixture(scope="module")
def values(planetary):
    joint, solution, _ = planetary
    document = loads_document(solved_with_capacities(joint, solution), [])
    return {
        (row["part"], row["position"], row["quantity"]): (row["values"], row["unit"])
        for row in document["loads"]
    }


@pytest.mark.slow
def test_pins_and_torques_by_hand(planetary, values):
    """10 N·m at the carrier with a ratio of 6: three pins on a circle of 30 mm; the oil drags on every surface."""
    _, solution, _ = planetary
    (sun, ring), drag = (
        np.asarray(part) for part in (solution.result.rolling.tangential, solution.result.rolling.drag)
    )
    assert sun - ring == pytest.approx(drag.sum(), rel=1e-9)  # a planet
    assert 0.0 < drag.sum() < 2.0
    pin, unit = values["carrier pin", "planet", "tangential force"]
    assert unit == "N"
    assert pin == pytest.approx([0.0, 10.0 / (3.0 * 30e-3)], rel=1e-9, abs=1e-9)
    for part, position, quantity, expected in (
        ("carrier", "on the axis, output", "torque of all pins", 10.0),
        ("sun", "on the axis, input", "torque of the rollers", -3.0 * 10e-3 * (sun + drag[0])),
        ("ring", "on the axis, grounded", "torque of the rollers", -3.0 * 50e-3 * (ring - drag[1])),
    ):
        found, unit = values[part, position, quantity]
        assert unit == "N*m"
        assert found == pytest.approx([0.0, expected], rel=1e-9, abs=1e-9)
    assert 3.0 * (10e-3 * (sun + drag[0]) + 50e-3 * (ring - drag[1])) == pytest.approx(10.0, rel=1e-9)


@pytest.mark.slow
def test_what_mounts_the_ring_by_hand(planetary, values):
    """Three planets; 30 um over 12.6e-6 of 50 mm a kelvin; the ring of a free rim bends."""
    _, solution, _ = planetary
    place = ("ring", "mounted over its rollers")
    force = 3 * 0.08 * float(solution.result.rest.normal[1])
    assert values[*place, "axial mounting force"] == ([pytest.approx(force), None], "N")
    rise = 30e-6 / (12.6e-6 * (0.05 - 30e-6))
    for what in ("heating of the ring", "or cooling of everything inside it"):
        assert values[*place, f"{what}, for a gap of 0 um"] == ([pytest.approx(rise, rel=1e-3), None], "K")
    stress, unit = values[*place, "largest hoop stress, mounted"]
    assert unit == "Pa"
    # curved beam under three forces, thin-ring formula at the load: 0.19 F R of moment, and F/(2 tan 60) of tension
    n, wall, width = float(solution.result.rest.normal[1]), 8e-3, 10e-3
    bending = 0.189 * n * 54e-3 * 6.0 / (width * wall**2)
    assert stress[0] == pytest.approx(bending + 0.289 * n / (width * wall), rel=0.25)
    assert values[*place, "yield strength"][0][0] == pytest.approx(2034e6, rel=0.01)


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


@pytest.mark.long
def test_the_loads_of_a_duty_are_cases_of_their_own(planar_case):
    """Torque of the ring over that of the carrier 5/6 without a drag of the oil; speeds in proportion."""
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
    ring, sun = (np.array(rows[body, "torque of the rollers"]) for body in ("ring", "sun"))
    assert ring[[0, 3]] == pytest.approx([0.0, 25.0 / 6.0], rel=1e-9, abs=1e-9)  # nothing turns
    assert ring + sun == pytest.approx([0.0, -10.0, -11.0, 5.0], rel=1e-9, abs=1e-9)
    dragged = 6.0 * ring[1:3] / np.array([-50.0, -55.0])
    assert np.all((dragged > 0.98) & (dragged < 1.0))
    one = 1500.0 * math.pi / 30.0
    assert rows["sun", "speed in the housing"] == pytest.approx([0.0, one, 2.0 * one, 0.0], rel=1e-9)


@pytest.mark.long
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


def bearing(*, life, duty_life, load=10.0, duty=("a load",)):
    def filled(value):
        return np.full(2, value)

    joint = SimpleNamespace(
        bearing_names=("pin", "sun"),
        rated_bearings=(None, RatedBearing(1000.0, 900.0, 1.0, load, "ball")),
        rolling=SimpleNamespace(duty=duty),
    )
    lives = BearingLives(filled(load), filled(life), filled(duty_life), filled(90.0), filled(0.01))
    (entry,) = bearing_entries(SimpleNamespace(joint=joint, bearings=lives))
    return entry


def test_lives_are_in_hours():
    entry = bearing(life=3600e3, duty_life=7200e3)
    assert (entry["bearing"], entry["type"]) == ("sun", "ball")
    assert (entry["life_hours"], entry["duty_life_hours"]) == (1e3, 2e3)
    assert entry["absent_because"] == []


@pytest.mark.parametrize(
    ("numbers", "said"),
    [
        ({"life": math.nan, "duty_life": 1.0}, ["at standstill"]),
        ({"life": math.inf, "duty_life": math.inf}, ["no load"]),
        ({"life": 1.0, "duty_life": math.nan}, ["under the duty"]),
        ({"life": 1.0, "duty_life": math.inf}, ["turns it"]),
        ({"life": math.nan, "duty_life": 1.0, "load": math.nan}, ["not known"]),
        ({"life": 1.0, "duty_life": math.nan, "duty": ()}, []),
    ],
)
def test_what_is_absent_has_a_reason(numbers, said):
    entry = bearing(**numbers)
    assert len(entry["absent_because"]) == len(said)
    assert all(words in text for words, text in zip(said, entry["absent_because"], strict=True))


def test_both_rims_of_a_body_that_bends():
    rims = BodyRims(
        *(np.array([1.0, 2.0]) * factor for factor in (1, 2, 3, 4)), *np.array([5.0, np.nan, 0.0])
    )
    assert rim_entry(rims) == {
        "stress_Pa": {"inner": 1.0, "outer": 2.0},
        "stress_at_rest_Pa": {"inner": 2.0, "outer": 4.0},
        "mean_Pa": {"inner": 3.0, "outer": 6.0},
        "amplitude_Pa": {"inner": 4.0, "outer": 8.0},
        "yield_safety": 5.0,
        "fatigue_safety": None,
    }
