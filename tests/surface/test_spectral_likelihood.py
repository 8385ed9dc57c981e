"""The fit on spectra that follow the model exactly."""

import numpy as np
import pytest

from asperity.surface.self_affine_band import widest_power_law
from asperity.surface.spectral_likelihood import fit_spectrum
from asperity.surface.spectrum import BinnedSpectrum


def exact(density, points=20000, independent=50.0):
    f = np.geomspace(1e2, 1e6, 80)
    return BinnedSpectrum(
        frequency=f,
        spread=np.zeros(80),
        ordinates=np.ones(80, dtype=np.int64),
        independent=np.full(80, independent),
        density=density(f),
        profiles=1,
        points=points,
        spacing=0.5e-6,
        differenced=True,
    )


def test_exact_power_law_and_its_covariance():
    spectrum = exact(lambda f: 1e-8 * f**-1.8)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", with_floor=False)
    assert fit.fractal_dimension == pytest.approx(1.6, abs=1e-8)
    assert fit.density(np.array([1e4]))[0] == pytest.approx(1e-8 * 1e4**-1.8, rel=1e-7)
    # straight-line regression: var(slope) = 1 / (nu sum u^2), D = (5 + slope) / 2
    u = np.log(spectrum.frequency / np.exp(np.mean(np.log(spectrum.frequency))))
    assert fit.covariance[0, 0] == pytest.approx(0.25 / (50.0 * np.sum(u**2)), rel=1e-6)


def test_floor_is_found_and_limits_the_band():
    spectrum = exact(lambda f: 1e-8 * f**-2.0 + 1e-18)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", with_floor=True)
    assert fit.fractal_dimension == pytest.approx(1.5, abs=1e-5)
    assert fit.floor == pytest.approx(1e-18, rel=1e-4)
    assert fit.usable_high == pytest.approx(1e5, rel=0.06)


def test_folded_power_is_the_sum_over_images():
    spectrum = exact(lambda f: 1e-8 * f**-1.6)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e5, tail="band_limited", with_floor=False)
    folded = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="folded", with_floor=False)
    f, fs = np.array([3e5]), 2e6
    k = np.arange(1, 200_000)
    images = folded.density(k * fs + f).sum() + folded.density(k * fs - f).sum()
    assert folded.expected(f)[0] == pytest.approx(float(folded.density(f)[0]) + images, rel=2e-3)
    assert fit.expected(f)[0] == fit.density(f)[0]


def test_band_stops_where_the_power_law_stops():
    def bent(f):
        return 1e-8 * f**-1.8 / (1 + (f / 1e5) ** 4)

    search = widest_power_law(
        spectrum=exact(bent, independent=500.0),
        low=None,
        high=None,
        noise_density=0.0,
        resolved_frequency=np.inf,
    )
    assert search.reason == ""
    assert 3e4 < search.fit.high < 2.5e5
    assert search.fit.fractal_dimension == pytest.approx(1.6, abs=0.03)


@pytest.mark.parametrize(
    ("density", "says"),
    [
        (lambda f: 1e-8 * f**-3.6, "falls as"),
        (lambda f: 1e-8 * f**-2.0 * (1 + 0.7 * np.sin(5 * np.log(f))), "%"),
    ],
)
def test_refusals_say_why(density, says):
    spectrum = exact(density, independent=500.0)
    search = widest_power_law(
        spectrum=spectrum, low=None, high=None, noise_density=0.0, resolved_frequency=np.inf
    )
    assert search.fit is None
    assert says in search.reason


def test_band_below_a_decade_is_refused():
    spectrum = exact(lambda f: 1e-8 * f**-2.0)
    search = widest_power_law(
        spectrum=spectrum, low=None, high=None, noise_density=0.0, resolved_frequency=1e3
    )
    assert "decades of wavelength" in search.reason
