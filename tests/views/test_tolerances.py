"""Sensitivities, tolerances and allowed sizes, as they are shown."""

import numpy as np
import pytest
from shown_blocks import ARCMINUTE, cells, sentences, tables

from asperity.study.tolerances.allowed_deviations import AllowedDeviations, AllowedSize
from asperity.views.tolerances import (
    allowed_sizes,
    elasticities,
    intervals,
    said,
    unlike_branches,
    variance_shares,
)

xarray = pytest.importorskip("xarray", reason="the extra 'study' is not installed")
INPUTS = [
    "load.preload",
    "drive.planet_radius",
    "materials.steel.density",
    "drive.planet_radius (finished part)",
]


@pytest.fixture
def ranked():
    """A drift of 10 arcmin that falls by 2 arcmin a millimetre; in SI the slope would be some 0.58 rad/m."""
    slopes = [0.01 * ARCMINUTE, -2.0 * ARCMINUTE / 1e-3, 0.0, 15.0 * ARCMINUTE / 1e-3]
    elasticity = np.array([[1.0, -4.0, 0.0, 30.0], [0.5, 4e-18, 0.0, np.nan]])
    return xarray.Dataset(
        {
            "value": ("input", [1000.0, 0.02, 7800.0, 0.02]),
            "elasticity": (("result", "input"), elasticity),
            "derivative": (("result", "input"), [slopes, [1.0, 0.0, 0.0, np.nan]]),
            "result_value": ("result", [10.0 * ARCMINUTE, 0.9]),
        },
        coords={
            "input": INPUTS,
            "result": ["drift", "efficiency"],
            "result_name": ("result", ["drift of the output", "efficiency of the drive"]),
        },
    )


def test_of_one_result_the_derivative_in_the_units_of_the_file(ranked):
    blocks = list(elasticities(ranked, ["drift"]))
    (table,) = tables(blocks).values()
    assert table.title == "drift of the output: 10 arcmin"
    assert table.head == ("number of the file", "value", "elasticity", "derivative\narcmin")
    assert table.rows == [
        ("drive.planet_radius (finished part)", "20 mm", "+30", "15 per mm"),
        ("drive.planet_radius", "20 mm", "-4", "-2 per mm"),
        ("load.preload", "1000 N", "+1", "0.01 per N"),
    ]
    assert table.shares == pytest.approx([1.0, -4.0 / 30.0, 1.0 / 30.0])
    about, without = sentences(blocks)
    assert "Those of finished parts deviate while all other parts stay as they are" in about
    assert without == "No effect: materials.steel.density."


def test_of_several_results_the_elasticities_ordered_by_the_first(ranked):
    (table,) = tables(elasticities(ranked, ["drift", "efficiency"])).values()
    assert table.title == "Elasticities, ordered by those of the drift of the output"
    assert [row[2:] for row in table.rows] == [("+30", "–"), ("-4", "0"), ("+1", "+0.5")]


def test_the_most_of_many(ranked):
    blocks = list(elasticities(ranked, ["drift"], most=1))
    assert len(tables(blocks)["drift of the output: 10 arcmin"].rows) == 1
    assert "Of the file's 4 numbers, the 1 of most influence." in sentences(blocks)


@pytest.fixture
def spread():
    names = ["standing_torque_capacity", "drive_life", "standing_limiting_contact"]
    shares = np.array([[0.2, 0.8], [0.5, 0.5], [np.nan, np.nan]])
    return xarray.Dataset(
        {
            "nominal": ("result", [2.0, 3600.0, 0.0]),
            "mean": ("result", [2.1, 7200.0, np.nan]),
            "standard_deviation": ("result", [0.1, 3600.0, np.nan]),
            "quantiles": (("result", "quantile"), [[1.8, 2.1, 2.4], [-np.inf, 5.0, 36000.0], [np.nan] * 3]),
            "total_order": (("result", "input"), shares),
            "total_order_half_width": (("result", "input"), 0.01 * shares),
            "first_order": (("result", "input"), 0.9 * shares),
            "first_order_half_width": (("result", "input"), 0.01 * shares),
            "tolerance": ("input", [50.0, 5e-6]),
            "samples": (("result", "sample"), np.array([[2.0] * 8, [1.0] * 8, [0.0] * 6 + [1.0] * 2])),
            "failed": ("result", [0.0, 0.015, 0.0]),
            "status": ("sample", np.zeros(8, dtype=np.int8)),
        },
        coords={
            "result": names,
            "input": ["load.preload", "drive.sun_radius"],
            "distribution": ("input", ["uniform", "normal 2 sigma"]),
            "finished_part": ("input", [False, True]),
            "result_name": ("result", ["capacity", "life", "contact that slips first"]),
            "unit": ("result", ["N*m", "s", "1"]),
            "categories": ("result", ["", "", "sp pwr"]),
        },
        attrs={"seed": 0},
    )


