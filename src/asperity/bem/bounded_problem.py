r"""Bounded minimisation for frictionless contact and for partial slip.

.. math::
    \min_t\; \tfrac12\, t\cdot A t - t\cdot b \quad\text{with}\quad l \le t \le h
    \quad\text{and, if prescribed,}\quad \sum t = T

t is the traction on the pixels, A the elastic response, b the imposed displacement. Where t lies between its bounds the
misfit u - b, u = A t, vanishes up to one common shift, which is the rigid displacement if the total is prescribed.

The solver is the conjugate-gradient method of Polonsky and Keer (1999) with three changes: the gradient is
preconditioned by a rough inverse of the response (operators of opposite order, Hiptmair 2006), so that the
number of iterations hardly grows with the grid; Polak and Ribière's formula replaces the restarts, so that
the search direction is kept when pixels enter or leave the contact; and the displacement is updated with the step
instead of being recomputed, which saves transforms in iterations where no pixel reaches a bound.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.engine.module import Module

Response = Callable[[Array], Array]
#: Newton or bisection steps for the common shift; a dozen are usual.
_SHIFT_STEPS = 200
#: Shift, excess of the sum, its rate, bracket, steps.
_Shift = tuple[Array, Array, Array, Array, Array, Array]


class BoundedSolution(Module):
    """Last iterate; the caller must check whether it is a solution.

    Traction t [Pa] and displacement u = A t [m]; ``shift``, common misfit u - b where t lies between its bounds [m],
    zero if the total is not prescribed; ``residual``, root mean square misfit over the unbound pixels, relative to the
    scale [-].
    """

    traction: Array
    displacement: Array
    shift: Array
    iterations: Array
    residual: Array


class _Misfit(NamedTuple):
    """Which points may move, their misfit without its common shift, how many they are, the shift, the residual."""

    moving: Array
    gradient: Array
    points: Array
    shift: Array
    residual: Array


class _State(NamedTuple):
    traction: Array
    displacement: Array
    direction: Array
    gradient: Array
    slope: Array
    misfit: _Misfit
    iterations: Array


def _masked_sum(mask: Array, field: Array) -> Array:
    return jnp.sum(jnp.where(mask, field, 0.0))


def shifted_within_bounds(traction: Array, chosen: Array, lower: Array, upper: Array, total: Array) -> Array:
    """Nearest traction [Pa] within bounds with the prescribed sum: the chosen points clipped after a common shift."""
    need = total - _masked_sum(~chosen, traction)

    def excess(c: Array) -> tuple[Array, Array]:
        moved = traction + c
        rate = jnp.sum(chosen & (moved > lower) & (moved < upper), dtype=traction.dtype)
        return _masked_sum(chosen, jnp.clip(moved, lower, upper)) - need, rate

    def unfinished(state: _Shift) -> Array:
        _, error, _, low, high, k = state
        return (jnp.abs(error) > 1e-14 * jnp.abs(need)) & (high > low) & (k < _SHIFT_STEPS)

    def step(state: _Shift) -> _Shift:
        c, error, rate, low, high, k = state
        low, high = jnp.where(error < 0.0, c, low), jnp.where(error > 0.0, c, high)
        newton = c - error / jnp.maximum(rate, 1.0)
        inside = (rate > 0.0) & (newton > low) & (newton < high)
        c = jnp.where(inside, newton, 0.5 * (low + high))
        error, rate = excess(c)
        return c, error, rate, low, high, k + 1

    count = jnp.maximum(jnp.sum(chosen, dtype=traction.dtype), 1.0)
    lowest = jnp.min(jnp.where(chosen, lower - traction, jnp.inf))
    # No point reaches an infinite upper bound: the mean deficit is then enough for every point.
    room = jnp.where(jnp.isfinite(upper), upper, lower + jnp.abs(need) / count + jnp.abs(need))
    highest = jnp.max(jnp.where(chosen, room - traction, -jnp.inf))
    error, rate = excess(jnp.zeros(()))
    first = (jnp.zeros(()), error, rate, lowest, highest, jnp.zeros((), dtype=jnp.int64))
    c = jax.lax.while_loop(unfinished, step, first)[0]
    return jnp.where(chosen, jnp.clip(traction + c, lower, upper), traction)


def _within_bounds(
    traction: Array, moving: Array, lower: Array, upper: Array | None, total: Array | None
) -> Array:
    """Clip the traction to its bounds, keeping its sum if one is prescribed."""
    if total is None:
        return jnp.maximum(traction, lower) if upper is None else jnp.clip(traction, lower, upper)
    if upper is not None:
        return shifted_within_bounds(traction, moving, lower, upper, total)
    # Polonsky and Keer's scaling is cheaper than the shift and leaves points at the bound alone.
    cut = jnp.maximum(traction, lower)
    least = jnp.sum(jnp.broadcast_to(lower, cut.shape))
    return lower + (cut - lower) * ((total - least) / (jnp.sum(cut) - least))


def bounded_solution(
    *,
    response: Response,
    estimate: Response,
    target: Array,
    lower: Array,
    upper: Array | None,
    total: Array | None,
    start: Array,
    scale: Callable[[Array, Array], Array],
    tolerance: Array,
    max_iterations: Array,
) -> BoundedSolution:
    """Last iterate of the problem of this module; call it inside a compiled function.

    ``response`` is A, traction to displacement, and ``estimate`` a rough inverse of it, which only affects the number
    of iterations; both symmetric and positive. ``target`` is b [m]; ``lower`` and ``upper`` [Pa] are scalars or fields,
    equal where no traction can act, None for no upper bound; ``total``, the prescribed sum of the traction [Pa], or
    None if only b is prescribed. The traction of the start [Pa] is shifted and clipped to the bounds and the sum.
    ``scale`` gives the reference displacement [m] of the misfit from traction and displacement; ``tolerance`` bounds
    the residual [-].
    """

    def off_bounds(t: Array, g: Array | None) -> Array:
        """Points between their bounds or, given the gradient, about to leave one."""
        free = t > lower if g is None else (t > lower) | (g < 0.0)
        if upper is None:
            return free
        below = t < upper if g is None else (t < upper) | (g > 0.0)
        return free & below & (lower < upper)

    def misfit(t: Array, u: Array) -> _Misfit:
        g = u - target
        if total is None:
            shift = jnp.zeros(())
        else:
            inside = off_bounds(t, None)
            shift = _masked_sum(inside, g) / jnp.sum(inside, dtype=g.dtype)
        g = g - shift
        moving = off_bounds(t, g)
        g = jnp.where(moving, g, 0.0)
        count = jnp.maximum(jnp.sum(moving, dtype=g.dtype), 1.0)
        return _Misfit(moving, g, count, shift, jnp.sqrt(jnp.sum(g * g) / count))

    def step(state: _State) -> _State:
        t, u = state.traction, state.displacement
        moving, g, count = state.misfit.moving, state.misfit.gradient, state.misfit.points
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
            inside = _within_bounds(t_new, moving, lower, upper, total)
            return inside, response(inside)

        beyond = t_new < lower if upper is None else (t_new < lower) | (t_new > upper)
        t_new, u_new = jax.lax.cond(jnp.any(beyond), cut, lambda _: (t_new, u_new), None)
        return _State(t_new, u_new, d, g, slope, misfit(t_new, u_new), state.iterations + 1)

    def unfinished(state: _State) -> Array:
        limit = tolerance * scale(state.traction, state.displacement)
        return (state.misfit.residual > limit) & (state.iterations < max_iterations)

    zero = jnp.zeros_like(target)
    if total is None:
        t0 = _within_bounds(start, jnp.ones(start.shape, dtype=bool), lower, upper, None)
    else:
        ceiling = jnp.asarray(jnp.inf) if upper is None else upper
        t0 = shifted_within_bounds(
            start, jnp.broadcast_to(lower < ceiling, start.shape), lower, ceiling, total
        )
    u0 = response(t0)
    first = _State(t0, u0, zero, zero, jnp.asarray(jnp.inf), misfit(t0, u0), jnp.zeros((), dtype=jnp.int64))
    last = jax.lax.while_loop(unfinished, step, first)
    reference = scale(last.traction, last.displacement)
    residual = last.misfit.residual
    return BoundedSolution(
        traction=last.traction,
        displacement=last.displacement,
        shift=last.misfit.shift,
        iterations=last.iterations,
        residual=jnp.where(residual > 0.0, residual / jnp.where(reference > 0.0, reference, residual), 0.0),
    )
