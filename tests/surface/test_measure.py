"""Conditioning, pooling and anisotropy; the figure draws both outcomes."""

import numpy as np
import pytest

from asperity.errors import InputError, NoSolutionError
from asperity.surface.fractal_fit import FractalFit, fractal_fit
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


def test_profiles_of_several_files_are_cut_to_the_shortest_and_share_a_spacing():
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


def axes_by_title(figure):
    return {axes.get_title(): axes for axes in figure.axes}


def lines_by_label(axes):
    return {line.get_label(): line for line in axes.get_lines()}


def test_figure_of_a_fit_draws_the_data_and_the_law():
    t = profile(4)
    z = t.heights - np.polyval(np.polyfit(t.position, t.heights, 1), t.position)
    t = t.with_heights(z)
    fit = fractal_fit(
        profiles=z[None], spacing=1e-7, estimator="likelihood", frequency_ratio=1.5, rows_of_a_map=False
    )
    figure = measurement_figure(surfaces=[t], fit=fit, direction="x")
    axes = axes_by_title(figure)
    assert set(axes) == {"p4", "Spectrum", "Structure function"}
    (drawn,) = axes["p4"].get_lines()
    np.testing.assert_allclose(drawn.get_xdata(), np.arange(2000) * 0.1, atol=1e-9)
    np.testing.assert_allclose(drawn.get_ydata(), 1e6 * z, rtol=1e-12)
    assert (axes["p4"].get_xlabel(), axes["p4"].get_ylabel()) == ("x [µm]", "height z [µm]")
    D, G = fit.fractal_dimension, fit.fractal_roughness
    law = lines_by_label(axes["Spectrum"])["fitted power law"]
    f, P = np.asarray(law.get_xdata()), np.asarray(law.get_ydata())
    assert (1 / f[0], 1 / f[-1]) == pytest.approx((fit.longest_wavelength, fit.shortest_wavelength))
    np.testing.assert_allclose(P, 0.5 * G ** (2 * D - 2) * f ** (2 * D - 5), rtol=1e-9)
    measured = lines_by_label(axes["Spectrum"])["measured"]
    x, y = np.asarray(measured.get_xdata()), np.asarray(measured.get_ydata())
    middle = (x > f[0]) & (x < f[0] * 30)
    assert abs(np.mean(np.log(y[middle] / (0.5 * G ** (2 * D - 2) * x[middle] ** (2 * D - 5))))) < 0.5
    line = lines_by_label(axes["Structure function"])["power law of this D and G"]
    tau, S = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
    np.testing.assert_allclose(np.diff(np.log(S)) / np.diff(np.log(tau)), 4 - 2 * D, rtol=1e-6)
    points = lines_by_label(axes["Structure function"])["measured"]
    assert np.asarray(points.get_ydata())[0] == pytest.approx(np.mean(np.diff(z) ** 2), rel=1e-9)
    assert np.asarray(points.get_xdata())[0] == pytest.approx(1e-7)
    assert all("[" in a.get_xlabel() and "[" in a.get_ylabel() for a in figure.axes)
    title = figure.get_suptitle()
    low, high = fit.dimension_interval(confidence=0.95)
    assert f"D = {D:.4f} ({low:.4f} … {high:.4f})" in title
    assert "1 profile(s) along x" in title


def test_figure_of_a_refusal_says_why_and_draws_no_law():
    figure = measurement_figure(surfaces=[profile(4)], fit="no power law at all", direction="x")
    axes = axes_by_title(figure)
    assert set(lines_by_label(axes["Spectrum"])) == {"measured"}
    assert figure.get_supxlabel() == "no power law at all"
    assert figure.get_suptitle() == "no D and G; reason below"


def test_figure_of_a_map_is_an_image_with_its_size():
    z = np.random.default_rng(0).standard_normal((70, 90)).cumsum(axis=1) * 1e-8
    figure = measurement_figure(
        surfaces=[Topography(z, 1e-6, 2e-6, source="m")], fit="no power law", direction="y"
    )
    axes = axes_by_title(figure)["m"]
    (image,) = axes.get_images()
    np.testing.assert_allclose(np.asarray(image.get_array()), 1e6 * z)
    assert image.get_extent() == pytest.approx([0, 90, 0, 140])


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
