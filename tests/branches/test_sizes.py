"""Sizes of branches: how far they may differ."""

import numpy as np
import pytest

from asperity.branches.sizes import refuse_wide
from asperity.errors import InputError


def test_up_to_three_times_the_nominal_interference():
    refuse_wide(np.array([-5e-6, 10e-6, 30e-6]), 10e-6)
    with pytest.raises(
        InputError, match=r"of branch 2, 30\.01 um, is more than 3 times that of equal .* 10 um"
    ):
        refuse_wide(np.array([10e-6, 30.01e-6]), 10e-6)
