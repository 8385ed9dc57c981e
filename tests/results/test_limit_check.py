"""A wedge that its pins hold: a state with a consequence, and a failure only where they cannot."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.joint.diagnostics import Diagnostics
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case
from asperity.results import SEVERITIES
from asperity.results.limit_check import checked_limits
from asperity.results.margins import margins
from asperity.results.solved import SolvedJoint, solved_with_capacities

PINS = '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "1500 N"\nstatic_rating = "{static} N"\ncount = 2\n\n[model]'


@pytest.fixture(scope="module")
def solved(solved_paper):
    return solved_with_capacities(*solved_paper)


@pytest.fixture(scope="module")
def paper(solved):
    return checked_limits(solved)


def by_name(entries, name):
    return {entry.contact: entry for entry in entries if entry.result.name == name}


def test_every_limit_is_listed_for_every_contact(solved, paper):
    names = {entry.result.name for entry in paper}
    near = solved.result.diagnostics
    there = {name for name in Diagnostics.__dataclass_fields__ if getattr(near, name) is not None}
    without_limit = {"hertz_half_width", "hertz_pressure"}
    others = {
        "balance_residual",
        "closure_residual",
        "fractal_dimension",
        "shakedown_ratio",
        "self_locking_ratio",
    }
    assert names == there - without_limit | others
    assert set(by_name(paper, "slip_ratio")) == {"sp", "pwr", "pwl", "wro", "wlo"}
    assert set(by_name(paper, "self_locking_ratio")) == {None}
    assert all(entry.meaning for entry in paper)


def test_the_most_serious_limits_come_first(paper):
    ranks = [SEVERITIES.index(entry.rule.severity) for entry in paper]
    assert ranks == sorted(ranks)
    assert len(set(ranks)) == 5


def test_the_facts_about_the_paper_s_joint(paper):
    """tan(beta/2) = 0.1153 with mu = 0.12; twice first yield at the sun; A_r beyond 2bB."""
    locking = by_name(paper, "self_locking_ratio")[None]
    assert locking.value == pytest.approx(0.1153 / 0.12, rel=1e-3)
    assert locking.ok
    sun = by_name(paper, "pressure_over_first_yield")["sp"]
    assert sun.value == pytest.approx(1.53e9 / (1.67 * 450e6), rel=2e-3)
    assert not sun.ok
    assert (sun.limit, sun.rule.severity) == (1.0, "damage")
    assert not by_name(paper, "real_area_over_hertz_area")["sp"].ok
    assert not by_name(paper, "asperity_over_bulk_stiffness")["sp"].ok
    for name in ("slip_ratio", "normal_force_over_preload", "fractal_dimension", "balance_residual"):
        assert all(entry.ok for entry in by_name(paper, name).values()), name


def test_an_undefined_value_is_not_ok(solved):
    """A lifted contact has no stiffness to compare."""
    near = solved.result.diagnostics
    lifted = dataclasses.replace(
        near,
        normal_force_over_preload=np.zeros(5),
        asperity_over_bulk_stiffness=np.full(5, math.nan),
    )
    result = dataclasses.replace(solved.result, diagnostics=lifted)
    entries = checked_limits(SolvedJoint(solved.joint, result, None))
    lifted = by_name(entries, "normal_force_over_preload")["sp"]
    assert (lifted.value, lifted.ok) == (0.0, False)
    undefined = by_name(entries, "asperity_over_bulk_stiffness")["sp"]
    assert math.isnan(undefined.value)
    assert not undefined.ok
    assert undefined.meaning.startswith("no value: the contact slips, has lifted off")


def judged(zou_file, *, friction, static=None):
    """mu against tan(beta/2) of the paper's wedge: beta = 13.158 deg gives 0.1153."""
    text = zou_file.read_text().replace("friction_coefficient = 0.12", f"friction_coefficient = {friction}")
    if static is not None:
        text = text.replace("\n[model]", PINS.format(static=static))
    solved = solved_case(parse_case(text, source="x"))
    check = next(each for each in checked_limits(solved) if each.result.name == "self_locking_ratio")
    margin = next(each for each in margins(solved) if each.result.name == "self_locking_ratio")
    return check, margin


def test_a_wedge_that_pins_hold_works(zou_file):
    check, margin = judged(zou_file, friction=0.1)
    assert check.value == pytest.approx(1.153, rel=1e-3)
    assert (check.ok, check.rule.severity, margin.severity, margin.state) == (
        False, "state", "state", "held by the pins",
    )  # fmt: skip
    assert " N (right loading roller) and " in check.meaning
    assert "not judged without [pin_bearing]" in check.meaning


@pytest.mark.long
def test_it_fails_where_the_bearings_of_the_pins_do(zou_file):
    strong, _ = judged(zou_file, friction=0.1, static=1200)
    weak, margin = judged(zou_file, friction=0.1, static=1)
    assert strong.rule.severity == "state"
    assert "the static safety of their bearings is " in strong.meaning
    assert (weak.rule.severity, margin.severity, margin.state) == ("function", "function", "")
    assert "more than the static rating" in weak.meaning


@pytest.mark.long
def test_a_safety_that_is_not_known_is_no_failure_of_the_pins(zou_file):
    """Under a load of the duty that the joint does not carry its bearings have no load, and no safety."""
    duty = '\n[[duty]]\noutput_torque = "900 N*m"\nsun_speed = "600 rpm"\nshare = 1.0\n'
    text = zou_file.read_text().replace("friction_coefficient = 0.12", "friction_coefficient = 0.1")
    text = text.replace("\n[model]", duty + PINS.format(static=1200))
    checks = checked_limits(solved_case(parse_case(text, source="x")))
    assert all(math.isnan(each.value) for each in checks if each.result.name == "bearing_static_safety")
    check = next(each for each in checks if each.result.name == "self_locking_ratio")
    assert (check.rule.severity, check.rule.state) == ("state", "held by the pins")
    assert check.meaning.endswith("the static safety of their bearings is not known")


def test_a_wedge_that_holds_itself_has_no_state(zou_file):
    check, margin = judged(zou_file, friction=0.12)
    assert check.ok
    assert (margin.passes, margin.state) == (True, "")
    assert dataclasses.replace(margin, passes=False).state  # only where it is crossed
