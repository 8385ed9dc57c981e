"""Shift of the straight line through the structure function: closed forms and matrices written out."""

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.surface.spectral_likelihood import SpectralFit
from asperity.surface.structure_line import structure_departure, structure_line, trend_share
from asperity.surface.synthesis import self_affine_profile

SPACING = 1e-7
LEVEL = 2e-9  # P = LEVEL / f^2, that is D = 1.5
TAU = SPACING * np.array([1, 2, 5, 20, 100])


def spectral_fit(floor=0.0, roll_off=0.0, tail="folded", D=1.5):
    return SpectralFit(
        fractal_dimension=D,
        log_level=float(np.log(LEVEL) - (5 - 2 * D) * np.log(1e5)),
        reference_frequency=1e5,
        floor=floor,
        floor_error=0.0,
        roll_off=roll_off,
        roll_off_error=0.0,
        roll_off_exponent=2.0,
        covariance=np.zeros((2, 2)),
        low=1e3,
        high=5e6,
        tail=tail,
        log_likelihood=0.0,
        misfit=0.0,
        chi_square=1.0,
        degrees=1,
        converged=True,
        sampling_frequency=1 / SPACING,
    )


def test_an_unlimited_power_law_has_no_departure():
    assert np.abs(structure_departure(spectral_fit(), TAU)).max() < 1e-12 * LEVEL * TAU[0]


def test_white_noise_adds_twice_its_variance_at_every_lag():
    """Density n up to the sampling limit: variance n / (2 spacing)."""
    got = structure_departure(spectral_fit(floor=3e-22), TAU)
    np.testing.assert_allclose(got, 2 * 3e-22 * 0.5 / SPACING, rtol=2e-3)


def test_k_correlation_in_closed_form():
    r"""P = A / (f^2 + f0^2): S = (pi A / f0) (1 - exp(-2 pi f0 tau)); the power law alone: 2 pi^2 A tau."""
    f0 = 2e4
    got = structure_departure(spectral_fit(roll_off=f0**2), TAU)
    exact = np.pi * LEVEL / f0 * -np.expm1(-2 * np.pi * f0 * TAU) - 2 * np.pi**2 * LEVEL * TAU
    np.testing.assert_allclose(got[1:], exact[1:], rtol=0.02)


def test_missing_power_above_the_sampling_limit():
    r"""Without f > fN the sum lacks 2 A int (1 - cos) / f^2 df, at tau = k / (2 fN) written out by quadrature."""
    f_n = 0.5 / SPACING
    got = structure_departure(spectral_fit(tail="band_limited"), TAU[:3])
    f = np.linspace(f_n, 400 * f_n, 4_000_001)
    for tau, value in zip(TAU[:3], got, strict=True):
        wave = 2 * (1 - np.cos(2 * np.pi * f * tau)) * LEVEL / f**2
        lacking = np.sum(0.5 * (wave[1:] + wave[:-1])) * (f[1] - f[0]) + 2 * LEVEL / f[-1]
        assert value == pytest.approx(-lacking, rel=0.02, abs=0.0)


@pytest.mark.parametrize("hurst", [0.2, 0.5, 0.9])
def test_what_a_subtracted_line_takes_from_self_affine_heights(hurst):
    """Expectation of the structure function after the projection, from the covariance of the heights."""
    n, lags = 400, np.array([4, 20, 80])
    i = np.arange(n, dtype=float)
    S = np.abs(i[:, None] - i) ** (2 * hurst)
    covariance = 0.5 * (S[0] + S[0][:, None] - S)
    design = np.stack([np.ones(n), i], axis=1)
    projector = np.eye(n) - design @ np.linalg.pinv(design)
    left = projector @ covariance @ projector
    variance = np.diag(left)
    for lag in lags:
        detrended = np.mean(variance[lag:] + variance[:-lag] - 2 * np.diag(left, lag))
        expected = 1 - detrended / lag ** (2 * hurst)
        assert trend_share(np.array([lag / n]), hurst)[0] == pytest.approx(expected, rel=0.02, abs=2e-3)


def test_interval_grows_by_the_shift():
    """With a roll-off in the fit the covariance contains the square of what it does to the line."""
    random = np.random.default_rng(0)
    z = np.array(
        [
            self_affine_profile(
                points=4096, spacing=SPACING, fractal_dimension=1.5, fractal_roughness=1e-10, random=random
            )
            for _ in range(12)
        ]
    )
    plain = structure_line(profiles=z, spacing=SPACING, fit=spectral_fit(tail="band_limited"))
    bent = structure_line(profiles=z, spacing=SPACING, fit=spectral_fit(roll_off=2e4**2))
    assert plain.fractal_dimension == bent.fractal_dimension or bent.longest_wavelength < 1e-4
    assert bent.covariance[0, 0] > plain.covariance[0, 0] + 0.02**2
    assert plain.shortest_wavelength == pytest.approx(2e-7)
    assert plain.log_roughness == pytest.approx(np.log(1e-10), abs=0.5)


def test_less_than_a_decade_of_lags_is_refused():
    with pytest.raises(NoSolutionError, match="less than one decade"):
        structure_line(
            profiles=np.random.default_rng(0).standard_normal((1, 256)).cumsum(axis=1),
            spacing=SPACING,
            fit=spectral_fit(),
        )


def test_a_line_outside_the_range_is_refused_in_words():
    """Differences of white heights (D above 2) and no heights at all."""
    white = np.diff(np.random.default_rng(0).standard_normal((12, 4097)), axis=1)
    for heights in (white, np.zeros((12, 4096))):
        with pytest.raises(NoSolutionError, match="structure function"):
            structure_line(profiles=heights, spacing=SPACING, fit=spectral_fit(tail="band_limited"))
