"""Ra of D and G against quadrature, synthetic profiles behind the filter of ISO 16610, and its own inverse."""

import math

import jax
import numpy as np
import pytest
from scipy.integrate import quad

from asperity.surface.levelling import gaussian_lowpass
from asperity.surface.roughness_average import (
    corresponding_average,
    fractal_roughness_from_average,
    pair_average,
    passed_variance,
    roughness_average,
    scatter_of_average,
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
