"""Results of studies as datasets: dimensions, units, and rows by their names."""

import numpy as np
import pytest

from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.results import RESULTS
from asperity.study.datasets import (
    dataset,
    key_attributes,
    number_or_null,
    result_attributes,
    result_rows,
    row_coordinates,
    row_dimensions,
    rows_of,
)

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
        found={"mass": np.array([1.0, 1.0, np.nan]), "slip_ratio": SLIP},
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
