"""What a result is: its rows, its units and the limit by which it is judged."""

import dataclasses
import math
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.results import RESULTS
from asperity.results.result import Limit, Result
from asperity.unit_table import Dimension


def test_both_sides_of_a_limit():
    slip, dimension = RESULTS["slip_ratio"].limit, RESULTS["fractal_dimension"].limit
    lifted = RESULTS["normal_force_over_preload"].limit
    assert [slip.is_kept(value) for value in (0.5, 1.0, math.inf)] == [True, False, False]
    assert [lifted.is_kept(value) for value in (0.5, 0.0)] == [True, False]
    assert [dimension.is_kept(value) for value in (1.01, 1.02, 1.5, 1.99, 1.995)] == [
        False,
        True,
        True,
        True,
        False,
    ]
    assert (slip.nearer_bound(9.0), lifted.nearer_bound(9.0)) == (1.0, 0.0)
    assert [dimension.nearer_bound(value) for value in (1.01, 1.995)] == [1.02, 1.99]


def test_rows_that_a_joint_does_not_have_are_not_judged():
    """Bearings without ratings have no row; a joint without any computes nothing."""
    safety = RESULTS["bearing_static_safety"]
    some = SimpleNamespace(
        joint=None,
        row_names=lambda axis: ("right_pin", "left_pin", "sun", "carrier"),
        has_bearings=(True, False, False, True),
        bearings=SimpleNamespace(static_safety=np.array([2.0, np.nan, np.nan, 0.5])),
    )
    assert safety.rows_of(some) == {"right_pin": 2.0, "carrier": 0.5}
    assert (
        safety.rows_of(SimpleNamespace(joint=None, has_bearings=(False,) * 4, row_names=some.row_names)) == {}
    )
    assert RESULTS["mass"].rows_of(SimpleNamespace(joint=None, size=SimpleNamespace(mass=3.0))) == {"": 3.0}


def test_limits_say_what_they_mean_and_what_to_do():
    judged = [result for result in RESULTS.values() if result.limit is not None]
    assert len(judged) >= 11
    for result in judged:
        limit = result.limit
        assert limit.kept != limit.crossed
        assert limit.remedy
        assert math.isfinite(limit.lowest) or math.isfinite(limit.highest)
        assert not limit.is_kept(math.nan)


@pytest.mark.parametrize(
    ("lowest", "highest", "nearer"),
    [
        (-math.inf, 1.0, {-5.0: 1.0, 5.0: 1.0}),
        (2.0, math.inf, {-5.0: 2.0, 5.0: 2.0}),
        (1.0, 2.0, {0.0: 1.0, 1.4: 1.0, 1.6: 2.0, 9.0: 2.0}),
    ],
)
def test_the_nearer_bound(lowest, highest, nearer):
    limit = Limit("model", "kept", "crossed", "remedy", lowest, highest)
    assert {value: limit.nearer_bound(value) for value in nearer} == nearer


def test_a_value_is_a_path_or_a_function():
    solved = SimpleNamespace(joint=None, result=SimpleNamespace(mass=3.0), row_names=lambda axis: ("a", "b"))
    path = Result("mass", "mass", Dimension.MASS, "kg", "result.mass")
    twice = Result("twice", "twice", Dimension.MASS, "kg", lambda s: 2.0 * s.result.mass, axis="body")
    assert (path.of(solved), twice.of(solved)) == (3.0, 6.0)
    assert (path.rows_of(solved), twice.rows_of(solved)) == ({"": 3.0}, {"a": 6.0, "b": 6.0})
    assert (path.row_shape, path.si_unit) == ((), "kg")
    assert dataclasses.replace(RESULTS["slip_ratio"], rows=("a", "b")).row_shape == (2,)
    assert np.isfinite(path.rows_of(solved)[""])


def test_where_a_result_has_no_value_is_said_by_its_note():
    assert RESULTS["drift_rate"].has_none == "where the input stands"
    assert RESULTS["bearing_duty_life"].has_none == (
        "without a duty or without a section for its ratings, such as [pin_bearing]"
    )
    assert RESULTS["mass"].has_none == RESULTS["slip_safety"].has_none == ""


def test_whatever_some_joints_lack_says_what_has_it():
    assert all(bool(row.only) == (row.present is not None) for row in RESULTS.values())
