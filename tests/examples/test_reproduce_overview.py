"""The example that draws the picture of the README."""

import importlib.util
from pathlib import Path

import pytest


def test_the_joint_is_stiffest_near_1_85(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    path = Path(__file__).parents[2] / "examples" / "reproduce_overview.py"
    spec = importlib.util.spec_from_file_location("reproduce_overview", path)
    assert spec is not None
    assert spec.loader is not None
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    assert example.main(tmp_path / "overview.png") == pytest.approx(1.85, abs=0.02)
    assert (tmp_path / "overview.png").stat().st_size > 20_000
