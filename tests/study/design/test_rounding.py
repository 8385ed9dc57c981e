"""Multiples of a step next to a value, on both sides and at the bounds; and designs with few digits."""

import dataclasses

import numpy as np
import pytest

from asperity.study.design.design_problem import Constraint, Objective, Variable
from asperity.study.design.design_search import FEASIBLE, SearchProgress
from asperity.study.design.rounding import neighbours, rounded_design, shortened_design


@pytest.mark.parametrize(
    ("value", "expected"),
    [
        (5.1e-3, (5.0e-3, 5.5e-3)),
        (5.0e-3, (5.0e-3,)),
        (5.0e-3 * (1.0 + 1e-12), (5.0e-3,)),
        (3.2e-3, (3.5e-3,)),  # 3 mm is below the lower bound
        (14.9e-3, (14.5e-3,)),  # 15 mm is above the upper one
    ],
)
def test_neighbours_are_multiples_within_the_bounds(value, expected):
    length = Variable("drive.contact_length", 3.1e-3, 14.95e-3, False, step=0.5e-3)
    assert neighbours(length, value) == pytest.approx(expected, rel=1e-12)


def test_bounds_that_are_multiples_count_as_such():
    """Three times 0.1 is more than 0.3 to rounding, and 0.3 over 0.1 less than 3."""
    above, below = Variable("x", 3 * 0.1, 0.7, False, step=0.1), Variable("x", 0.1, 0.3, False, step=0.1)
    assert neighbours(above, 0.32) == pytest.approx((0.3, 0.4), rel=1e-12)
    assert neighbours(below, 0.28) == pytest.approx((0.2, 0.3), rel=1e-12)


PRELOAD, LENGTH = "load.preload", "drive.contact_length"
FREE = np.zeros(2, dtype=bool)


def test_a_design_gets_four_digits_and_keeps_its_bound(evaluator):
    """The mass is 100 L; the pressure sqrt(P/L) leaves room."""
    make = evaluator((Objective("mass", 1.0),), (Constraint("hertz_pressure", True, 1e10, (0, 1)),))
    scaled = make.scaled({PRELOAD: 1000.0 / 3.0, LENGTH: 2e-3})
    point, place = shortened_design(make, scaled, FREE)
    assert point == {PRELOAD: 333.3, LENGTH: 2e-3}
    assert make.point(place) == pytest.approx(point, rel=1e-15)


def test_a_limit_that_rounding_would_cross_is_kept_by_rounding_the_other_way(evaluator):
    """The smallest P under a limit of the slip ratio 50 M/P: 250.3 N would cross it, 250.4 N keep it."""
    exact = 250.33333349
    limit = 50.0 * 5.0 / exact
    make = evaluator(
        (Objective("preload", 1.0),), (Constraint("slip_ratio", True, limit, (0, 1)),), torques=(5.0,)
    )
    point, place = shortened_design(make, make.scaled({PRELOAD: exact, LENGTH: 5e-3}), FREE)
    assert make(place).violation <= FEASIBLE
    assert point[PRELOAD] == 250.4


def test_between_two_limits_there_are_more_digits(evaluator):
    """From 250.32 N for a slip ratio to at most 250.34 N: 250.3 and 250.4 N miss one of them."""
    limits = (
        Constraint("slip_ratio", True, 250.0 / 250.32, (0, 1)),
        Constraint("preload", True, 250.34, (0,)),
    )
    make = evaluator((Objective("mass", 1.0),), limits, torques=(5.0,))
    point, place = shortened_design(make, make.scaled({PRELOAD: 250.3333333, LENGTH: 2e-3}), FREE)
    assert make(place).violation <= FEASIBLE
    assert point[PRELOAD] in (250.33, 250.34)


def test_many_variables_are_rounded_one_after_the_other(evaluator, monkeypatch):
    """As above, with the way of each that keeps the limits."""
    monkeypatch.setattr("asperity.study.design.rounding._COMBINED", 1)
    make = evaluator(
        (Objective("preload", 1.0),),
        (Constraint("slip_ratio", True, 250.0 / 250.33333349, (0, 1)),),
        torques=(5.0,),
    )
    point, place = shortened_design(make, make.scaled({PRELOAD: 250.33333349, LENGTH: 5e-3}), FREE)
    assert make(place).violation <= FEASIBLE
    assert point == {PRELOAD: 250.4, LENGTH: 5e-3}


def test_sizes_with_a_step_keep_their_value(evaluator):
    make = evaluator((Objective("mass", 1.0),), (Constraint("hertz_pressure", True, 1e10, (0, 1)),))
    scaled = make.scaled({PRELOAD: 1000.0 / 3.0, LENGTH: 7.0 * 25.4e-3 / 64.0})
    point, _ = shortened_design(make, scaled, np.array([False, True]))
    assert point[LENGTH] == pytest.approx(7.0 * 25.4e-3 / 64.0, rel=1e-14)


def test_an_objective_that_may_be_negative_changes_by_a_thousandth_of_itself(evaluator):
    """The speed ratio -P/100, to be made small: four digits of 1234.56789 N change its 12 by less than that."""
    make = evaluator((Objective("speed_ratio", 1.0),), (Constraint("hertz_pressure", True, 1e10, (0, 1)),))
    point, _ = shortened_design(make, make.scaled({PRELOAD: 1234.56789, LENGTH: 5e-3}), FREE)
    assert point[PRELOAD] == 1235.0


@pytest.mark.parametrize(("step", "length"), [(1e-3, 5e-3), (0.15e-3, 4.65e-3)])
def test_sizes_are_rounded_to_the_side_that_keeps_the_limits(evaluator, step, length):
    """At most 0.52 GPa and a slip of 0.8: 312.5 N on 4.62 mm. Of 4 and 5 mm only 5 keep it, of 4.5 and 4.65 mm 4.65."""
    limits = (Constraint("hertz_pressure", True, 5.2e8, (0, 1)), Constraint("slip_ratio", True, 0.8, (0, 1)))
    make, told = evaluator((Objective("mass", 1.0),), limits), []
    preload, size = make.variables
    make.variables = (preload, dataclasses.replace(size, step=step))
    best = make.scaled({PRELOAD: 312.5, LENGTH: 312.5 * (2.0 / 520.0) ** 2})
    rounded, fixed = rounded_design(make, best, SearchProgress(lambda *done: told.append(done)))
    assert fixed.tolist() == [False, True]
    assert make.point(rounded)[LENGTH] == pytest.approx(length, rel=1e-12)
    assert make(rounded).violation <= FEASIBLE
    assert told[-1] == (2, 2)


def test_a_design_that_misses_a_limit_still_exists_when_it_is_rounded(evaluator):
    """At 300.004 N rollers have a clearance of 4 nm; 300 N leave none, 299.9 N would overlap."""
    limits = (Constraint("preload", True, 200.0, (0,)), Constraint("clearance", False, 0.2e-3, (0, 1)))
    make = evaluator((Objective("mass", 1.0),), limits)
    point, place = shortened_design(make, make.scaled({PRELOAD: 300.004, LENGTH: 5e-3}), FREE)
    assert point[PRELOAD] > 300.0
    assert make.nonexistence(make(place)) <= FEASIBLE
