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


def test_a_refusal_about_another_file_of_the_command_stays_as_it_is():
    for words in (
        "curve.csv: line 3 has no number",
        "curve.csv, other.csv: both are curves of a joint that rests",
    ):
        with pytest.raises(InputError, match=f"^{words}$"), about("mine.toml", "curve.csv", None):
            raise InputError(words)


@pytest.mark.slow
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
