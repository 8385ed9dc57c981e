"""A wedge that its pins hold: a state with a consequence, and a failure only where they cannot."""

import dataclasses

import pytest

from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solved_case
from asperity.results.limit_check import checked_limits
from asperity.results.margins import margins

PINS = '\n[pin_bearing]\ntype = "roller"\ndynamic_rating = "1500 N"\nstatic_rating = "{static} N"\ncount = 2\n\n[model]'


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


@pytest.mark.slow
def test_it_fails_where_the_bearings_of_the_pins_do(zou_file):
    strong, _ = judged(zou_file, friction=0.1, static=1200)
    weak, margin = judged(zou_file, friction=0.1, static=1)
    assert strong.rule.severity == "state"
    assert "static safety of" in strong.meaning
    assert (weak.rule.severity, margin.severity, margin.state) == ("function", "function", "")
    assert "more than the static rating" in weak.meaning


def test_a_wedge_that_holds_itself_has_no_state(zou_file):
    check, margin = judged(zou_file, friction=0.12)
    assert check.ok
    assert (margin.passes, margin.state) == (True, "")
    assert dataclasses.replace(margin, passes=False).state  # only where it is crossed
