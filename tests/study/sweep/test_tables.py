"""Files hold what the dataset holds, with units, and replace nothing unasked."""

import csv

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.status import STATUS_NAMES
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.study.datasets import coordinate, dataset, rows_of
from asperity.study.parameters import parse_axis
from asperity.study.sweep.tables import check_table_path, write_table


@pytest.fixture
def small(case):
    status = np.array([[0, STATUS_NAMES.index("beyond_torque_capacity")], [0, 0]], dtype=np.int8)
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
        found={"published_stiffness_output": stiffness, "normal_force": forces},
        attributes={},
    )


def test_csv_names_units_and_reasons(small, tmp_path):
    write_table(small, tmp_path / "s.csv")
    with (tmp_path / "s.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert [row["load.preload [N]"] for row in rows] == ["900.0", "900.0", "1000.0", "1000.0"]
    assert [row["status_meaning"] for row in rows] == ["solved", "beyond_torque_capacity", "solved", "solved"]
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
        found={"clearance": gaps},
        table=table,
        attributes={},
    )
    rows = rows_of(found, "clearance")
    assert list(rows) == list(names)
    np.testing.assert_array_equal(np.stack([each.values for each in rows.values()]), gaps)
