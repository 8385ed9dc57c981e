"""Results of studies as datasets: dimensions, units, and rows by their names."""

import csv
import subprocess
import sys

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.results import RESULTS
from asperity.study.datasets import (
    check_table_path,
    coordinate,
    dataset,
    key_attributes,
    number_or_null,
    result_attributes,
    result_rows,
    row_coordinates,
    row_dimensions,
    rows_of,
    write_table,
)
from asperity.study.parameters import parse_axis

pytest.importorskip("xarray")

TORQUE = np.array([0.0, 5.0, 20.0])
SLIP = np.arange(15.0).reshape(5, 3)


@pytest.fixture(scope="module")
def table(case):
    return results_of(si_values(case))


@pytest.fixture(scope="module")
def found(table):
    return dataset(
        table=table,
        dimensions=("load.output_torque",),
        coordinates={
            "load.output_torque": (("load.output_torque",), TORQUE, key_attributes("load.output_torque"))
        },
        status=np.array([0, 0, 3], dtype=np.int8),
        result_values={"mass": np.array([1.0, 1.0, np.nan]), "slip_ratio": SLIP},
        attributes={"title": "a test"},
    )


def test_numbers_for_json():
    assert number_or_null(np.float64(1.5)) == 1.5
    assert [number_or_null(value) for value in (np.nan, np.inf, -np.inf)] == [None] * 3


def test_rows_come_first_and_have_names(found):
    assert found["slip_ratio"].dims == ("contact", "load.output_torque")
    assert found["mass"].dims == ("load.output_torque",)
    assert found["contact"].values.tolist() == ["sp", "pwr", "pwl", "wro", "wlo"]
    rows = rows_of(found, "slip_ratio")
    assert list(rows) == ["sp", "pwr", "pwl", "wro", "wlo"]
    np.testing.assert_array_equal(rows["pwl"].values, [6.0, 7.0, 8.0])
    assert list(rows_of(found, "mass")) == [""]


def test_everything_has_its_unit(found):
    assert found["load.output_torque"].attrs["units"] == "N*m"
    assert found["mass"].attrs == {"units": "kg", "long_name": RESULTS["mass"].label}
    assert result_attributes(RESULTS["drift"])["units"] == "rad"
    # rows that a joint does not have are nan, and the file says so
    assert "nan for bodies that do not bend" in result_attributes(RESULTS["rim_yield_safety"])["comment"]
    assert key_attributes("drive.sun_radius")["units"] == "m"
    # codes of the status are told in the file itself
    assert len(found["status"].attrs["flag_meanings"].split()) == len(found["status"].attrs["flag_values"])


def test_names_of_all_numbers_of_some_results(table):
    rows = result_rows(table[name] for name in ("mass", "slip_ratio", "axial_thrust"))
    assert rows[0] == ("mass", "kg", "mass of the rolling parts")
    assert [name for name, _, _ in rows[1:6]] == [
        f"slip_ratio_{c}" for c in ("sp", "pwr", "pwl", "wro", "wlo")
    ]
    assert rows[1][1:] == ("1", "slip ratio T/(mu N), sp")
    assert len(rows) == 1 + 5 + table["axial_thrust"].row_shape[0]


def test_every_axis_has_a_coordinate_with_a_meaning(table):
    for result in table.values():
        for dimension in row_dimensions(result):
            (dims, values, attributes) = row_coordinates([result])[dimension]
            assert dims == (dimension,)
            assert values.shape == result.row_shape
            assert attributes["long_name"]


@pytest.fixture
def small(case):
    status = np.array([[0, STATUS_NAMES.index("beyond_standing_capacity")], [0, 0]], dtype=np.int8)
    stiffness = np.array([[1.0, np.nan], [3.0, 4.0]])
    forces = np.arange(20.0).reshape(5, 2, 2)
    return dataset(
        table=results_of(si_values(case)),
        dimensions=("load.preload", "load.output_torque"),
        coordinates={
            "load.preload": (
                ("load.preload",),
                np.array([900.0, 1000.0]),
                {"units": "N", "long_name": "preload"},
            ),
            "load.output_torque": (
                ("load.output_torque",),
                np.array([0.0, 20.0]),
                {"units": "N*m", "long_name": "t"},
            ),
        },
        status=status,
        result_values={"published_stiffness_output": stiffness, "normal_force": forces},
        attributes={},
    )


