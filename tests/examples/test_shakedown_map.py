"""The picture of shakedown and first yield."""

import numpy as np
import pytest


def test_curves_are_ordered_and_the_kink_is_the_published_one(load_example, tmp_path):
    example = load_example("shakedown_map")
    friction = np.linspace(0.0, 0.6, 121)
    shakedown, tresca, mises = example.limits(friction).values()
    assert np.all(shakedown >= tresca * (1 - 1e-12))
    assert np.all(tresca > mises)
    assert friction[np.argmax(np.isclose(shakedown * friction, 1.0))] == pytest.approx(0.367, abs=0.005)
    example.draw(friction, example.limits(friction)).savefig(tmp_path / "map.png")
    assert (tmp_path / "map.png").stat().st_size > 20_000
