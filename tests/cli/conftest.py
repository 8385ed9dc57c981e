from pathlib import Path
from typing import NamedTuple

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


class Outcome(NamedTuple):
    code: int
    out: str
    err: str


@pytest.fixture
def call(monkeypatch, capsys):
    """Call the command as a shell would: exit code, standard output, standard error."""
    from asperity.cli import main

    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")

    def run(*arguments) -> Outcome:
        monkeypatch.setattr("sys.argv", ["asperity", *map(str, arguments)])
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            main()
        told = capsys.readouterr()
        return Outcome(ended.value.code, told.out, told.err)

    return run


@pytest.fixture
def joint_file(tmp_path):
    """Maker of a joint file: the example with some of its text replaced."""

    def write(*replacements: tuple[str, str]) -> Path:
        text = EXAMPLE.read_text(encoding="utf-8")
        for old, new in replacements:
            assert old in text
            text = text.replace(old, new)
        (tmp_path / "joint.toml").write_text(text, encoding="utf-8")
        return tmp_path / "joint.toml"

    return write
