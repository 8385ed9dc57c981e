"""Ra of D and G against quadrature, synthetic profiles behind the filter of ISO 16610, and its own inverse."""

import math

import jax
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.special import ndtr

from asperity.errors import InputError
from asperity.surface.levelling import gaussian_lowpass
from asperity.surface.roughness_average import (
    average_from_depth,
    corresponding_average,
    depth_cut_off,
    depth_over_average,
    fractal_roughness_from_average,
    pair_average,
    passed_variance,
    roughness_average,
    scatter_of_average,
    scatter_of_depth,
    standard_cut_off,
)
from asperity.surface.synthesis import spectral_profile
from asperity.surface.weierstrass import weierstrass_mandelbrot_profile

DIMENSIONS = [1.05, 1.2, 1.5, 1.8, 1.95]


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_the_passed_variance_is_its_integral(dimension):
    h = 2.0 - dimension
    integral, _ = quad(
        lambda x: math.exp(-2.0 * h * x) * (1.0 - 2.0 ** (-math.exp(2.0 * x))) ** 2, -12.0, 200.0, limit=500
    )
    assert passed_variance(fractal_dimension=dimension) == pytest.approx(integral, rel=1e-6)


@pytest.mark.parametrize("dimension", DIMENSIONS)
def test_there_and_back(dimension):
    g = fractal_roughness_from_average(roughness_average=0.2e-6, cut_off=0.8e-3, fractal_dimension=dimension)
    back = roughness_average(fractal_dimension=dimension, fractal_roughness=g, cut_off=0.8e-3)
    assert back == pytest.approx(0.2e-6, rel=1e-9)


def test_ra_of_synthetic_profiles_behind_the_filter():
    """Profiles of 32 cut-offs with the spectrum of D and G; the filter of the instruments, then the mean of |z|."""
    points, cut_off, d = 2**14, 0.8e-3, 1.3
    g = fractal_roughness_from_average(roughness_average=0.2e-6, cut_off=cut_off, fractal_dimension=d)
    spacing = 32.0 * cut_off / points
    random = np.random.default_rng(7)
    measured = []
    for _ in range(30):
        z = spectral_profile(
            points=points,
            spacing=spacing,
            fractal_dimension=d,
            fractal_roughness=g,
            periodic=True,
            random=random,
        )
        rough = np.abs(z - gaussian_lowpass(heights=z, spacing=spacing, cutoff=cut_off))
        inner = rough[points // 32 : -points // 32]  # half a cut-off at each end has truncated weights
        measured += [part.mean() for part in np.array_split(inner, 6)]
    assert np.mean(measured) == pytest.approx(0.2e-6, rel=0.03)
    expected = scatter_of_average(fractal_dimension=d, cut_offs=5)
    assert np.std(measured) / np.mean(measured) == pytest.approx(expected, rel=0.25)


def test_mean_square_of_the_profile_of_equation_6():
    """Its frequencies gamma^n/L, each with the filter's share of its amplitude; the sum against the closed form.

    The sum repeats with ln gamma: for gamma = 1.5 it stays within a percent of its mean.
    """
    d, g, gamma, length, cut_off = 1.4, 1e-11, 1.5, 1e-3, 0.8e-3
    lowest, count = -4, 40
    phases = np.zeros(1)
    amplitude = []
    for n in range(lowest, lowest + count):
        one = weierstrass_mandelbrot_profile(
            position=0.5 * length / gamma**n,
            profile_length=length,
            fractal_dimension=d,
            fractal_roughness=g,
            frequency_ratio=gamma,
            phases=phases,
            lowest_index=n,
        )
        amplitude.append(0.5 * float(one))  # half a wavelength from 0: twice the amplitude
    frequency = gamma ** np.arange(lowest, lowest + count) / length
    passed = np.array(amplitude) * (1.0 - 2.0 ** -((frequency * cut_off) ** 2))
    closed = roughness_average(fractal_dimension=d, fractal_roughness=g, cut_off=cut_off)
    assert closed * math.sqrt(math.pi / 2.0) == pytest.approx(math.sqrt(0.5 * np.sum(passed**2)), rel=0.01)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_derivatives_are_exact():
    def g(d, ra):
        return fractal_roughness_from_average(roughness_average=ra, cut_off=0.8e-3, fractal_dimension=d)

    slope = jax.grad(lambda d, ra: jax.numpy.log(g(d, ra)), argnums=(0, 1))(1.4, 0.2e-6)
    steps = [
        (math.log(g(1.4 + 1e-6, 0.2e-6)) - math.log(g(1.4 - 1e-6, 0.2e-6))) / 2e-6,
        (math.log(g(1.4, 0.2002e-6)) - math.log(g(1.4, 0.1998e-6))) / 0.4e-9,
    ]
    assert np.asarray(slope) == pytest.approx(steps, rel=1e-5)


@pytest.mark.parametrize(
    ("average", "cut_off"),
    [
        (0.02e-6, 0.08e-3),
        (0.05e-6, 0.25e-3),
        (0.1e-6, 0.25e-3),
        (0.2e-6, 0.8e-3),
        (3e-6, 2.5e-3),
        (20e-6, 8e-3),
    ],
)
def test_cut_offs_are_those_of_the_standard(average, cut_off):
    assert standard_cut_off(roughness_average=average) == cut_off
    assert standard_cut_off(roughness_average=np.array([average]))[0] == cut_off


def test_two_bodies_add_their_mean_squares():
    assert pair_average(first=3e-7, second=4e-7) == pytest.approx(5e-7)


def test_the_corresponding_ra_is_of_each_of_two_bodies_and_in_its_class():
    found = corresponding_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=None)
    pair = roughness_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=found.cut_off)
    assert found.pair == pytest.approx(pair)
    assert found.per_body == pytest.approx(pair / math.sqrt(2.0))
    assert found.cut_off == standard_cut_off(roughness_average=found.per_body)
    assert found.low < found.per_body < found.high
    stated = corresponding_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=0.8e-3)
    assert stated.per_body / found.per_body == pytest.approx((0.8 / 0.25) ** 0.6)  # cut-off to the power H


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
