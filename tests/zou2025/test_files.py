"""What lands in the output folder."""

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.zou2025.claims import judge
from asperity.zou2025.curves import Curves
from asperity.zou2025.files import output_folder, verdict_document, write_panel, write_verdicts
from asperity.zou2025.panels import all_panels


def test_a_panel_becomes_a_picture_and_its_numbers(curves: Curves, tmp_path: Path) -> None:
    panel = next(p for p in all_panels(curves) if p.name == "5b")
    write_panel(panel, tmp_path)
    table = tmp_path / "figure_5b.csv"
    assert (tmp_path / "figure_5b.png").read_bytes().startswith(b"\x89PNG")
    with table.open(encoding="utf-8") as stream:
        header = next(csv.reader(stream))
    assert header == [
        "output_torque_Nm",
        *(f"tangential_force_{c}_N" for c in ("sp", "pwr", "pwl", "wro", "wlo")),
    ]
    numbers = np.loadtxt(table, delimiter=",", skiprows=1)
    assert numbers[-1, 1] == pytest.approx(46.296, abs=1e-3)
    np.testing.assert_array_equal(numbers[:, 0], panel.abscissa)  # all digits are kept


@pytest.fixture
def folder(curves: Curves, tmp_path: Path) -> Path:
    write_verdicts(verdict_document(curves, judge(curves)), tmp_path)
    return tmp_path


def test_tables(folder: Path) -> None:
    with (folder / "table_1.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [row["case"] for row in rows] == list("abcdef")
    # N/mm at D = 1.4, the model reference
    assert float(rows[0]["tangential_stiffness_largest_N_per_mm"]) == pytest.approx(3.904e6, rel=6e-4)
    with (folder / "table_2.csv").open(encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    assert [float(row["output_torque_Nm"]) for row in rows] == pytest.approx([0, 1, 2, 3, 4, 5])
    # without losses the torque of the sun is a ninth of the output torque, shared by three contacts at 4 mm
    assert [float(row["tangential_force_sp_N"]) for row in rows] == pytest.approx(
        [torque / 9.0 / 3.0 / 4e-3 for torque in range(6)]
    )


def test_verdicts_are_plain_json(folder: Path) -> None:
    read = json.loads((folder / "claims.json").read_text(encoding="utf-8"))
    assert read["claims"][0]["name"] == "C1"
    assert {c["name"] for c in read["criteria"]} >= {"nearly the same", "significantly"}
    assert read["assumptions"]
    assert [row["case"] for row in read["table_1"]] == list("abcdef")


def test_a_folder_that_cannot_be_created_is_an_input_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with (
        pytest.raises(InputError, match="cannot create the folder"),
        output_folder(tmp_path / "file" / "below"),
    ):
        pass


def test_an_earlier_run_is_replaced_and_nothing_else(curves: Curves, folder: Path) -> None:
    panel = next(p for p in all_panels(curves) if p.name == "5b")
    (folder / "notes.txt").write_text("mine")
    for _ in range(2):
        with output_folder(folder):
            write_panel(panel, folder)
    (folder / "claims.json").unlink()  # as an interrupted run leaves it, in a folder that was there before
    for table in ("table_1.csv", "table_2.csv"):
        (folder / table).unlink()
    with output_folder(folder):
        write_panel(panel, folder)
    (folder / "figure_5b.png").write_bytes(b"\x89PNG of mine")
    with pytest.raises(InputError, match=r"figure_5b\.png is of no earlier run"), output_folder(folder):
        pass
    (folder / "figure_5b.png").unlink()
    with pytest.raises(InputError, match=r"figure_5b\.csv is of no earlier run"), output_folder(folder):
        pass
    (folder / "figure_5b.csv").unlink()
    (folder / "claims.json").symlink_to(folder / "notes.txt")
    with pytest.raises(InputError, match=r"claims\.json is of no earlier run"), output_folder(folder):
        pass
    assert (folder / "notes.txt").read_text() == "mine"


def test_what_was_created_for_an_unfinished_folder_is_removed_and_nothing_else(tmp_path: Path) -> None:
    def interrupted(path: Path, *others: Path) -> None:
        with output_folder(path) as folder:
            (folder / "figure.csv").write_text("")
            for other in others:
                other.mkdir()
            raise KeyboardInterrupt

    for path, others in (("new/folder", ()), ("new/folder", ("new/other",)), ("new", ())):
        with pytest.raises(KeyboardInterrupt):
            interrupted(tmp_path / path, *(tmp_path / other for other in others))
        assert (tmp_path / "new").exists() == bool(others or path == "new")
    assert {path.name for path in (tmp_path / "new").iterdir()} == {"other", "figure.csv"}
