"""A conflict in words: the limits that restrict, what is reached of them, and the variables at their bounds."""

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.si_tables import si_values
from asperity.study.design.design_result import (
    DesignResult,
    LimitReport,
    StartReport,
    bounds_words,
    conflict,
    crossed_limits,
    design_document,
    front_diagnostics,
    joint_diagnostics,
    met_words,
    not_limited,
)


def limit(name, *, at_most, limit, value, missed_by=0.0, active=True, row="", label=""):
    return LimitReport(name, label or name, row, at_most, limit, value, missed_by, active, 0.5, False, 5.0)


def result(limits, at_bound=(), crossed=()):
    found = SimpleNamespace(limits=limits, at_bound=dict(at_bound), feasible=False, crossed=crossed)
    found.violation = DesignResult.violation.fget(found)
    return found


def test_a_limit_says_sense_value_share_and_torque():
    slip = limit(
        "slip_ratio",
        at_most=True,
        limit=0.5,
        value=0.55,
        missed_by=0.1,
        row="rollers_ring",
        label="friction used",
    )
    assert slip.text == "friction used at rollers ring at most 0.5 (reached 0.55, 10 % off, at 5 N·m)"
    kept = limit("preload", at_most=False, limit=400.0, value=410.0)
    assert kept.text == "preload at least 400 N (reached 410 N, at 5 N·m)"


def test_a_limit_without_a_value_says_why():
    drift = limit("drift_rate", at_most=True, limit=1e-5, value=math.nan, missed_by=math.nan)
    assert drift.text.endswith(
        "(no value there; no design has one: there is none where the input stands, at 5 N·m)"
    )
    stiffness = limit("slip_safety", at_most=False, limit=1.0, value=math.nan, missed_by=math.nan)
    assert stiffness.text.endswith("(no value there; no design has one, at 5 N·m)")


def test_a_conflict_names_the_active_limits_and_the_bounds():
    slip = limit("slip_ratio", at_most=True, limit=0.5, value=0.55, missed_by=0.1)
    load = limit("preload", at_most=True, limit=400.0, value=416.0, missed_by=0.04)
    idle = limit("mass", at_most=True, limit=1.0, value=0.5, active=False)
    found = result((slip, load, idle), {"load.preload": "upper"})
    text = conflict(found)
    assert found.violation == 0.1
    assert text.startswith(
        "no design meets all limits; the best one misses a limit by 10 %. These limits conflict: "
    )
    assert slip.text in text
    assert load.text in text
    assert idle.text not in text
    assert text.endswith("; load.preload is at its upper bound. Relax one of these, or widen the bounds")
    assert "conflict:" not in conflict(result((slip,)))
    ratio = limit("speed_ratio", at_most=True, limit=-11.0, value=-10.8, missed_by=0.02, active=False)
    assert ratio.text in conflict(result((slip, load, idle, ratio))), (
        "a limit that another one outweighs is missed too"
    )
    assert DesignResult.violation.fget(SimpleNamespace(feasible=True)) == 0.0


#: What a document says of a joint and of a limit that it crosses.
TOLD = {"diagnostics": [{"name": "slip_ratio", "ok": True, "value": math.nan}], "no_result_because": None}
CROSSED = {
    "name": "duty_shakedown_ratio",
    "label": "shakedown of the duty",
    "contact": "load 2",
    "shown": "1.2",
    "limit_shown": "1",
    "ok": False,
    "known": True,
    "meaning": "it flows",
    "severity": "damage",
    "value": 1.2,
}


