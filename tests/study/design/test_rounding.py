"""Multiples of a step next to a value, on both sides and at the bounds; and designs with few digits."""

import numpy as np
import pytest

from asperity.study.design.design_problem import Constraint, Objective, Variable
from asperity.study.design.design_search import FEASIBLE
from asperity.study.design.rounding import neighbours, shortened_design


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


PRELOAD, LENGTH = "load.preload", "drive.contact_length"
FREE = np.zeros(2, dtype=bool)


def test_a_design_gets_seven_digits_and_keeps_its_bound(evaluator):
    """The mass is 100 L; the pressure sqrt(P/L) leaves room."""
    make = evaluator((Objective("mass", 1.0),), (Constraint("hertz_pressure", True, 1e10, (0, 1)),))
    scaled = make.scaled({PRELOAD: 1000.0 / 3.0, LENGTH: 2e-3})
    point, place = shortened_design(make, scaled, FREE)
    assert point == {PRELOAD: 333.3333, LENGTH: 2e-3}
    assert make.point(place) == pytest.approx(point, rel=1e-15)


def test_a_limit_that_rounding_would_cross_gets_more_digits(evaluator):
    """The smallest P under a limit of the slip ratio 50 M/P, whose seven digits are too small by 1.4e-7."""
    exact = 250.33333349
    limit = 50.0 * 5.0 / exact
    make = evaluator(
        (Objective("preload", 1.0),), (Constraint("slip_ratio", True, limit, (0, 1)),), torques=(5.0,)
    )
    point, place = shortened_design(make, make.scaled({PRELOAD: exact, LENGTH: 5e-3}), FREE)
    assert make(place).violation <= FEASIBLE
    assert point[PRELOAD] == pytest.approx(exact, rel=FEASIBLE)
    assert point[PRELOAD] == float(f"{point[PRELOAD]:.9g}")


def test_sizes_with_a_step_keep_their_value(evaluator):
    make = evaluator((Objective("mass", 1.0),), (Constraint("hertz_pressure", True, 1e10, (0, 1)),))
    scaled = make.scaled({PRELOAD: 1000.0 / 3.0, LENGTH: 7.0 * 25.4e-3 / 64.0})
    point, _ = shortened_design(make, scaled, np.array([False, True]))
    assert point[LENGTH] == pytest.approx(7.0 * 25.4e-3 / 64.0, rel=1e-14)
