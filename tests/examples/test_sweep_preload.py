"""The map of preload and torque."""

import pytest


@pytest.mark.slow
def test_the_map_ends_at_the_capacity(load_example, monkeypatch, tmp_path):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    # the capacity at 1000 N is 13.2 N·m by bisection (asperity windup): 13 is the last step of 1 N·m below it
    assert load_example("sweep_preload").main(tmp_path / "map.png") == 13.0
    assert (tmp_path / "map.png").stat().st_size > 10_000
