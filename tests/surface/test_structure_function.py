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
    with pytest.raises(InputError, match="lags must lie"):
        structure_functions(profiles=np.zeros((1, 10)), lags=np.array([10]))
