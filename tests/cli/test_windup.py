"""``asperity windup`` of a joint whose stiffness is replaced by a constant one: every figure is known by hand."""

import csv
import json
from pathlib import Path

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.results import windup_document
from asperity.standing import windup as module

STIFFNESS = 1e5  # N·m/rad
ARCMINUTE = np.pi / 180.0 / 60.0


@pytest.fixture
def asked(monkeypatch):
    """What the command asks the wind-up for."""
    kept = {}

    def constant(joint, **options):
        kept.update(options)
        compliance = 1.0 / STIFFNESS
        return module.windup_of(
            lambda torque: (jnp.full_like(torque, compliance), jnp.full_like(torque, compliance)),
            largest_torque=options["largest_torque"],
            stage_shares=options["stage_shares"],
            play=joint.play,
        )

    monkeypatch.setattr(windup_document, "windup", constant)
    return kept


def test_document(call, joint_file, asked):
    outcome = call("windup", joint_file(), "--torque", "10 N*m", "--level", "published", "--json")
    assert (outcome.code, outcome.err) == (0, "")
    found = json.loads(outcome.out)
    assert (asked["level"], asked["largest_torque"]) == ("published", 10.0)
    capacity = found["standing_torque_capacity"]
    assert capacity["limiting_contact"] == capacity["reverse"]["limiting_contact"] == "sp"
    assert 12.96 < capacity["output_torque_Nm"] < 1.05 * 12.96  # mu N_0 9 n R_s, and a little for the wedge
    assert found["largest_torque_Nm"] == 10.0
    assert found["windup_rad"] == pytest.approx(10.0 / STIFFNESS, rel=1e-12)
    for name in ("hysteresis_rad", "dissipated_energy_J"):  # a spring loses nothing
        assert found[name] == pytest.approx(0.0, abs=1e-12)
    assert found["lost_motion_rad"] == pytest.approx(2 * 0.03 * 10.0 / STIFFNESS, rel=1e-9)
    assert [stage["to_Nm"] for stage in found["stages"]] == pytest.approx([10.0 / 3.0, 20.0 / 3.0, 10.0])
    assert [stage["stiffness_Nm_per_rad"] for stage in found["stages"]] == pytest.approx([STIFFNESS] * 3)


def test_table_curves_and_picture(call, joint_file, asked, tmp_path):
    files = tmp_path / "w.csv", tmp_path / "w.png"
    outcome = call("windup", joint_file(), "--csv", files[0], "--plot", files[1])
    assert outcome.code == 0
    assert asked["largest_torque"] == 5.0  # the file's own
    for text in (
        "contact sp slips (both directions)",
        f"{5.0 / STIFFNESS / ARCMINUTE:.4g} arcmin",
        "29.09",
        "K3",
    ):
        assert text in outcome.out, text
    for text in ("static curve holds up to (creep 5 % of the wind-up)", "41.22 arcmin", "two regimes"):
        assert text in outcome.out, text
    rows = list(csv.DictReader(files[0].read_text().splitlines()))
    torque, angle = (
        np.array([float(row[name]) for row in rows]) for name in ("torque_Nm", "loading_angle_rad")
    )
    np.testing.assert_allclose(angle, torque / STIFFNESS, atol=1e-15)
    assert files[1].stat().st_size > 10_000


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--torque", "50 N*m"), "--torque: the output torque 50 N·m is beyond the standing torque capacity"),
        (("--torque", "5 N"), "--torque: expected a torque"),
        (("--torque", "0 N*m"), "--torque: a wind-up needs a torque that is not zero"),
        (("--stages", "0.5", "0.2"), "--stages 0.5 0.2: allowed are two shares with 0 < first < second < 1"),
        (("--creep-share", "0"), "--creep-share 0: allowed is a number above 0, e.g. 0.05"),
        (("--rolling-csv", "joint.toml"), "joint.toml: this is the file that is read; give another name"),
        (("--csv", "joint.toml"), "joint.toml: this is the file that is read; give another name"),
        (("--csv", "nowhere/w.csv"), "nowhere/w.csv: there is no folder 'nowhere'"),
        (("--plot", "w.xyz"), "w.xyz: the name of an image must end in .png, .svg or .pdf"),
    ],
)
def test_refusals(call, joint_file, asked, arguments, said, monkeypatch):
    file = joint_file()
    monkeypatch.chdir(file.parent)
    outcome = call("windup", file, *arguments)
    assert (outcome.code, outcome.out) == (2, "")
    assert said in outcome.err


def test_play_of_the_file_is_in_every_figure(call, joint_file, asked):
    """54 arcmin of play: before, a calibrated joint lost them."""
    file = joint_file(("[model]", '[play]\nangle = "54 arcmin"\ntake_up_torque = "0 N*m"\n\n[model]'))
    found = json.loads(call("windup", file, "--torque", "10 N*m", "--json").out)
    spring = 10.0 / STIFFNESS
    assert found["lost_motion_rad"] == pytest.approx(54.0 * ARCMINUTE + 0.06 * spring, rel=1e-9)
    assert found["windup_rad"] == pytest.approx(27.0 * ARCMINUTE + spring, rel=1e-9)
    first = (10.0 / 3.0) / (27.0 * ARCMINUTE + spring / 3.0)
    assert found["stages"][0]["stiffness_Nm_per_rad"] == pytest.approx(first, rel=1e-9)


