"""Transform against double loop, with and without gaps."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.spectral_likelihood import SpectralFit
from asperity.surface.structure_function import (
    height_step,
    logarithmic_lags,
    quantisation_noise_density,
    resolved_frequency,
    structure_departure,
    structure_functions,
    structure_line,
    trend_share,
)
from asperity.surface.synthesis import self_affine_profile


@pytest.mark.parametrize("gaps", [False, True])
def test_equals_the_double_loop(gaps):
    random = np.random.default_rng(3)
    z = np.cumsum(random.standard_normal((3, 301)), axis=1) + 7.0
    if gaps:
        z[random.random(z.shape) < 0.1] = np.nan
    lags = np.array([1, 2, 16, 17, 40, 150, 300])
    got = structure_functions(profiles=z, lags=lags)
    expected = np.array([[np.nanmean((row[k:] - row[:-k]) ** 2) if k else 0 for k in lags[:-1]] for row in z])
    np.testing.assert_allclose(got[:, :-1], expected, rtol=1e-9)


def test_lags_are_distinct_and_bounded():
    lags = logarithmic_lags(points=1000, per_decade=10, longest_fraction=0.25)
    assert lags[0] == 1
    assert lags[-1] == 250
    assert (np.diff(lags) > 0).all()
    with pytest.raises(InputError, match="lags must lie between 1 and 9 points"):
        structure_functions(profiles=np.zeros((1, 10)), lags=np.array([10]))


def test_lags_are_ten_to_a_decade():
    """Long lags follow 10^(k/10); the longest is the requested share of the record."""
    lags = logarithmic_lags(points=40_000, per_decade=10, longest_fraction=0.25)
    np.testing.assert_array_equal(lags[-11:], np.round(10_000 * 10 ** (np.arange(-10, 1) / 10)))


@pytest.mark.parametrize("gaps", [False, True])
def test_an_offset_costs_no_digits(gaps):
    """Heights of order one on an offset of 1e7: squares of 1e14 leave two digits of the difference."""
    z = np.cumsum(np.random.default_rng(4).standard_normal((2, 500)), axis=1)
    if gaps:
        z[:, ::7] = np.nan
    lags = np.array([1, 16, 17, 100, 400])
    level = structure_functions(profiles=z, lags=lags)
    np.testing.assert_allclose(structure_functions(profiles=z + 1e7, lags=lags), level, rtol=1e-6)
    assert np.isnan(structure_functions(profiles=np.array([[1.0, np.nan, 2.0]]), lags=np.array([1]))).all()


def test_blocks_of_rows_change_nothing(monkeypatch):
    from asperity.surface import structure_function

    z = np.random.default_rng(5).standard_normal((7, 60))
    whole = structure_functions(profiles=z, lags=np.array([1, 20, 59]))
    monkeypatch.setattr(structure_function, "_CHUNK_POINTS", 130)
    np.testing.assert_array_equal(structure_functions(profiles=z, lags=np.array([1, 20, 59])), whole)


def test_step_is_found_under_a_tilt_and_absent_without_rounding():
    z = np.cumsum(np.random.default_rng(0).standard_normal((1, 3000)), axis=1)
    assert height_step(profiles=z) is None
    rounded = np.round(z / 0.7) * 0.7 + 0.01 * np.arange(3000)
    assert height_step(profiles=rounded) == pytest.approx(0.7, rel=0.02)


def test_many_small_moves_are_no_step():
    """Nine in ten moves are tiny and the others of any size: the tiny ones are multiples of nothing."""
    random = np.random.default_rng(3)
    tiny, large = 1e-4 * random.standard_normal(4000), random.uniform(0.5, 3.0, 4000)
    moves = np.where(random.random(4000) < 0.9, tiny, large * random.choice([-1.0, 1.0], 4000))
    assert height_step(profiles=np.cumsum(moves)[None]) is None


def test_staircase_with_rare_steps():
    z = np.cumsum(np.cumsum(np.random.default_rng(1).standard_normal((1, 20000)), axis=1), axis=1)
    step = 1e-2 * z.std()
    got = height_step(profiles=np.round(z / step) * step)
    assert got == pytest.approx(step, rel=1e-3)


def test_coarse_steps_are_found_and_limit_the_frequency():
    z = np.cumsum(np.random.default_rng(0).standard_normal((1, 20000)), axis=1)
    rounded = np.round(z / 5.0) * 5.0
    step = height_step(profiles=rounded)
    assert step == pytest.approx(5.0, rel=0.01)
    # a random walk moves by 5 rms in 25 points: waves of 100 points are resolved
    assert resolved_frequency(profiles=rounded, step=step, spacing=1.0) == pytest.approx(0.01, rel=0.5)
    assert resolved_frequency(profiles=z, step=0.1, spacing=1.0) == np.inf


def test_bearing_step(shared_data):
    """SOURCE.txt: heights in steps of about 0.076 um."""
    from asperity.surface.measure_files import read_surface

    t = read_surface(
        path=shared_data / "bearing_roller_profiles" / "NU206-RE-1.txt", position_unit="mm", height_unit="um"
    )
    assert height_step(profiles=t.heights[None]) == pytest.approx(0.076e-6, rel=0.03)


def test_noise_of_rounding_is_a_twelfth_of_the_square():
    assert quantisation_noise_density(step=3.0, spacing=2.0) == pytest.approx(2 * 2.0 * 9.0 / 12)


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
