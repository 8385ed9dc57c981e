"""Commands say whose results theirs are where a file has sections [[branch]]."""

import json
import re
from pathlib import Path
from types import SimpleNamespace

import pytest

from asperity.joint_file import reader

EXAMPLES = Path(__file__).parents[2] / "examples"
NOTE = "the results are those of the branches of the file, [[branch]]"


@pytest.fixture(params=["zou2025", "planetary"])
def unequal(tmp_path, request):
    text = (EXAMPLES / f"{request.param}.toml").read_text(encoding="utf-8")
    text = text.replace('preload = "1000 N"', 'interference = "13 um"')
    branches = '[[branch]]\nplanet_deviation = "1 um"\n\n[[branch]]\n\n[[branch]]\n\n'
    (tmp_path / "unequal.toml").write_text(text.replace("[model]", f"{branches}[model]", 1), encoding="utf-8")
    return tmp_path / "unequal.toml"


@pytest.mark.parametrize(
    ("command", "options"),
    [
        ("sweep", ("--over", "load.nothing=1 N:2 N:2")),
        ("sensitivity", ("--result", "none")),
        ("uncertainty", ()),  # without tolerances
    ],
)
def test_the_note_comes_first(call, unequal, command, options):
    outcome = call(command, unequal, *options)
    assert outcome.code == 2
    assert outcome.err.startswith("asperity: note: ")
    assert outcome.err.count(NOTE) == 1


def test_files_of_equal_branches_have_no_note(call):
    outcome = call("sensitivity", EXAMPLES / "planetary.toml", "--result", "none")
    assert outcome.code == 2
    assert "note" not in outcome.err


@pytest.mark.parametrize(("heights", "notes"), [({"surface.sp": (1e-8, 2e-8, 3e-8)}, 1), (None, 0)])
@pytest.mark.parametrize("options", [(), ("--branches", "3")])
def test_what_is_kept_of_a_measured_surface_is_said(call, monkeypatch, heights, notes, options):
    """Not of its D and G, which do not depend on the torque."""
    case = reader.read_case(EXAMPLES / "zou2025.toml").with_measured(
        SimpleNamespace(heights=heights, text="{}")
    )
    monkeypatch.setattr("asperity.cli.joint_input.read_case", lambda file: case)
    outcome = call("uncertainty", "joint.toml", *options)
    assert outcome.code == 2  # without tolerances
    assert outcome.err.count("what the contacts feel of the measured surface") == notes


def enlarged(unequal):
    """Three planets 2 um larger at 13 N·m, and beside them a file of equal ones of 34 um, whose name is returned."""
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8")
    stronger = text.replace('output_torque = "10 N*m"', 'output_torque = "13 N*m"')
    harder = unequal.parent / "harder.toml"
    harder.write_text(stronger.replace('interference = "30 um"', 'interference = "34 um"'), encoding="utf-8")
    branches = '[[branch]]\nplanet_deviation = "2 um"\n\n' * 3
    unequal.write_text(stronger.replace("[model]", f"{branches}[model]", 1), encoding="utf-8")
    return harder


@pytest.mark.long
@pytest.mark.parametrize("unequal", ["planetary"], indirect=True)
def test_commands_of_the_files_own_branches_say_so(call, unequal):
    """Three planets 2 um larger carry 13 N·m, and are an interference of 34 um; equal ones of 30 um carry 12.1 N·m."""
    harder = enlarged(unequal)
    for command, keys in (
        ("windup", ("windup_rad", "hysteresis_rad", "lost_motion_rad", "dissipated_energy_J")),
        ("dynamics", ("stiffness_output_Nm_per_rad", "free_frequency_Hz", "corner_frequency_Hz")),
    ):
        own, equal = (call(command, file, "--json") for file in (unequal, harder))
        assert (own.code, equal.code, equal.err) == (0, 0, "")
        assert "the results are those of the branches of the file, [[branch]]" in own.err
        found, expected = json.loads(own.out), json.loads(equal.out)
        assert (found["of_own_branches"], expected["of_own_branches"]) == (True, False)
        if command == "dynamics":
            found, expected = found["at_torque"], expected["at_torque"]
        for key in keys:
            assert found[key] == pytest.approx(expected[key], rel=1e-8, abs=0.0), key
        assert "of its own branches" in " ".join(call(command, unequal).out.split())
    outcome = call("windup", unequal, "--torque", "14 N*m")
    assert outcome.code == 2
    assert (
        "--torque: the output torque 14 N·m is beyond the standing torque capacity 13.78 N·m, at which contact sp_"
        in outcome.err
    )


