"""The paper's joint, solved once, as its rows see it."""

import numpy as np
import pytest

from asperity.results import RESULTS


@pytest.fixture(scope="session")
def value(solved_example):
    """A result by its name [SI]: a number, or one for each row."""
    return lambda name: np.asarray(RESULTS[name].of(solved_example), dtype=float)
