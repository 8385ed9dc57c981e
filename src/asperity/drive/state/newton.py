"""Newton's method for equations whose first unknowns are positive."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import jax
import jax.flatten_util
import jax.numpy as jnp
from jax import Array

from asperity.types import Real

_NEWTON_BUDGET = 60
_SMALLEST_SHARE = 0.2  # a step leaves at least this share of each positive unknown
_SMALLEST_STEP = 1e-13
#: Steps shorter than this become shorter as their squares do, and the next one can be foretold.
_SHORT_STEP = 1e-6


def tied_zeros(values: Array) -> Array:
    """Zeros that are batched where some values are: JAX traces a loop once more for every start that is not."""
    return jnp.where(values > jnp.inf, 1.0, 0.0)


def newton(
    step_at: Callable[[Any], Any], first: Any, *, positive: int, longest: Real = math.inf
) -> tuple[Any, Array]:
    r"""Root of as many equations as unknowns, without derivatives.

    .. math:: x \leftarrow x - \alpha\, J^{-1} r(x)

    Parameters
    ----------
    step_at : callable
        From a module of unknowns, each of order 1, to the step :math:`J^{-1} r(x)`, of the same structure.
    first : module of Array
        Where the search starts.
    positive : int
        How many of the first unknowns must stay positive: a step is shortened (alpha < 1) so that they keep a fifth.
    longest : Real, optional
        Change of an unknown in one step, not shortened, beyond which the search is given up [-].

    Returns
    -------
    module of Array
        The last iterate; its residual is for the caller to check.
    Array
        Largest change of an unknown in the last step, not shortened [-]: large, or nan, where the unknowns are not
        determined.

    Notes
    -----
    The search ends with a step that is as small as rounding errors, or after which the next one would be: with
    quadratic convergence a step s after a step t is followed by one of :math:`s\,(s/t)^2`.

    References
    ----------
    Newton's method.
    """
    start, shape = jax.flatten_util.ravel_pytree(first)

    def unfinished(state: tuple[Array, Array, Array, Array]) -> Array:
        _, size, before, steps = state
        settled = (size < _SHORT_STEP) & (size * (size / before) ** 2 < _SMALLEST_STEP)
        return (size > _SMALLEST_STEP) & ~settled & (size < longest) & (steps < _NEWTON_BUDGET)

    def improve(state: tuple[Array, Array, Array, Array]) -> tuple[Array, Array, Array, Array]:
        x, before, _, steps = state
        step, _ = jax.flatten_util.ravel_pytree(step_at(shape(x)))
        normal, falling = x[:positive], step[:positive]
        room = jnp.where(falling > 0.0, (1.0 - _SMALLEST_SHARE) * normal / falling, jnp.inf)
        share = jnp.minimum(1.0, jnp.min(room))
        return x - share * step, jnp.max(jnp.abs(step)), before, steps + 1

    nothing = tied_zeros(start[0])
    # no step has gone before the first one: it foretells nothing
    begin = (start, nothing + 1.0, nothing, nothing.astype(int))
    x, size, _, _ = jax.lax.while_loop(unfinished, improve, begin)
    return shape(x), size
