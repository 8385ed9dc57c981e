"""Scaling of a free number to 0…1 and back, by hand and by differences."""

import numpy as np
import pytest

from asperity.study.design.design_problem import Objective, Variable

LINEAR = Variable("load.preload", 200.0, 1000.0, False)
LOGARITHMIC = Variable("surface.fractal_roughness", 1e-12, 1e-8, True)


def test_bounds_are_0_and_1_and_the_middle_is_a_mean():
    assert [LINEAR.to_unit(value) for value in (200.0, 600.0, 1000.0)] == [0.0, 0.5, 1.0]
    assert [LINEAR.from_unit(place) for place in (0.0, 0.25, 1.0)] == [200.0, 400.0, 1000.0]
    assert [LOGARITHMIC.to_unit(value) for value in (1e-12, 1e-10, 1e-8)] == pytest.approx([0.0, 0.5, 1.0])
    assert [LOGARITHMIC.from_unit(place) for place in (0.0, 0.25, 1.0)] == pytest.approx([1e-12, 1e-11, 1e-8])


@pytest.mark.parametrize("variable", [LINEAR, LOGARITHMIC])
def test_slope_is_that_of_the_value(variable):
    place = np.array([0.1, 0.5, 0.8])
    difference = (variable.from_unit(place + 1e-6) - variable.from_unit(place - 1e-6)) / 2e-6
    np.testing.assert_allclose(variable.slope(variable.from_unit(place)), difference, rtol=1e-8)


def test_an_objective_is_the_smallest_or_the_largest():
    texts = [Objective("mass", sign).text for sign in (1.0, -1.0)]
    assert texts == ["smallest mass of the rolling parts", "largest mass of the rolling parts"]
