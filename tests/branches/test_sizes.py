"""Sizes of branches: how far they may differ."""

import numpy as np
import pytest

from asperity.branches.sizes import SectorDeviations, refuse_wide
from asperity.errors import InputError


def test_up_to_three_times_the_nominal_interference():
    refuse_wide(np.array([-5e-6, 10e-6, 30e-6]), 10e-6)
    with pytest.raises(
        InputError, match=r"of branch 2, 30\.01 um, is more than 3 times that of equal .* 10 um"
    ):
        refuse_wide(np.array([10e-6, 30.01e-6]), 10e-6)


def test_a_further_deviation_is_that_of_the_first_track_of_the_first_sector():
    sizes = SectorDeviations(
        {"planet": np.array([1e-6, 2e-6]), "roller": np.zeros(2)},
        np.array([[3e-6, 1e-6], [0.0, 2e-6]]),
        np.array([1.0, -0.5]),
        0.0,
    ).with_first(4e-6)
    np.testing.assert_allclose(sizes.deviations["planet"], [5e-6, 2e-6], rtol=1e-12)
    np.testing.assert_array_equal(sizes.deviations["roller"], 0.0)
    np.testing.assert_allclose(sizes.added, [[7e-6, -1e-6], [0.0, 2e-6]], rtol=1e-12)
