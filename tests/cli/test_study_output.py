"""Points as they are printed: units of the key, counts of each status, nan as a dash."""

import numpy as np
import pytest

from asperity.cli.study_output import (
    show_points,
    show_status,
    status_counts,
)
from asperity.joint.status import STATUS_NAMES
from asperity.results import RESULTS
from asperity.units import from_si

xarray = pytest.importorskip("xarray")
SLIPS = STATUS_NAMES.index("beyond_standing_capacity")


@pytest.fixture
def found():
    """Two preloads by two planet radii in SI units; one point slips."""
    dims = ("load.preload", "drive.planet_radius")
    stiffness = np.array([[5.0e6, 4.5e6], [4.0e6, np.nan]])
    return xarray.Dataset(
        {
            "status": (dims, np.array([[0, 0], [0, SLIPS]], dtype=np.int8)),
            "published_stiffness_output": (dims, stiffness),
        },
        coords={"load.preload": [1000.0, 800.0], "drive.planet_radius": [0.0135, 0.0136]},
    )


def test_counts_of_an_array_and_of_chunks(found):
    assert status_counts(found) == {0: 3, SLIPS: 1}
    pytest.importorskip("dask")
    assert status_counts(found.chunk({"load.preload": 1})) == {0: 3, SLIPS: 1}


def test_status_in_words(found, capsys):
    show_status(found)
    found["status"][0, 0] = -1
    show_status(found)
    told = capsys.readouterr().out.splitlines()
    slips = "  1 not solved: the output torque is beyond the standing torque capacity: a contact slips"
    assert told == [
        "4 points, 3 solved",
        slips,
        "4 points, 2 solved",
        "  1 not solved: not computed",
        slips,
    ]


def test_slip_that_skew_makes_in_rolling_is_told_beside_the_status(found, capsys):
    """A joint that stands has its results; that it slips once it turns is no status."""
    ratio = np.full((2, 2, 2), 0.5)
    ratio[0, 1, 1] = 1.4
    ratio[1, 1, 0] = np.nan
    found["rolling_slip_ratio"] = ((*found["status"].dims, "contact"), ratio)
    show_status(found)
    told = capsys.readouterr().out.splitlines()
    assert (
        told[-1] == "  1 solved standing, but a contact slips as a whole in rolling: skew takes its friction"
    )
    found["rolling_slip_ratio"][0, 1, 1] = 0.9
    show_status(found)
    assert "rolling" not in capsys.readouterr().out


def test_points_are_shown_in_the_unit_of_the_key(found, capsys):
    found["status"] = found["status"].where(found["status"] == 0, STATUS_NAMES.index("unbalanced"))
    show_points(found, {})
    lines = capsys.readouterr().out.splitlines()
    head = lines[0].split("  ")
    for text in ("preload [N]", "planet radius [mm]", "published stiffness output [N·m/rad]", "status"):
        assert text in [word.strip() for word in head]
    rows = [line.split() for line in lines if line.strip().startswith(("1000", "800"))]
    assert rows == [
        ["1000", "13.5", "5e6"],
        ["1000", "13.6", "4.5e6"],
        ["800", "13.5", "4e6"],
        ["800", "13.6", "–", "unbalanced"],
    ]


def test_results_of_contacts_have_a_column_each_and_contacts_their_names(capsys):
    dims = ("load.preload",)
    contacts = ["sp", "pwr", "pwl", "wro", "wlo"]
    pressure = np.arange(1.0, 11.0).reshape(5, 2) * 1e8
    made = xarray.Dataset(
        {
            "status": (dims, np.zeros(2, dtype=np.int8)),
            "hertz_pressure": (("contact", *dims), pressure),
            "standing_limiting_contact": (
                dims,
                np.array([0.0, 4.0]),
                {"categories": "sp pwr pwl wro wlo none"},
            ),
        },
        coords={"load.preload": [800.0, 1000.0], "contact": contacts},
    )
    show_points(made, {})
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert ["800", "100", "300", "500", "700", "900", "sp"] in rows  # MPa
    assert ["1000", "200", "400", "600", "800", "1000", "wlo"] in rows


