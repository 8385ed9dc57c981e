"""Lay of a surface: stretched spectra of known ratio, single waves, and maps that are the same in both directions."""

import math

import numpy as np
import pytest
from scipy.integrate import dblquad, quad

from asperity.errors import InputError
from asperity.surface.height_spectrum import (
    _running_over,
    spectrum_from_document,
    spectrum_of_map,
    spectrum_of_profiles,
)
from asperity.surface.lay import (
    felt_rolling_share,
    rolling_share,
    share_across,
)
from asperity.surface.topography import Topography

POINTS, SPACING = 256, 0.8e-6
NO_LIMIT = np.array(0.0)


def share_of(spectra, rolling=NO_LIMIT, axial=NO_LIMIT):
    many = len(spectra)
    return felt_rolling_share(
        tuple(spectra), rolling=many * (np.asarray(rolling),), axial=many * (np.asarray(axial),)
    )


def map_spectrum(heights, *, rolling="x"):
    return spectrum_of_map(topography=Topography(heights, SPACING, SPACING, source="a map"), rolling=rolling)


def stretched(length_ratio, seed):
    """Heights whose correlation length along y is so many times that along x; roll-off at 12 µm, exponent 0.8."""
    frequency = np.fft.fftfreq(POINTS, SPACING)
    size = np.sqrt(frequency**2 / length_ratio + length_ratio * frequency[:, None] ** 2)
    amplitude = np.maximum(size, 1.0 / 12e-6) ** -1.8
    amplitude[0, 0] = 0.0
    random = np.random.default_rng(seed)
    heights = np.fft.ifft2(amplitude * np.fft.fft2(random.standard_normal((POINTS, POINTS)))).real
    return 1e-7 * heights / heights.std()


@pytest.mark.parametrize("ratio", [1.0, 3.0, 10.0, 30.0])
def test_share_of_a_stretched_spectrum_by_quadrature(ratio):
    """Of C(q_x^2 + g^2 q_y^2), whatever it is: all angles alike after stretching."""
    mean, _ = quad(
        lambda angle: (
            (ratio * math.cos(angle)) ** 2 / ((ratio * math.cos(angle)) ** 2 + math.sin(angle) ** 2)
        ),
        0.0,
        0.5 * math.pi,
    )
    assert float(share_across(length_ratio=ratio)) == pytest.approx(mean / (0.5 * math.pi), rel=1e-9)


@pytest.mark.parametrize("ratio", [1.0, 3.0, 10.0])
def test_share_of_synthesised_maps(ratio):
    """g/(1 + g) within four standard errors and 0.02 of the window; the other way around in the other direction."""
    found = [
        [float(share_of([map_spectrum(stretched(ratio, seed), rolling=rolling)])) for rolling in "xy"]
        for seed in range(8)
    ]
    error = 4.0 * np.std(found, axis=0) / math.sqrt(len(found))
    expected = ratio / (1.0 + ratio)
    np.testing.assert_allclose(np.mean(found, axis=0), [expected, 1.0 - expected], atol=0.02 + error.max())
    np.testing.assert_allclose(np.sum(found, axis=1), 1.0, rtol=1e-9)


def test_a_map_that_is_the_same_in_both_directions_has_no_lay():
    """To rounding, in any band that is the same in both, through bins too."""
    heights = stretched(1.0, 3)
    spectrum = map_spectrum(heights + heights.T)
    limits = 1.0 / np.array([1e-2, 73e-6, 30e-6, 11.3e-6, 4e-6])
    np.testing.assert_allclose(share_of([spectrum], limits, limits), 0.5, atol=1e-12)


def test_a_band_cuts_each_direction():
    """Of two waves of 10 µm, the one that runs along the axis is left out where the line covers it, and likewise."""
    y, x = np.mgrid[0:POINTS, 0:POINTS] * SPACING
    length = POINTS * SPACING / round(POINTS * SPACING / 10e-6)
    heights = 1e-7 * (2.0 * np.cos(2.0 * np.pi * x / length) + np.cos(2.0 * np.pi * y / length))
    width = 1.0 / np.array([50e-6, 50e-6, 3e-6])
    line = 1.0 / np.array([50e-6, 3e-6, 50e-6])
    np.testing.assert_allclose(share_of([map_spectrum(heights)], width, line), [0.8, 1.0, 0.0], atol=0.01)


def test_integrals_over_bins():
    edges, others = np.array([0.0, 0.5, 1.5, 4.0, 900.0]), np.array([0.0, 2.0, 2.5, 7.0])
    found = _running_over(edges, others)
    for i, j in [(0, 0), (1, 2), (3, 1), (2, 0)]:
        expected, _ = dblquad(
            lambda y, x: x**2 / (x**2 + y**2), edges[i], edges[i + 1], others[j], others[j + 1]
        )
        assert found[i, j] == pytest.approx(expected, rel=1e-6)
    np.testing.assert_allclose(
        found + _running_over(others, edges).T, np.outer(np.diff(edges), np.diff(others)), rtol=1e-9
    )


def test_profiles_have_the_lay_that_is_stated():
    profile = stretched(1.0, 1)[:4]
    for lay, share in (("rolling", 0.0), ("axis", 1.0), ("isotropic", 0.5)):
        spectrum = spectrum_of_profiles(profiles=profile, spacing=SPACING, lay=lay, source="a profile")
        assert float(share_of([spectrum])) == share


def test_two_bodies_count_by_their_mean_squares():
    """Nine parts of a map without lay and one of grooves along the axis."""
    heights = stretched(1.0, 3)
    smooth = map_spectrum(heights + heights.T)
    profile = spectrum_of_profiles(
        profiles=stretched(1.0, 1)[:4], spacing=SPACING, lay="axis", source="a profile"
    )
    squares = [float(one.squares(rolling=NO_LIMIT, axial=NO_LIMIT)) for one in (smooth, profile)]
    expected = (0.5 * squares[0] + squares[1]) / sum(squares)
    assert float(share_of([smooth, profile])) == pytest.approx(expected, rel=1e-12)


def test_ratio_and_direction_are_the_share():
    assert float(rolling_share(length_ratio=1.0, grooves="axis")) == 0.5
    for grooves, share in (("axis", 0.75), ("rolling", 0.25)):
        assert float(rolling_share(length_ratio=3.0, grooves=grooves)) == pytest.approx(share, rel=1e-15)


def test_a_document_of_a_map_with_empty_bins_is_damaged():
    document = map_spectrum(stretched(1.0, 1)).document()
    assert spectrum_from_document(document).is_map
    document["rolling_frequency_edges_per_m"][1] = document["rolling_frequency_edges_per_m"][2]
    with pytest.raises(InputError, match="damaged"):
        spectrum_from_document(document)
