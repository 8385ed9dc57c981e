"""Rows of the loads of pins and ring, by hand."""

from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results import RESULTS
from asperity.results.solved import SolvedJoint


def test_torques_of_the_papers_joint(value):
    """5 N·m at the carrier; the sun's 5/9 N·m turns the other way, so that the ring holds both."""
    assert abs(value("grounded_torque")) == pytest.approx(5.0 * (1.0 + 1.0 / 9.0), rel=1e-3)
    assert value("pin_load").shape == (2,)
    # both pins of a branch turn the carrier, at 35 mm from the axis: (F_right - F_left) cos(push angle 0)
    assert 3.0 * 35e-3 * abs(np.diff(value("pin_load"))[0]) == pytest.approx(5.0, rel=0.02)


def test_a_joint_without_ratings_has_no_lives(paper_joint):
    solved = SolvedJoint(paper_joint(), SimpleNamespace(solved=np.array([True, True])), None)
    assert RESULTS["bearing_life"].of(solved).shape == (4, 2)
    assert np.all(np.isnan(np.asarray(RESULTS["bearing_static_safety"].of(solved))))


def test_limits_of_bearings():
    """ISO 76: at least as strong as the load; ISO 281: valid up to half the dynamic rating."""
    safety, ratio = RESULTS["bearing_static_safety"].limit, RESULTS["bearing_load_ratio"].limit
    assert [safety.is_kept(value) for value in (0.99, 1.0, 5.0)] == [False, True, True]
    assert [ratio.is_kept(value) for value in (0.1, 0.5, 0.51)] == [True, True, False]
