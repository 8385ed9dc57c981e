"""Rz/Ra of normally distributed heights: profiles by another way, bounds of extreme values, and the range of Ra."""

import math

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ndtr

from asperity.errors import InputError
from asperity.surface.levelling import gaussian_lowpass
from asperity.surface.peak_to_valley import (
    average_from_depth,
    depth_cut_off,
    depth_over_average,
    scatter_of_depth,
)
from asperity.surface.synthesis import spectral_profile

#: Cut-off [m], and that of the stylus and its circuit: ISO 3274:1996, table 1.
PAIRS = [(0.08e-3, 2.5e-6), (0.25e-3, 2.5e-6), (0.8e-3, 2.5e-6), (2.5e-3, 8e-6), (8e-3, 25e-6)]


@pytest.mark.parametrize(
    ("dimension", "pair", "profiles"),
    [
        (1.2, PAIRS[0], 40),
        (1.8, PAIRS[0], 40),
        pytest.param(1.4, PAIRS[1], 60, marks=pytest.mark.slow),
        pytest.param(1.2, PAIRS[2], 30, marks=pytest.mark.slow),
        pytest.param(1.7, PAIRS[2], 30, marks=pytest.mark.slow),
    ],
)
def test_ratio_and_scatter_of_synthetic_profiles(dimension, pair, profiles):
    """Profiles of given D and G behind the filters of ISO 16610, both applied along the profile."""
    (cut_off, short), random = pair, np.random.default_rng(5)
    per = round(6.25 * cut_off / short)  # points in a cut-off
    spacing = cut_off / per
    depths, averages = [], []
    for _ in range(profiles):
        z = spectral_profile(
            points=per * 34,
            spacing=spacing,
            fractal_dimension=dimension,
            fractal_roughness=1e-11,
            periodic=True,
            random=random,
        )
        z = gaussian_lowpass(heights=z, spacing=spacing, cutoff=short)
        z = z - gaussian_lowpass(heights=z, spacing=spacing, cutoff=cut_off)
        sampling = z[2 * per : 32 * per].reshape(-1, 5, per)  # without the ends of truncated weights
        depths += list(np.ptp(sampling, axis=2).mean(axis=1))
        averages += list(np.abs(sampling).mean(axis=(1, 2)))
    depth, average = np.array(depths), np.array(averages)
    ratios = depth / average
    error = ratios.std() / ratios.mean() / math.sqrt(depth.size)
    assert error < 0.007
    fitted = depth_over_average(fractal_dimension=dimension, cut_off=cut_off)
    assert depth.mean() / average.mean() == pytest.approx(fitted, rel=3.0 * error + 0.002)
    assert depth.std(ddof=1) / depth.mean() == pytest.approx(
        scatter_of_depth(fractal_dimension=dimension, cut_off=cut_off), rel=3.0 / math.sqrt(2.0 * depth.size)
    )


def extreme(points):
    """Mean of the largest of independent normal numbers."""
    return quad(lambda u: (1.0 - ndtr(u) ** points) - (ndtr(-u) ** points), 0.0, 12.0)[0]


@pytest.mark.parametrize("pair", PAIRS[:3])
@pytest.mark.parametrize("dimension", [1.05, 1.5, 1.95])
def test_the_ratio_lies_between_bounds_of_extreme_values(pair, dimension):
    """Above: Rice's rate of crossings. Below: Slepian's inequality for points that are at most so much alike."""
    per = 2048
    f = np.arange(4 * per + 1) / 8.0  # per cut-off
    f[0] = 1e-9
    power = (
        f ** (2.0 * dimension - 5.0) * (1.0 - 2.0 ** -(f**2)) ** 2 * 4.0 ** -((f * pair[1] / pair[0]) ** 2)
    )
    power[0] = 0.0
    power /= power.sum()
    rate = math.sqrt(float(power @ f**2))  # upward crossings of the mean line in a cut-off
    above = quad(lambda u: min(1.0, ndtr(-u) + rate * math.exp(-0.5 * u * u)), 0.0, 12.0, limit=200)[0]
    alike = np.fft.irfft(power) * 4 * per  # correlation at multiples of a cut-off / 2048
    assert alike[0] == pytest.approx(1.0, rel=1e-6)
    below = max(
        math.sqrt(1.0 - max(alike[per // points : per : per // points].max(), 0.0)) * extreme(points)
        for points in (4, 16, 64)
    )
    over_rms = depth_over_average(fractal_dimension=dimension, cut_off=pair[0]) * math.sqrt(2.0 / math.pi)
    assert 2.0 * below < over_rms < 2.0 * above


def test_ratio_rises_and_scatter_falls_with_d():
    d = np.linspace(1.01, 1.99, 99)
    for cut_off, _ in PAIRS:
        assert np.all(np.diff([depth_over_average(fractal_dimension=x, cut_off=cut_off) for x in d]) > 0.0)
        assert np.all(np.diff([scatter_of_depth(fractal_dimension=x, cut_off=cut_off) for x in d]) < 0.0)


def test_the_range_of_ra_holds_every_d_and_every_rz():
    known = {"fractal_dimension": 1.3, "dimension_tolerance": 0.2, "cut_off": 0.8e-3}
    middle, half = average_from_depth(mean_roughness_depth=1.6e-6, tolerance=0.2e-6, **known)
    assert middle == 1.6e-6 / depth_over_average(fractal_dimension=1.3, cut_off=0.8e-3)
    ends = [
        rz / depth_over_average(fractal_dimension=d, cut_off=0.8e-3)
        for d in (1.1, 1.2, 1.3, 1.4, 1.5)
        for rz in (1.4e-6, 1.8e-6)
    ]
    assert half == pytest.approx(max(max(ends) - middle, middle - min(ends)))
    free = average_from_depth(mean_roughness_depth=1.6e-6, tolerance=0.0, **known)
    scatter = 2.0 * scatter_of_depth(fractal_dimension=1.1, cut_off=0.8e-3)
    assert free == (
        middle,
        pytest.approx(
            (1.0 + scatter) * 1.6e-6 / depth_over_average(fractal_dimension=1.1, cut_off=0.8e-3) - middle
        ),
    )
    one = average_from_depth(
        mean_roughness_depth=1.6e-6,
        tolerance=1.6e-7,
        fractal_dimension=1.3,
        dimension_tolerance=0.0,
        cut_off=0.8e-3,
    )
    assert one == (middle, pytest.approx(0.1 * middle))


@pytest.mark.parametrize(
    ("depth", "cut_off"),
    [(0.1e-6, 0.08e-3), (0.4e-6, 0.25e-3), (1.6e-6, 0.8e-3), (20e-6, 2.5e-3), (60e-6, 8e-3)],
)
def test_cut_offs_of_the_standard(depth, cut_off):
    assert depth_cut_off(mean_roughness_depth=depth) == cut_off


def test_another_cut_off_is_refused():
    with pytest.raises(InputError, match=r"0\.08 mm, 0\.25 mm, 0\.8 mm, 2\.5 mm, 8 mm, got 1 mm"):
        depth_over_average(fractal_dimension=1.3, cut_off=1e-3)
