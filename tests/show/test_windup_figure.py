"""Wind-up as a picture: the loop, its deviation from a straight line, and the stiffness, of a known curve."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.show.windup_figure import windup_figure

ARCSECOND = math.pi / (180.0 * 3600.0)


@pytest.fixture
def panels():
    torque = np.linspace(-4.0, 4.0, 9)
    straight, bow = 1e-4 * torque, 2e-6 * (16.0 - torque**2)
    curve = SimpleNamespace(
        torque=torque,
        stiffness=np.full(9, 1e4),
        angle=straight,
        unloading_angle=straight + bow,
        reloading_angle=straight - bow,
        stage_torque=np.array([0.0, 1.0, 2.0, 4.0]),
        stage_stiffness=np.full(3, 1e4),
        reverse_stage_stiffness=np.full(3, 1e4),
    )
    return windup_figure(curve, title="a joint").axes


def test_deviation_shows_the_hysteresis_that_the_loop_hides(panels):
    _, deviation, _ = panels
    first, unloading, reloading, _ = deviation.lines
    np.testing.assert_allclose(first.get_ydata(), 0.0, atol=1e-9)
    assert unloading.get_ydata()[4] == pytest.approx(3.2e-5 / ARCSECOND)
    np.testing.assert_allclose(reloading.get_ydata(), -unloading.get_ydata(), atol=1e-9)
    assert deviation.get_ylabel().endswith("[arcsec]")


def test_loop_and_stiffness_are_in_arcminutes(panels):
    loop, _, stiffness = panels
    assert loop.lines[0].get_xdata()[-1] == pytest.approx(4e-4 / (60.0 * ARCSECOND))
    assert stiffness.lines[0].get_ydata()[0] == pytest.approx(1e4 * 60.0 * ARCSECOND)
