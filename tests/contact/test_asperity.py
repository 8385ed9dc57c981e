"""One asperity: its published formulas against each other and against its shape."""

import math

import jax
import numpy as np
import pytest

from asperity.contact.asperity import (
    asperity_height,
    base_factor,
    base_length,
    elastic_spot_area,
    elastic_spot_load,
    hertz_load,
    normal_spot_stiffness,
    plastic_spot_area,
    plastic_spot_load,
    slip_factor,
    summit_radius,
    tangential_spot_stiffness,
)

SURFACE = {"fractal_dimension": 1.4, "fractal_roughness": 1e-11, "frequency_ratio": 1.5}
MODULUS = 113.187e9
BASES = ("majumdar_bhushan_1991", "circular_spot")


def test_profile_is_the_cosine_of_equation_7():
    height = asperity_height(position=np.array([0.0, 1e-6, 4e-6]), base_length=3e-6, **SURFACE)
    summit = 1e-11**0.4 * math.sqrt(math.log(1.5)) * 3e-6**0.6
    assert float(height[0]) == pytest.approx(summit, rel=1e-14)
    assert float(height[1]) == pytest.approx(summit / 2, rel=1e-12)  # cos 60 degrees
    assert np.isnan(height[2])  # there is no profile beyond half the base


def test_summit_radius_is_the_curvature_of_the_profile():
    height = lambda x: asperity_height(position=x, base_length=3e-6, **SURFACE)  # noqa: E731
    curvature = jax.grad(jax.grad(height))(0.0)
    assert summit_radius(base_length=3e-6, **SURFACE) == pytest.approx(-1 / float(curvature), rel=1e-12)


@pytest.mark.parametrize("base", BASES)
def test_load_of_an_elastic_spot_is_hertz_on_its_summit(base):
    """(17) from (9), (13), (14): press the summit until the spot has the area."""
    area = 1e-9
    radius = summit_radius(base_length=base_length(spot_area=area, asperity_base=base), **SURFACE)
    deformation = area / (math.pi * radius)
    assert elastic_spot_area(summit_radius=radius, deformation=deformation) == pytest.approx(area, rel=1e-14)
    assert plastic_spot_area(summit_radius=radius, deformation=deformation) == pytest.approx(
        2 * area, rel=1e-14
    )
    pressed = hertz_load(contact_modulus=MODULUS, summit_radius=radius, deformation=deformation)
    direct = elastic_spot_load(spot_area=area, contact_modulus=MODULUS, asperity_base=base, **SURFACE)
    assert float(direct) == pytest.approx(float(pressed), rel=1e-12)


def test_base_factor_is_the_named_variant():
    assert float(base_factor(fractal_dimension=1.4, asperity_base="majumdar_bhushan_1991")) == 1.0
    assert base_factor(fractal_dimension=1.4, asperity_base="circular_spot") == pytest.approx(
        (math.pi / 4) ** 0.7
    )


def test_plastic_spot_carries_its_hardness():
    assert plastic_spot_load(hardness=1260e6, spot_area=1e-10) == pytest.approx(0.126, rel=1e-14)


def test_spot_stiffnesses_are_those_of_a_circle_of_that_area():
    """Mindlin: 8 G* r; Hertz: 2 E* r."""
    area = math.pi * 2e-6**2
    tangential = tangential_spot_stiffness(spot_area=area, tangential_contact_modulus=2e10, slip_factor=0.5)
    assert float(tangential) == pytest.approx(8 * 2e10 * 2e-6 * 0.5, rel=1e-14)
    assert float(normal_spot_stiffness(spot_area=area, contact_modulus=MODULUS)) == pytest.approx(
        2 * MODULUS * 2e-6, rel=1e-14
    )


def test_slip_factor_values_and_limits():
    share = np.array([0.0, 0.5, 1 - 1e-3, 1.0, 1.5])
    found = slip_factor(tangential_force=share * 120.0, normal_force=1000.0, friction_coefficient=0.12)
    np.testing.assert_allclose(found[:3], [1.0, 0.5 ** (1 / 3), 0.1], rtol=1e-12)
    assert found[3:].tolist() == [0.0, 0.0]
    assert float(slip_factor(tangential_force=0.0, normal_force=0.0, friction_coefficient=0.12)) == 0.0


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_slip_factor_derivative_is_exact_in_stick_and_zero_beyond():
    def factor(shear):
        return slip_factor(tangential_force=shear, normal_force=1000.0, friction_coefficient=0.12)

    slope = jax.vmap(jax.grad(factor))(np.array([0.0, 60.0, 120.0, 500.0]))
    np.testing.assert_allclose(slope[:2], [-1 / 360, -1 / 360 * 0.5 ** (-2 / 3)], rtol=1e-12)
    assert slope[2:].tolist() == [0.0, 0.0]
