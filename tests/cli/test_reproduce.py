"""``asperity reproduce`` as a user calls it."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli.commands import asperity


@pytest.fixture(autouse=True)
def _no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("reproduction") / "made" / "here"


@pytest.mark.long
def test_json_and_files(folder: Path) -> None:
    result = CliRunner().invoke(asperity, ["reproduce", "--json", "--out", str(folder)])
    assert result.exit_code == 0, result.output
    document = json.loads(result.stdout)
    assert len(document["claims"]) == 14
    panels = ["4a", "4b", "4c", "4d", "4e", "4f", "5a", "5b", "6a", "6b", "7a", "7b", "8a", "8b"]
    for panel in panels:
        assert (folder / f"figure_{panel}.png").stat().st_size > 5000
        assert (folder / f"figure_{panel}.csv").read_text(encoding="utf-8").count("\n") > 50
    assert json.loads((folder / "claims.json").read_text(encoding="utf-8")) == document
    assert "14 panels" in result.stderr


def test_text_says_met_and_not_met_and_where_files_would_go() -> None:
    result = CliRunner().invoke(asperity, ["reproduce"])
    assert result.exit_code == 0, result.output
    lines = result.stdout.splitlines()
    assert any(line.startswith("C3 ") and " met " in line for line in lines)
    assert any(line.startswith("C12 ") and "not met" in line for line in lines)
    assert any(line.startswith("window not met") for line in lines)
    assert "Criteria for the qualitative terms of the paper" in result.stdout
    assert "--out FOLDER" in result.stderr


def test_out_must_be_a_folder(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("")
    result = CliRunner().invoke(asperity, ["reproduce", "--out", str(file)])
    assert result.exit_code == 2
    assert "is a file" in result.output
