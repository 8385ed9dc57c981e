"""Conditioning, pooling and anisotropy; the figure draws both outcomes."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.fractal_fit import fractal_fit
from asperity.surface.line_spectrum import line_concentration
from asperity.surface.measure import Conditioning, DirectionalFits, conditioned, pooled_profiles
from asperity.surface.plots import measurement_figure
from asperity.surface.synthesis import self_affine_profile
from asperity.surface.topography import Topography

PLAIN = Conditioning("mean", None, "refuse", None, None, None)


def profile(seed, spacing=1e-7, G=1e-9):
    z = self_affine_profile(
        points=2000,
        spacing=spacing,
        fractal_dimension=1.5,
        fractal_roughness=G,
        random=np.random.default_rng(seed),
    )
    return Topography(z, spacing, source=f"p{seed}")


def test_filter_touches_height_parameters_only():
    t = profile(1)
    plain = conditioned(topography=t, conditioning=PLAIN)
    cut = conditioned(topography=t, conditioning=Conditioning("mean", None, "refuse", None, None, 2e-5))
    np.testing.assert_array_equal(plain.topography.heights, cut.topography.heights)
    assert cut.heights.root_mean_square < 0.7 * plain.heights.root_mean_square
    gap = t.with_heights(np.where(np.arange(2000) == 7, np.nan, t.heights))
    with pytest.raises(InputError, match="missing"):
        conditioned(topography=gap, conditioning=PLAIN)


def test_pooling():
    profiles, spacing, rows = pooled_profiles(surfaces=[profile(1), profile(2)], direction="x")
    assert (profiles.shape, spacing, rows) == ((2, 2000), 1e-7, False)
    with pytest.raises(InputError, match="different spacing"):
        pooled_profiles(surfaces=[profile(1), profile(2, spacing=2e-7)], direction="x")


def test_anisotropy_ratio_is_the_ratio_of_amplitudes():
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


def test_figure_of_a_fit_and_of_a_refusal(tmp_path):
    t = profile(4)
    fit = fractal_fit(
        profiles=t.heights[None],
        spacing=1e-7,
        estimator="likelihood",
        frequency_ratio=1.5,
        rows_of_a_map=False,
    )
    for name, outcome in (("fit", fit), ("refusal", "no power law")):
        figure = measurement_figure(surfaces=[t], fit=outcome, direction="x")
        assert all("[" in a.get_xlabel() and "[" in a.get_ylabel() for a in figure.axes)
        figure.savefig(tmp_path / f"{name}.png")


def test_lines_and_noise_are_distinguished():
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
