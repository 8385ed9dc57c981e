"""The load along crowned rollers."""

import numpy as np
import pytest


def test_every_curve_carries_the_force(load_example, tmp_path, saved_figures):
    example = load_example("crowned_rollers")
    shown = example.main(tmp_path / "crowns.png")
    assert np.all(np.diff(shown.line_load[0]) > 0.0)
    left, right, _ = saved_figures[0].axes
    assert left.get_ylabel() == "line load [N/mm]"
    for line in left.lines:
        y, load = line.get_xdata(), line.get_ydata()
        assert np.trapezoid(load, y) == pytest.approx(
            2000.0, rel=0.005
        )  # between the slices by interpolation
    (curve,) = right.lines
    assert np.all(np.diff(curve.get_ydata()) < 0.0)
