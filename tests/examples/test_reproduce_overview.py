"""The example that draws the picture of the README."""

import numpy as np
import pytest


def test_the_joint_is_stiffest_near_1_85(load_example, tmp_path, monkeypatch, saved_figures):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    assert load_example("reproduce_overview").main(tmp_path / "overview.png") == pytest.approx(1.85, abs=0.02)
    (figure,) = saved_figures
    drive, panel = figure.axes
    assert (
        len(drive.patches) >= 1 + 3 * 3 + 1
    )  # sun, ring, and a planet with two loading rollers in each branch
    torques = [text.get_text() for text in panel.get_legend().get_texts()]
    assert torques == [f"{torque} N·m" for torque in range(6)]
    curves = [line for line in panel.lines if line.get_label() in torques]
    peaks = [np.max(line.get_ydata()) for line in curves]
    assert np.all(np.diff(peaks) < 0.0)  # more torque, less stiffness
    top = curves[-1].get_xdata()[np.argmax(curves[-1].get_ydata())]
    assert f"peak at $D$ = {top:.3f}" in [text.get_text() for text in panel.texts]
