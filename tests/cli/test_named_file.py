"""Refusals of a joint name its file."""

import pytest

from asperity.cli.named_file import about
from asperity.errors import InputError, MissingExtraError, NoSolutionError


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


@pytest.mark.parametrize(
    "command", ["joint", "roll", "loads", "windup", "dynamics", "draw", "report", "export"]
)
def test_a_joint_that_cannot_exist_is_refused_by_the_name_of_its_file(call, joint_file, tmp_path, command):
    inertias = '[dynamics]\ninput_inertia = "2e-6 kg*m^2"\noutput_inertia = "0.05 kg*m^2"\n\n[model]'
    file = joint_file(("planets = 3", "planets = 30"), ("[model]", inertias))
    more = {
        "draw": ("--forces", "--out", tmp_path / "a.svg"),
        "report": ("--out", tmp_path / "a.html"),
        "export": ("--to", "table", "--out", tmp_path / "a.csv"),
    }
    found = call(command, file, *more.get(command, ()))
    assert found.code == 2
    assert found.err.splitlines()[0].startswith(f"asperity: error: {file}: the rollers do not fit")
