"""The fit on spectra that follow the model exactly."""

from dataclasses import replace

import numpy as np
import pytest

from asperity.surface.spectral_likelihood import _misfit, areal_share, fit_spectrum


def test_exact_power_law_and_its_covariance(exact):
    spectrum = exact(lambda f: 1e-8 * f**-1.8)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0)
    assert fit.fractal_dimension == pytest.approx(1.6, abs=1e-8)
    assert fit.density(np.array([1e4]))[0] == pytest.approx(1e-8 * 1e4**-1.8, rel=1e-7, abs=0.0)
    # linear regression of ln P on D, the level, the first term of a roll-off f^-2 and of a white part f^beta
    u = spectrum.frequency / fit.reference_frequency
    design = np.stack([2 * np.log(u), np.ones(80), -0.9 * u**-2.0, u**1.8], axis=1)
    expected = np.linalg.inv(50.0 * design.T @ design)
    np.testing.assert_allclose(fit.covariance, expected[:2, :2], rtol=1e-4)
    assert fit.misfit == 0.0
    assert abs(fit.roll_off) < 1e-6 * 1e2**2
    assert fit.floor_error == pytest.approx(
        fit.density(np.array([fit.reference_frequency]))[0] * np.sqrt(expected[3, 3]), rel=1e-4, abs=0.0
    )


def test_roll_off_is_part_of_the_model(exact):
    """K-correlation at 1e4 1/m, and a sharp corner: the same D as without."""
    for density, m in (
        (lambda f: 1e-8 * (f**2 + 1e8) ** -0.9, 2.0),
        (lambda f: 1e-8 * (f**8 + 1e32) ** -0.225, 8.0),
    ):
        fit = fit_spectrum(
            spectrum=exact(density), low=1e2, high=1e6, tail="band_limited", roll_off_exponent=m
        )
        assert fit.fractal_dimension == pytest.approx(1.6, abs=1e-5)
        assert fit.roll_off ** (-1 / m) == pytest.approx(1e-4, rel=1e-4)
        f = np.geomspace(1e2, 1e6, 7)
        np.testing.assert_allclose(fit.expected(f), density(f), rtol=1e-4)
        low, high = fit.usable_band
        # (1 + x^m)^(1.8 / m) = 2 where the roll-off takes half
        assert low == pytest.approx(1e4 / (2 ** (m / 1.8) - 1) ** (1 / m), rel=0.03)
        assert high == pytest.approx(1e6)


def test_misfit_is_an_estimate_not_a_threshold(exact):
    """Residuals of 4 % about a power law that sampling makes uncertain by 2 %: what is beyond is 3.5 %."""
    wobble = 1.0 + 0.04 * np.sqrt(2.0) * np.cos(np.pi * np.arange(80) / 2 + 0.7)
    spectrum = exact(lambda f: 1e-8 * f**-1.8 * wobble, independent=2500.0)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0)
    assert fit.chi_square / fit.degrees == pytest.approx(0.04**2 * 2500 * 80 / 76, rel=0.03)
    assert fit.misfit == pytest.approx(np.sqrt(0.04**2 * 80 / 76 - 0.02**2), rel=0.03)
    quiet = fit_spectrum(
        spectrum=exact(lambda f: 1e-8 * f**-1.8 * wobble, independent=50.0),
        low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0,
    )  # fmt: skip
    assert quiet.misfit == 0.0  # 14 % of sampling scatter hide it
    exact_covariance = fit_spectrum(
        spectrum=exact(lambda f: 1e-8 * f**-1.8, independent=2500.0),
        low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0,
    ).covariance  # fmt: skip
    assert fit.covariance[0, 0] == pytest.approx(
        exact_covariance[0, 0] * fit.chi_square / fit.degrees, rel=0.05
    )


def test_misfit_of_bins_alike_is_what_sampling_does_not_explain():
    """sum r^2 = degrees (1/nu + tau^2)."""
    residual, nu = 0.04 * np.cos(np.arange(30.0)), np.full(30, 5000.0)
    expected = float(np.sum(residual**2)) / 26 - 1 / 5000
    assert _misfit(residual, nu, 26) == pytest.approx(expected, rel=1e-5)
    assert _misfit(residual, nu / 10, 26) == 0.0


def test_floor_is_found_and_limits_the_band(exact):
    spectrum = exact(lambda f: 1e-8 * f**-2.0 + 1e-18)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0)
    assert fit.fractal_dimension == pytest.approx(1.5, abs=1e-5)
    assert fit.floor == pytest.approx(1e-18, rel=1e-4, abs=0.0)
    assert fit.usable_band[1] == pytest.approx(1e5, rel=0.06)


def test_folded_power_is_the_sum_over_images(exact):
    spectrum = exact(lambda f: 1e-8 * f**-1.6)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e5, tail="band_limited", roll_off_exponent=2.0)
    folded = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="folded", roll_off_exponent=2.0)
    folded = replace(folded, floor=0.0, roll_off=0.0)
    f, fs = np.array([3e5]), 2e6
    k = np.arange(1, 200_000)
    images = folded.density(k * fs + f).sum() + folded.density(k * fs - f).sum()
    assert folded.expected(f)[0] == pytest.approx(float(folded.density(f)[0]) + images, rel=2e-3, abs=0.0)
    assert fit.expected(f)[0] == pytest.approx(fit.density(f)[0], rel=1e-6)


