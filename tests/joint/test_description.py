"""Numbers for one or all contacts, and numbers of one rank."""

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np

from asperity.joint.description import per_contact, with_one_rank
from asperity.materials import Material

SUN, RING = (Material(modulus, 0.3, 7800.0, 4e8, 1.2e9) for modulus in (200e9, 100e9))


def test_one_or_five_things_are_stacked():
    np.testing.assert_array_equal(per_contact((2.0,)), [2.0])
    np.testing.assert_array_equal(per_contact((1.0, 2.0, 3.0, 4.0, 5.0)), [1.0, 2.0, 3.0, 4.0, 5.0])
    assert per_contact((np.ones(3), 2.0)).shape == (2, 3)
    assert per_contact((SUN, RING)).youngs_modulus.tolist() == [200e9, 100e9]


def test_every_number_gets_the_rank_of_the_batch(paper_joint):
    joint = dataclasses.replace(paper_joint(), preload=jnp.ones((4, 3)), output_torque=jnp.ones(3))
    shapes = {leaf.shape for leaf in jax.tree.leaves(with_one_rank(joint))}
    assert shapes == {(4, 3), (1, 3), (1, 1)}