def test_intervals_have_the_units_of_their_results(spread):
    """A life of 3600 s is one hour; one that fails is as bad as can be; what is no quantity has shares."""
    blocks = list(intervals(spread))
    (table,) = tables(blocks).values()
    assert table.rows == [
        ("capacity", "N·m", "2", "2.1", "0.1", "1.8", "2.4"),
        ("life", "h", "1", "2", "1", "fails", "10"),
    ]
    told = sentences(blocks)
    assert any("1.5 % of the drives fail and have no life" in text for text in told)
    assert "Contact that slips first: sp in 75.00 %, pwr in 25.00 %." in told
    assert told[-1].endswith("all other parts stay as they are, and adds to the interference.")
    assert said(spread, "drive_life") == "life"


def test_shares_of_the_variance_the_largest_first(spread):
    (table,) = variance_shares(spread, ["standing_torque_capacity"])
    assert table.title == "Contributions to the variance of the capacity (Sobol indices, ± 95 %)"
    assert table.rows == [
        ("drive.sun_radius", "0.005 mm", "normal 2 sigma", "0.720 ± 0.008", "0.800 ± 0.008"),
        ("load.preload", "50 N", "uniform", "0.180 ± 0.002", "0.200 ± 0.002"),
    ]
    assert table.shares == pytest.approx([0.8, 0.2])
    (several,) = variance_shares(spread, ["standing_torque_capacity", "drive_life"])
    assert [row[3:] for row in several.rows] == [("0.8", "0.5"), ("0.2", "0.5")]
    assert list(variance_shares(spread, ["standing_limiting_contact"])) == []


def test_drives_whose_branches_are_drawn():
    scatter = {
        "first_slip_Nm": [8.0, 9.0, 10.0],
        "all_slip_Nm": [9.0, 10.0, 11.0],
        "rolling_first_slip_Nm": None,
        "largest_share": [0.34, 0.36, 0.4],
        "largest_rolling_share": [0.34, 0.36, 0.4],
        "sun_force_N": [1.0, 2.0, 3.0],
        "equal_branches_Nm": 12.0,
        "share_with_a_loose_branch": 0.01,
        "share_that_slips_under_the_torque": 0.125,
        "share_without_a_balance": 0.0,
    }
    table, told = unlike_branches(scatter, 200)
    assert table.title == "200 drives with branches of their own sizes"
    rows = cells(table)
    assert rows["first branch slips, standing"] == ("N·m", "8", "9", "10")
    assert rows["first branch slips, rolling"] == ("N·m", "–", "–", "–")
    assert rows["largest share of a branch, standing"] == ("%", "34", "36", "40")
    assert told.text.startswith("Equal branches pass 12 N·m; a branch is loose in 1 % and slips under")
    assert told.text.endswith("in 12.5 % of the drives.")
    _, without = unlike_branches(scatter | {"share_without_a_balance": 0.05}, 200)
    assert without.text.endswith("; 5 % have no balance.")


def test_allowed_sizes_with_their_grades(planar_case):
    """A deviation of the radius is a width of four times that on the diameter."""
    sizes = (
        AllowedSize("drive.sun_radius", 0.02, 0.9e-6, "IT3", 0.25),
        AllowedSize("load.interference", 0.1, 1e-8, "", 0.1),
    )
    allowed = AllowedDeviations(sizes, ("drive.planet_radius",), 9990, 10_000, 0.999)
    table, told, without = allowed_sizes(allowed, planar_case("planetary"))
    assert table.rows == [
        ("drive.sun_radius", "20 mm", "0.9 µm", "3.6 µm", "IT3", "25 %/µm"),
        ("load.interference (bore)", "100 mm", "0.01 µm", "0.04 µm", "finer than IT01", "10 %/µm"),
    ]
    assert told.text.startswith("9990 of 10000 drives keep all limits (99.9 % are asked for).")
    assert without.text == "No influence: drive.planet_radius."
