"""Rows of rolling bearings: nothing without ratings, and their limits."""

from types import SimpleNamespace

import numpy as np

from asperity.results import RESULTS
from asperity.results.solved import SolvedJoint


def test_a_joint_without_ratings_has_no_lives(paper_joint):
    solved = SolvedJoint(paper_joint(), SimpleNamespace(solved=np.array([True, True])), None)
    assert RESULTS["bearing_life"].of(solved).shape == (4, 2)
    assert np.all(np.isnan(np.asarray(RESULTS["bearing_static_safety"].of(solved))))


def test_limits_of_bearings():
    """ISO 76: at least as strong as the load; ISO 281: valid up to half the dynamic rating."""
    safety, ratio = RESULTS["bearing_static_safety"].limit, RESULTS["bearing_load_ratio"].limit
    assert [safety.is_kept(value) for value in (0.99, 1.0, 5.0)] == [False, True, True]
    assert [ratio.is_kept(value) for value in (0.1, 0.5, 0.51)] == [True, True, False]
