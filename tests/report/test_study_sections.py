"""Sections of a report on sensitivities, tolerances and a design."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from designed import design_problem, design_result, slip_limit

from asperity.joint_file.any_joint import results_of
from asperity.joint_file.reader import read_case
from asperity.joint_file.si_tables import si_values
from asperity.report.study_sections import STUDIED, ReportStudies, study_files, study_sections
from asperity.study.design.design_problem import Variable
from asperity.views.blocks import Heading, Listing, Paragraph, Picture, Table

xarray = pytest.importorskip("xarray", reason="the extra 'study' is not installed")
ROOT = Path(__file__).parents[2]
PATHS = ["load.preload", "drive.sun_radius"]


@pytest.fixture
def sensitivities():
    """The radius moves every result by -2 % per %, the preload by 0.5 %."""
    elasticity = np.tile([0.5, -2.0], (len(STUDIED), 1))
    elasticity[1, 0] = 4e-18  # what rounding leaves of nothing
    return xarray.Dataset(
        {
            "elasticity": (("result", "input"), elasticity),
            "derivative": (("result", "input"), elasticity),
            "value": ("input", [1000.0, 4e-3]),
            "result_value": ("result", np.ones(len(STUDIED))),
        },
        coords={
            "result": list(STUDIED),
            "input": PATHS,
            "result_unit": ("result", ["1"] * len(STUDIED)),
            "input_name": ("input", ["preload", "sun radius"]),
            "result_name": ("result", [f"{name} of this drive" for name in STUDIED]),
        },
    )


@pytest.fixture
def spread():
    count, samples = len(STUDIED), 200
    per_input = np.tile([0.2, 0.8], (count, 1))
    return xarray.Dataset(
        {
            "nominal": ("result", np.full(count, 2.0)),
            "mean": ("result", np.full(count, 2.1)),
            "standard_deviation": ("result", np.full(count, 0.1)),
            "quantiles": (
                ("result", "quantile"),
                [*np.tile([1.8, 2.1, 2.4], (count - 1, 1)), [-np.inf, 1.8, 2.4]],
            ),
            "total_order": (("result", "input"), per_input),
            "total_order_half_width": (("result", "input"), 0.01 * per_input),
            "first_order": (("result", "input"), per_input),
            "first_order_half_width": (("result", "input"), 0.01 * per_input),
            "tolerance": ("input", [50.0, 5e-6]),
            "samples": (("result", "sample"), np.linspace(1.8, 2.4, samples) * np.ones((count, 1))),
            "failed": ("result", [0.0, 0.0, 0.015, 0.015, 0.5]),
            "status": ("sample", np.r_[np.zeros(samples - 3), np.ones(3)].astype(np.int8)),
        },
        coords={
            "result": list(STUDIED),
            "input": PATHS,
            "distribution": ("input", ["uniform", "normal 2 sigma"]),
            "finished_part": ("input", [False, True]),
            "input_name": ("input", ["preload", "sun radius"]),
            "result_name": ("result", [f"{name} of this drive" for name in STUDIED]),
            "unit": ("result", ["1"] * count),
            "categories": ("result", [""] * count),
        },
        attrs={"seed": 0},
    )


@pytest.fixture
def designed(case, monkeypatch):
    from matplotlib.figure import Figure

    monkeypatch.setattr(
        "asperity.study.design.design_plot.design_figure", lambda result, width: Figure(figsize=(width, 2.0))
    )
    problem = design_problem(case, Variable("load.preload", 500.0, 2000.0, logarithmic=True))
    return design_result(problem, {"load.preload": 2000.0}, slip_limit(0.1))


def of(kind, blocks):
    return [block for block in blocks if isinstance(block, kind)]


@pytest.mark.parametrize(
    "name", ["zou2025", "planetary", "multiroller", "stepped_planet", "planar", "wheel_pair"]
)
def test_every_drive_has_the_results_that_are_studied(name):
    table = results_of(si_values(read_case(ROOT / "examples" / f"{name}.toml")))
    assert all(table[each].differentiable and not table[each].categories for each in STUDIED)


def test_nothing_is_shown_of_studies_that_were_not_made():
    assert list(study_sections(ReportStudies())) == list(study_files(ReportStudies())) == []


def test_sensitivities_are_ordered_by_their_size(sensitivities):
    blocks = list(study_sections(ReportStudies(sensitivities)))
    assert blocks[0] == Heading("Sensitivities")
    (table,) = of(Table, blocks)
    assert [row[:3] for row in table.rows] == [
        ("drive.sun_radius", "4 mm", "-2"),
        ("load.preload", "1000 N", "+0.5"),
    ]
    assert [row[3] for row in table.rows] == ["-2", "0"]
    assert table.title == "Elasticities, ordered by those of the assembly_stiffness_output of this drive"
    assert {len(row) for row in table.rows} == {len(table.head)} == {2 + len(STUDIED)}
    assert len(of(Picture, blocks)) == 1
    again = list(study_sections(ReportStudies(sensitivities)))
    assert [each.svg for each in of(Picture, again)] == [each.svg for each in of(Picture, blocks)]


def test_tolerances_say_how_many_joints_and_who_contributes(spread):
    blocks = list(study_sections(ReportStudies(spread=spread)))
    assert blocks[0] == Heading("Tolerances")
    counted = "the quantiles count them as the worst, mean and standard deviation leave them out"
    drawn, *said = (block.text for block in of(Paragraph, blocks))
    assert drawn.startswith("200 joints drawn from the tolerances of the joint file, seed 0. The shares")
    assert said == [
        f"1.5 % of the drives fail and have no drift of this drive, efficiency of this drive: {counted}.",
        f"50 % of the drives fail and have no drive_life of this drive: {counted}.",
        said[-1],
    ]
    assert said[-1].endswith("all other parts stay as they are, and adds to the interference.")
    intervals, shares = of(Table, blocks)
    assert intervals.rows[1] == (
        "standing_torque_capacity of this drive", "N·m", "2", "2.1", "0.1", "1.8", "2.4",
    )  # fmt: skip
    assert intervals.rows[-1][-2:] == ("fails", "6.6667e-4")  # 2.4 s in hours
    assert [row[:4] for row in shares.rows] == [
        ("drive.sun_radius", "0.005 mm", "normal 2 sigma", "0.8"),
        ("load.preload", "50 N", "uniform", "0.2"),
    ]


def test_a_design_is_shown_before_and_after_with_its_limits_and_files(designed):
    studies = ReportStudies(design=designed, design_name="d.toml", design_text="joint = 'a'\n")
    blocks = list(study_sections(studies))
    said = [block.text for block in of(Paragraph, blocks)]
    assert said[0] == "What d.toml asks for:"
    assert said[1].startswith(
        "largest torsional stiffness at the output, assembled (upper bound: pins rigid), worst case of 2 torques: "
    )
    assert said[1].endswith("30000 N·m/rad in joint.toml, 35000 N·m/rad as designed.")
    assert said[2] == "All limits are met."
    free, summary, limits = of(Table, blocks)
    assert free.rows == [("load.preload", "1000 N", "2000 N", "500 N", "2000 N", "upper")]
    assert {row[2] for row in summary.rows} == {"–"}
    assert limits.rows == [("slip ratio T/(mu N), sp", "0.8", "≤ 0.8", "5 N·m", "active", "0.1")]
    assert [block.text for block in of(Listing, study_files(studies))] == ["joint = 'a'\n", "# designed\n"]


def test_a_design_that_misses_its_limits_says_so(designed):
    missed = dataclasses.replace(designed.limits[0], missed_by=0.1, value=0.88)
    failed = dataclasses.replace(designed, feasible=False, limits=(missed,))
    blocks = list(study_sections(ReportStudies(design=failed)))
    (strong,) = [block for block in of(Paragraph, blocks) if block.strong]
    assert strong.text.startswith("No design meets all limits; the best one misses a limit by 10 %")
    assert of(Table, blocks)[2].rows[0][-2] == "10 % off"
