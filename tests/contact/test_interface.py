"""Asperities and bulk in series."""

import math

import jax
import jax.numpy as jnp
import pytest

from asperity.contact.interface import (
    Interface,
    bulk_tangential_stiffness,
    compliance_share,
    series_stiffness,
)
from asperity.materials import contact_modulus, tangential_contact_modulus


def test_two_springs_in_series_add_their_compliances():
    assert float(series_stiffness(2e8, 3e8)) == pytest.approx(1.0 / (1.0 / 2e8 + 1.0 / 3e8), rel=1e-15)
    assert float(series_stiffness(0.0, 3e8)) == 0.0
    assert float(series_stiffness(0.0, 0.0)) == 0.0


def test_shares_of_the_compliance_add_up_to_one():
    rough = Interface(asperity_normal=4e9, asperity_tangential=3e9, bulk_normal=2e8, bulk_tangential=1.6e8)
    other = Interface(asperity_normal=2e8, asperity_tangential=1.6e8, bulk_normal=4e9, bulk_tangential=3e9)
    assert float(rough.asperity_share_normal + other.asperity_share_normal) == pytest.approx(1.0, rel=1e-15)
    assert float(rough.asperity_share_tangential) == pytest.approx(
        (1 / 3e9) / (1 / 3e9 + 1 / 1.6e8), rel=1e-14
    )
    assert float(rough.normal) < 2e8
    assert math.isnan(float(compliance_share(0.0, 0.0)))


def test_gradient_is_finite_where_a_spring_is_gone():
    slope = jax.grad(lambda k: jnp.sum(series_stiffness(k, jnp.array([0.0, 1e8]))))(jnp.zeros(2))
    assert bool(jnp.all(jnp.isfinite(slope)))


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
def test_like_bodies_have_the_ratio_of_mindlin(nu):
    elastic = {
        "youngs_modulus_1": 2e11,
        "youngs_modulus_2": 2e11,
        "poisson_ratio_1": nu,
        "poisson_ratio_2": nu,
    }
    ours = bulk_tangential_stiffness(
        bulk_normal_stiffness=1e8,
        contact_modulus=contact_modulus(**elastic),
        tangential_contact_modulus=tangential_contact_modulus(**elastic),
        normal_force=100.0,
        tangential_force=0.0,
        friction_coefficient=0.1,
    )
    assert float(ours) == pytest.approx(1e8 * 2.0 * (1.0 - nu) / (2.0 - nu), rel=1e-14)  # Mindlin 1949


def test_partial_slip_softens_the_bodies_too():
    half = bulk_tangential_stiffness(
        bulk_normal_stiffness=1e8, contact_modulus=1e11, tangential_contact_modulus=2e10,
        normal_force=100.0, tangential_force=8.75, friction_coefficient=0.1,
    )  # fmt: skip
    assert float(half) == pytest.approx(0.8e8 * 0.5, rel=1e-12)  # (1 - 7/8)^(1/3) = 1/2
