"""A design as plain data: senses in words, and no number that JSON does not know."""

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.study.design.design_document import design_document
from asperity.study.design.design_result import DesignResult, LimitReport, StartReport


@pytest.fixture(autouse=True)
def judged(monkeypatch):
    """The designed joint is judged without solving it."""
    told = {"diagnostics": [{"name": "slip_ratio", "ok": True, "value": math.nan}], "no_result_because": None}
    monkeypatch.setattr(
        "asperity.study.design.design_document.found_diagnostics", lambda text: told if text == "text" else {}
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
    assert document["diagnostics"] == [{"name": "slip_ratio", "ok": True, "value": None}]
    assert document["no_result_because"] is None


def test_a_design_that_meets_its_limits_violates_none():
    assert design_document(design(1.0, feasible=True))["violation"] == 0.0
