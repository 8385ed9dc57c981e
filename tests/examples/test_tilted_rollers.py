"""The loads along tilted rollers, against slices of another program."""

import numpy as np
import pytest


def test_it_prints_the_peaks_of_an_independent_computation(load_example, tmp_path, capsys, saved_figures):
    peaks = load_example("tilted_rollers").main(tmp_path / "tilted.png")
    said = capsys.readouterr().out
    found = [float(line.split(": ")[1].split()[0]) for line in said.splitlines()]
    # without tilt and at 0.5 mrad: cylinders, Lundberg, Johns and Gohar, ISO/TS 16281, crown of 2 m
    expected = [1039.6, 1328.1, 1082.8, 1247.0, 1081.5, 1246.7, 1383.0, 1398.2, 1279.3, 1298.3]
    assert found == pytest.approx(expected, rel=2e-3)
    assert peaks["cylinders"][10] == pytest.approx(2.299, rel=1e-3)  # 1 mrad
    left, right = saved_figures[0].axes
    for line in left.lines:
        assert np.trapezoid(line.get_ydata(), line.get_xdata()) == pytest.approx(2000.0, rel=1e-6)
    assert len(right.lines) == 5
