"""Slip of contacts that stand: the integral of their incremental compliance."""

import dataclasses
import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.contact.crowned_line import CrownedLines
from asperity.contact.crowned_shear import crown_shear_compliance
from asperity.drive.normal_springs import NormalSprings, crowned_springs
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.state import ContactLaws, slip_at_rest, surface_speeds

NORMAL = jnp.array([800.0])
LIMIT = 0.1 * 800.0


def laws(asperities=2e-10):
    return ContactLaws(
        springs=NormalSprings(jnp.array([5e-9]), jnp.array([4.2e-9])),
        reference_force=jnp.array([700.0]),
        creep=CreepLaw(jnp.array([0.1]), jnp.array([1e-5])),
        asperity_compliance=None if asperities is None else jnp.array([asperities]),
    )


@pytest.mark.parametrize("share", [0.05, 0.5, 0.95])
def test_slip_is_the_integral_of_the_incremental_compliance(share):
    """Bodies C_0 + b ln 1/(1 - q), asperities c_a (1 - q)^(-1/3), by quadrature."""
    q, weights = np.polynomial.legendre.leggauss(200)
    q, weights = 0.5 * share * (q + 1.0), 0.5 * share * weights
    compliance = 4.2e-9 - 0.8e-9 * np.log1p(-q) + 2e-10 * (1.0 - q) ** (-1.0 / 3.0)
    found = slip_at_rest(laws=laws(), normal=NORMAL, tangential=jnp.array([share * LIMIT]))
    assert float(found[0]) == pytest.approx(LIMIT * float(weights @ compliance), rel=1e-8)
    back = slip_at_rest(laws=laws(), normal=NORMAL, tangential=jnp.array([-share * LIMIT]))
    assert float(back[0]) == -float(found[0])
    random = dataclasses.replace(laws(), slip_exponent=1.0)  # asperities c_a/(1 - q)
    compliance = 4.2e-9 - 0.8e-9 * np.log1p(-q) + 2e-10 / (1.0 - q)
    found = slip_at_rest(laws=random, normal=NORMAL, tangential=jnp.array([share * LIMIT]))
    assert float(found[0]) == pytest.approx(LIMIT * float(weights @ compliance), rel=1e-8)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_beyond_999_thousandths_the_tangent_goes_on():
    """The slope there is the incremental compliance at 0.999 of friction, bodies and asperities."""

    def slip(force):
        return slip_at_rest(laws=laws(), normal=NORMAL, tangential=jnp.array([force]))[0]

    expected = 4.2e-9 - 0.8e-9 * math.log(1e-3) + 2e-10 * 1e-3 ** (-1.0 / 3.0)
    for share in (0.9989999, 1.0, 1.5):
        assert float(jax.grad(slip)(share * LIMIT)) == pytest.approx(expected, rel=1e-3)
    assert float(slip(1.5 * LIMIT) - slip(1.2 * LIMIT)) == pytest.approx(0.3 * LIMIT * expected, rel=1e-9)


@pytest.mark.slow
def test_crowned_contacts_slip_by_their_shear_compliance_more():
    """The slope of the slip is the compliance of the even contact and that of the crown, under N - T/mu."""
    lines = CrownedLines(*(jnp.array([x]) for x in (0.5, 10e-3, 20e-3 / 3.0, 113e9)))
    crowned = dataclasses.replace(
        laws(),
        springs=dataclasses.replace(
            laws().springs, crowns=crowned_springs(lines=lines, rest_force=jnp.array([700.0]))
        ),
        lateral_strain_compliance=jnp.array([4e-12]),
    )

    def slip(force, contact):
        return slip_at_rest(laws=contact, normal=NORMAL, tangential=jnp.array([force]))[0]

    slope = jax.jit(jax.value_and_grad(slip))
    compliance = jax.jit(crown_shear_compliance)
    for share in (0.3, 0.9):
        even, both = (float(slope(share * LIMIT, contact)[1]) for contact in (laws(), crowned))
        expected = compliance(
            stick_force=(1.0 - share) * NORMAL, lateral_strain_compliance=4e-12, **vars(lines)
        )
        assert both - even == pytest.approx(float(expected[0]), rel=1e-3)
        assert both - even > 0.1 * even
    assert float(slope(-0.5 * LIMIT, crowned)[0]) == -float(slope(0.5 * LIMIT, crowned)[0])


def test_without_a_force_the_slope_is_that_of_both_sides():
    """It was 0, as if the contact were rigid: contacts side by side then had no unique share."""

    def slip(force):
        return slip_at_rest(laws=laws(), normal=NORMAL, tangential=jnp.array([force]))[0]

    assert float(slip(0.0)) == 0.0
    assert float(jax.grad(slip)(0.0)) == pytest.approx(4.2e-9 + 2e-10, rel=1e-12)


def test_surface_speeds_are_relative_to_the_carrier(drives):
    """Sun at 1, carrier at 1/6: 10 mm * 5/6 on both sides, and on the ring 50 mm / 6."""
    one, two = surface_speeds(drive=drives["planetary"], speed=jnp.array([1.0, -0.25, 0.0, 1.0 / 6.0]))
    np.testing.assert_allclose(one, [10e-3 * 5.0 / 6.0, 20e-3 * 5.0 / 12.0], rtol=1e-12)
    np.testing.assert_allclose(two, [20e-3 * 5.0 / 12.0, 50e-3 / 6.0], rtol=1e-12)


def test_beyond_slip_the_slip_grows():
    def slip(force):
        return slip_at_rest(laws=laws(None), normal=NORMAL, tangential=jnp.array([force]))[0]

    assert float(slip(1.5 * LIMIT)) > float(slip(LIMIT)) > float(slip(0.999 * LIMIT))
    assert math.isfinite(float(jax.grad(slip)(1.2 * LIMIT)))
