"""``asperity loads``: table, JSON and CSV."""

import csv
import json
import re

import pytest

DUTY = '\n[[duty]]\noutput_torque = "3 N*m"\nsun_speed = "3000 rpm"\nshare = 1.0\n'


def test_table_and_json_agree_with_the_joint(call, zou_file, monkeypatch):
    """On a terminal so wide that no cell is wrapped."""
    monkeypatch.setattr("asperity.cli.terminal.WIDEST", 200)
    shown = call("loads", zou_file)
    assert shown.code == 0
    _, title, case, torque, heads, _, *rows = shown.out.splitlines()
    assert (title.strip(), torque.strip()) == ("Loads of the structure", "5 N·m")
    assert case.strip() == "working torque, in rolling"
    cells = [re.split(r"\s{2,}", line.strip()) for line in (heads, *rows)]
    assert cells[0] == ["part", "load", "unit", "without torque", "6000 rpm"]
    assert "carrier pin, right loading roller" in {row[0] for row in cells}
    assert ["carrier, on the axis, output", "torque of all pins", "N·m", "0", "-5"] in cells
    assert "All sectors are equal: the roller forces on the carrier" in shown.out
    document = json.loads(call("loads", zou_file, "--json").out)
    torque = [row["values"] for row in document["loads"] if row["quantity"] == "torque of all pins"]
    assert torque[0] == pytest.approx([0.0, -5.0])
    mounted = {row["quantity"]: row["values"] for row in document["loads"] if row["part"] == "ring"}
    solved = json.loads(call("joint", zou_file, "--json").out)["standing"]["forces"][
        "normal_without_torque_N"
    ]
    force = 3 * 0.12 * (solved["wro"] + solved["wlo"])
    assert mounted["axial mounting force"] == [pytest.approx(force), None]
    assert mounted["heating of the ring, for a gap of 0 um"] == [None, None]


@pytest.mark.long
def test_every_load_of_the_duty_is_a_column(call, joint_file, tmp_path):
    file, target = joint_file(("[surface]", f"{DUTY}\n[surface]")), tmp_path / "loads.csv"
    assert call("loads", file, "--csv", target).code == 0
    with target.open(encoding="utf-8") as stream:
        head, *rows = csv.reader(stream)
    assert head == [
        "part",
        "position",
        "load",
        "unit",
        "without torque",
        "working torque, in rolling, 5 N·m, 6000 rpm",
        "duty 1, in rolling, 3 N·m, 3000 rpm",
    ]
    torque = next(row for row in rows if row[2] == "torque of all pins")
    assert [float(cell) for cell in torque[4:]] == pytest.approx([0.0, -5.0, -3.0])
    speed = next(row for row in rows if row[0].startswith("sun") and row[2] == "speed in the housing")
    assert [float(cell) for cell in speed[4:]] == pytest.approx([0.0, 6000.0, 3000.0])
    assert speed[3] == "rpm"


@pytest.mark.slow
def test_a_drive_of_another_type(call, zou_file):
    """Input, output and grounded member hold each other about the axis."""
    document = json.loads(call("loads", zou_file.with_name("multiroller.toml"), "--json").out)
    torques = [row["values"] for row in document["loads"] if row["unit"] == "N*m"]
    assert len(torques) == 3
    assert sum(values[1] for values in torques) == pytest.approx(0.0, abs=1e-9)
    assert max(values[1] for values in torques) == pytest.approx(10.0)
