"""Requirements that the worst of unequal branches has to meet, from branches made by hand."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.results.branch_limits import (
    branch_checks,
    capacity_words,
    equal_branches_note,
    least_life,
    pressed,
    refuse_beyond,
    refuse_no_rolling_together,
    shortest_life,
)

SLIPS_EARLY = {"first_slip": 3.598, "branch": 2, "contact": 0}


def checks_of(found, **changes):
    return {each.result.name: each for each in branch_checks(found, **{"turns": False} | changes)}


def test_a_branch_that_slips_under_the_torque_does_not_work(unequal_branches):
    found = unequal_branches()
    check = checks_of(found)["branch_slip"]
    assert check.ok
    assert check.value == pytest.approx(5.0 / 8.0)
    assert "no branch slips" in check.meaning
    early = dataclasses.replace(found.capacity, **SLIPS_EARLY)
    slip = np.array([0.26, 0.45, 1.0])
    found = unequal_branches(capacity=early, standing=dataclasses.replace(found.standing, slip_ratio=slip))
    check = checks_of(found)["branch_slip"]
    assert not check.ok
    assert (check.rule.severity, check.contact) == ("function", "planet 3")
    assert check.value == pytest.approx(5.0 / 3.598)
    for words in (
        "contact sp of planet 3 slips first, at 3.598 N·m",
        "worst branch is 1 (planets that slip: 3)",
        "13 N·m",
    ):
        assert words in check.meaning


def test_a_branch_that_the_friction_of_the_bearings_makes_slip_slips_under_any_torque(unequal_branches):
    found = unequal_branches()
    at_rest = dataclasses.replace(found.capacity, **(SLIPS_EARLY | {"first_slip": 0.0}))
    for torque in (5.0, 0.0):
        check = checks_of(unequal_branches(capacity=at_rest, torque=torque))["branch_slip"]
        assert not check.ok
        assert check.value == math.inf
        assert "contact sp of planet 3 slips first, at 0 N·m" in check.meaning


def test_more_than_all_branches_pass(unequal_branches):
    found = unequal_branches(torque=14.0, standing=None)
    slip, _, pressure = branch_checks(found, turns=False)
    assert "contact by contact: equal ones carry 13 N·m at most" in equal_branches_note(found)
    assert not slip.ok
    assert "all branches slip at 12.5 N·m" in slip.meaning
    assert math.isnan(pressure.value)  # by hand the state without torque has no pressure
    assert not pressure.ok


def test_pressures_are_those_of_the_worst_contact_of_the_worst_branch(unequal_branches):
    shakedown = np.full((5, 3), 0.5)
    shakedown[3, 1] = 0.9
    rolling = dataclasses.replace(
        unequal_branches().standing,
        limits={"shakedown_ratio": shakedown, "life_hours": np.array([1.18e7, 1.9e7, np.nan])},
    )
    found = unequal_branches(rolling=rolling)
    checks = checks_of(found, turns=True)
    yields, shakes = checks["branch_pressure_over_first_yield"], checks["branch_shakedown_ratio"]
    assert (yields.contact, yields.value, yields.ok) == ("sp of planet 1", 1.2, False)
    assert (shakes.contact, shakes.value, shakes.ok) == ("wro of planet 2", 0.9, True)
    assert least_life(found) == 1.18e7
    assert "life under the torque would be 1.18e7 h" in equal_branches_note(found)
    assert checks["branch_slip_in_rolling"].ok


def test_a_branch_that_slips_leaves_the_shortest_life_unknown(unequal_branches):
    """The loose planet 3 has no life and does no harm; planet 2, pressed and slipping, may live shorter than any."""
    state = dataclasses.replace(unequal_branches().standing, preload=np.array([1100.0, 950.0, 0.0]))
    lives = {
        "known": [400.0, 900.0, np.nan],
        "slips": [400.0, np.nan, np.nan],
        "unloaded": [np.inf, np.inf, np.nan],
    }
    found = {
        name: shortest_life(dataclasses.replace(state, limits={"life_hours": np.array(each)}))
        for name, each in lives.items()
    }
    assert (found["known"], found["unloaded"]) == (400.0, math.inf)
    assert math.isnan(found["slips"])
    assert math.isnan(shortest_life(None))


def test_a_joint_that_stands_has_no_requirement_in_rolling(unequal_branches):
    assert list(checks_of(unequal_branches())) == [
        "branch_slip",
        "branch_preload",
        "branch_pressure_over_first_yield",
    ]
    # but its worst branch is judged as its equal ones are: as if it rolled slowly
    slow = dataclasses.replace(
        unequal_branches().standing, limits={"shakedown_ratio": np.array([[0.5, 1.2, np.nan]] * 5)}
    )
    shakes = checks_of(unequal_branches(rolling=slow))["branch_shakedown_ratio"]
    assert (shakes.contact, shakes.value, shakes.ok) == ("sp of planet 2", 1.2, False)
    unknown = checks_of(unequal_branches(), turns=True)["branch_shakedown_ratio"]
    assert math.isnan(unknown.value)
    assert not unknown.ok
    assert math.isnan(least_life(unequal_branches()))


def test_words_name_the_planet_and_how_hard_it_is_pressed(unequal_branches):
    assert pressed(unequal_branches()) == "planet 1 is pressed 1.1 times as hard, and loose is planet 3"
    tight = unequal_branches(preload=np.array([1100.0, 900.0, 950.0]))
    assert pressed(tight) == "planet 1 is pressed 1.1 times as hard"
    assert equal_branches_note(tight).endswith("planet 1 is pressed 1.1 times as hard.")
    like = dataclasses.replace(tight, preload=np.full(3, 1.2 * tight.own_preload))
    assert pressed(like) == "every planet is pressed 1.2 times as hard"
    entry = {"first_slip_Nm": 3.598, "first_branch": 3, "first_contact": "sp", "first_event": "slips"}
    document = {"branch_is": "planet", "torque_capacity": entry}
    assert capacity_words(document, "torque_capacity") == "3.598 N·m: contact sp of planet 3 slips first"


def test_a_loose_branch_is_a_requirement_that_is_not_met(unequal_branches):
    check = checks_of(unequal_branches())["branch_preload"]
    assert (check.contact, check.value, check.ok, check.rule.severity) == ("planet 3", 0.0, False, "function")
    tight = unequal_branches(preload=np.array([1100.0, 900.0, 950.0]))
    check = checks_of(tight)["branch_preload"]
    assert (check.contact, check.value, check.ok) == ("planet 2", 0.9, True)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_a_torque_beyond_what_all_branches_carry_is_refused(unequal_branches, way):
    found = unequal_branches()
    refuse_beyond(found, way * 12.4)
    with pytest.raises(
        InputError, match=r"beyond what the branches carry together, 12\.5 N·m: all of them slip"
    ):
        refuse_beyond(found, way * 12.6)
    unknown = dataclasses.replace(found, capacity=dataclasses.replace(found.capacity, all_slip=math.nan))
    refuse_beyond(unknown, way * 1e9)  # no limit is known, so that none is crossed


def test_branches_that_do_not_roll_are_refused(unequal_branches):
    own = unequal_branches()
    refuse_no_rolling_together(dataclasses.replace(own, rolling=own.standing))
    with pytest.raises(
        NoSolutionError, match=r"under 5 N·m: .* roll up to 8 N·m, at which contact sp of planet 2 slips"
    ):
        refuse_no_rolling_together(own)
