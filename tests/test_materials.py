"""Moduli of a pair of bodies."""

import jax.numpy as jnp
import pytest

from asperity.materials import (
    Material,
    contact_modulus,
    hardness,
    pair,
    shear_modulus,
    tangential_contact_modulus,
)

STEEL = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)
BRONZE = Material(110e9, 0.34, 8800.0, 300e6, 900e6)


def moduli(one, two):
    return {
        "youngs_modulus_1": one.youngs_modulus,
        "youngs_modulus_2": two.youngs_modulus,
        "poisson_ratio_1": one.poisson_ratio,
        "poisson_ratio_2": two.poisson_ratio,
    }


def test_published_hardness_of_the_papers_steel():
    assert hardness(hardness_factor=2.8, yield_strength=450e6) == pytest.approx(1260e6)


def test_like_bodies_give_the_closed_forms():
    """E* = E/(2(1 - nu^2)) (Johnson 1985, 4.2); G* = G/(2(2 - nu)) (Mindlin 1949)."""
    assert contact_modulus(**moduli(STEEL, STEEL)) == pytest.approx(206e9 / (2 * (1 - 0.09)), rel=1e-15)
    assert tangential_contact_modulus(**moduli(STEEL, STEEL)) == pytest.approx(
        206e9 / 2.6 / (2 * 1.7), rel=1e-15
    )
    assert shear_modulus(youngs_modulus=206e9, poisson_ratio=0.3) == pytest.approx(206e9 / 2.6, rel=1e-15)


def test_tangential_over_normal_stiffness_is_mindlins_ratio():
    """8 G* r over 2 E* r of like bodies is 2(1 - nu)/(2 - nu)."""
    ratio = (
        8
        * tangential_contact_modulus(**moduli(BRONZE, BRONZE))
        / (2 * contact_modulus(**moduli(BRONZE, BRONZE)))
    )
    assert ratio == pytest.approx(2 * (1 - 0.34) / (2 - 0.34), rel=1e-14)


def test_a_rigid_mate_leaves_one_body():
    rigid = Material(1e30, 0.3, 1.0, 1e30, 1e30)
    assert contact_modulus(**moduli(STEEL, rigid)) == pytest.approx(206e9 / 0.91, rel=1e-12)


def test_pair_is_symmetric_and_takes_the_weaker_body():
    one, two = pair(STEEL, BRONZE), pair(BRONZE, STEEL)
    assert one == two
    assert one.hardness == 900e6
    assert one.yield_strength == 300e6
    assert one.contact_modulus == pytest.approx(1 / ((1 - 0.09) / 206e9 + (1 - 0.34**2) / 110e9), rel=1e-15)


def test_arrays_broadcast():
    batch = Material(jnp.array([206e9, 110e9]), 0.3, 7850.0, jnp.array([450e6, 600e6]), 1260e6)
    found = pair(batch, STEEL)
    assert found.contact_modulus.shape == (2,)
    assert found.yield_strength.tolist() == [450e6, 450e6]
