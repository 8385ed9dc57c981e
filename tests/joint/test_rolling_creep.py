"""Creep of the contacts: Carter's limit, the layer's compliance by hand, and skew."""

import math

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.joint.contacts import joint_contacts
from asperity.joint.rolling_creep import capacity_loss, contact_creep, lateral_slip_ratio

NORMAL = np.array([1000.0, 600.0, 500.0, 600.0, 500.0])
RADIUS = np.array([4.0 * 13.5 / 17.5, *[13.5 * 5.0 / 18.5] * 2, *[5.0 * 40.0 / 35.0] * 2]) * 1e-3
LENGTH, MODULUS, FRICTION = 5e-3, 206e9 / (2.0 * 0.91), 0.12
WIDTH = np.sqrt(4.0 * NORMAL * RADIUS / (math.pi * LENGTH * MODULUS))
CARTER = FRICTION * WIDTH / RADIUS  # creepage at gross slip


@pytest.fixture(scope="module")
def creep(paper_joint):
    def of(stiffness, skew=None, slip_ratio=0.4):
        return contact_creep(
            contacts=joint_contacts(paper_joint()),
            skew=skew,
            normal_force=jnp.asarray(NORMAL),
            tangential_force=jnp.asarray(slip_ratio * FRICTION * NORMAL),
            asperity_normal_stiffness=jnp.full(5, stiffness),
        )

    return of


def test_stiff_asperities_leave_carters_creep(creep):
    found = creep(1e20)
    np.testing.assert_allclose(found.layer_factor, 1.0, rtol=1e-6)
    np.testing.assert_allclose(found.law.gross_slip_scale * np.sqrt(NORMAL), CARTER, rtol=1e-6)
    np.testing.assert_array_equal(found.skew_factor, 1.0)
    assert found.parallel
    assert found.crown_factor is None


def test_ratio_of_the_layer(creep):
    """E* B over the tangential stiffness of the asperities, 2 (1 - nu)/(2 - nu) of their normal one (Mindlin)."""
    stiffness = 3e9
    found = creep(stiffness)
    np.testing.assert_allclose(
        found.layer_ratio, MODULUS * LENGTH / (2.0 * 0.7 / 1.7 * stiffness), rtol=1e-12
    )
    # a soft layer makes the strip creep more
    assert np.all(np.asarray(creep(3e8).layer_factor) > np.asarray(found.layer_factor))


def test_contacts_without_an_elastic_spot_have_no_creep(creep):
    assert np.all(np.isnan(np.asarray(creep(0.0).law.gross_slip_scale)))


def test_skew_adds_creep_and_takes_friction(creep):
    """Small angles: friction acts along the creepage's direction, so that the axial force grows in proportion."""
    stiff = {"friction_coefficient": FRICTION, "width_over_radius": WIDTH / RADIUS}
    parallel = creep(1e20)
    along = 0.4 * jnp.asarray(CARTER)
    np.testing.assert_array_equal(lateral_slip_ratio(creep=parallel, creepage=along, **stiff), 0.0)
    np.testing.assert_array_equal(capacity_loss(creep=parallel, **stiff), 0.0)
    little, twice = (creep(1e20, skew=(angle,)) for angle in (1e-6, 2e-6))
    assert not little.parallel
    first, second = (lateral_slip_ratio(creep=skewed, creepage=along, **stiff) for skewed in (little, twice))
    lost = capacity_loss(creep=little, **stiff)
    np.testing.assert_allclose(np.asarray(second) / np.asarray(first), 2.0, rtol=1e-3)
    assert np.all(np.asarray(lost) >= 0.0)
    assert np.all(np.asarray(lost) < 1e-3)
    strong = creep(1e20, skew=(5e-3,))
    assert np.all(np.asarray(strong.skew_factor) > 1.0)
