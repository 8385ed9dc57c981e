"""Missing points: counted, and handled only by choice."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.topography import Topography, without_missing


def line(*values):
    return Topography(np.array(values, dtype=float), 1.0, source="t")


def test_refusal_names_the_number():
    with pytest.raises(InputError, match="1 of 3 points"):
        without_missing(topography=line(0, np.nan, 1), choice="refuse")


def test_longest_and_interpolated_profile():
    gap = line(np.nan, 1, np.nan, 3, 4, 5, np.nan)
    np.testing.assert_array_equal(without_missing(topography=gap, choice="longest").heights, [3, 4, 5])
    np.testing.assert_array_equal(
        without_missing(topography=gap, choice="interpolate").heights, [1, 2, 3, 4, 5]
    )


def test_largest_rectangle_equals_brute_force():
    random = np.random.default_rng(0)
    z = np.where(random.random((9, 11)) < 0.15, np.nan, 1.0)
    got = without_missing(topography=Topography(z, 1.0, 1.0), choice="longest").heights
    best = max(
        (b - t) * (r - l)
        for t in range(9)
        for b in range(t + 1, 10)
        for l in range(11)  # noqa: E741
        for r in range(l + 1, 12)
        if not np.isnan(z[t:b, l:r]).any()
    )
    assert got.size == best


def test_cut_and_directions_and_bad_input():
    t = line(*range(10))
    np.testing.assert_array_equal(t.cut(start=2.0, stop=4.0).heights, [2, 3, 4])
    with pytest.raises(InputError, match="no points"):
        t.cut(start=20.0, stop=30.0)
    with pytest.raises(InputError, match="direction"):
        t.profiles(direction="y")
    with pytest.raises(InputError, match="positive"):
        Topography(np.zeros(3), 0.0)
    with pytest.raises(InputError, match="infinite"):
        line(1, np.inf)
