"""Columns as a CSV file: every digit, and whole or not at all."""

import csv
import math

import numpy as np
import pytest

from asperity.cli.columns import write_columns
from asperity.errors import InputError


def test_no_digit_is_lost(tmp_path):
    file = tmp_path / "columns.csv"
    torque, stiffness = np.array([0.0, 0.1, 1.0 / 3.0]), [1e-300, math.pi, 5.04e6]
    write_columns({"torque [N*m]": torque, "stiffness, mean [N*m/rad]": stiffness}, str(file))
    with file.open(newline="") as source:
        head, *rows = csv.reader(source)
    assert head == ["torque [N*m]", "stiffness, mean [N*m/rad]"]
    assert [[float(cell) for cell in row] for row in rows] == list(
        map(list, zip(torque, stiffness, strict=True))
    )


def test_columns_of_unlike_length_write_nothing(tmp_path):
    with pytest.raises(ValueError, match="dimension"):
        write_columns({"a": [1.0, 2.0], "b": [1.0]}, str(tmp_path / "columns.csv"))
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_does_not_exist_is_told(tmp_path):
    with pytest.raises((InputError, OSError), match="nowhere"):
        write_columns({"a": [1.0]}, str(tmp_path / "nowhere" / "columns.csv"))
