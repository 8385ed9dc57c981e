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
    conflict,
    design_document,
    front_diagnostics,
    joint_diagnostics,
    not_limited,
)


def limit(name, *, at_most, limit, value, missed_by=0.0, active=True, row="", label=""):
    return LimitReport(name, label or name, row, at_most, limit, value, missed_by, active, 0.5, False, 5.0)


def result(limits, at_bound=()):
    found = SimpleNamespace(limits=limits, at_bound=dict(at_bound), feasible=False)
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
        "(no value there, none of any design: there is none where the input stands, at 5 N·m)"
    )
    stiffness = limit("slip_safety", at_most=False, limit=1.0, value=math.nan, missed_by=math.nan)
    assert stiffness.text.endswith("(no value there, none of any design, at 5 N·m)")


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


@pytest.fixture
def judged(monkeypatch):
    """The designed joint is judged without solving it."""
    told = {"diagnostics": [{"name": "slip_ratio", "ok": True, "value": math.nan}], "no_result_because": None}
    monkeypatch.setattr(
        "asperity.study.design.design_result.joint_diagnostics", lambda text: told if text == "text" else {}
    )


def design(sign, **changes):
    limit = LimitReport("slip_ratio", "slip ratio", "sp", True, 0.5, 0.55, 0.1, True, 0.5, False, 5.0)
    start = dict.fromkeys(StartReport.__dataclass_fields__, 0.0)
    numbers = {
        "problem": SimpleNamespace(
            objectives=[SimpleNamespace(name="mass", sign=sign)],
            table={"mass": SimpleNamespace(label="mass of two discs")},
        ),
        "feasible": False,
        "point": {"load.preload": 900.0},
        "at_bound": {"load.preload": "lower"},
        "objective_before": 2.0,
        "objective_after": 1.5,
        "objective_unrounded": None,
        "summary_before": {"drift": math.nan},
        "summary_after": {"drift": 1e-3},
        "limits": (limit,),
        "optimality_residual": math.inf,
        "starts": (StartReport(**start),),
        "evaluations": 12,
        "joint_text": "text",
        "nominal": {"slip_ratio": np.array([0.4, math.nan])},
    }
    return DesignResult(**(numbers | changes))


@pytest.mark.parametrize(("sign", "sense"), [(1.0, "minimise"), (-1.0, "maximise")])
def test_plain_data(judged, sign, sense):
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
    assert document["diagnostics"] == [{"name": "slip_ratio", "ok": True, "value": None}]
    assert document["no_result_because"] is None


def test_a_design_that_meets_its_limits_violates_none(judged):
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
    entry = {"name": "pressure_over_first_yield", "ok": False, "value": 1.2}
    told = {"diagnostics": [entry, entry | {"value": 1.25}, entry | {"value": None}], "life_hours": 137.0}

    def line(*names, **changes):
        limits = tuple(limit(name, at_most=True, limit=1.0, value=0.5) for name in names)
        return not_limited(
            design(1.0, limits=limits, summary_after={"hertz_pressure": 2.663e9}), told | changes
        )

    life, pressure = "a life of 137 h", "a pressure of 2663 MPa, up to 1.25 times that of first yield"
    assert (
        line("slip_ratio")
        == f"No limit of yield and life was asked for: the design has {pressure} and {life}."
    )
    assert line("hertz_pressure") == f"No limit of life was asked for: the design has {life}."
    assert line("drive_life", "hertz_pressure") == ""
    assert line("duty_life", diagnostics=[entry | {"ok": True}]) == ""
    assert line("slip_ratio", diagnostics=None, life_hours=None) == ""


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
