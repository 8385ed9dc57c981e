"""The figure of a measurement: heights, spectrum and structure function with the law, or why there is none."""

import io
from xml.etree import ElementTree

import numpy as np
import pytest

from asperity.surface.fractal_fit import fractal_fit
from asperity.surface.plots import measurement_figure
from asperity.surface.topography import Topography


def axes_by_title(figure):
    return {axes.get_title(): axes for axes in figure.axes}


def lines_by_label(axes):
    return {line.get_label(): line for line in axes.get_lines()}


def test_figure_of_a_fit_draws_the_data_and_the_law(profile):
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
    assert np.asarray(points.get_ydata())[0] == pytest.approx(np.mean(np.diff(z) ** 2), rel=1e-9, abs=0.0)
    assert np.asarray(points.get_xdata())[0] == pytest.approx(1e-7)
    assert all("[" in a.get_xlabel() and "[" in a.get_ylabel() for a in figure.axes)
    title = figure.get_suptitle()
    low, high = fit.dimension_interval(confidence=0.95)
    assert f"D = {D:.4f} ({low:.4f} … {high:.4f})" in title
    assert "1 profile(s) along x" in title


def test_figure_of_a_refusal_says_why_and_draws_no_law(profile):
    figure = measurement_figure(surfaces=[profile(4)], fit="no power law at all", direction="x")
    axes = axes_by_title(figure)
    assert set(lines_by_label(axes["Spectrum"])) == {"measured"}
    assert figure.get_supxlabel() == "no power law at all"
    assert figure.get_suptitle() == "no D and G, reason below; a joint uses the spectrum"


def test_figure_of_a_map_is_an_image_with_its_size():
    z = np.random.default_rng(0).standard_normal((70, 90)).cumsum(axis=1) * 1e-8
    figure = measurement_figure(
        surfaces=[Topography(z, 1e-6, 2e-6, source="m")], fit="no power law", direction="y"
    )
    axes = axes_by_title(figure)["m"]
    (image,) = axes.get_images()
    np.testing.assert_allclose(np.asarray(image.get_array()), 1e6 * z)
    assert image.get_extent() == pytest.approx([0, 90, 0, 140])


def test_any_name_of_a_file_is_a_title():
    """Without control characters, which XML does not know, and not as a formula."""
    heights = 1e-7 * np.random.default_rng(0).standard_normal(500)
    named = Topography(heights, 1e-6, source="we\x07lle\udcfc$a{b$")
    target = io.BytesIO()
    measurement_figure(surfaces=[named], fit="none", direction="x").savefig(target, format="svg")
    assert "welle" not in ElementTree.fromstring(target.getvalue()).itertext()