def test_csv_names_units_and_reasons(small, tmp_path):
    write_table(small, tmp_path / "s.csv")
    with (tmp_path / "s.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["load.preload [N]"] for row in rows] == ["900.0", "900.0", "1000.0", "1000.0"]
    assert [row["status_meaning"] for row in rows] == [
        "solved",
        "beyond_standing_capacity",
        "solved",
        "solved",
    ]
    assert [row["published_stiffness_output [N*m/rad]"] for row in rows] == ["1.0", "", "3.0", "4.0"]
    assert [row["normal_force_pwr [N]"] for row in rows] == ["4.0", "5.0", "6.0", "7.0"]
    assert list(tmp_path.iterdir()) == [tmp_path / "s.csv"]


def test_parquet_is_the_same_table(small, tmp_path):
    import pandas

    write_table(small, tmp_path / "s.parquet")
    write_table(small, tmp_path / "s.csv")
    one, other = pandas.read_parquet(tmp_path / "s.parquet"), pandas.read_csv(tmp_path / "s.csv")
    assert list(one.columns) == list(other.columns)
    np.testing.assert_array_equal(one["normal_force_wlo [N]"], other["normal_force_wlo [N]"])


def test_netcdf_keeps_everything(small, tmp_path):
    import xarray

    write_table(small, tmp_path / "s.nc")
    with xarray.open_dataset(tmp_path / "s.nc", engine="h5netcdf") as again:
        xarray.testing.assert_equal(again.load(), small)
        assert again["normal_force"].attrs["units"] == "N"
        assert again["status"].attrs["flag_meanings"] == small["status"].attrs["flag_meanings"]


def test_refusals(tmp_path):
    (tmp_path / "s.csv").write_text("mine")
    with pytest.raises(InputError, match="exists already"):
        check_table_path(tmp_path / "s.csv", overwrite=False)
    check_table_path(tmp_path / "s.csv", overwrite=True)
    with pytest.raises(InputError, match=r"\.zarr, \.nc, \.parquet, \.csv"):
        check_table_path(tmp_path / "s.xlsx", overwrite=False)
    with pytest.raises(InputError, match="no folder"):
        check_table_path(tmp_path / "nowhere" / "s.csv", overwrite=False)
    (tmp_path / "d.csv").mkdir()
    with pytest.raises(InputError, match="exists already"):
        check_table_path(tmp_path / "d.csv", overwrite=True)


def test_clearances_are_a_result_and_have_rows(case):
    table, axis = results_of(si_values(case)), parse_axis("load.output_torque=0 N*m:5 N*m:2")
    names = table["clearance"].row_names
    gaps = np.arange(2.0 * len(names)).reshape(len(names), 2)
    found = dataset(
        dimensions=(axis.path,),
        coordinates={axis.path: coordinate(axis)},
        status=np.zeros(2, dtype=np.int8),
        result_values={"clearance": gaps},
        table=table,
        attributes={},
    )
    rows = rows_of(found, "clearance")
    assert list(rows) == list(names)
    np.testing.assert_array_equal(np.stack([each.values for each in rows.values()]), gaps)


@pytest.mark.slow
def test_a_disk_that_is_full_is_one_message_and_leaves_nothing(tmp_path):
    """HDF5 ends a process that cannot write to its file; a largest file size stands for the full disk."""
    program = (
        "import resource, sys, numpy, xarray; resource.setrlimit(resource.RLIMIT_FSIZE, (50_000, 50_000)); "
        "from asperity.study.datasets import write_table; "
        "write_table(xarray.Dataset({'a': ('x', numpy.random.rand(30_000))}), sys.argv[1])"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, str(tmp_path / "s.nc")], capture_output=True, text=True
    )
    assert done.returncode == 1
    assert done.stderr.rstrip().endswith("s.nc: cannot be written: File too large")
    assert list(tmp_path.iterdir()) == []
