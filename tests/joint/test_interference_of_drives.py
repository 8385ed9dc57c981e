"""Interference and preload of the paper's joint against an independent computation."""

import numpy as np
import pytest


@pytest.fixture(scope="module")
def springs(paper_joint, evaluated_together):
    """The paper's joint as springs: Johnson, and Weber and Banaschek for a wall of 60 mm."""

    def evaluated(**changes):
        return evaluated_together(paper_joint(ring_wall_thickness=60e-3, body_model="springs", **changes))

    return evaluated


@pytest.mark.long
def test_a_thousand_newtons_are_thirteen_micrometres_at_any_torque(springs):
    """12.904 um, computed independently."""
    found = springs(output_torque=np.array([0.0, 5.0, 12.0]))
    np.testing.assert_allclose(found.interference, 12.904e-6, atol=5e-10)


@pytest.mark.long
def test_planets_too_large_or_too_small(springs):
    """5 um on every planet radius make 218 or 1854 N, 2 um 676 or 1335 N; a planet counts 1.9413 times."""
    sizes = np.array([-5e-6, -2e-6, 0.0, 2e-6, 5e-6])
    found = springs(interference=12.904e-6 + 1.9413 * sizes, output_torque=0.0)
    np.testing.assert_allclose(found.preload, [218.0, 676.0, 1000.0, 1335.0, 1854.0], atol=0.6)


@pytest.mark.long
def test_exact_bodies_and_a_ring_that_carries_itself(paper_joint, evaluated_together):
    """All six radial loads on a ring of 10 mm: 2.43827e-8 m/N free, 2.71043e-9 held, computed independently."""
    held, free, springs = (
        evaluated_together(paper_joint(output_torque=np.array([1e-6, 5.0]), **changes)).interference
        for changes in ({}, {"ring_support": "free"}, {"body_model": "springs"})
    )
    np.testing.assert_allclose(held, springs, rtol=0.03)
    force = 1000.0 / (2 * np.cos(np.radians(27.0831))) * np.cos(np.radians(13.1582))
    np.testing.assert_allclose(free - held, force * (2.43827e-8 - 2.71043e-9), rtol=0.01)
    # it is that of the joint at rest, although the matrix of the bodies is found under load
    assert held[1] == pytest.approx(held[0], rel=2e-5)
