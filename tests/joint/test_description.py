"""Which materials meet at which contact, and numbers of one rank."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.description import Bodies, contact_bodies, contact_pairs, per_contact, with_one_rank
from asperity.materials import Material

SUN, PLANET, ROLLER, RING = (
    Material(modulus, ratio, 7800.0, strength, 3.0 * strength)
    for modulus, ratio, strength in (
        (200e9, 0.30, 4e8),
        (210e9, 0.28, 5e8),
        (300e9, 0.26, 9e8),
        (100e9, 0.34, 2e8),
    )
)
BODIES = Bodies(SUN, PLANET, ROLLER, RING)


def test_one_or_five_things_are_stacked():
    np.testing.assert_array_equal(per_contact((2.0,)), [2.0])
    np.testing.assert_array_equal(per_contact((1.0, 2.0, 3.0, 4.0, 5.0)), [1.0, 2.0, 3.0, 4.0, 5.0])
    assert per_contact((np.ones(3), 2.0)).shape == (2, 3)
    assert per_contact((SUN, RING)).youngs_modulus.tolist() == [200e9, 100e9]


def test_driving_and_driven_bodies_follow_the_power():
    driving, driven = contact_bodies(BODIES)
    assert driving.youngs_modulus.tolist() == [200e9, 210e9, 210e9, 300e9, 300e9]
    assert driven.youngs_modulus.tolist() == [210e9, 300e9, 300e9, 100e9, 100e9]


def test_pairs_by_hand():
    """1/E = sum (1 - nu^2)/E_i and 1/G* = sum (2 - nu)/G_i, model.md section 3; hardness of the softer body."""
    pairs = contact_pairs(BODIES)
    for index, (one, two) in enumerate(((SUN, PLANET), *2 * ((PLANET, ROLLER),), *2 * ((ROLLER, RING),))):
        flexibility = sum((1.0 - body.poisson_ratio**2) / body.youngs_modulus for body in (one, two))
        shear = sum(
            (2.0 - body.poisson_ratio) * 2.0 * (1.0 + body.poisson_ratio) / body.youngs_modulus
            for body in (one, two)
        )
        assert float(pairs.contact_modulus[index]) == pytest.approx(1.0 / flexibility, rel=1e-14)
        assert float(pairs.tangential_contact_modulus[index]) == pytest.approx(1.0 / shear, rel=1e-14)
        assert float(pairs.hardness[index]) == min(one.hardness, two.hardness)
        assert float(pairs.yield_strength[index]) == min(one.yield_strength, two.yield_strength)


def test_every_number_gets_the_rank_of_the_batch(paper_joint):
    joint = dataclasses.replace(paper_joint(), preload=jnp.ones((4, 3)), output_torque=jnp.ones(3))
    shapes = {leaf.shape for leaf in jax.tree.leaves(with_one_rank(joint))}
    assert shapes == {(4, 3), (1, 3), (1, 1)}
