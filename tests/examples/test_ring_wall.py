"""The stiffness over the wall of the ring."""

import numpy as np


def test_a_housing_lies_between_free_and_held(load_example, tmp_path, monkeypatch):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    springs, held, housing, free = load_example("ring_wall").main(tmp_path / "wall.png").values()
    assert np.all(housing < held)
    assert np.all(free[:30] < housing[:30])
    assert np.all(
        np.abs(springs / held - 1.0) < 0.025
    )  # today's springs are those of a ring in a rigid housing
    assert (tmp_path / "wall.png").stat().st_size > 20_000
