"""Transform against double loop, with and without gaps."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.structure_function import logarithmic_lags, structure_functions


@pytest.mark.parametrize("gaps", [False, True])
def test_equals_the_double_loop(gaps):
    random = np.random.default_rng(3)
    z = np.cumsum(random.standard_normal((3, 301)), axis=1) + 7.0
    if gaps:
        z[random.random(z.shape) < 0.1] = np.nan
    lags = np.array([1, 2, 16, 17, 40, 150, 300])
    got = structure_functions(profiles=z, lags=lags)
    expected = np.array([[np.nanmean((row[k:] - row[:-k]) ** 2) if k else 0 for k in lags[:-1]] for row in z])
    np.testing.assert_allclose(got[:, :-1], expected, rtol=1e-9)


def test_lags_are_distinct_and_bounded():
    lags = logarithmic_lags(points=1000, per_decade=10, longest_fraction=0.25)
    assert lags[0] == 1
    assert lags[-1] == 250
    assert (np.diff(lags) > 0).all()
    with pytest.raises(InputError, match="lags must lie between 1 and 9 points"):
        structure_functions(profiles=np.zeros((1, 10)), lags=np.array([10]))


def test_lags_are_ten_to_a_decade():
    """Long lags follow 10^(k/10); the longest is the requested share of the record."""
    lags = logarithmic_lags(points=40_000, per_decade=10, longest_fraction=0.25)
    np.testing.assert_array_equal(lags[-11:], np.round(10_000 * 10 ** (np.arange(-10, 1) / 10)))


@pytest.mark.parametrize("gaps", [False, True])
def test_an_offset_costs_no_digits(gaps):
    """Heights of order one on an offset of 1e7: squares of 1e14 leave two digits of the difference."""
    z = np.cumsum(np.random.default_rng(4).standard_normal((2, 500)), axis=1)
    if gaps:
        z[:, ::7] = np.nan
    lags = np.array([1, 16, 17, 100, 400])
    level = structure_functions(profiles=z, lags=lags)
    np.testing.assert_allclose(structure_functions(profiles=z + 1e7, lags=lags), level, rtol=1e-6)
    assert np.isnan(structure_functions(profiles=np.array([[1.0, np.nan, 2.0]]), lags=np.array([1]))).all()


def test_blocks_of_rows_change_nothing(monkeypatch):
    from asperity.surface import structure_function

    z = np.random.default_rng(5).standard_normal((7, 60))
    whole = structure_functions(profiles=z, lags=np.array([1, 20, 59]))
    monkeypatch.setattr(structure_function, "_CHUNK_POINTS", 130)
    np.testing.assert_array_equal(structure_functions(profiles=z, lags=np.array([1, 20, 59])), whole)
