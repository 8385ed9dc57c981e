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


def tied_zeros(values: Array) -> Array:
    """Zeros that are batched where some values are: JAX traces a loop once more for every start that is not."""
    return jnp.where(values > jnp.inf, 1.0, 0.0)


def newton(
    step_at: Callable[[Any], tuple[Any, Any]],
    first: Any,
    *,
    positive: int,
    residual: Any = None,
    longest: Real = math.inf,
) -> tuple[Any, Array, Any]:
    r"""Root of as many equations as unknowns, without derivatives.

    .. math:: x \leftarrow x - \alpha\, J^{-1} r(x)

    Parameters
    ----------
    step_at : callable
        From a module of unknowns, each of order 1, to the step :math:`J^{-1} r(x)`, of the same structure, and to the
        residuals r(x).
    first : module of Array
        Where the search starts.
    positive : int
        How many of the first unknowns must stay positive: a step is shortened (alpha < 1) so that they keep a fifth.
    residual : module of Array, optional
        Of the structure of the residuals, of any value; None where they are None.
    longest : Real, optional
        Change of an unknown in one step, not shortened, beyond which the search is given up [-].

    Returns
    -------
    module of Array
        The last iterate; its residual is for the caller to check.
    Array
        Largest change of an unknown in the last step, not shortened [-]: large, or nan, where the unknowns are not
        determined.
    module of Array
        The residuals before the last step.

    References
    ----------
    Newton's method.
    """
    start, shape = jax.flatten_util.ravel_pytree(first)

    def unfinished(state: tuple[Array, Array, Array, Any]) -> Array:
        _, size, steps, _ = state
        return (size > 1e-13) & (size < longest) & (steps < _NEWTON_BUDGET)

    def improve(state: tuple[Array, Array, Array, Any]) -> tuple[Array, Array, Array, Any]:
        x, _, steps, _ = state
        change, misfit = step_at(shape(x))
        step, _ = jax.flatten_util.ravel_pytree(change)
        normal, falling = x[:positive], step[:positive]
        room = jnp.where(falling > 0.0, (1.0 - _SMALLEST_SHARE) * normal / falling, jnp.inf)
        share = jnp.minimum(1.0, jnp.min(room))
        return x - share * step, jnp.max(jnp.abs(step)), steps + 1, misfit

    nothing = tied_zeros(start[0])
    begin = (start, nothing + 1.0, nothing.astype(int), residual)
    x, size, _, misfit = jax.lax.while_loop(unfinished, improve, begin)
    return shape(x), size, misfit
