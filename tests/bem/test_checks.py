"""Each check lets the good through unchanged and names value and allowed range of the bad."""

import numpy as np
import pytest

from asperity.bem.checks import field_on_grid, grid, inside, positive
from asperity.errors import InputError


def test_positive():
    assert positive("length", 2, "m") == 2.0
    assert positive("length", np.inf, "m", infinite=True) == np.inf


@pytest.mark.parametrize(
    ("value", "infinite", "said"),
    [
        (0.0, False, "length = 0 m: it must be positive and finite"),
        (-3.0, True, "length = -3 m: it must be positive$"),
        (np.nan, True, "length = nan m: it must be positive$"),
        (np.inf, False, "length = inf m: it must be positive and finite"),
    ],
)
def test_what_is_not_positive(value, infinite, said):
    with pytest.raises(InputError, match=said):
        positive("length", value, "m", infinite=infinite)


def test_inside_takes_the_upper_bound_but_not_the_lower():
    assert inside("poisson_ratio", 0.5, -1.0, 0.5) == 0.5
    for value in (-1.0, 0.51, np.nan):
        with pytest.raises(InputError, match=r"poisson_ratio = .*: it must lie above -1 and be at most 0\.5"):
            inside("poisson_ratio", value, -1.0, 0.5)


def test_a_field_becomes_double_and_keeps_its_numbers():
    found = field_on_grid("height", np.array([[1, 2], [3, 4]], dtype=np.float32), (2, 2))
    assert found.dtype == np.float64
    np.testing.assert_array_equal(found, [[1.0, 2.0], [3.0, 4.0]])


def test_a_field_of_another_shape_or_with_holes():
    with pytest.raises(InputError, match=r"height has shape \(3,\): the grid of the half-space has \(4,\)"):
        field_on_grid("height", np.zeros(3), (4,))
    with pytest.raises(InputError, match="height has 2 of 4 values that are not finite"):
        field_on_grid("height", [0.0, np.nan, np.inf, 1.0], (4,))


def test_grids_of_one_and_two_axes():
    points, spacing = grid((4, 8), (1e-6, 2e-6))
    assert points == (4, 8)
    np.testing.assert_array_equal(spacing, [1e-6, 2e-6])
    assert grid((2,), (1.0,))[0] == (2,)


@pytest.mark.parametrize(
    ("shape", "pixel"), [((1,), (1.0,)), ((4, 4, 4), (1.0, 1.0, 1.0)), ((4, 4), (1.0,)), ((4,), (0.0,))]
)
def test_what_is_no_grid(shape, pixel):
    with pytest.raises(InputError, match=r"a grid has one or two axes|pixel_size = 0 m"):
        grid(shape, pixel)
