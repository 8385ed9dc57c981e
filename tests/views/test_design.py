"""A design as it is shown: before and after, limits, starts of the search, and a Pareto front."""

import dataclasses

import numpy as np
import pytest
from designed import design_problem, design_result, slip_limit
from shown_blocks import sentences, tables

from asperity.study.design.design_problem import Variable
from asperity.study.design.design_result import StartReport
from asperity.views.blocks import Bullets, Heading, Paragraph
from asperity.views.design import design, design_warnings, front, front_warnings

LIMIT = slip_limit(0.1234)


def start(objective, *, converged=True, violation=0.0):
    return StartReport({}, objective, violation, converged)


@pytest.fixture(scope="module")
def found(case):
    """The paper's joint with twice its preload, which is the upper bound."""
    problem = design_problem(
        case,
        Variable("load.preload", 500.0, 2000.0, logarithmic=True),
        Variable("drive.planet_bore_diameter", 8e-3, 16e-3, logarithmic=False),
    )
    point = {"load.preload": 2000.0, "drive.planet_bore_diameter": 12e-3}
    return design_result(problem, point, LIMIT, (start(1.0),))


def test_the_goal_before_and_as_designed(found):
    goal, met, *_ = design(found)
    assert goal.text == (
        f"{found.problem.goal}, worst case of 2 torques: 30000 N·m/rad in joint.toml, 35000 N·m/rad as designed."
    )
    assert goal.text.startswith("largest torsional stiffness at the output, assembled")
    assert met == Paragraph("All limits are met.", strong=True, passed=True)


def test_free_numbers_limits_and_results(found):
    shown = tables(design(found))
    free = shown["Free numbers"]
    assert free.rows == [
        ("load.preload", "1000 N", "2000 N", "500 N", "2000 N", "upper"),
        ("drive.planet_bore_diameter", "–", "12 mm", "8 mm", "16 mm", ""),
    ]
    assert free.head == ("number of the file", "before", "design", "from", "to", "at bound")
    assert free.words == (0, 5)
    summary = shown["Before and design"]
    assert {row[2] for row in summary.rows} == {"–"}
    (limit,) = shown["Limits of the design, each where it is closest"].rows
    assert limit == ("slip ratio T/(mu N), sp", "0.8", "≤ 0.8", "5 N·m", "active", "0.123")


def test_limits_and_results_are_in_the_units_of_the_file(found):
    """8.7e8 Pa against 1.4e9 Pa; 6e8 Pa, 0.05 m and 2e4 N·m/rad before, 7e8 Pa, 0.04 m and nothing as designed."""
    pressed = dataclasses.replace(
        LIMIT,
        name="hertz_pressure",
        label="Hertz pressure",
        limit=1.4e9,
        value=8.7e8,
        active=False,
        multiplier=0.0,
    )
    before = {"hertz_pressure": 6e8, "envelope_diameter": 0.05, "assembly_stiffness_output": 2e4}
    after = {"hertz_pressure": 7e8, "envelope_diameter": 0.04, "assembly_stiffness_output": float("nan")}
    shown = tables(
        design(
            dataclasses.replace(
                found, limits=(LIMIT, pressed), summary_before=before, summary_after=after, at_bound={}
            )
        )
    )
    _, row = shown["Limits of the design, each where it is closest"].rows
    assert row == ("Hertz pressure, sp", "870 MPa", "≤ 1400 MPa", "5 N·m", "met", "")
    rows = [row[1:] for row in shown["Before and design"].rows]
    assert rows == [("50 mm", "40 mm"), ("600 MPa", "700 MPa"), ("20000 N·m/rad", "–")]


def test_steps_have_a_column_and_what_they_cost(found):
    stepped = dataclasses.replace(found.problem.variables[0], step=50.0)
    problem = dataclasses.replace(found.problem, variables=(stepped,))
    blocks = list(
        design(dataclasses.replace(found, problem=problem, objective_unrounded=35100.0, at_bound={}))
    )
    assert tables(blocks)["Free numbers"].head[-1] == "step"
    assert "35100 N·m/rad before rounding to the stated steps." in sentences(blocks)