def design(sign, **changes):
    limit = LimitReport("slip_ratio", "slip ratio", "sp", True, 0.5, 0.55, 0.1, True, 0.5, False, 5.0)
    start = dict.fromkeys(StartReport.__dataclass_fields__, 0.0)
    numbers = {
        "problem": SimpleNamespace(
            objectives=[SimpleNamespace(name="mass", sign=sign)],
            table={"mass": SimpleNamespace(label="mass of two discs", said="mass of two discs")},
        ),
        "feasible": False,
        "crossed": (),
        "allowed": (CROSSED,),
        "unknown": (),
        "point": {"load.preload": 900.0},
        "optimum": {"load.preload": 900.1},
        "at_bound": {"load.preload": "lower"},
        "objective_before": 2.0,
        "objective_after": 1.5,
        "objective_unrounded": None,
        "missed_before": (limit,),
        "summary_before": {"drift": math.nan},
        "summary_after": {"drift": 1e-3},
        "limits": (limit,),
        "optimality_residual": math.inf,
        "starts": (StartReport(**start),),
        "evaluations": 12,
        "joint_text": "text",
        "diagnostics": TOLD,
        "nominal": {"slip_ratio": np.array([0.4, math.nan])},
    }
    return DesignResult(**(numbers | changes))


@pytest.mark.parametrize(("sign", "sense"), [(1.0, "minimise"), (-1.0, "maximise")])
def test_plain_data(sign, sense):
    document = json.loads(json.dumps(design_document(design(sign)), allow_nan=False))
    assert document["objective"] == {
        "result": "mass",
        "label": "mass of two discs",
        "sense": sense,
        "before": 2.0,
        "after": 1.5,
        "unrounded": None,
    }
    assert document["violation"] == 0.1
    assert document["optimality_residual"] is None
    assert document["before"] == {"drift": None}
    assert document["nominal"] == {"slip_ratio": [0.4, None]}
    assert document["limits"][0]["value"] == 0.55
    assert document["limits"][0]["label"] == "slip ratio"
    assert document["evaluations"] == 12
    assert document["variables_unrounded"] == {"load.preload": 900.1}
    assert document["allowed"] == [CROSSED]
    assert document["missed_before"][0]["name"] == "slip_ratio"
    assert document["diagnostics"] == [{"name": "slip_ratio", "ok": True, "value": None}]
    assert document["no_result_because"] is None


def test_a_design_that_meets_its_limits_violates_none():
    assert design_document(design(1.0, feasible=True))["violation"] == 0.0


xarray = pytest.importorskip("xarray", reason="the extra 'study' is not installed")


@pytest.fixture
def solved(monkeypatch):
    """The files that were solved; a preload above 2 kN crosses a limit, below 500 N there is no joint."""
    seen = []

    def document(case):
        preload = si_values(case)["load"]["preload"]
        seen.append(preload)
        if preload < 500.0:
            raise NoSolutionError("slips")
        entries = [{"name": "a", "ok": True}, {"name": "b", "ok": preload < 2000.0}]
        return SimpleNamespace(document={"diagnostics": entries, "life_hours": 137.0})

    monkeypatch.setattr("asperity.study.design.design_result.solve_case", document)
    return seen


def test_all_limits_of_a_design_or_why_there_are_none(solved, case):
    text = joint_file_text(case, {"load.preload": 1200.0}, comment="designed")
    assert joint_diagnostics(text) == {
        "diagnostics": [{"name": "a", "ok": True}, {"name": "b", "ok": True}],
        "life_hours": 137.0,
        "no_result_because": None,
    }
    text = joint_file_text(case, {"load.preload": 400.0}, comment="designed")
    assert joint_diagnostics(text) == {"diagnostics": None, "no_result_because": "slips"}
    assert solved == [1200.0, 400.0]


def test_what_no_limit_was_asked_for_is_said_in_a_line():
    def line(*names, life=137.0):
        limits = tuple(limit(name, at_most=True, limit=1.0, value=0.5) for name in names)
        return not_limited(design(1.0, limits=limits, diagnostics=TOLD | {"life_hours": life}))

    assert (
        line("slip_ratio") == "The design file sets no limit for life: the design has a rating life of 137 h."
    )
    assert line("drive_life", "hertz_pressure") == line("duty_life") == line("slip_ratio", life=None) == ""


