"""Closed forms of a sine and of Gaussian heights."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.height_parameters import height_parameters
from asperity.surface.topography import Topography


def test_sine():
    x = np.arange(10000) * 1e-7
    h = height_parameters(topography=Topography(2e-6 * np.sin(2 * np.pi * x / 1e-4 + 0.3), 1e-7))
    assert h.arithmetic_mean == pytest.approx(2e-6 * 2 / np.pi, rel=1e-4)
    assert h.root_mean_square == pytest.approx(2e-6 / np.sqrt(2), rel=1e-4)
    assert h.kurtosis == pytest.approx(1.5, rel=1e-4)
    assert abs(h.skewness) < 1e-6
    assert h.total_height == pytest.approx(4e-6, rel=1e-4)
    assert h.mean_element_width == pytest.approx(1e-4, rel=1e-3)


def test_gaussian_map_with_gaps():
    z = np.random.default_rng(0).standard_normal((300, 300))
    z[0, :5] = np.nan
    h = height_parameters(topography=Topography(z, 1.0, 1.0))
    assert (h.points, h.missing_points) == (89995, 5)
    assert h.arithmetic_mean == pytest.approx(np.sqrt(2 / np.pi), rel=0.01)
    assert h.kurtosis == pytest.approx(3.0, rel=0.03)
    assert h.mean_element_width is None


def test_nothing_to_evaluate():
    with pytest.raises(InputError):
        height_parameters(topography=Topography(np.full(4, np.nan), 1.0))