def test_a_design_that_misses_its_limits_says_so(found):
    missed = dataclasses.replace(LIMIT, missed_by=0.1, value=0.88, active=False)
    failed = dataclasses.replace(found, feasible=False, limits=(missed,))
    blocks = list(design(failed))
    (strong,) = (block for block in blocks if isinstance(block, Paragraph) and block.strong)
    assert strong.passed is False
    assert strong.text.startswith("No design meets all limits; the best one misses a limit by 10 %")
    (row,) = tables(blocks)["Limits of the design, each where it is closest"].rows
    assert row[4] == "10 % off"


@pytest.mark.parametrize(
    ("starts", "said"),
    [
        ([start(1.0, converged=False)] * 2, "0 of 2 starts converged. "),
        ([start(1.0)], "The only start found an optimum. "),
        ([start(1.0)] * 2, "Both starts found the same optimum. "),
        ([start(each) for each in (1.0, 1.00001, 0.99999)], "All 3 starts found the same optimum. "),
        ([start(each) for each in (1.0, 1.0, 2.0)], "3 of 3 starts converged, to 2 different optima. "),
        ([start(1.0), start(1.0, converged=False)], "1 of 2 starts converged, to one optimum. "),
        ([start(1.0, violation=0.1), start(1.0)], "2 of 2 starts converged, to one optimum. "),
    ],
)
def test_starts_that_reach_nothing_have_no_values(found, starts, said):
    *_, last = design(dataclasses.replace(found, starts=tuple(starts)))
    assert last.text.startswith(said)


def test_warnings_of_the_designed_joint(found, paper_view):
    crossed = dataclasses.replace(
        found, diagnostics=found.diagnostics | {"diagnostics": paper_view.document["diagnostics"]}
    )
    blocks = list(design_warnings(crossed))
    assert any(block.items for block in blocks if hasattr(block, "items"))
    assert blocks[-1].text.startswith("Asperities alone: outside the range of this law")
    lost = {"diagnostics": None, "no_result_because": "it slips"}
    (said,) = sentences(design_warnings(dataclasses.replace(found, diagnostics=lost)))
    assert said.endswith("no result under the output torque of its file: it slips")


@pytest.mark.parametrize(("size", "shown"), [(3, 3), (31, 11), (1, 1)])
def test_some_designs_of_a_front_in_the_units_of_their_results(size, shown):
    """From 1000 N up to 2000 N, and 0.5 to 1 kg."""
    xarray = pytest.importorskip("xarray")
    dataset = xarray.Dataset(
        {
            "load.preload": ("design", np.linspace(1000.0, 2000.0, size)),
            "mass": ("design", np.linspace(0.5, 1.0, size)),
            "assembly_stiffness_output": ("design", np.linspace(3e4, 4e4, size)),
        }
    )
    (table,) = front(dataset, ["load.preload", "mass", "assembly_stiffness_output"])
    assert len(table.rows) == shown
    assert table.title.startswith(f"Pareto front of {size} design{'s' * (size > 1)}")
    assert table.title.endswith("of them, evenly spread") == (shown < size)
    assert [head.partition("\n")[2] for head in table.head] == ["N", "kg", "N·m/rad"]
    assert table.rows[0] == ("1000", "0.5", "30000")
    if size > 1:
        assert table.rows[-1] == ("2000", "1", "40000")


def test_limits_that_designs_of_a_front_cross_are_counted():
    slip, heat = {"label": "slip"}, {"label": "heat"}
    entries = [[slip, slip, heat], [slip], [], None]
    lost, heading, counted = front_warnings({"diagnostics": entries})
    assert lost.text == "1 designs have no result under the torque of the file."
    assert isinstance(heading, Heading)
    assert isinstance(counted, Bullets)
    assert list(counted.items) == ["slip: 2 of 3", "heat: 1 of 3"]
    (said,) = front_warnings({"diagnostics": [[], []]})
    assert said.text == "No warnings: all limits of the model are met."
