"""``asperity dynamics``: table, JSON, CSV, picture, and what is missing."""

import csv
import json

import numpy as np
import pytest

SECTION = '\n[dynamics]\ninput_inertia = "2e-6 kg*m^2"\noutput_inertia = "500 kg*cm^2"\n'


def coupled(joint_file, more=""):
    return joint_file(("[surface]", f"{SECTION}{more}\n[surface]"))


@pytest.mark.slow
def test_table_json_csv_and_picture(call, joint_file, tmp_path):
    file, data, picture = coupled(joint_file), tmp_path / "response.csv", tmp_path / "response.svg"
    outcome = call("dynamics", file, "--csv", str(data), "--plot", str(picture))
    assert outcome.code == 0
    for text in ("motor locked (antiresonance)", "Hz", "kg·m²", "creep corner", "No dynamics.loss_factor"):
        assert text in outcome.out
    document = json.loads(call("dynamics", file, "--json").out)
    at = document["at_torque"]
    assert document["inertia"]["output_kg_m2"] == 0.05
    # the rollers are 1e-3 of the load: two inertias and a spring but for that
    expected = np.sqrt(at["stiffness_output_Nm_per_rad"] / at["output_inertia_kg_m2"]) / (2 * np.pi)
    assert at["locked_frequency_Hz"] == pytest.approx(expected, rel=2e-3)
    with data.open() as stream:
        rows = list(csv.reader(stream))
    assert rows[0][0] == "frequency_Hz"
    assert len(rows) == 1 + len(document["response"]["frequency_Hz"])
    assert "both sides free (resonance)" in picture.read_text()


def test_inertias_are_needed(call, joint_file):
    outcome = call("dynamics", joint_file())
    assert (outcome.code, outcome.out) == (2, "")
    assert "has no section [dynamics]" in outcome.err


def test_the_reason_why_creep_is_left_out():
    """A joint that stands has no creep, a corner at 0 Hz; one that does not roll steadily has no number at all."""
    from asperity.api.structure import JointDynamics

    names = (
        "output_torque_Nm",
        "stiffness_output_Nm_per_rad",
        "input_inertia_at_output_kg_m2",
        "spin_inertia_at_output_kg_m2",
        "output_inertia_kg_m2",
        "locked_frequency_Hz",
        "free_frequency_Hz",
    )
    at = dict.fromkeys(names, 1.0) | {"creep_damping_Nms_per_rad": None}
    over = {name: [1.0] for name in (*names, "corner_frequency_Hz")}
    said = []
    for corner in (0.0, None):
        document = {
            "at_torque": at | {"corner_frequency_Hz": corner},
            "over_torque": over,
            "of_own_branches": True,
            "stiffness_bound": None,
        }
        said.append(repr(JointDynamics("a.toml", document, None, damped=True)))
    assert "The input stands" in said[0]
    assert "stands" not in said[1]
    assert "does not roll steadily, or a branch of it slips" in said[1]


@pytest.mark.slow
def test_a_joint_that_stands(call, joint_file):
    file = joint_file(("[surface]", f"{SECTION}loss_factor = 0.01\n[surface]"), ('"6000 rpm"', '"0 rpm"'))
    outcome = call("dynamics", file)
    assert outcome.code == 0
    assert "The input stands: creep does not act." in outcome.out
    assert "loss_factor" not in outcome.out


@pytest.mark.long
def test_a_drive_of_another_type(call, zou_file, tmp_path):
    file, picture = zou_file.with_name("multiroller.toml"), tmp_path / "response.svg"
    outcome = call("dynamics", file, "--plot", picture, "--json")
    assert outcome.code == 0
    at = json.loads(outcome.out)["at_torque"]
    expected = np.sqrt(at["stiffness_output_Nm_per_rad"] / at["output_inertia_kg_m2"]) / (2 * np.pi)
    assert at["locked_frequency_Hz"] == pytest.approx(expected, rel=2e-3)
    assert at["corner_frequency_Hz"] > 0.0
    assert picture.stat().st_size > 10_000
