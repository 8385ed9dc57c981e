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


def test_sizes_and_positions_are_in_metres():
    profile, height_map = Topography(np.zeros(5), 0.25), Topography(np.zeros((3, 8)), 0.5, 0.125)
    assert profile.size == (1.25,)
    assert height_map.size == (4.0, 0.375)
    np.testing.assert_array_equal(height_map.position, 0.5 * np.arange(8))
    rows, spacing = height_map.profiles(direction="y")
    assert (rows.shape, spacing) == ((8, 3), 0.125)
    cut = Topography(np.arange(10.0), 0.25).cut(start=0.5, stop=1.25)
    np.testing.assert_array_equal(cut.heights, [2, 3, 4, 5])
    half = Topography(np.arange(10.0), 0.25).cut(start=0.6, stop=1.15)  # to the nearest points
    np.testing.assert_array_equal(half.heights, [2, 3, 4, 5])


def test_longest_piece_is_the_longest_not_the_last():
    nan = np.nan
    z = line(1, 2, 3, nan, 4, 5, nan, 6)
    got = without_missing(topography=z, choice="longest")
    np.testing.assert_array_equal(got.heights, [1, 2, 3])
    assert got.notes == ("2 of 8 points missing: filled 0 along x, kept a complete piece of 3",)


def test_large_maps_are_searched_on_a_grid_of_cells():
    """1000 x 1000 points, one missing in the middle: nearly half of the map remains."""
    z = np.zeros((1000, 1000))
    z[500, 500] = np.nan
    got = without_missing(topography=Topography(z, 1.0, 1.0), choice="longest").heights
    assert got.shape in ((1000, 500), (500, 1000), (1000, 498), (498, 1000))
    assert not np.isnan(got).any()


def test_a_gap_beside_the_last_point_is_filled():
    nan = np.nan
    got = without_missing(topography=line(1, 2, nan, 4, nan), choice="interpolate")
    np.testing.assert_array_equal(got.heights, [1, 2, 3, 4])
    assert "filled 1 along x" in got.notes[0]
