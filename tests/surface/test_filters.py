"""Transmission of the Gaussian filter as the standard prints it."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.filters import filtered, gaussian_lowpass
from asperity.surface.topography import Topography


@pytest.mark.parametrize("ratio", [0.5, 1.0, 2.0])
def test_transmission(ratio):
    """2^-(cutoff/wavelength)^2: half at the cutoff (ISO 16610-21)."""
    x = np.arange(8000) * 1e-6
    wave = np.sin(2 * np.pi * x / (ratio * 400e-6))
    low = gaussian_lowpass(heights=wave, spacing=1e-6, cutoff=400e-6)
    middle = slice(2000, 6000)
    gain = np.dot(low[middle], wave[middle]) / np.dot(wave[middle], wave[middle])
    assert gain == pytest.approx(2.0 ** -(ratio**-2), abs=2e-4)


def test_constant_stays_and_gaps_stay_gaps():
    z = np.full(500, 3.0)
    z[100:120] = np.nan
    low = gaussian_lowpass(heights=z, spacing=1.0, cutoff=50.0)
    np.testing.assert_allclose(low[~np.isnan(z)], 3.0, rtol=1e-12)
    assert np.isnan(low).sum() == 20


def test_areal_filter_acts_along_both_axes():
    y, x = np.mgrid[0:300, 0:300]
    z = np.sin(2 * np.pi * x / 50) * np.sin(2 * np.pi * y / 50)
    low = filtered(topography=Topography(z, 1.0, 1.0), short_cutoff=50.0, long_cutoff=None).heights
    assert np.dot(low[100:200, 100:200].ravel(), z[100:200, 100:200].ravel()) / np.sum(
        z[100:200, 100:200] ** 2
    ) == pytest.approx(0.25, abs=1e-3)


def test_wrong_cutoffs():
    t = Topography(np.zeros(100), 1.0)
    for short, long in ((20.0, 10.0), (1.0, None), (None, 1000.0)):
        with pytest.raises(InputError):
            filtered(topography=t, short_cutoff=short, long_cutoff=long)
