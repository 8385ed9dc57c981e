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


@pytest.mark.parametrize(("cutoff", "allowed"), [(0.99, False), (1.0, True), (20.0, True), (20.1, False)])
def test_cutoff_from_twice_the_spacing_to_the_length(cutoff, allowed):
    """40 points of 0.5: twice the spacing is 1, the length 20."""
    heights = np.sin(np.arange(40.0))
    if allowed:
        assert gaussian_lowpass(heights=heights, spacing=0.5, cutoff=cutoff).shape == (40,)
    else:
        with pytest.raises(InputError, match=r"\(1 m\).*\(20 m\)"):
            gaussian_lowpass(heights=heights, spacing=0.5, cutoff=cutoff)


def test_weights_are_those_of_the_standard_at_any_spacing():
    """A single spike shows the weighting function exp[-pi (x / (alpha lambda_c))^2] / (alpha lambda_c)."""
    z = np.zeros(401)
    z[200] = 1.0
    x = (np.arange(401) - 200) * 0.25
    alpha = 0.46971863934982566  # sqrt(ln 2 / pi), ISO 16610-21 prints 0.4697
    weight = np.exp(-np.pi * (x / (alpha * 10.0)) ** 2) / (alpha * 10.0)
    np.testing.assert_allclose(
        gaussian_lowpass(heights=z, spacing=0.25, cutoff=10.0), 0.25 * weight, atol=1e-9
    )


def test_band_between_both_cutoffs():
    """Roughness between lambda_s and lambda_c passes; both lengths go into the notes."""
    x = np.arange(4000) * 1e-6
    waves = {wavelength: np.sin(2 * np.pi * x / wavelength) for wavelength in (4e-6, 100e-6, 3000e-6)}
    got = filtered(topography=Topography(sum(waves.values()), 1e-6), short_cutoff=20e-6, long_cutoff=600e-6)
    middle = slice(1500, 2500)
    np.testing.assert_allclose(got.heights[middle], waves[100e-6][middle], atol=0.09)
    assert "lambda_s = 2e-05 m" in got.notes[0]
    assert "lambda_c = 0.0006 m" in got.notes[1]
