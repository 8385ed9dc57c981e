r"""The one minimisation behind frictionless contact and partial slip.

.. math::
    \min_t\; \tfrac12\, t\cdot A t - t\cdot b \quad\text{with}\quad l \le t \le h
    \quad\text{and, if asked,}\quad \sum t = T

t is the traction on the pixels, A the elastic response, b the imposed displacement. Where t lies between its
bounds the misfit u - b, u = A t, vanishes up to one common shift, which is the rigid displacement if the total is prescribed.

The solver is the conjugate-gradient method of Polonsky and Keer (1999) with three changes: the gradient is
preconditioned by the opposite operator (Hiptmair 2006), so that the number of iterations hardly grows with the grid;
Polak and Ribière's formula stands in for the restarts, so that pixels entering or leaving do not throw away
the search direction; and the displacement is updated with the step instead of being recomputed, which saves
transforms wherever no pixel was cut off at a bound.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

Response = Callable[[Array], Array]


class BoundedSolution(eqx.Module):
    """Where the iteration ended; whether that is a solution is for the caller to check.

    Parameters
    ----------
    traction : Array
        t [Pa].
    displacement : Array
        u = A t [m].
    shift : Array, scalar
        Common misfit u - b where t lies between its bounds [m]; zero if the total is not prescribed.
    iterations : Array, scalar
        Iterations used.
    residual : Array, scalar
        Root mean square misfit over the unbound pixels, relative to the scale [-].
    """

    traction: Array
    displacement: Array
    shift: Array
    iterations: Array
    residual: Array


class _State(NamedTuple):
    traction: Array
    displacement: Array
    direction: Array
    gradient: Array
    slope: Array
    shift: Array
    residual: Array
    iterations: Array


def _masked_sum(mask: Array, field: Array) -> Array:
    return jnp.sum(jnp.where(mask, field, 0.0))


def within_bounds(traction: Array, lower: Array, upper: Array, total: Array | None) -> Array:
    """Cut the traction at its bounds and scale what lies between them to the prescribed total.

    Parameters
    ----------
    traction, lower, upper : array
        Traction and its bounds [Pa].
    total : array, scalar, or None
        Prescribed sum [Pa].

    Returns
    -------
    array
        Traction within its bounds; its sum is the total unless an upper bound cuts again.
    """
    cut = jnp.clip(traction, lower, upper)
    if total is None:
        return cut
    inside = (cut > lower) & (cut < upper)
    rest = jnp.where(inside, lower, cut)
    factor = (total - jnp.sum(rest)) / _masked_sum(inside, cut - lower)
    return jnp.where(inside, jnp.minimum(lower + (cut - lower) * factor, upper), cut)


def bounded_solution(
    *,
    response: Response,
    estimate: Response,
    target: Array,
    lower: Array,
    upper: Array,
    total: Array | None,
    start: Array,
    scale: Callable[[Array, Array], Array],
    tolerance: Array,
    max_iterations: Array,
) -> BoundedSolution:
    """Solve the problem of this module; call it inside a compiled function.

    Parameters
    ----------
    response : callable
        A, traction to displacement; symmetric and positive.
    estimate : callable
        Rough inverse of A, symmetric and positive; it only affects the number of iterations.
    target : array
        b [m].
    lower, upper : array, shape of ``target``
        Bounds [Pa]; equal where no traction can act.
    total : array, scalar, or None
        Prescribed sum of the traction [Pa], or None if b alone decides.
    start : array
        Traction to start from [Pa].
    scale : callable
        Displacement [m] that the misfit is measured by, from traction and displacement.
    tolerance : array, scalar
        Bound on the residual [-].
    max_iterations : array, scalar
        Where to give up.

    Returns
    -------
    BoundedSolution
        The last iterate.
    """
    usable = upper > lower

    def misfit(t: Array, u: Array) -> tuple[Array, Array, Array, Array]:
        """Which pixels may move, their misfit without its common shift, how many they are, and the shift."""
        g = u - target
        if total is None:
            shift = jnp.zeros(())
        else:
            inside = (t > lower) & (t < upper)
            shift = _masked_sum(inside, g) / jnp.sum(inside, dtype=g.dtype)
        g = g - shift
        moving = usable & ((t > lower) | (g < 0.0)) & ((t < upper) | (g > 0.0))
        return moving, jnp.where(moving, g, 0.0), jnp.maximum(jnp.sum(moving, dtype=g.dtype), 1.0), shift

    def step(state: _State) -> _State:
        t, u = state.traction, state.displacement
        moving, g, count, shift = misfit(t, u)
        residual = jnp.sqrt(jnp.sum(g * g) / count)
        if total is not None:
            g = jnp.where(moving, g - jnp.sum(g) / count, 0.0)
        z = jnp.where(moving, estimate(g), 0.0)
        slope = jnp.sum(g * z)
        beta = jnp.maximum(slope - jnp.sum(state.gradient * z), 0.0) / state.slope  # Polak and Ribière
        d = jnp.where(moving, z + beta * state.direction, 0.0)
        if total is not None:
            d = jnp.where(moving, d - jnp.sum(d) / count, 0.0)
        w = response(d)
        curvature = jnp.sum(d * w)
        tau = jnp.where(curvature > 0.0, jnp.sum(g * d) / curvature, 0.0)
        t_new, u_new = t - tau * d, u - tau * w

        def cut(_: None) -> tuple[Array, Array]:
            inside = within_bounds(t_new, lower, upper, total)
            return inside, response(inside)

        outside = jnp.any((t_new < lower) | (t_new > upper))
        t_new, u_new = jax.lax.cond(outside, cut, lambda _: (t_new, u_new), None)
        return _State(t_new, u_new, d, g, slope, shift, residual, state.iterations + 1)

    def unfinished(state: _State) -> Array:
        limit = tolerance * scale(state.traction, state.displacement)
        return (state.residual > limit) & (state.iterations < max_iterations)

    zero = jnp.zeros_like(target)
    t0 = within_bounds(start, lower, upper, total)
    infinite = jnp.asarray(jnp.inf)
    first = _State(
        t0, response(t0), zero, zero, infinite, jnp.zeros(()), infinite, jnp.zeros((), dtype=jnp.int64)
    )
    last = jax.lax.while_loop(unfinished, step, first)
    _, g, count, shift = misfit(last.traction, last.displacement)
    reference = scale(last.traction, last.displacement)
    residual = jnp.sqrt(jnp.sum(g * g) / count)
    return BoundedSolution(
        traction=last.traction,
        displacement=last.displacement,
        shift=shift,
        iterations=last.iterations,
        residual=jnp.where(residual > 0.0, residual / jnp.where(reference > 0.0, reference, residual), 0.0),
    )
