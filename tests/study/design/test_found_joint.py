"""Warnings of the joints that a design has found are those that ``asperity joint`` prints."""

from types import SimpleNamespace

import pytest

from asperity.errors import NoSolutionError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.si_tables import si_values
from asperity.study.design import found_joint
from asperity.study.design.found_joint import found_diagnostics, front_diagnostics

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
        return SimpleNamespace(document={"diagnostics": entries})

    monkeypatch.setattr(found_joint, "solve_case", document)
    return seen


def test_all_limits_of_a_design_or_why_there_are_none(solved, case):
    text = joint_file_text(case, {"load.preload": 1200.0}, comment="designed")
    assert found_diagnostics(text) == {
        "diagnostics": [{"name": "a", "ok": True}, {"name": "b", "ok": True}],
        "no_result_because": None,
    }
    text = joint_file_text(case, {"load.preload": 400.0}, comment="designed")
    assert found_diagnostics(text) == {"diagnostics": None, "no_result_because": "slips"}
    assert solved == [1200.0, 400.0]


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
    found = found_diagnostics(text)
    assert found["diagnostics"] is None
    assert "missing" in found["no_result_because"]
