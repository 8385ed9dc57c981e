"""``asperity init``: a joint file to start from."""

from importlib.resources import files
from pathlib import Path

EXAMPLE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


def test_the_packaged_example_is_the_one_in_the_repository():
    assert files("asperity.joint_file").joinpath("zou2025.toml").read_text("utf-8") == EXAMPLE.read_text(
        "utf-8"
    )


def test_it_is_written_once_and_only_overwritten_when_asked(call, tmp_path):
    target = tmp_path / "mine.toml"
    outcome = call("init", target)
    assert outcome.code == 0
    assert f"next: asperity joint {target}" in outcome.err
    assert target.read_bytes() == EXAMPLE.read_bytes()
    target.write_text("mine")
    refused = call("init", target)
    assert refused.code == 2
    assert "already exists; choose another name, or overwrite it with --force" in refused.err
    assert target.read_text() == "mine"
    assert call("init", target, "--force").code == 0
    assert target.read_bytes() == EXAMPLE.read_bytes()


def test_a_dash_prints_it(call):
    outcome = call("init", "-")
    assert (outcome.code, outcome.out) == (0, EXAMPLE.read_text("utf-8"))


def test_a_place_that_cannot_be_written(call, tmp_path):
    outcome = call("init", tmp_path / "nowhere" / "joint.toml")
    assert outcome.code == 2
    assert "there is no folder" in outcome.err
