"""The commands for studies: what they print and write, and how they refuse."""

import re
from pathlib import Path

import pytest
from commands import run

from asperity.errors import InputError
from asperity.results.table import GROUPS

FILE = str(Path(__file__).parents[2] / "examples" / "zou2025.toml")
TORQUE = ["--over", "load.output_torque=0 N*m:20 N*m:3"]


pytestmark = pytest.mark.usefixtures("own_folder")


def test_help_names_every_group_of_results():
    shown = " ".join(run("sweep", "--help").output.split())
    listed = shown[shown.index("separated by commas: ") : shown.index("Only these are computed")]
    assert set(re.findall(r"\w+", listed)) >= set(GROUPS)


@pytest.mark.slow
def test_small_sweep_is_printed_drawn_and_written(tmp_path):
    done = run("sweep", FILE, *TORQUE, "--results", "published", "--out", "s.csv", "--plot")
    assert done.exit_code == 0
    assert "3 points, 2 solved" in done.output
    assert "beyond the standing torque capacity" in done.output
    rows = (tmp_path / "s.csv").read_text().splitlines()
    assert rows[0].startswith(
        "load.output_torque [N*m],status,status_meaning,published_stiffness_output [N*m/rad]"
    )
    assert [row.split(",")[0] for row in rows[1:]] == ["0.0", "10.0", "20.0"]
    # 5.04e6 N*m/rad without torque: the guide value for the published model at this joint
    assert float(rows[1].split(",")[3]) == pytest.approx(5.04e6, rel=2e-3)
    assert (tmp_path / "sweep.png").stat().st_size > 10_000
    with pytest.raises(InputError, match="exists already"):
        run("sweep", FILE, *TORQUE, "--out", "s.csv")
    shown = run("sweep", FILE, *TORQUE, "--results", "published")
    assert re.search(r"beyond\s+standing\s+capacity\s*$", shown.output)
    assert "published" in shown.output


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--over", "load.torque=0 N*m:1 N*m:2"], "did you mean"),
        ([*TORQUE, "--out", "s.xlsx"], "ending must be"),
        ([*TORQUE, "--workers", "2"], r"need an --out of type \.zarr"),
        ([*TORQUE, "--plot", "s.bmp"], r"\.png, \.svg or \.pdf"),
        ([*TORQUE, "--results", "everything"], "no result 'everything'"),
        ([*TORQUE, "--plot", "--plot-result", "nope"], "no result 'nope'"),
        (
            [*TORQUE, "--plot", "--results", "published", "--plot-result", "slip_ratio"],
            "'slip_ratio' is not among",
        ),
        ([*TORQUE, "--plot-result", "slip_ratio"], "--plot-result needs --plot"),
    ],
)
def test_refusals_come_first(arguments, told, monkeypatch):
    monkeypatch.setattr(
        "asperity.study.sweep.sweep.block_results", lambda *_, **__: pytest.fail("computed before checking")
    )
    with pytest.raises(InputError, match=told):
        run("sweep", FILE, *arguments)


def test_help_shows_its_examples_line_by_line():
    shown = run("sweep", "--help").output
    assert "\\b" not in shown
    assert '\n  asperity sweep joint.toml --over "load.output_torque=0 N*m:5 N*m:11" --plot\n' in shown


@pytest.mark.slow
def test_units_and_results_that_are_repeated_all_count(tmp_path):
    """The last one alone had counted, without a word."""
    over = ["--over", "drive.contact_length=5 mm:10 mm:2"]
    asked = ["--results", "mass", "--results", "envelope_diameter", "--units", "g", "--units", "um,kg"]
    done = run("sweep", FILE, *over, *asked[:-1], "mm", "--out", "s.csv")
    assert done.exit_code == 0
    head, first, second = (row.split(",") for row in (tmp_path / "s.csv").read_text().splitlines())
    assert head[0] == "drive.contact_length [mm]"
    assert head[3:] == ["mass [g]", "envelope_diameter [mm]"]
    assert [float(row[0]) for row in (first, second)] == [5.0, 10.0]
    assert float(second[3]) == pytest.approx(2.0 * float(first[3]), rel=1e-9)
    assert float(first[4]) == pytest.approx(200.0)  # a ring of 40 mm with a wall of 60 mm
