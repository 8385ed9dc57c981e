"""The W-M sums against the equation written out term by term."""

import jax
import numpy as np
import pytest

from asperity.errors import InputError
from asperity.surface import conventions
from asperity.surface.conventions import areal_roughness_from_profile
from asperity.surface.weierstrass import (
    periodic_weierstrass_surface,
    weierstrass_mandelbrot_profile,
)

L, D, G, GAMMA = 1e-3, 1.4, 1e-11, 1.5


def profile(x, phases, lowest, D=D, G=G):
    return weierstrass_mandelbrot_profile(
        position=x,
        profile_length=L,
        fractal_dimension=D,
        fractal_roughness=G,
        frequency_ratio=GAMMA,
        phases=phases,
        lowest_index=lowest,
    )


def test_profile_is_equation_6_summed_by_hand():
    phases = np.random.default_rng(0).uniform(0, 2 * np.pi, 20)
    x = np.linspace(0, L, 101)
    expected = np.zeros(101)
    for n, phi in zip(range(-2, 18), phases, strict=True):
        term = np.cos(phi) - np.cos(2 * np.pi * GAMMA**n * x / L - phi)
        expected += L * (G / L) ** (D - 1) * np.sqrt(np.log(GAMMA)) * GAMMA ** ((D - 2) * n) * term
    np.testing.assert_allclose(profile(x, phases, -2), expected, atol=1e-12 * np.abs(expected).max())


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_gradient_in_dimension_agrees_with_finite_differences():
    phases = np.linspace(0.1, 6, 12)
    x = np.array([0.3e-3])
    slope = jax.grad(lambda d: profile(x, phases, 0, D=d)[0])(1.4)
    h = 1e-6
    numeric = (profile(x, phases, 0, D=1.4 + h) - profile(x, phases, 0, D=1.4 - h))[0] / (2 * h)
    np.testing.assert_allclose(slope, numeric, rtol=1e-6)


@pytest.mark.parametrize("dimension", [1.2, 1.5, 1.8])
def test_log_period_average_of_the_structure_function_is_the_convention(dimension):
    """<S(tau) tau^-2H> over one period of ln tau, from the line sum over n = -120 .. 120."""
    H = 2 - dimension
    n = np.arange(-120, 121)
    f = GAMMA**n / L
    tau = 1e-6 * GAMMA ** (np.arange(64) / 64)
    S = np.array(
        [
            np.log(GAMMA)
            * G ** (2 * (dimension - 1))
            * np.sum(f ** (-2 * H) * 2 * np.sin(np.pi * f * t) ** 2)
            for t in tau
        ]
    )
    mean = np.mean(S * tau ** (-2 * H))
    model = conventions.structure_function(lag=1.0, fractal_dimension=dimension, fractal_roughness=G)
    np.testing.assert_allclose(mean, model, rtol=2e-2 if dimension > 1.7 else 2e-3)


ARGUMENTS = {
    "points": 64,
    "side": 1e-3,
    "longest_wavelength": 0.5e-3,
    "shortest_wavelength": 8e-3 / 64,
    "fractal_dimension": 1.4,
    "fractal_roughness": 1e-11,
    "frequency_ratio": 1.5,
}


def surface(seed=0, **change):
    return periodic_weierstrass_surface(**(ARGUMENTS | change), random=np.random.default_rng(seed))


def test_the_mean_square_is_the_sum_of_half_squared_amplitudes():
    """Equation (6) with the areal G: every wave adds half of its squared amplitude, whatever its phase."""
    z = surface()
    areal = areal_roughness_from_profile(fractal_dimension=1.4, fractal_roughness=1e-11)
    frequencies = (
        1.5 ** np.arange(4) / 0.5e-3
    )  # 2 to 6.75 waves per side; the next would be shorter than 8 pixels
    amplitudes = np.sqrt(np.log(1.5)) * areal**0.4 * frequencies**-0.6
    assert np.mean(z**2) == pytest.approx(np.sum(amplitudes**2) / 2.0, rel=1e-10, abs=0.0)
    assert abs(z.mean()) < 1e-15


def test_the_spectrum_lies_on_rings():
    power = np.abs(np.fft.fft2(surface())) ** 2
    k = np.fft.fftfreq(64, 1 / 64)
    distance = np.hypot(*np.meshgrid(k, k))[power > 1e-15 * power.max()]
    rings = 2.0 * 1.5 ** np.arange(4)
    assert np.abs(distance[:, None] - rings).min(axis=1).max() <= 0.5
    np.testing.assert_allclose(power, np.roll(power[::-1, ::-1], (1, 1), (0, 1)), atol=1e-9 * power.max())


def test_seeds_differ_and_repeat():
    assert np.array_equal(surface(3), surface(3))
    assert not np.allclose(surface(3), surface(4))


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"fractal_dimension": 2.4}, "between 1 and 2"),
        ({"shortest_wavelength": 1e-6}, "two pixels"),
        ({"longest_wavelength": 2e-3}, "must lie between"),
        ({"frequency_ratio": 1.0}, "frequency_ratio = 1"),
    ],
)
def test_bad_input_is_named(change, named):
    with pytest.raises(InputError, match=named):
        surface(**change)
