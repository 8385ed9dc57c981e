"""Known forms vanish, roughness stays; outliers are marked."""

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface.levelling import (
    default_form,
    filtered,
    gaussian_lowpass,
    levelled,
    without_outliers,
)
from asperity.surface.topography import Topography

Y, X = np.mgrid[0:20, 0:30].astype(float)


@pytest.mark.parametrize(
    ("form", "degree", "z"),
    [
        ("plane", None, 3 + 2 * X - Y),
        ("cylinder_x", None, 1 + X - 0.1 * X**2),
        ("cylinder_y", None, Y + 0.3 * Y**2),
        ("polynomial", 3, X**2 * Y - 4 * Y**3 + X),
    ],
)
def test_form_of_a_map_vanishes_even_with_gaps(form, degree, z):
    z = z.copy()
    z[3:6, 4:9] = np.nan
    flat = levelled(topography=Topography(z, 1.0, 1.0), form=form, degree=degree).heights
    assert np.nanmax(np.abs(flat)) < 1e-9 * np.nanmax(np.abs(z))
    assert np.isnan(flat).sum() == 15


def test_line_is_the_least_squares_line():
    z = np.random.default_rng(0).standard_normal(100)
    x = np.arange(100)
    expected = z - np.polyval(np.polyfit(x, z, 1), x)
    np.testing.assert_allclose(
        levelled(topography=Topography(z, 1.0), form="line").heights, expected, atol=1e-12
    )


def test_wrong_forms():
    t = Topography(np.zeros(5), 1.0)
    for form, degree in (("plane", None), ("sphere", None), ("polynomial", None), ("polynomial", 40)):
        with pytest.raises(InputError):
            levelled(topography=t, form=form, degree=degree)


def test_default_form_removes_the_tilt_and_what_leaves_it_is_refused():
    """Of z = tilt + noise with the variances 1 : 1/24 the tilt has 96 %; at 1 : 1/6 it has 86 %."""
    x = np.linspace(-1.0, 1.0, 2001)
    tilt = x / x.std()
    noise = np.random.default_rng(5).standard_normal(2001)
    noise -= np.polyval(np.polyfit(x, noise, 1), x)
    noise /= noise.std()
    steep, gentle = (Topography(tilt + noise / np.sqrt(n), 1.0, source="t") for n in (24, 6))
    for form in ("none", "mean"):
        with pytest.raises(InputError, match=r"tilt makes up 96.0 % .* use the form 'line'"):
            levelled(topography=steep, form=form)
        assert levelled(topography=gentle, form=form).heights.std() == pytest.approx(np.sqrt(7 / 6))
    flat = levelled(topography=steep, form=default_form(steep))
    np.testing.assert_allclose(flat.heights, noise / np.sqrt(24), atol=1e-12)
    assert flat.notes == ("form removed: line",)
    assert default_form(Topography(np.zeros((3, 3)), 1.0, 1.0)) == "plane"
    with pytest.raises(InputError, match="use the form 'plane'"):
        levelled(topography=Topography(X - Y + 1e-3 * np.sin(X * Y), 1.0, 1.0), form="mean")


def test_outliers():
    z = 0.01 * np.random.default_rng(1).standard_normal(500)
    z[[50, 300]] = 5.0
    got = without_outliers(topography=Topography(z, 1.0), threshold=8.0, window=9)
    np.testing.assert_array_equal(np.flatnonzero(np.isnan(got.heights)), [50, 300])
    with pytest.raises(InputError):
        without_outliers(topography=got, threshold=8.0, window=4)


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
        with pytest.raises(InputError, match=r"\(1000 mm\).*\(20000 mm\)"):
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
