"""Asperities and bulk in series."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.bem import (
    FreeHalfSpace,
    elastic_pair,
    normal_contact,
    normal_stiffness,
    partial_slip,
    tangential_stiffness,
)
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.contact.interface import (
    bulk_tangential_stiffness,
    series_stiffness,
)


def test_two_springs_in_series_add_their_compliances():
    assert float(series_stiffness(2e8, 3e8)) == pytest.approx(1.0 / (1.0 / 2e8 + 1.0 / 3e8), rel=1e-15)
    assert float(series_stiffness(0.0, 3e8)) == 0.0
    assert float(series_stiffness(0.0, 0.0)) == 0.0


def test_friction_used_by_half_adds_the_logarithm_of_two():
    """Compliances 3 and 2 ln(1/(1 - 0.5)) nm/N."""
    stiffness = bulk_tangential_stiffness(
        normal_compliance=3e-9,
        logarithmic_compliance=2e-9,
        normal_force=1000.0,
        tangential_force=60.0,
        friction_coefficient=0.12,
    )
    assert 1.0 / float(stiffness) == pytest.approx(3e-9 + 2e-9 * math.log(2.0), rel=1e-12)


def test_gradient_is_finite_where_a_spring_is_gone():
    slope = jax.grad(lambda k: jnp.sum(series_stiffness(k, np.array([0.0, 1e8]))))(np.zeros(2))
    assert bool(jnp.all(jnp.isfinite(slope)))


LOAD, MU, FAR = 2e5, 0.12, 1e-2  # N/m, -, m


@pytest.fixture(scope="module")
def strip():
    """A line contact of steel cylinders by boundary elements: plane strain, loads per metre of length."""
    pair = elastic_pair(
        youngs_modulus_1=206e9, youngs_modulus_2=206e9, poisson_ratio_1=0.3, poisson_ratio_2=0.3
    )
    radius = 6e-3
    width = np.sqrt(4.0 * LOAD * radius / (np.pi * pair.contact_modulus))
    x = (np.arange(257) - 128) * width / 120
    half_space = FreeHalfSpace(pair, shape=(257,), pixel_size=(width / 120,), reference_distance=FAR)
    return normal_contact(half_space, -(x**2) / (2.0 * radius), normal_force=LOAD)


def bodies(strip, tangential_force):
    """Tangential stiffness as the package gives it, from the normal stiffness of the boundary elements."""
    normal = normal_stiffness(strip.half_space, strip.pressure > 0.0).stiffness
    logarithm = logarithmic_compliance(contact_length=1.0, youngs_modulus=206e9, poisson_ratio=0.3)
    return bulk_tangential_stiffness(
        normal_compliance=1.0 / normal,
        logarithmic_compliance=2.0 * logarithm,
        normal_force=LOAD,
        tangential_force=tangential_force,
        friction_coefficient=MU,
    )


@pytest.mark.slow
def test_a_sticking_line_contact_is_as_stiff_in_shear_as_in_compression_by_boundary_elements(strip):
    found = tangential_stiffness(strip.half_space, strip.pressure > 0.0, axis=0).stiffness
    assert float(bodies(strip, 0.0)) == pytest.approx(float(found), rel=1e-6)


@pytest.mark.slow
def test_partial_slip_softens_the_bodies_as_by_boundary_elements(strip):
    """Slope of the first loading: the incremental stiffness; the secant one would be 1 to 10 % off here."""
    shares = np.array([0.25, 0.57, 0.85])
    step = 0.01
    path = MU * LOAD * np.sort(np.concatenate([shares - step, shares + step]))
    found = partial_slip(
        strip.half_space, strip.pressure, friction_coefficient=MU, axis=0, tangential_force=path
    )
    shift = np.asarray(found.displacement)
    expected = np.diff(path)[::2] / np.diff(shift)[::2]
    ours = bodies(strip, MU * LOAD * shares)
    np.testing.assert_allclose(ours, expected, rtol=2e-3)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_from_gross_slip_on_the_bodies_carry_nothing_and_slopes_stay_finite(strip):
    forces = np.array([0.999, 1.0, 1.5]) * MU * LOAD
    assert float(bodies(strip, forces)[0]) > 0.0
    np.testing.assert_array_equal(bodies(strip, forces)[1:], 0.0)
    slope = jax.grad(lambda force: jnp.sum(bodies(strip, force)))(forces)
    assert bool(jnp.all(jnp.isfinite(slope)))


def test_a_contact_that_carries_nothing_has_no_stiffness_and_finite_slopes():
    def stiffness(normal, compliance):
        return bulk_tangential_stiffness(
            normal_compliance=compliance,
            logarithmic_compliance=1e-9,
            normal_force=normal,
            tangential_force=np.zeros(()),
            friction_coefficient=MU,
        )

    assert float(stiffness(np.zeros(()), np.asarray(np.inf))) == 0.0
    assert all(map(jnp.isfinite, jax.grad(stiffness, argnums=(0, 1))(np.zeros(()), np.asarray(np.inf))))
