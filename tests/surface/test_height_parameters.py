"""Closed forms of a sine and of Gaussian heights."""

import numpy as np
import pytest
import scipy.ndimage

from asperity.errors import InputError
from asperity.surface.height_parameters import height_parameters
from asperity.surface.levelling import levelled
from asperity.surface.measure_files import read_surface
from asperity.surface.topography import Topography


def test_element_width_of_a_sine():
    x = np.arange(10000) * 1e-7
    h = height_parameters(topography=Topography(2e-6 * np.sin(2 * np.pi * x / 1e-4 + 0.3), 1e-7))
    assert h.mean_element_width == pytest.approx(1e-4, rel=1e-3)


def test_gaussian_map_with_gaps():
    z = np.random.default_rng(0).standard_normal((300, 300))
    z[0, :5] = np.nan
    h = height_parameters(topography=Topography(z, 1.0, 1.0))
    assert (h.points, h.missing_points) == (89995, 5)
    assert h.arithmetic_mean == pytest.approx(np.sqrt(2 / np.pi), rel=0.01)
    assert h.kurtosis == pytest.approx(3.0, rel=0.03)
    assert h.mean_element_width is None


def test_nothing_to_evaluate():
    with pytest.raises(InputError):
        height_parameters(topography=Topography(np.full(4, np.nan), 1.0))


def test_four_heights_by_hand():
    """0, 0, 0, 3 um on an offset: mean 0.75; Pq^2 = 27/16 um^2; Psk = 2/sqrt(3); Pku = 7/3; Pa = 1.125 um."""
    h = height_parameters(topography=Topography(1e-6 * np.array([5.0, 5.0, 5.0, 8.0]), 1e-6))
    assert h.arithmetic_mean == pytest.approx(1.125e-6)
    assert h.root_mean_square == pytest.approx(1e-6 * np.sqrt(27 / 16))
    assert h.skewness == pytest.approx(2 / np.sqrt(3))
    assert h.kurtosis == pytest.approx(7 / 3)
    assert h.total_height == pytest.approx(3e-6)


def test_element_width_interpolates_the_crossings_and_ignores_small_peaks():
    """A triangle of 10.37 points crosses its mean line on straight flanks; ripple of 2 % does not count."""
    period = 10.37
    x = np.arange(4000)
    wave = 2 * np.abs(2 * ((x / period + 0.1) % 1.0) - 1.0) - 1.0
    h = height_parameters(topography=Topography(4.0 + wave, 2e-6))
    assert h.mean_element_width == pytest.approx(period * 2e-6, rel=1e-4)
    slow = np.sin(2 * np.pi * x / 400) + 0.02 * np.sin(2 * np.pi * x / 3.1)
    h = height_parameters(topography=Topography(slow, 1.0))
    assert h.mean_element_width == pytest.approx(400, rel=5e-3)
    few = height_parameters(topography=Topography(np.array([-1.0, 1.0, -1.0, -3.0, 1.0, 0.5]), 1.0))
    # upward through the mean -5/12 at 0 + 7/24 and 3 + 31/48
    assert few.mean_element_width == pytest.approx(3 + 31 / 48 - 7 / 24)


@pytest.mark.parametrize("heights", [np.zeros(50), np.linspace(0, 1, 50)])
def test_no_element(heights):
    assert height_parameters(topography=Topography(heights, 1.0)).mean_element_width is None


def ridges(*, wavelength, shape, angle=0.0, spacing=1e-6):
    y, x = np.indices(shape) * spacing
    return Topography(
        1e-7 * np.cos(2 * np.pi * (x * np.cos(angle) + y * np.sin(angle)) / wavelength), spacing, spacing
    )


def test_straight_ridges_have_a_length_and_no_aspect():
    """The autocorrelation of a sine is a cosine: 0.2 at wavelength arccos(0.2)/(2 pi); along the ridges it stays 1."""
    h = height_parameters(topography=ridges(wavelength=40e-6, shape=(300, 400), angle=0.3))
    assert h.correlation_length == pytest.approx(40e-6 * np.arccos(0.2) / (2 * np.pi), rel=0.02)
    assert h.aspect_ratio is None
    slope = 1e-7 * 2 * np.pi / 40e-6
    assert h.developed_area_ratio == pytest.approx(slope**2 / 4, rel=0.02)


@pytest.mark.parametrize("scale", [1, 8])
def test_texture_of_known_autocorrelation(scale):
    """White heights smoothed by Gaussians of 6 points along x and half that length along y: the autocorrelation
    exp(-x^2/4s^2) is 0.2 at s sqrt(-4 ln 0.2), along y at half that."""
    fine = scipy.ndimage.gaussian_filter(
        np.random.default_rng(1).standard_normal((256 * scale, 2304)), (3 * scale, 6), mode="wrap"
    )
    h = height_parameters(topography=Topography(1e-8 * fine, 1e-6, 1e-6 / scale))
    assert h.correlation_length == pytest.approx(3e-6 * np.sqrt(-4 * np.log(0.2)), rel=0.05)
    assert h.aspect_ratio == pytest.approx(0.5, rel=0.1)


def test_developed_area_of_a_tilted_plane():
    """sqrt(1 + 0.3^2 + 0.4^2) - 1."""
    y, x = np.indices((700, 20))
    h = height_parameters(topography=Topography(0.3 * x + 0.8 * y, 1.0, 2.0))
    assert h.developed_area_ratio == pytest.approx(np.sqrt(1.25) - 1.0, rel=1e-12)


def test_block_means_and_points_agree():
    """A map of 2304 points is read by block means first; a length of few points by the points themselves."""
    z = scipy.ndimage.gaussian_filter(np.random.default_rng(2).standard_normal((2304, 2304)), 2, mode="wrap")
    h = height_parameters(topography=Topography(z, 1.0, 1.0))
    assert h.correlation_length == pytest.approx(2 * np.sqrt(-4 * np.log(0.2)), rel=0.02)
    assert h.aspect_ratio == pytest.approx(1.0, abs=0.05)


def test_parameters_of_a_measured_map_by_another_program(shared_data):
    """surfalize 0.19.2, of the same heights less the plane."""
    measured = read_surface(path=shared_data / "surfacetopography_examples" / "x3p-2.x3p")
    h = height_parameters(topography=levelled(topography=measured, form="plane"))
    assert 1e6 * h.arithmetic_mean == pytest.approx(0.0618930582, rel=1e-8)
    assert 1e6 * h.root_mean_square == pytest.approx(0.0771930328, rel=1e-8)
    assert h.skewness == pytest.approx(-0.378673607, rel=1e-8)
    assert h.kurtosis == pytest.approx(2.98459665, rel=1e-8)
    assert 1e6 * h.total_height == pytest.approx(0.552102046, rel=1e-8)
    assert h.developed_area_ratio == pytest.approx(0.00192026142, rel=1e-4)
    assert h.correlation_length == pytest.approx(2.66468589e-6, rel=1e-3)
    assert h.aspect_ratio is None
