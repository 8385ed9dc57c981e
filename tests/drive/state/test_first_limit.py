"""Slip ratios, and the search for the first of several limits of known functions."""

import math

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.state.first_limit import first_limit, slip_ratio


def cubic(limit):
    """Two limits as by hand: x³ reaches its own first, the line would reach twice that."""
    return lambda x: jnp.stack([(x / limit) ** 3 - 1.0, 0.5 * x / limit - 1.0])


@pytest.mark.parametrize("guess", [1e-3, 1.0, 7.0, 7.5, 1e6])
@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_first_limit_is_found_from_any_guess(guess):
    found = first_limit(excesses=cubic(7.0), first_guess=guess)
    assert float(found.value) == pytest.approx(7.0, rel=1e-12)
    assert int(found.which) == 0


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_a_batch_finds_each_its_own():
    limits = jnp.array([0.3, 7.0, 2e5])
    found = first_limit(excesses=cubic(limits), first_guess=jnp.ones(3))
    np.testing.assert_allclose(found.value, limits, rtol=1e-12)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_no_limit_and_a_limit_at_once():
    never = first_limit(excesses=lambda x: jnp.stack([-1.0 / (1.0 + x)]), first_guess=1.0)
    at_once = first_limit(excesses=lambda x: jnp.stack([x - 5.0, 1.0 + x]), first_guess=1.0)
    assert (float(never.value), int(never.which)) == (math.inf, -1)
    assert (float(at_once.value), int(at_once.which)) == (0.0, 1)


@pytest.mark.programs("derivatives by JAX, one operation after the other")
def test_the_derivative_is_implicit():
    slope = jax.grad(lambda limit: first_limit(excesses=cubic(limit), first_guess=1.0).value)(7.0)
    assert float(slope) == pytest.approx(1.0, rel=1e-9)


def test_a_nan_is_no_limit_of_its_own():
    def with_hole(x):
        return jnp.stack([jnp.where(x > 3.0, jnp.nan, x - 7.0), jnp.where(x > 3.0, 1.0, -1.0)])

    found = first_limit(excesses=with_hole, first_guess=1.0)
    assert (float(found.value), int(found.which)) == (pytest.approx(3.0, rel=1e-12), 1)


def test_slip_ratio_of_an_open_contact():
    assert float(slip_ratio(normal_force=0.0, tangential_force=1.0, friction_coefficient=0.1)) == math.inf
    assert float(slip_ratio(normal_force=0.0, tangential_force=0.0, friction_coefficient=0.1)) == 0.0


def test_where_nothing_is_known_beyond_a_limit_it_is_that_which_is_all_but_reached():
    """A force that falls to nothing at 7, beyond which no state is found: not the limit of the search itself."""

    def lifts(x):
        lost = x > 7.0 - 1e-12
        return jnp.stack(
            [
                jnp.where(lost, jnp.nan, 0.5 * x / 7.0 - 1.0),
                jnp.where(lost, jnp.nan, x / 7.0 - 1.0),
                jnp.where(lost, 1.0, -1.0),
            ]
        )

    found = first_limit(excesses=lifts, first_guess=1.0)
    assert (float(found.value), int(found.which)) == (pytest.approx(7.0, rel=1e-11), 1)
