"""Commands to start with: a joint file, its schema, completion in the shell."""

import json
from importlib.resources import files
from pathlib import Path

import pytest

from asperity.cli import start
from asperity.drive.types import DEFAULT_TYPE
from asperity.joint_file.reader import parse_case
from asperity.precision import note_once

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def written():
    """The plain planetary of the examples."""
    return (EXAMPLES / "planetary.toml").read_text("utf-8")


@pytest.mark.parametrize("name", ["planetary", "zou2025"])
def test_the_packaged_example_is_the_one_in_the_repository(name):
    packaged = files("asperity.joint_file").joinpath(f"{name}.toml")
    assert packaged.read_text("utf-8") == (EXAMPLES / f"{name}.toml").read_text("utf-8")


def test_it_is_written_once_and_only_overwritten_when_asked(call, tmp_path, written):
    target = tmp_path / "mine.toml"
    outcome = call("init", target)
    assert outcome.code == 0
    assert f"next: asperity joint {target}" in outcome.err
    assert target.read_text("utf-8") == written
    target.write_text("mine")
    refused = call("init", target)
    assert refused.code == 2
    assert "already exists; choose another name, or overwrite it with --force" in refused.err
    assert target.read_text() == "mine"
    assert call("init", target, "--force").code == 0
    assert target.read_text("utf-8") == written


def test_a_dash_prints_it(call, written):
    outcome = call("init", "-")
    assert (outcome.code, outcome.out) == (0, written)


def test_what_it_writes_is_a_joint_that_works(call, tmp_path):
    file = tmp_path / "joint.toml"
    call("init", file)
    assert "\nWorks: " in call("joint", file).out


def test_a_designers_file_does_not_inherit_the_papers_closure(call):
    text = (EXAMPLES / "zou2025.toml").read_text("utf-8")
    for key in ('traction_split = "equal_coefficients"', 'closure_springs = "bulk"'):
        (line,) = [each for each in text.splitlines(keepends=True) if each.startswith(key)]
        text = text.replace(line, "")
    written = call("init", "-", "--type", "wedge").out
    assert written == text
    model = parse_case(written, source="joint.toml").model
    assert model.traction_split == "springs"
    assert model.closure_springs is None


def test_a_place_that_cannot_be_written(call, tmp_path):
    outcome = call("init", tmp_path / "nowhere" / "joint.toml")
    assert outcome.code == 2
    assert "there is no folder" in outcome.err


def test_the_schema_is_json(call):
    outcome = call("schema")
    assert outcome.code == 0
    assert json.loads(outcome.out)["title"] == "Joint file of asperity"


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_a_script_for_every_shell(call, shell):
    outcome = call("completion", shell)
    assert outcome.code == 0
    assert "_ASPERITY_COMPLETE" in outcome.out


def test_an_unknown_shell(call):
    outcome = call("completion", "cmd")
    assert outcome.code == 2
    assert "bash" in outcome.err


def test_commands_are_completed(call, monkeypatch):
    monkeypatch.setenv("_ASPERITY_COMPLETE", "bash_complete")
    monkeypatch.setenv("COMP_WORDS", "asperity jo")
    monkeypatch.setenv("COMP_CWORD", "1")
    assert call().out == "plain,joint\n"


def test_the_default_is_the_type_of_a_file_without_one_and_a_former_name_is_told(call, caplog):
    assert start._DEFAULT == DEFAULT_TYPE
    note_once.cache_clear()
    assert call("init", "-", "--type", "zou2025").out == call("init", "-", "--type", "wedge").out
    assert caplog.messages == ['asperity: note: the type "zou2025" is called "wedge" now']
    refused = call("init", "-", "--type", "wedges")
    assert refused.code == 2
    assert "'wheel_pair'" in refused.err
