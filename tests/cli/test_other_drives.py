"""Commands on joint files of other drives: what works, and what is refused in one message."""

from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("sweep", "--over", "drive.ring_radius=1 mm:2 mm:2"), "of a drive of type planetary has no number"),
        (("sweep", "--over", "surface.wro.fractal_dimension=1.4:1.5:2"), "this drive has no contact 'wro'"),
        (
            ("sweep", "--over", "load.output_torque=1 N*m:2 N*m:2", "--results", "wedge_angle"),
            "no result 'wedge_angle': only one with wedges between planets and ring has it",
        ),
        (
            ("sensitivity", "--result", "self_locking_ratio"),
            "no result 'self_locking_ratio': only one with wedges",
        ),
    ],
)
def test_what_the_drive_has_not_is_refused_by_name(call, arguments, said):
    command, *others = arguments
    outcome = call(command, EXAMPLES / "planetary.toml", *others)
    assert (outcome.code, outcome.err.count("\n")) == (2, 1)
    assert said in outcome.err


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["planetary", "planetary_hollow", "multiroller", "stepped_planet", "planar", "wheel_pair"]
)
def test_every_type_is_written_and_drawn(call, tmp_path, name):
    file = tmp_path / f"{name}.toml"
    assert call("init", file, "--type", name).code == 0
    drawn = call("draw", file, "--out", tmp_path / f"{name}.svg")
    assert drawn.code == 0
    assert (tmp_path / f"{name}.svg").read_text(encoding="utf-8").startswith("<?xml")


def test_an_impossible_drive_is_not_drawn(call, tmp_path):
    text = (EXAMPLES / "planetary.toml").read_text(encoding="utf-8").replace("planets = 3", "planets = 9")
    (tmp_path / "many.toml").write_text(text, encoding="utf-8")
    outcome = call("draw", tmp_path / "many.toml", "--out", tmp_path / "x.svg")
    assert outcome.code == 2
    assert "neighbours of planet overlap by" in outcome.err
