"""Torque capacity: the largest output torque before the first limit is reached (A9)."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.implicit import implicit_root
from asperity.types import Real

#: Relative width of the last interval of the search.
SEARCH_TOLERANCE = 1e-13
#: Share of the first guess below which a drive has no capacity at all.
SMALLEST_SHARE = 1e-12

_MOST_STEPS = 150  # forty doublings reach 10^12 times the guess, ninety halvings any interval's last digit


class FirstLimit(NamedTuple):
    """Where the first of several limits is reached.

    Parameters
    ----------
    value : Array
        Largest value that keeps all limits; infinite where none is reached, 0 where one is reached at once.
    which : Array
        Which limit it is; −1 where none is reached.
    """

    value: Array
    which: Array


class _Search(NamedTuple):
    lower: Array  # no limit is reached here
    upper: Array  # one is, once bracketed
    bracketed: Array
    which: Array  # the one reached at the upper bound
    steps: Array


def slip_ratio(*, normal_force: Real, tangential_force: Real, friction_coefficient: Real) -> Array:
    r"""Traction used over traction available, :math:`|T|/(\mu N)`.

    Parameters
    ----------
    normal_force, tangential_force : Real
        N and T of a contact [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Array
        Ratio [-]; the contact slips grossly from 1 on. Infinite for a force without a normal load, 0 for neither.

    References
    ----------
    Amontons–Coulomb friction; Zou et al. 2025, equation (22).
    """
    limit = friction_coefficient * normal_force
    touching = limit > 0.0
    force = jnp.abs(tangential_force)
    return jnp.where(touching, force / jnp.where(touching, limit, 1.0), jnp.where(force > 0.0, jnp.inf, 0.0))


def first_limit(*, excesses: Callable[[Array], Array], first_guess: Real) -> FirstLimit:
    r"""Smallest positive value at which one of several functions becomes positive.

    .. math:: \max_i g_i(x) = 0

    Parameters
    ----------
    excesses : callable
        Values, shape (...), to the functions g, shape (limits, ...); negative before a limit, and not negative at it
        and beyond. A nan counts as not reached.
    first_guess : Real
        Value of the right order, shape (...), where the search begins; in the unit of the values [any].

    Returns
    -------
    FirstLimit
        The value, shape (...), with the implicit derivative of the limit that is reached; and which one that is.

    Notes
    -----
    Doubling until a limit is reached, then halving. A limit that jumps instead of passing through zero has no implicit
    derivative; 0 is returned for it.

    References
    ----------
    Equation (A9) of :doc:`/equations`.
    """
    start = jnp.asarray(first_guess)
    excesses = jax.jit(excesses)  # traced once for the search and for the derivative

    def unfinished(state: _Search) -> Array:
        wide = (state.upper - state.lower > SEARCH_TOLERANCE * state.upper) & (
            state.upper > SMALLEST_SHARE * start
        )
        searching = ~state.bracketed & (state.upper < 2.0**40 * start) | state.bracketed & wide
        return jnp.any(searching) & (state.steps < _MOST_STEPS)

    def narrow(state: _Search) -> _Search:
        """Double the upper bound until a limit is reached there, then halve the interval."""
        trial = jnp.where(state.bracketed, 0.5 * (state.lower + state.upper), state.upper)
        beyond = excesses(trial) >= 0.0
        reached = jnp.any(beyond, axis=0)
        return _Search(
            lower=jnp.where(reached, state.lower, trial),
            upper=jnp.where(reached, trial, jnp.where(state.bracketed, state.upper, 2.0 * state.upper)),
            bracketed=state.bracketed | reached,
            which=jnp.where(reached, jnp.argmax(beyond, axis=0), state.which),
            steps=state.steps + 1,
        )

    nowhere = jnp.zeros_like(start, dtype=bool)
    first = _Search(jnp.zeros_like(start), start, nowhere, jnp.argmax(nowhere[None], axis=0), jnp.asarray(0))
    lower, upper, bracketed, index, _ = jax.lax.stop_gradient(jax.lax.while_loop(unfinished, narrow, first))
    at_once = bracketed & (upper <= SMALLEST_SHARE * start)
    fixed = ~bracketed | at_once

    def excess(value: Array) -> Array:
        chosen = jnp.take_along_axis(excesses(value), index[None], axis=0)[0]
        return jnp.where(fixed, value - lower, chosen)

    def divide(linear, right_side: Array) -> Array:  # type: ignore[no-untyped-def]
        slope = linear(jnp.ones_like(right_side))
        return right_side / jnp.where(slope == 0.0, 1.0, slope)

    # the root is known: the search returns it, and implicit_root gives it the implicit derivative
    root = implicit_root(excess, lower, lambda _, found: found, divide)
    value = jnp.where(bracketed, jnp.where(at_once, 0.0, root), jnp.inf)
    return FirstLimit(value=value, which=jnp.where(bracketed, index, -1))