def test_a_negative_torque_is_the_same_curve(call, joint_file, asked):
    documents = [
        json.loads(call("windup", joint_file(), f"--torque={torque}", "--json").out)
        for torque in ("10 N*m", "-10 N*m")
    ]
    assert documents[0] == documents[1]


@pytest.mark.long
def test_a_direction_with_less_capacity_is_refused_by_name(call, joint_file):
    """A constant pin force: 182 N·m one way, 12.5 the other."""
    file = joint_file(('closure = "elastic"', 'closure = "constant_pin_force"'))
    outcome = call("windup", file, "--torque", "13 N*m")
    assert (outcome.code, outcome.out) == (2, "")
    assert "--torque: the output torque -13 N·m is beyond the standing torque capacity -12.4" in outcome.err


def test_a_sun_that_turns(call, joint_file, asked, tmp_path):
    """Creep begins with half the drift of 'asperity roll' and ends with all of it."""
    table = tmp_path / "beyond.csv"
    file = joint_file()
    found = json.loads(call("windup", file, "--rolling-csv", table, "--creep-share", "0.1", "--json").out)
    drift = json.loads(call("roll", file, "--json").out)["rolling"]["drift_rad_per_output_turn"]
    rolling = found["rolling"]
    assert rolling["unknown_because"] == rolling["reverse"]["unknown_because"] == []
    assert rolling["drift_rad_per_output_turn"] == pytest.approx(drift, rel=1e-12)
    rows = [list(map(float, row)) for row in list(csv.reader(table.read_text().splitlines()))[1:]]
    sun, output, behind, swing = np.array(rows).T
    assert behind[0] == found["windup_rad"]
    slope = np.diff(behind) / np.diff(output) / (drift / (2.0 * np.pi))
    assert slope[0] == pytest.approx(0.5, abs=0.01)
    assert slope[-1] == pytest.approx(1.0, rel=1e-6)
    held = rolling["static_curve_up_to"]
    assert np.interp(held["output_rad"], output, behind) == pytest.approx(1.1 * found["windup_rad"], rel=1e-4)
    assert held["input_rad"] / held["output_rad"] == pytest.approx(sun[-1] / output[-1], rel=1e-12)
    widths = [contact["rolls_its_width_in"]["output_rad"] for contact in rolling["contacts"].values()]
    assert rolling["steady_creep_from"]["output_rad"] == max(widths)
    still = rolling["swing_without_drift"]["output_rad"]
    assert np.all(swing[output < still] < 1e-3 * 2.0 * drift * still)
    assert swing[-1] < 2.0 * drift / (2.0 * np.pi) * output[-1]


@pytest.mark.slow
def test_a_torque_beyond_rolling_has_no_drift(call, tmp_path):
    """The tutorial's joint passes 14.33 N·m at rest, 13.28 in rolling."""
    file = Path(__file__).parents[2] / "examples" / "tutorial_joint.toml"
    outcome = call("windup", file, "--torque", "13.8 N*m", "--json")
    assert outcome.code == 0
    (reason,) = json.loads(outcome.out)["rolling"]["unknown_because"]
    assert "no steady rolling" in reason
    shown = call("windup", file, "--torque", "13.8 N*m", "--plot", tmp_path / "w.png")
    assert "When the input turns under 13.8 N·m: no steady rolling" in shown.out.replace("\n", " ")
    refused = call("windup", file, "--torque", "13.8 N*m", "--rolling-csv", tmp_path / "r.csv")
    assert (refused.code, refused.out) == (2, "")
    assert "--rolling-csv: no steady rolling" in refused.err


@pytest.mark.long
def test_a_drive_of_another_type(call, zou_file, tmp_path):
    file, table = zou_file.with_name("multiroller.toml"), tmp_path / "w.csv"
    found = json.loads(call("windup", file, "--csv", table, "--json").out)
    solved = json.loads(call("joint", file, "--json").out)
    assert (
        found["standing_torque_capacity"]["limiting_contact"]
        == solved["standing_torque_capacity"]["limiting_contact"]
    )
    rows = list(csv.DictReader(table.read_text().splitlines()))
    stiffness = solved["torsional_stiffness"]["assembly"]["output_Nm_per_rad"]
    assert float(rows[-1]["incremental_stiffness_Nm_per_rad"]) == pytest.approx(stiffness, rel=1e-9)
    drift = solved["rolling"]["drift_rad_per_output_turn"]
    assert found["rolling"]["drift_rad_per_output_turn"] == pytest.approx(drift, rel=1e-9)
    shares = [contact["share_of_drift"] for contact in found["rolling"]["contacts"].values()]
    assert sum(shares) == pytest.approx(1.0)
    assert call("windup", file, "--plot", tmp_path / "w.svg").code == 0
    refused = call("windup", file, "--torque", "90 N*m")
    assert (refused.code, refused.out) == (2, "")
    assert "--torque: the output torque 90 N·m is beyond the standing torque capacity" in refused.err