@pytest.mark.parametrize("tail", ["band_limited", "folded", "areal"])
@pytest.mark.parametrize("m", [2.0, 8.0])
def test_all_parts_of_the_model_together_are_recovered(exact, tail, m):
    """Power law of D = 1.6 with roll-off at 2e3 1/m, white part and tail, written out here with image sums."""
    f_s = 2e6

    def law(f):
        return 1e-8 * f**-1.8

    def density(f):
        bent = law(f) * (1 + (2e3 / f) ** m) ** (-1.8 / m)
        if tail == "areal":
            y = np.geomspace(1e-7, 1e6, 20_001)[:, None] * 1e6
            kernel = (f**2 + y**2) ** -1.4
            cumulated = np.cumsum(0.5 * (kernel[1:] + kernel[:-1]) * np.diff(y, axis=0), axis=0)
            bent *= cumulated[np.searchsorted(y[1:, 0], 1e6)] / cumulated[-1]
        if tail == "folded":
            k = np.arange(1, 20_001)[:, None]
            rest = 2 * 1e-8 * f_s**-1.8 * 20_000.5**-0.8 / 0.8  # of the sum, as an integral
            bent = bent + (law(k * f_s + f) + law(k * f_s - f)).sum(axis=0) + rest
        return bent + 4e-20

    fit = fit_spectrum(
        spectrum=exact(density, independent=2000.0), low=1e2, high=1e6, tail=tail, roll_off_exponent=m
    )
    assert fit.converged
    assert fit.fractal_dimension == pytest.approx(1.6, abs=1e-3)
    assert fit.floor == pytest.approx(4e-20, rel=0.02, abs=0.0)
    assert fit.roll_off ** (-1 / m) == pytest.approx(1 / 2e3, rel=0.01)
    f = np.geomspace(2e2, 9e5, 9)
    np.testing.assert_allclose(fit.expected(f), density(f), rtol=3e-3)


def test_errors_of_the_departures_are_those_of_the_regression(exact):
    """K-correlation and floor: standard errors from the design written out at the truth."""
    density = lambda f: 1e-8 * (f**2 + 1e8) ** -0.9 + 4e-20  # noqa: E731
    spectrum = exact(density, independent=2000.0)
    fit = fit_spectrum(spectrum=spectrum, low=1e2, high=1e6, tail="band_limited", roll_off_exponent=2.0)
    f, P = spectrum.frequency, density(spectrum.frequency)
    law = P - 4e-20
    columns = [law * (2 * np.log(f / fit.reference_frequency) + np.log1p(1e8 / f**2)), law]
    columns += [-0.9 * law / (f**2 + 1e8), np.ones_like(f)]
    design = np.stack(columns, axis=1) / P[:, None]
    design /= (scale := np.sqrt((design**2).sum(axis=0)))
    errors = np.sqrt(np.diag(np.linalg.inv(2000.0 * design.T @ design))) / scale
    assert np.sqrt(fit.covariance[0, 0]) == pytest.approx(errors[0], rel=1e-3)
    assert np.sqrt(fit.covariance[1, 1]) == pytest.approx(errors[1], rel=1e-3)
    assert fit.roll_off_error == pytest.approx(errors[2], rel=1e-3)
    assert fit.floor_error == pytest.approx(errors[3], rel=1e-3, abs=0.0)
    assert fit.roll_off_wavelength == pytest.approx(1e-4, rel=1e-4)


def test_too_few_bins_and_empty_bins_are_not_fitted(exact):
    spectrum = exact(lambda f: 1e-8 * f**-1.8)
    f = spectrum.frequency

    def fitted(low, high, spectrum=spectrum):
        return fit_spectrum(spectrum=spectrum, low=low, high=high, tail="band_limited", roll_off_exponent=2.0)

    assert fitted(f[10], f[15]) is None  # six bins, four parameters
    seven = fitted(f[10], f[16])
    assert (seven.low, seven.high, seven.degrees) == (f[10], f[16], 3)
    assert fitted(1e2, 1e6, exact(lambda f: np.where(f > 5e5, 0.0, f**-1.8))) is None


@pytest.mark.parametrize("exponent", [1.3, 2.0, 2.8])
def test_areal_share_is_the_quotient_of_the_integrals(exponent):
    for x in (0.05, 0.4, 1.0):
        y = np.geomspace(1e-6, 1e7, 400_001)
        density = (x**2 + y**2) ** (-0.5 * (exponent + 1))
        cumulated = np.cumsum(0.5 * (density[1:] + density[:-1]) * np.diff(y))
        expected = np.interp(1.0, y[1:], cumulated) / cumulated[-1]
        assert areal_share(np.array([x]), exponent)[0] == pytest.approx(expected, rel=1e-4)


def test_a_roll_off_is_a_wavelength_where_its_error_is_below_a_quarter(exact):
    """lambda = c^(-1/m): the relative error of the wavelength is that of c over m."""
    fit = fit_spectrum(
        spectrum=exact(lambda f: 1e-8 * (f**8 + 1e32) ** -0.225, independent=2000.0),
        low=1e2, high=1e6, tail="band_limited", roll_off_exponent=8.0,
    )  # fmt: skip
    assert replace(fit, roll_off_error=0.24 * 8 * fit.roll_off).roll_off_wavelength == pytest.approx(
        1e-4, rel=1e-3
    )
    assert replace(fit, roll_off_error=0.26 * 8 * fit.roll_off).roll_off_wavelength is None
