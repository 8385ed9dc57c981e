"""Conversion constants against quadrature and against each other."""

import numpy as np
import pytest
from scipy.integrate import quad

from asperity.errors import InputError
from asperity.surface import conventions as c

CASES = [(1.2, 3e-13), (1.5, 1e-9), (1.8, 2e-8)]


@pytest.mark.parametrize(("D", "G"), CASES)
def test_structure_function_is_the_cosine_transform_of_the_spectrum(D, G):
    """S(tau) = 2 int P (1 - cos): substitution f = u / (2 pi tau), split where the cosine oscillates."""
    tau, s = 1e-6, 5 - 2 * D
    near = quad(lambda u: (1 - np.cos(u)) * u**-s, 0, 2 * np.pi, limit=200)[0]
    far = (2 * np.pi) ** (1 - s) / (s - 1) - quad(lambda u: u**-s, 2 * np.pi, np.inf, weight="cos", wvar=1.0)[
        0
    ]
    P1 = c.power_spectral_density(frequency=1 / (2 * np.pi * tau), fractal_dimension=D, fractal_roughness=G)
    expected = 2 * P1 * (near + far) / (2 * np.pi * tau)
    np.testing.assert_allclose(
        c.structure_function(lag=tau, fractal_dimension=D, fractal_roughness=G), expected, rtol=1e-6
    )


@pytest.mark.parametrize(("D", "G"), CASES)
def test_round_trips(D, G):
    S = float(c.structure_function(lag=2e-6, fractal_dimension=D, fractal_roughness=G))
    np.testing.assert_allclose(c.roughness_from_structure_function(level=S, lag=2e-6, fractal_dimension=D), G)
    areal = c.areal_roughness_from_profile(fractal_dimension=D, fractal_roughness=G)
    np.testing.assert_allclose(
        c.profile_roughness_from_areal(fractal_dimension=D, areal_fractal_roughness=areal), G
    )


@pytest.mark.parametrize(("D", "G"), CASES)
def test_profile_spectrum_of_a_surface_is_the_integral_of_the_areal_one(D, G):
    """P(fx) = 2 int C(sqrt(fx^2 + fy^2)) dfy."""
    fx = 1e5
    areal = c.areal_roughness_from_profile(fractal_dimension=D, fractal_roughness=G)

    def areal_density(fy):  # C(f) = G_a^(2(D-1)) f^-(6-2D)/4 pi, over that at fx
        return np.hypot(1.0, fy) ** -(6 - 2 * D)

    unit = areal ** (2 * (D - 1)) * fx ** -(6 - 2 * D) / (4 * np.pi)
    P = 4 * fx * unit * quad(areal_density, 0, np.inf)[0]
    np.testing.assert_allclose(
        c.power_spectral_density(frequency=fx, fractal_dimension=D, fractal_roughness=G), P, rtol=1e-7
    )


@pytest.mark.parametrize(("D", "G"), [(2.3, 1e-9), (1.0, 1e-9), (1.5, 0.0), (1.5, float("inf"))])
def test_impossible_values_are_refused(D, G):
    with pytest.raises(InputError):
        c.validated_fractal(fractal_dimension=D, fractal_roughness=G)


@pytest.mark.parametrize(("D", "G"), [*CASES, (1.0 + 1e-9, 1e-60), (2.0 - 1e-9, 1.0)])
def test_possible_values_are_passed_on(D, G):
    assert c.validated_fractal(fractal_dimension=D, fractal_roughness=G) == (D, G)
