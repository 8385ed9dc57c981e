"""Limits of the loads of a duty, from numbers made by hand; those of results have tests of their own."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results import RESULTS
from asperity.results import all_limits as module
from asperity.results.all_limits import further_checks
from asperity.rolling.conditions import DutyPoint

DUTY = (DutyPoint(5.0, 50.0 * math.pi, 0.5), DutyPoint(20.0, 100.0 * math.pi, 0.3), DutyPoint(-4.0, 0.0, 0.2))


@pytest.fixture(autouse=True)
def rows(monkeypatch):
    """Of all results the safeties of the rims."""
    known = {
        name: dataclasses.replace(RESULTS[name], present=lambda solved: solved.bent)
        for name in ("rim_yield_safety", "rim_fatigue_safety")
    }
    monkeypatch.setattr(module, "results_of_joint", lambda solved: known)


def solved(pressures, *, slips=None, duty=DUTY, standing=(30.0, 3.0)):
    joint = SimpleNamespace(rolling=SimpleNamespace(duty=duty), ends=("sun", "carrier"), input_speed=1.0)
    slips = [0.5 * each for each in pressures] if slips is None else slips
    rolling = SimpleNamespace(duty_shakedown_ratios=np.array(pressures), duty_slip_ratios=np.array(slips))
    forward, back = (SimpleNamespace(output_torque=each) for each in standing)
    return SimpleNamespace(
        joint=joint,
        result=SimpleNamespace(rolling=rolling),
        bent=(False, False),
        row_names=lambda axis: ("planet", "ring"),
        required_life=None,
        over_turn=None,
        standing_capacity=forward,
        reverse_standing_capacity=back,
    )


def duty_checks(pressures, **options):
    return [each for each in further_checks(solved(pressures, **options)) if "duty" in each.result.name]


def test_a_joint_that_rolls_under_its_duty():
    count, pressure = duty_checks([0.5, 0.8, 0.4], standing=(30.0, 4.5))
    assert (count.value, count.ok, count.meaning) == (
        0.0,
        True,
        "every load of the duty is carried without gross slip",
    )
    assert (pressure.value, pressure.contact, pressure.ok) == (0.8, "load 2", True)
    assert further_checks(solved([], duty=())) == ()


def test_loads_that_it_does_not_carry_are_named():
    count, pressure = duty_checks([1.2, math.nan, math.nan])
    assert (count.value, count.ok, count.rule.severity) == (2.0, False, "function")
    named = "load 2, 20 N·m with the sun at 3000 rpm; load 3, -4 N·m with the sun at 0 rpm"
    assert count.meaning.startswith(f"not carried: {named}; a contact slips as a whole")
    assert (pressure.value, pressure.contact, pressure.ok) == (1.2, "load 1", False)
    assert [each.value for each in duty_checks(3 * [math.nan])] == [3.0]  # no pressure is known


def test_a_skewed_joint_that_turns_while_a_contact_slips_does_not_carry_the_load():
    count, pressure = duty_checks([0.5, 0.6, 0.4], slips=[0.9, 1.4, 1.0], standing=(30.0, 4.5))
    assert count.value == 1.0
    assert "load 2, 20 N·m" in count.meaning
    assert "-4 N·m" not in count.meaning  # the third load stands, where skew does not act
    assert pressure.ok


def test_the_worst_load_for_a_rim_is_named():
    """The second load is not carried: what the ring would bear under it says nothing."""

    def rims(yield_safety, fatigue_safety):
        return SimpleNamespace(
            yield_safety=np.array([math.nan, yield_safety]),
            fatigue_safety=np.array([math.nan, fatigue_safety]),
        )

    joint = solved([0.5, math.nan, 0.4], standing=(30.0, 4.5))
    joint.bent = (False, True)
    joint.rims = rims(9.0, 9.0)
    joint.duty_rims = (rims(3.0, 0.9), rims(0.1, 0.1), rims(2.0, 1.8))
    found = {each.result.name: each for each in further_checks(joint)}
    assert set(found) == {
        "duty_loads_not_carried",
        "duty_shakedown_ratio",
        "duty_rim_yield_safety",
        "duty_rim_fatigue_safety",
    }
    of_yield, of_fatigue = found["duty_rim_yield_safety"], found["duty_rim_fatigue_safety"]
    assert (of_yield.value, of_yield.contact, of_yield.ok) == (2.0, "ring, load 3", True)
    assert (of_fatigue.value, of_fatigue.contact, of_fatigue.ok) == (0.9, "ring, load 1", False)
    assert of_fatigue.result.label == "rim fatigue safety, worst load of the duty"
    assert joint.rims.yield_safety[1] == 9.0  # that of its own torque stays
