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
    figure = example.draw(friction, example.limits(friction))
    figure.savefig(tmp_path / "map.png")
    (panel,) = figure.axes
    assert panel.get_ylabel() == "peak pressure over shear yield strength, $p_0/k$"
    for line, name, values in zip(
        panel.lines, ("shakedown", "Tresca", "Mises"), (shakedown, tresca, mises), strict=False
    ):
        assert name in line.get_label()
        np.testing.assert_array_equal(line.get_ydata(), values)
    # Johnson, Contact Mechanics, section 9.2: 4 k without friction
    assert panel.lines[0].get_ydata()[0] == pytest.approx(4.0, rel=1e-3)
