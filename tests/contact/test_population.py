"""The population of spots: psi, lambda, the critical area, the density."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq

from asperity.contact.population import (
    contact_factor,
    critical_area,
    domain_extension_factor,
    hertz_area_contact_factor,
    log_critical_area,
    log_domain_extension_factor,
    printed_contact_factor,
    spot_density,
)

MODULUS = 206e9 / (2 * 0.91)
OUTER = {
    "radius_1": 10e-3,
    "radius_2": 20e-3,
    "sign": 1.0,
    "contact_length": 5e-3,
    "contact_modulus": MODULUS,
}
INNER = OUTER | {"sign": -1.0}


def test_domain_extension_factor_of_the_paper():
    # model equation (10), root to 17 digits
    assert float(domain_extension_factor(fractal_dimension=1.4)) == pytest.approx(
        2.0848507806760166, rel=4e-16
    )


def test_domain_extension_factor_is_the_root_at_every_dimension():
    dimensions = np.linspace(1.02, 1.99, 40)

    def root(D):
        def condition(psi):
            return psi ** ((2 - D) / 2) - (1 + psi ** (-D / 2)) ** (-(2 - D) / D) - (2 - D) / D

        return brentq(condition, 1.0, 10.0, xtol=1e-15, rtol=1e-15)

    found = domain_extension_factor(fractal_dimension=dimensions)
    # near D = 2 the condition as printed loses digits by cancellation
    np.testing.assert_allclose(found, [root(D) for D in dimensions], rtol=2e-13)


def test_domain_extension_factor_meets_its_two_limits():
    """D -> 1: psi^(1/2) - 1/(1 + psi^(-1/2)) = 1, golden ratio squared; D -> 2: ln psi = 1 - ln(1 + 1/psi), e - 1."""
    golden = (1 + math.sqrt(5)) / 2
    found = domain_extension_factor(fractal_dimension=jnp.array([1 + 1e-9, 2 - 1e-9]))
    np.testing.assert_allclose(found, [golden**2, math.e - 1], rtol=1e-8)


def test_derivatives_of_the_domain_extension_factor():
    D, h = np.linspace(1.05, 1.98, 9), 1e-4
    value = lambda d: log_domain_extension_factor(fractal_dimension=d)  # noqa: E731
    slopes = jax.jit(jax.vmap(lambda d: (value(d), jax.grad(value)(d), jax.grad(jax.grad(value))(d))))
    here, first, second = slopes(D)
    up, down = slopes(D + h)[0], slopes(D - h)[0]
    np.testing.assert_allclose(first, (up - down) / (2 * h), rtol=1e-6)
    np.testing.assert_allclose(second, (up - 2 * here + down) / h**2, rtol=1e-3, atol=1e-5)


def printed(R1, R2, B, E, sign):
    """(11) term by term in mm and MPa."""
    exponent = 1 / R1 + 1 / R2 if sign > 0 else abs(1 / R1 - 1 / R2)
    span = R1 + R2 if sign > 0 else abs(R1 - R2)
    return (math.sqrt(4 * B / (math.pi * E) * R1 * R2 / span) / (math.pi * span)) ** exponent


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_printed_contact_factor_in_the_papers_units(sign):
    found = printed_contact_factor(**(OUTER | {"sign": sign}))
    assert float(found) == pytest.approx(printed(10.0, 20.0, 5.0, MODULUS * 1e-6, sign), rel=1e-12)


@pytest.mark.parametrize(("pair", "span"), [(OUTER, 30e-3), (INNER, 10e-3)])
def test_hertz_area_factor_is_a_share_of_areas(pair, span):
    radius = 10e-3 * 20e-3 / span
    half_width = math.sqrt(4 * 800.0 * radius / (math.pi * 5e-3 * MODULUS))
    share = 2 * half_width * 5e-3 / (2 * math.pi * span * 5e-3)  # Hertz strip over both cylinders' mantle
    found = hertz_area_contact_factor(**pair, normal_force=800.0)
    assert float(found) == pytest.approx(share ** (1e-3 / radius), rel=1e-12)


def test_contact_factor_by_name():
    assert float(contact_factor(model="unity", **OUTER, normal_force=1.0)) == 1.0
    assert contact_factor(model="printed", **INNER, normal_force=1.0) == printed_contact_factor(**INNER)
    assert contact_factor(model="hertz_area", **INNER, normal_force=9.0) == hertz_area_contact_factor(
        **INNER, normal_force=9.0
    )


def test_critical_area_is_where_plastic_and_elastic_pressure_scale_alike():
    area = critical_area(
        fractal_dimension=1.4, fractal_roughness=1e-11, contact_modulus=MODULUS, hardness=1260e6
    )
    assert float(area) == pytest.approx(1e-22 * (2 * MODULUS / 1260e6) ** 5, rel=1e-12, abs=0.0)


def test_critical_area_spans_hundreds_of_decades():
    low, high = (
        log_critical_area(fractal_dimension=D, fractal_roughness=G, contact_modulus=MODULUS, hardness=1260e6)
        for D, G in ((1.99, 1e-16), (1.02, 1e-6))
    )
    ratio = 2 * MODULUS / 1260e6
    assert float(low) == pytest.approx(-32 * math.log(10) + 2 / 0.99 * math.log(ratio), rel=1e-12)
    assert float(high) == pytest.approx(-12 * math.log(10) + 100 * math.log(ratio), rel=1e-12)


def test_spot_density_has_one_spot_of_the_largest_size_and_a_finite_area():
    """(10): the number above a is lambda psi^((2-D)/2) ((a_l/a)^(D/2) - 1); nothing is larger than a_l."""
    D, largest, factor = 1.4, 1e-8, 0.4
    psi = 2.0848507806760166

    def density(area):
        return float(
            spot_density(spot_area=area, largest_area=largest, contact_factor=factor, fractal_dimension=D)
        )

    count, _ = quad(density, 1e-9, largest, epsabs=0.0, epsrel=1e-10)
    assert count == pytest.approx(factor * psi**0.3 * (10**0.7 - 1), rel=1e-9)
    assert density(1.0001e-8) == 0.0
