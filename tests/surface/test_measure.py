"""Conditioning, pooling and anisotropy; lines and noise are told apart."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.fractal_fit import FractalFit, fractal_fit
from asperity.surface.line_spectrum import line_concentration
from asperity.surface.measure import Conditioning, DirectionalFits, conditioned, pooled_profiles
from asperity.surface.topography import Topography

PLAIN = Conditioning("mean", None, "refuse", None, None, None)


def test_filter_touches_height_parameters_only(profile):
    t = profile(1)
    plain = conditioned(topography=t, conditioning=PLAIN)
    cut = conditioned(topography=t, conditioning=Conditioning("mean", None, "refuse", None, None, 2e-5))
    np.testing.assert_array_equal(plain.topography.heights, cut.topography.heights)
    assert plain.heights == cut.heights
    assert cut.roughness.lengths["Rq"] < 0.7 * plain.heights.root_mean_square
    assert plain.roughness.startswith("Ra is ")  # more than the class of 0.08 mm holds, on 0.2 mm of length
    gap = t.with_heights(np.where(np.arange(2000) == 7, np.nan, t.heights))
    with pytest.raises(InputError, match="missing"):
        conditioned(topography=gap, conditioning=PLAIN)


def test_pooling(profile):
    profiles, spacing, rows = pooled_profiles(surfaces=[profile(1), profile(2)], direction="x")
    assert (profiles.shape, spacing, rows) == ((2, 2000), 1e-7, False)
    with pytest.raises(InputError, match="different spacing"):
        pooled_profiles(surfaces=[profile(1), profile(2, spacing=2e-7)], direction="x")


def test_anisotropy_ratio_is_the_ratio_of_amplitudes(profile):
    def fit(scale):
        return fractal_fit(
            profiles=scale * profile(3).heights[None],
            spacing=1e-7,
            estimator="likelihood",
            frequency_ratio=1.5,
            rows_of_a_map=False,
        )

    assert DirectionalFits(fit(3.0), fit(1.0)).anisotropy_ratio == pytest.approx(3.0, rel=1e-4)
    assert DirectionalFits(fit(3.0), "refused").anisotropy_ratio is None


def power_law(dimension, roughness, shortest, longest):
    return FractalFit(
        fractal_dimension=dimension,
        log_roughness=np.log(roughness),
        covariance=np.eye(2),
        frequency_ratio=1.5,
        shortest_wavelength=shortest,
        longest_wavelength=longest,
        estimator="likelihood",
        profiles=1,
        points=1000,
        noise_density=0.0,
        roll_off_wavelength=None,
        height_step=None,
        misfit=0.0,
        reduced_chi_square=1.0,
    )


def test_anisotropy_of_unlike_power_laws_is_that_at_the_middle_of_the_common_band():
    """P = G^(2D-2) f^(2D-5)/2 at the wavelength of 20 um between 10 and 40; amplitudes are roots of P."""
    x, y = power_law(1.3, 2e-9, 1e-6, 4e-5), power_law(1.6, 5e-8, 1e-5, 3e-4)
    f = 1 / 2e-5
    expected = np.sqrt(2e-9**0.6 * f**-2.4 / (5e-8**1.2 * f**-1.8))
    assert DirectionalFits(x, y).anisotropy_ratio == pytest.approx(expected, rel=1e-12)


def test_profiles_of_several_files_are_cut_to_the_shortest_and_share_a_spacing(profile):
    short = Topography(profile(2).heights[:1500], 1e-7 * (1 + 0.99e-3), source="short")
    profiles, spacing, _ = pooled_profiles(surfaces=[profile(1), short], direction="x")
    assert (profiles.shape, spacing) == ((2, 1500), 1e-7)
    np.testing.assert_array_equal(profiles[0], profile(1).heights[:1500])
    other = Topography(short.heights, 1e-7 * (1 + 1.02e-3), source="other")
    with pytest.raises(InputError, match="different spacing"):
        pooled_profiles(surfaces=[profile(1), other], direction="x")
    with pytest.raises(InputError, match="only profiles can be averaged"):
        pooled_profiles(
            surfaces=[Topography(np.zeros((3, 4)), 1e-7, 1e-7, source="map"), profile(1)], direction="x"
        )


def test_lines_and_noise_are_distinguished(profile):
    x = np.arange(8192) / 8192
    comb = sum(1.5 ** (-0.5 * n) * np.cos(2 * np.pi * 1.5**n * x + n) for n in range(20))
    assert line_concentration(profile=comb, frequency_ratio=1.5) > 0.95
    assert line_concentration(profile=profile(5).heights, frequency_ratio=1.5) < 0.6
    with pytest.raises(NoSolutionError, match="not a series of lines"):
        fractal_fit(
            profiles=profile(5).heights[None],
            spacing=1e-7,
            estimator="lines",
            frequency_ratio=1.5,
            rows_of_a_map=False,
        )
