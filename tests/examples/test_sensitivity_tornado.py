"""The tornado of the paper's joint."""

import pytest

pytestmark = pytest.mark.slow


@pytest.mark.long
def test_capacity_is_proportional_to_the_planets(load_example, monkeypatch, tmp_path):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    assert load_example("sensitivity_tornado").main(tmp_path / "t.png") == pytest.approx(1.0, abs=1e-9)
    assert (tmp_path / "t.png").stat().st_size > 10_000
