"""Plain letters where a terminal has no others, refusals that name the file, escaped control characters."""

import ast
import io
import json
import sys
from pathlib import Path

import pytest

from asperity import errors
from asperity.cli.commands import asperity
from asperity.cli.terminal import about, console, print_json, show_blocks
from asperity.errors import InputError, MissingExtraError, NoSolutionError
from asperity.views.blocks import Paragraph, Table
from asperity.views.terminal import WIDEST


def test_a_pipe_without_unicode_gets_plain_letters(monkeypatch):
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw, encoding="ascii"))
    rows = [("published → bound", "5", "1", "–")]
    show_blocks(Table("Stiffness", ("model", "K\nN·m/rad", "area\nmm²", "life"), rows), Paragraph("± é"))
    sys.stdout.flush()
    text = raw.getvalue().decode("ascii")
    assert "N*m/rad" in text
    assert "mm^2" in text
    assert "published -> bound" in text
    assert "+- ?" in text
    assert "\x1b" not in text
    words = [line.split() for line in text.splitlines()]
    assert ["published", "->", "bound", "5", "1", "-"] in words


def test_a_pipe_is_as_wide_as_tables_may_be(monkeypatch):
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(io.BytesIO(), encoding="utf-8"))
    assert console().width == WIDEST


@pytest.mark.parametrize("kind", [InputError, NoSolutionError])
def test_a_refusal_names_the_file_once_and_keeps_its_kind(kind):
    with (
        pytest.raises(kind, match=r"^mine\.toml: planet 3 is loose$") as refused,
        about("mine.toml"),
        about("mine.toml"),
    ):
        raise kind("planet 3 is loose", options=("torque",))
    assert refused.value.options == ("torque",)


def test_other_errors_stay_as_they_are():
    with pytest.raises(MissingExtraError, match=r"^install it$"), about("mine.toml"):
        raise MissingExtraError("install it")


def test_a_refusal_about_another_file_of_the_command_stays_as_it_is():
    for words in (
        "curve.csv: line 3 has no number",
        "curve.csv, other.csv: both are curves of a joint that rests",
    ):
        with pytest.raises(InputError, match=f"^{words}$"), about("mine.toml", "curve.csv", None):
            raise InputError(words)


@pytest.mark.parametrize(
    "command",
    [
        "joint",
        "roll",
        "loads",
        "windup",
        "dynamics",
        "draw",
        "report",
        "export",
        "sensitivity",
        "uncertainty",
    ],
)
def test_a_joint_that_cannot_exist_is_refused_by_the_name_of_its_file(call, joint_file, tmp_path, command):
    inertias = '[dynamics]\ninput_inertia = "2e-6 kg*m^2"\noutput_inertia = "0.05 kg*m^2"\n\n[model]'
    preload = ('preload = "1000 N"', 'preload = "1000 N +- 50 N, uniform"')
    file = joint_file(("planets = 3", "planets = 30"), ("[model]", inertias), preload)
    more = {
        "draw": ("--forces", "--out", tmp_path / "a.svg"),
        "report": ("--out", tmp_path / "a.html"),
        "export": ("--to", "table", "--out", tmp_path / "a.csv"),
    }
    found = call(command, file, *more.get(command, ()))
    assert found.code == 2
    assert found.err.splitlines()[0].startswith(f"asperity: error: {file}: the rollers do not fit")


def test_a_number_that_a_study_asks_for_and_the_file_lacks_is_refused_by_the_name_of_the_file(
    call, joint_file, tmp_path
):
    file, curve = joint_file(), tmp_path / "curve.csv"
    curve.write_text("torque [N*m],angle [arcmin]\n" + "".join(f"{k},{k}\n" for k in range(9)))
    for command, said in (
        (("sweep", file, "--over", "duty.1.output_torque=1 N*m:2 N*m:3"), ""),
        (("uncertainty", file), "the joint file states no tolerances"),
        (("calibrate", file, curve, "--unknown", "play.take_up_torque"), "play.take_up_torque is the torque"),
    ):
        found = call(*command)
        assert found.code == 2
        assert found.err.splitlines()[0].startswith(f"asperity: error: {file}: {said}")


def _all_options(command):
    below = (
        [command.get_command(None, name) for name in command.list_commands(None)]
        if hasattr(command, "commands")
        else []
    )
    own = {word.lstrip("-") for option in command.params for word in option.opts if word.startswith("--")}
    return own.union(*map(_all_options, below))


def test_every_option_that_a_message_names_exists():
    """Named in errors without its dashes, it is written there as on the command line."""
    known = _all_options(asperity)
    named = set()
    for file in Path(errors.__file__).parent.rglob("*.py"):
        for call in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(call, ast.Call) and getattr(call.func, "id", "").endswith("Error"):
                given = [keyword.value for keyword in call.keywords if keyword.arg == "options"]
                named |= {
                    text.value for each in given for text in ast.walk(each) if isinstance(text, ast.Constant)
                }
    named.discard("-unit")  # the end of two of them
    assert len(named) > 10
    assert named <= known


def test_a_document_has_no_half_characters(capsys):
    """Names of files that are not UTF-8 hold them; JSON of control characters is JSON."""
    print_json({"one": "we\x07lle\udcfc", "\udcfc": ["µ\U0001f600", 1.5, None, ("\udcff",)]})
    read = json.loads(capsys.readouterr().out)
    assert read == {"one": "we\x07lle\\udcfc", "\\udcfc": ["µ\U0001f600", 1.5, None, ["\\udcff"]]}
    json.dumps(read, ensure_ascii=False).encode()
