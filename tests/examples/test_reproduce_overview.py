"""The example that draws the picture of the README."""

import pytest


def test_the_joint_is_stiffest_near_1_85(load_example, tmp_path, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    assert load_example("reproduce_overview").main(tmp_path / "overview.png") == pytest.approx(1.85, abs=0.02)
    assert (tmp_path / "overview.png").stat().st_size > 20_000
