"""Scaling of a free number to 0…1 and back, by hand and by differences."""

from pathlib import Path

import numpy as np
import pytest

from asperity.study.design.design_problem import DesignProblem, Objective, Variable, WorstCase

ROOT = Path(__file__).parents[3]

LINEAR = Variable("load.preload", 200.0, 1000.0, False)
LOGARITHMIC = Variable("surface.fractal_roughness", 1e-12, 1e-8, True)


def test_bounds_are_0_and_1_and_the_middle_is_a_mean():
    assert [LINEAR.to_unit(value) for value in (200.0, 600.0, 1000.0)] == [0.0, 0.5, 1.0]
    assert [LINEAR.from_unit(place) for place in (0.0, 0.25, 1.0)] == [200.0, 400.0, 1000.0]
    assert [LOGARITHMIC.to_unit(value) for value in (1e-12, 1e-10, 1e-8)] == pytest.approx([0.0, 0.5, 1.0])
    assert [LOGARITHMIC.from_unit(place) for place in (0.0, 0.25, 1.0)] == pytest.approx(
        [1e-12, 1e-11, 1e-8], rel=1e-9, abs=0.0
    )


@pytest.mark.parametrize("variable", [LINEAR, LOGARITHMIC])
def test_slope_is_that_of_the_value(variable):
    place = np.array([0.1, 0.5, 0.8])
    difference = (variable.from_unit(place + 1e-6) - variable.from_unit(place - 1e-6)) / 2e-6
    np.testing.assert_allclose(variable.slope(variable.from_unit(place)), difference, rtol=1e-8)


def problem(case, *objectives):
    return DesignProblem(case, "", "assembly", (), objectives, (), WorstCase((), "none", 0, 0), 1, 0)


def test_the_goal_is_the_smallest_or_the_largest(case):
    goals = [problem(case, Objective("mass", sign)).goal for sign in (1.0, -1.0)]
    assert goals == ["smallest mass of the rolling parts", "largest mass of the rolling parts"]


def test_the_goal_has_words_that_fit_every_drive(case):
    """A first contact need not be one of a sun, and an outer body need not be a ring."""
    for name, words in (
        ("preload", "normal force of the first contact in the assembled drive"),
        ("envelope_diameter", "outer diameter of the largest body"),
    ):
        assert problem(case, Objective(name, 1.0)).goal == f"smallest {words}"