def test_no_number_is_cut_where_the_columns_do_not_fit(capsys):
    """Twelve results of twelve letters take more than one table; each has the coordinates, the last one the status."""
    dims = ("load.preload",)
    names = [name for name, each in RESULTS.items() if each.axis == "one" and not each.categories][:12]
    values = [-1.23456e-100 * (k + 1) for k in range(len(names))]
    made = xarray.Dataset(
        {"status": (dims, np.array([SLIPS], dtype=np.int8))}
        | {name: (dims, np.array([value])) for name, value in zip(names, values, strict=True)},
        coords={"load.preload": [800.0]},
    )
    show_points(made, {})
    text = capsys.readouterr().out
    assert "…" not in text
    assert max(map(len, text.splitlines())) <= 100
    rows = [line.split() for line in text.splitlines() if line.strip().startswith("800")]
    assert len(rows) > 1
    shown = [float(cell) for row in rows for cell in row[1:] if cell[0] == "-"]
    expected = [from_si(value, RESULTS[name].display_unit) for name, value in zip(names, values, strict=True)]
    np.testing.assert_allclose(shown, expected, rtol=1e-4)
    assert "beyond" in rows[-1]
    assert "beyond" not in rows[0]


def test_results_that_are_not_shown_are_named(capsys):
    dims = ("load.preload",)
    contacts = [f"c{k}" for k in range(30)]
    made = xarray.Dataset(
        {
            "status": (dims, np.zeros(1, dtype=np.int8)),
            "torque_capacity": (dims, np.array([12.0])),
            "hertz_pressure": (("contact", *dims), np.full((30, 1), 1e9)),
        },
        coords={"load.preload": [800.0], "contact": contacts},
    )
    show_points(made, {})
    text = capsys.readouterr().out
    assert "not shown: hertz_pressure; --out writes them all, --results chooses some" in text
    assert "torque capacity" in text


def test_results_that_are_bounds_are_named(capsys):
    dims = ("load.preload",)
    made = xarray.Dataset(
        {
            "status": (dims, np.zeros(1, dtype=np.int8)),
            "assembly_stiffness_output": (dims, [3e4], {"long_name": "stiffness (upper bound: pins rigid)"}),
            "torque_capacity": (dims, [12.0], {"long_name": "torque capacity"}),
        },
        coords={"load.preload": [800.0]},
    )
    show_points(made, {})
    assert "\nupper bound: pins rigid: assembly_stiffness_output\n" in capsys.readouterr().out
    show_points(made.drop_vars("assembly_stiffness_output"), {})
    assert "upper bound" not in capsys.readouterr().out


def test_bodies_that_do_not_bend_have_no_column_and_it_is_said(capsys):
    dims = ("load.output_torque",)
    made = xarray.Dataset(
        {
            "status": (dims, np.zeros(2, dtype=np.int8)),
            "rim_yield_safety": (("body", *dims), np.array([[np.nan, np.nan], [29.66, 28.5]])),
        },
        coords={"load.output_torque": [5.0, 10.0], "body": ["sun", "ring"]},
    )
    show_points(made, {})
    text = capsys.readouterr().out
    rows = [line.split() for line in text.splitlines() if line.strip().startswith(("5", "10"))]
    assert rows == [["5", "29.66"], ["10", "28.5"]]
    assert "no value of rim_yield_safety of sun: yield strength over the largest Mises stress" in text
    assert "nan for bodies that do not bend" in text
    assert "not shown" not in text


def test_a_column_of_statuses_stands_where_a_point_is_unsolved(found, capsys):
    show_points(found, {})
    assert "status" in capsys.readouterr().out
    show_points(found.isel({"load.preload": [0]}), {})
    assert "status" not in capsys.readouterr().out
