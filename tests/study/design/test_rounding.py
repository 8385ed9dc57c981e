"""Multiples of a step next to a value, on both sides and at the bounds."""

import pytest

from asperity.study.design.design_problem import Variable
from asperity.study.design.rounding import neighbours


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
