"""Roller pairs by hand, and each with its own model of the contact factor."""

import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.laws.zou_2025 import Zou2025
from asperity.contact.roller_pairs import (
    CONTACT_FACTOR_MODELS,
    contact_factors,
    numbered_contact_factors,
    roller_pairs,
    rough_contacts,
)
from asperity.materials import Material, pair

STEEL = Material(206e9, 0.3, 7850.0, 450e6, 1260e6)


def pairs(sign=1.0):
    """Rollers of 10 and 20 mm, 5 mm long, at the paper's peak D = 1.85."""
    return roller_pairs(
        radius_1=10e-3,
        radius_2=20e-3,
        sign=sign,
        contact_length=5e-3,
        friction_coefficient=0.1,
        moduli=pair(STEEL, STEEL),
        surface=Zou2025(1.85, 1e-11, 1.5, "majumdar_bhushan_1991"),
    )


def test_radius_and_strip_by_hand():
    """R = R1 R2/(R1 ± R2); b = sqrt(4 N R/(pi B E*)) with E* = 113.187 GPa, Johnson 1985, (4.43)."""
    assert float(pairs().effective_radius) == pytest.approx(20e-3 / 3.0, rel=1e-14)
    assert float(pairs(-1.0).effective_radius) == pytest.approx(20e-3, rel=1e-14)
    width = np.sqrt(4.0 * 1000.0 * 20e-3 / 3.0 / (np.pi * 5e-3 * 206e9 / 1.82))
    assert float(pairs().half_width(1000.0)) == pytest.approx(width, rel=1e-13)
    assert float(pairs().half_width(0.0)) == pytest.approx(width / np.sqrt(1000.0), rel=1e-13)


def test_the_peak_of_the_paper_with_either_sense_of_the_tangential_force():
    """K_t at D = 1.85: 2.825e9 N/mm with the printed lambda (table of the model's page); T = 7/8 mu N halves it."""
    factor = contact_factors(pairs=pairs(), model="printed", normal_force=1000.0)
    stiffness = rough_contacts(
        pairs=pairs(),
        contact_factor=factor,
        normal_force=1000.0,
        tangential_force=np.array([0.0, 87.5, -87.5]),
    ).tangential_stiffness
    np.testing.assert_allclose(stiffness, [2.825e12, 1.4125e12, 1.4125e12], rtol=2e-4)


def test_each_row_uses_its_own_model():
    printed, unity = CONTACT_FACTOR_MODELS.index("printed"), CONTACT_FACTOR_MODELS.index("unity")
    found = numbered_contact_factors(
        pairs=pairs(), model_number=np.array([printed, unity, printed, 7]), normal_force=np.full(4, 1000.0)
    )
    expected = float(contact_factors(pairs=pairs(), model="printed", normal_force=1000.0))
    np.testing.assert_allclose(found[:3], [expected, 1.0, expected], rtol=1e-15)
    assert jnp.isnan(found[3])  # there is no model 7
