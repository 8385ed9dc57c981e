"""The rough steel patch."""

import pytest


@pytest.mark.slow
def test_rough_patch_has_mindlins_ratio_and_slips(load_example, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    found = load_example("bem_partial_slip").main()
    assert found["ratio"] == pytest.approx(2.0 * 0.7 / 1.7, rel=0.02)  # Mindlin 1949
    assert 0.0 < found["stick_at_95"] < 0.2
