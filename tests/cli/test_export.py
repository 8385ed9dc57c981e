"""``asperity export``: what it writes and says, and what it refuses."""

import csv
import json

import numpy as np
import pytest


@pytest.mark.slow
def test_table_is_the_windup_and_the_drift(call, joint_file, tmp_path):
    file, table, curve = joint_file(), tmp_path / "t.csv", tmp_path / "w.csv"
    outcome = call("export", file, "--to", "table", "--out", table, "--torque", "-4 N*m")
    assert outcome.code == 0
    assert f"wrote {table}" in outcome.err
    assert "Stiffness at 4 N*m" in outcome.out
    lines = [line for line in table.read_text().splitlines() if not line.startswith("#")]
    rows = list(csv.DictReader(lines))
    found = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    windup = json.loads(call("windup", file, "--torque", "4 N*m", "--csv", curve, "--json").out)
    for row, other in zip(rows, csv.DictReader(curve.read_text().splitlines()), strict=True):
        assert row["loading_rad"] == other["loading_angle_rad"]
        assert row["unloading_rad"] == other["unloading_angle_rad"]
    drift = windup["rolling"]["drift_rad_per_output_turn"]
    assert found["drift_driving_rad_per_turn"][-1] == pytest.approx(drift, rel=1e-9)
    assert found["drift_driving_rad_per_turn"][0] == pytest.approx(-drift, rel=1e-9)
    solved = json.loads(call("joint", joint_file(('"5 N*m"', '"4 N*m"')), "--json").out)[
        "torsional_stiffness"
    ]
    levels = {"published": "published", "series": "series_with_bulk", "assembly": "assembly"}
    for column, level in levels.items():
        expected = solved[level]["output_Nm_per_rad"]
        assert found[f"stiffness_{column}_Nm_per_rad"][-1] == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--to", "adams", "--out", "a.csv"), "'adams' is not"),
        (
            ("--to", "table", "--out", "a.txt"),
            "a.txt: the name of a file for 'table' must end in .csv or .mat",
        ),
        (("--to", "table", "--out", "nowhere/a.csv"), "nowhere/a.csv: there is no folder 'nowhere'"),
        (("--to", "table", "--out", "."), "directory"),
        (("--to", "table"), "--out"),
        (("--to", "table", "--out", "a.csv", "--torque", "5 N"), "--torque: expected a torque"),
        (
            ("--to", "table", "--out", "a.csv", "--torque", "0 N*m"),
            "--torque: a wind-up needs a torque that is not",
        ),
        (
            ("--to", "table", "--out", "a.csv", "--torque", "50 N*m"),
            "--torque: the output torque 50 N·m is beyond",
        ),
    ],
)
def test_refusals(call, joint_file, arguments, said, monkeypatch):
    file = joint_file()
    monkeypatch.chdir(file.parent)
    outcome = call("export", file, *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err
    assert not (file.parent / "a.csv").exists()


def test_a_joint_that_cannot_exist(call, joint_file, monkeypatch):
    file = joint_file(('ring_radius = "40 mm"', 'ring_radius = "20 mm"'))
    monkeypatch.chdir(file.parent)
    outcome = call("export", file, "--to", "table", "--out", "a.csv")
    assert (outcome.code, outcome.out) == (2, "")
    assert len(outcome.err.strip().splitlines()) == 1


def test_targets_are_those_of_the_room():
    from asperity.cli.export import TARGETS
    from asperity.export.targets import SUFFIXES

    assert tuple(SUFFIXES) == TARGETS


@pytest.mark.long
@pytest.mark.parametrize(
    ("to", "name"), [("table", "a.csv"), ("mujoco", "a.xml"), ("fmu", "a.fmu"), ("modelica", "a.mo")]
)
def test_a_drive_of_another_type(call, zou_file, tmp_path, to, name):
    outcome = call("export", zou_file.with_name("multiroller.toml"), "--to", to, "--out", tmp_path / name)
    assert outcome.code == 0
    assert "Drift per output turn at 10 N*m, steady rolling" in outcome.out
    if to == "mujoco":  # sun and ring turn the same way
        text = (tmp_path / name).read_text()
        assert '<joint name="motor" type="hinge" axis="0 0 1"' in text
        assert "motor: the sun, in its own angles; output: the ring." in text
