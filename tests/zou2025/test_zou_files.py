"""What lands in the output folder."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.zou2025.claims import judge
from asperity.zou2025.curves import Curves
from asperity.zou2025.files import output_folder, verdict_document, write_panel, write_tables, write_verdicts
from asperity.zou2025.panels import all_panels


def test_a_panel_becomes_a_picture_and_its_numbers(curves: Curves, tmp_path: Path) -> None:
    panel = next(p for p in all_panels(curves) if p.name == "5b")
    picture, table = write_panel(panel, tmp_path)
    assert picture.name == "figure_5b.png"
    assert picture.read_bytes().startswith(b"\x89PNG")
    with table.open(encoding="utf-8") as stream:
        header = next(csv.reader(stream))
    assert header == [
        "output_torque_Nm",
        *(f"tangential_force_{c}_N" for c in ("sp", "pwr", "pwl", "wro", "wlo")),
    ]
    numbers = np.loadtxt(table, delimiter=",", skiprows=1)
    assert numbers[-1, 1] == pytest.approx(46.296, abs=1e-3)
    np.testing.assert_array_equal(numbers[:, 0], panel.abscissa)  # all digits are kept


def test_tables(curves: Curves, tmp_path: Path) -> None:
    table_1, table_2 = write_tables(curves, tmp_path)
    with table_1.open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["case"] for row in rows] == list("abcdef")
    with table_2.open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["output_torque_Nm"]) for row in rows] == pytest.approx([0, 1, 2, 3, 4, 5])


def test_verdicts_are_plain_json(curves: Curves, tmp_path: Path) -> None:
    document = verdict_document(curves, judge(curves))
    read = json.loads(write_verdicts(document, tmp_path).read_text(encoding="utf-8"))
    assert read["claims"][0]["name"] == "C1"
    assert {c["name"] for c in read["criteria"]} >= {"nearly the same", "significantly"}
    assert read["assumptions"]


def test_a_folder_that_cannot_be_made_is_an_input_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="cannot make the folder"):
        output_folder(tmp_path / "file" / "below")