@pytest.mark.long
@pytest.mark.parametrize("unequal", ["planetary"], indirect=True)
def test_what_rolls_is_what_the_branches_of_the_file_do_together(call, unequal, tmp_path):
    """The same three planets; 2 and 1 um less than nominal, they would slip at less than equal ones."""
    harder = enlarged(unequal)
    own, equal = (call("roll", file, "--json") for file in (unequal, harder))
    assert (own.code, own.err, equal.code) == (0, "", 0)
    found, expected = json.loads(own.out), json.loads(equal.out)
    for key in ("drift_rad_per_output_turn", "efficiency", "speed_loss"):
        assert found[key] == pytest.approx(expected[key], rel=1e-8), key
    shown = call("roll", unequal)
    text = " ".join(shown.out.split())
    assert shown.code == 0
    (capacity,) = re.findall(
        r"torque capacity, rolling [0-9.]+ N·m", " ".join(call("roll", harder).out.split())
    )
    assert capacity in text
    assert call("roll", unequal, "--plot", tmp_path / "curves.svg").code == 0
    assert "sp_2" in (tmp_path / "curves.svg").read_text(encoding="utf-8")


@pytest.mark.long
def test_a_torque_beyond_all_branches_is_refused(call, unequal):
    unequal.write_text(
        unequal.read_text(encoding="utf-8").replace('output_torque = "', 'output_torque = "9', 1),
        encoding="utf-8",
    )
    for command in ("joint", "roll"):
        outcome = call(command, unequal)
        assert outcome.code == 2
        assert "is beyond the standing torque capacity" in outcome.err


@pytest.mark.long
@pytest.mark.parametrize("unequal", ["zou2025"], indirect=True)
def test_the_papers_drive_rolls_with_its_own_branches(call, unequal):
    """Planets 0.5, 0.4 and 0.2 um larger carry 14.2 N·m, equal ones of 13 um of interference 13.3."""
    text = unequal.read_text(encoding="utf-8")
    start, end = text.index("[[branch]]"), text.index("[model]")
    larger = "".join(f'[[branch]]\nplanet_deviation = "{size} um"\n\n' for size in (0.5, 0.4, 0.2))
    text = text[:start] + larger + text[end:]
    unequal.write_text(
        text.replace('output_torque = "5 N*m"', 'output_torque = "13.6 N*m"'), encoding="utf-8"
    )
    outcome = call("roll", unequal, "--json")
    assert outcome.code == 0, outcome.err
    found = json.loads(outcome.out)
    losses = found["losses_W"]
    counted = sum(
        losses[cause] for cause in ("creep", "skew", "hysteresis", "oil", "bearings") if losses[cause]
    )
    assert losses["total"] == pytest.approx(counted, rel=1e-9)
    rolling = found["rolling"]
    assert rolling["input_power_W"] == pytest.approx(rolling["output_power_W"] + losses["total"], rel=1e-9)
    output = 13.6 * rolling["output_speed_rad_per_s"]
    assert rolling["output_power_W"] == pytest.approx(output, rel=1e-9)
    ideal = abs(found["standing"]["forces"]["output_speed_rad_per_s"])
    assert rolling["output_speed_rad_per_s"] == pytest.approx(ideal * (1.0 - found["speed_loss"]), rel=1e-6)
    # the torque at the contacts of the sun is at least that of the output over the ratio
    # contacts are looked at 1e-9 of the torque below it
    assert found["standing"]["forces"]["input_torque_Nm"] >= 13.6 * (1.0 - 1.1e-9) / abs(
        found["geometry"]["speed_ratio"]
    )
