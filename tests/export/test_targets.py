"""Targets by name, endings of files, refusals."""

import pytest

from asperity.errors import InputError
from asperity.export.targets import SUFFIXES, Exported, check_target, exported, write_exported


@pytest.mark.parametrize(
    ("to", "name", "said"),
    [
        ("adams", "a.csv", "there is no export to 'adams'; known are table, mujoco, fmu, modelica"),
        ("table", "a.txt", "the name of a file for 'table' must end in .csv or .mat"),
        ("table", "nowhere/a.csv", "there is no folder"),
        ("table", "joint.csv", "this is the file that is read"),
    ],
)
def test_refusals(tmp_path, monkeypatch, to, name, said):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "joint.csv").write_text("")
    with pytest.raises(InputError, match=said):
        check_target(to, name, "joint.csv")


def test_every_target_writes_every_ending(content, tmp_path):
    for to, suffixes in SUFFIXES.items():
        for suffix in suffixes:
            file = tmp_path / f"{to}{suffix.upper()}"
            check_target(to, file)
            made = exported(content, to=to, suffix=file.suffix)
            write_exported(made, file)
            assert file.read_bytes() == made.data == exported(content, to=to, suffix=suffix).data


def test_what_cannot_be_written(tmp_path):
    with pytest.raises(InputError, match="there is no folder"):
        write_exported(Exported(b""), tmp_path / "nowhere" / "a.csv")
