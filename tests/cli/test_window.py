"""``asperity window``: verdict first, files, and one clear message for what is refused."""

import csv
import json
from pathlib import Path

import pytest

WHEELS = Path(__file__).parents[2] / "examples" / "wheel_pair.toml"


def test_text_csv_and_picture(call, tmp_path):
    files = tmp_path / "window.csv", tmp_path / "window.png"
    told = call(
        "window",
        WHEELS,
        "--from",
        "500 N",
        "--to",
        "1 kN",
        "--points",
        2,
        "--csv",
        files[0],
        "--plot",
        files[1],
    )
    assert told.code == 0, told.err
    assert (
        told.out.splitlines()[1]
        == "The output torque of the file lies inside the window at 1000 N of preload."
    )
    rows = list(csv.DictReader(files[0].read_text().splitlines()))
    assert [float(rows[end]["preload_N"]) for end in (0, -1)] == [500.0, 1000.0]
    # mu N R of 1000 N, standing
    assert float(rows[-1]["gross_slip_Nm"]) == pytest.approx(0.08 * 1000.0 * 0.040, rel=1e-9)
    assert files[1].stat().st_size > 10_000


def test_document(call):
    told = call("window", WHEELS, "--from", "900 N", "--to", "1100 N", "--points", 2, "--json")
    assert told.code == 0, told.err
    document = json.loads(told.out)
    assert (document["over"], document["key"], document["working_N"]) == ("preload", "load.preload", 1000.0)
    assert document["at_N"] == [900.0, 1000.0, 1100.0]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--points", "1"), "the number of points must be from 2 to 500, got 1 (option --points)"),
        (
            ("--from", "900 N", "--to", "200 N"),
            "from 900 N to 200 N it does not; choose a start below the end",
        ),
        (("--from", "9 um"), "--from: expected a force"),
        (("--over", "temperature"), "no section [temperature]"),
        (("--from", "0 N"), "0 N is not allowed; it must be at least 0.001 N"),
    ],
)
def test_refusals(call, options, said):
    told = call("window", WHEELS, *options)
    assert (told.code, told.out) == (2, "")
    assert said in told.err
    assert len(told.err.strip().splitlines()) == 1
