"""Largest stresses under full slip against a search in Flamant's solution, and the stored coefficients against them."""

import jax.numpy as jnp
import numpy as np
import pytest
from flamant import flamant_field

from asperity.contact.shakedown_table import MISES, SHEAR
from asperity.contact.stress_peaks import (
    POISSON_RANGE,
    SHEAR_FRICTION,
    fitted_coefficients,
    full_slip_stress,
    mises_friction,
    mises_peak,
    shear_peak,
)

GRID = np.meshgrid(np.linspace(-1.2, 1.2, 97), np.linspace(0.1, 1.2, 56), indexing="ij")


FRICTIONS = np.array([0.0, 0.1, 0.2, 0.3, 0.35])


@pytest.mark.slow
def test_without_friction_the_peaks_are_johnsons():
    shear = shear_peak(friction_coefficient=FRICTIONS)
    in_plane = mises_peak(friction_coefficient=FRICTIONS, poisson_ratio=0.5)
    assert [float(v[0]) for v in (shear.stress, shear.position, shear.depth)] == pytest.approx(
        [0.25, np.sqrt(0.75), 0.5], rel=1e-10
    )
    assert float(in_plane.stress[0]) == pytest.approx(0.3002831, rel=1e-6)
    assert float(in_plane.depth[0]) == pytest.approx(np.sqrt((np.sqrt(5) - 1) / 2), rel=1e-10)


@pytest.mark.slow
def test_peaks_are_the_largest_of_flamants_field():
    shear = shear_peak(friction_coefficient=FRICTIONS)
    mises = mises_peak(friction_coefficient=FRICTIONS, poisson_ratio=0.3)
    assert bool(jnp.all(shear.solved))
    assert bool(jnp.all(mises.solved))
    for i, friction in enumerate(FRICTIONS):
        sx, sz, t = flamant_field(friction, *GRID, 400)
        largest = [np.abs(t).max()]
        expected = [float(shear.stress[i])]
        if friction <= 0.2:  # beyond, the largest Mises stress for nu = 0.3 is at the surface
            largest.append(np.sqrt((sx - sz) ** 2 / 4 + t**2 + 0.16 / 3 * ((sx + sz) / 2) ** 2).max())
            expected.append(float(mises.stress[i]))
        assert largest == pytest.approx(expected, rel=2e-3)
        assert np.all(np.array(largest) <= np.array(expected) * (1 + 1e-6))


@pytest.mark.long
def test_stored_coefficients_are_those_of_the_field():
    shear, mises = fitted_coefficients(shear_terms=len(SHEAR), mises_terms=(len(MISES), len(MISES[0])))
    np.testing.assert_allclose(SHEAR, shear, atol=1e-9)
    np.testing.assert_allclose(MISES, mises, atol=1e-9)


@pytest.mark.long
def test_surface_overtakes_every_tabulated_peak_within_the_table():
    """At the largest tabulated friction the surface is more stressed than the peak, and the peak's lead only falls."""
    assert 1 / float(shear_peak(friction_coefficient=SHEAR_FRICTION).stress) > 1 / SHEAR_FRICTION
    poisson = np.linspace(*POISSON_RANGE, 9)
    friction = np.array([[0.8], [0.9], [1.0]]) * mises_friction(poisson)
    peak = mises_peak(friction_coefficient=friction, poisson_ratio=poisson)
    assert bool(jnp.all(peak.solved))
    lead = np.asarray(peak.stress) / np.sqrt(friction**2 + (1 - 2 * poisson) ** 2 / 3 * (1 + friction**2))
    assert np.all(lead[2] < 1)
    assert np.all(np.diff(lead, axis=0) < 0)


def test_full_slip_in_units_of_the_contact():
    found = full_slip_stress(position=0.3, depth=0.4, friction_coefficient=0.2)
    expected = [float(v[0]) for v in flamant_field(0.2, np.array([0.3]), np.array([0.4]), 400)]
    np.testing.assert_allclose([found.longitudinal, found.normal, found.shear], expected, rtol=1e-9)