def test_which_crossed_limits_the_design_file_allows():
    """A wider limit for a result is leave for it; a life is required under a name of its own; notes are no damage."""
    entries = [
        CROSSED,
        CROSSED | {"name": "shakedown_ratio"},
        CROSSED | {"name": "required_drive_life"},
        CROSSED | {"name": "rim_yield_safety"},
        CROSSED | {"name": "film_ratio", "severity": "state"},
        CROSSED | {"name": "kept", "ok": True},
        CROSSED | {"name": "open", "known": False},
    ]
    constraints = [
        SimpleNamespace(name="shakedown_ratio", implied=False),
        SimpleNamespace(name="drive_life", implied=False),
        SimpleNamespace(name="rim_yield_safety", implied=True),
    ]
    found = crossed_limits(SimpleNamespace(constraints=constraints), {"diagnostics": entries})
    crossed, allowed, unknown = found
    assert [entry["name"] for entry in crossed] == ["duty_shakedown_ratio", "rim_yield_safety"]
    assert [entry["name"] for entry in allowed] == ["shakedown_ratio", "required_drive_life"]
    assert [entry["name"] for entry in unknown] == ["open"]
    assert crossed_limits(SimpleNamespace(constraints=[]), {"diagnostics": None}) == ((), (), ())


def test_all_limits_are_met_is_said_only_where_they_are():
    assert met_words(feasible=True, allowed=()) == "All limits are met"
    assert met_words(feasible=False, allowed=(CROSSED,)) == "NOT all limits are met"
    assert met_words(feasible=True, allowed=(CROSSED,)) == (
        "All limits of the design file are met, which allows: shakedown of the duty 1.2 at load 2, limit 1"
    )
    assert met_words(feasible=True, allowed=(), unknown=(CROSSED,)) == (
        "No limit is crossed; not known: shakedown of the duty at load 2 (it flows)"
    )


def test_what_the_search_does_not_follow_is_a_shortcoming():
    """All limits of the search are kept, but a load of the duty makes the surface flow."""
    kept = limit("preload", at_most=False, limit=400.0, value=410.0, active=False)
    text = conflict(result((kept,), crossed=(CROSSED,)))
    assert "that it does not: shakedown of the duty 1.2 at load 2, limit 1. Change what it depends on" in text
    missed = limit("slip_ratio", at_most=True, limit=0.5, value=0.55, missed_by=0.1)
    text = conflict(result((missed,), crossed=(CROSSED, CROSSED | {"name": "slip_ratio", "label": "twice"})))
    assert "It also misses: shakedown of the duty 1.2" in text
    assert "twice" not in text


def test_what_holds_a_design_is_said():
    """Bounds of variables and limits that are reached; a limit that is missed is said elsewhere."""
    reached = limit("hertz_pressure", at_most=True, limit=1.4e9, value=1.4e9, row="sp", label="pressure")
    least = limit("preload", at_most=False, limit=400.0, value=400.0)
    missed = limit("slip_ratio", at_most=True, limit=0.5, value=0.55, missed_by=0.1)
    idle = limit("mass", at_most=True, limit=1.0, value=0.5, active=False)
    found = result((reached, least, missed, idle), {"load.preload": "lower"})
    assert bounds_words(found) == (
        "load.preload at its lower bound; pressure at sp at its largest, 1400 MPa; preload at its smallest, 400 N"
    )
    assert bounds_words(result((idle,))) == ""


def test_crossed_limits_of_a_front_design_by_design(solved, case):
    preloads = [400.0, 1200.0, 2400.0]
    front = xarray.Dataset({"load.preload": ("design", preloads)})
    problem = SimpleNamespace(case=case, variables=[SimpleNamespace(path="load.preload")])
    steps = []
    found = front_diagnostics(problem, front, progress=lambda done, total: steps.append((done, total)))
    assert found["diagnostics"] == [None, [], [{"name": "b", "ok": False}]]
    assert found["no_result_because"] == ["slips", None, None]
    assert (solved, steps) == (preloads, [(1, 3), (2, 3), (3, 3)])


def test_a_planetary_is_read_as_one():
    text = "type = 'planetary'"
    found = joint_diagnostics(text)
    assert found["diagnostics"] is None
    assert "missing" in found["no_result_because"]
