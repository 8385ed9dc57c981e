"""Rows of the loads of pins and ring, by hand."""

import numpy as np
import pytest


def test_torques_of_the_papers_joint(value):
    """5 N·m at the carrier; the sun's 5/9 N·m turns the other way, so that the ring holds both."""
    assert abs(value("grounded_torque")) == pytest.approx(5.0 * (1.0 + 1.0 / 9.0), rel=1e-3)
    assert value("pin_load").shape == (2,)
    # both pins of a branch turn the carrier, at 35 mm from the axis: (F_right - F_left) cos(push angle 0)
    assert 3.0 * 35e-3 * abs(np.diff(value("pin_load"))[0]) == pytest.approx(5.0, rel=0.02)
