r"""The one minimisation behind frictionless contact and partial slip.

.. math::
    \min_t\; \tfrac12\, t\cdot A t - t\cdot b \quad\text{with}\quad l \le t \le h
    \quad\text{and, if asked,}\quad \sum t = T

t is the traction on the pixels, A the elastic response, b the imposed displacement. Where t lies between its
bounds the misfit u - b, u = A t, vanishes up to one common shift, which is the rigid displacement if the
total is prescribed.

The solver is the conjugate-gradient method of Polonsky and Keer (1999) with three changes: the gradient is
preconditioned by the opposite operator (Hiptmair 2006), so that the number of iterations hardly grows with
the grid; Polak and Ribière's formula stands in for the restarts, so that pixels entering or leaving do not
throw away the search direction; and the displacement is updated with the step instead of being recomputed,
which saves transforms wherever no pixel was cut off at a bound.
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


def _moved_to_total(traction: Array, chosen: Array, lower: Array, upper: Array, total: Array) -> Array:
    """Scale the chosen points towards one bound so that the whole adds up, as far as they can."""
    now, least, most = (_masked_sum(chosen, bound) for bound in (traction, lower, upper))
    need = total - _masked_sum(~chosen, traction)
    fall = jnp.clip((need - least) / (now - least), 0.0, 1.0)
    rise = jnp.clip((most - need) / (most - now), 0.0, 1.0)
    moved = jnp.where(need < now, lower + (traction - lower) * fall, upper - (upper - traction) * rise)
    return jnp.where(chosen, moved, traction)


def within_bounds(traction: Array, lower: Array, upper: Array | None, total: Array | None) -> Array:
    """Cut the traction at its bounds and move what lies between them to the prescribed total.

    Parameters
    ----------
    traction : array
        Traction [Pa].
    lower, upper : array
        Bounds [Pa]; no upper bound is None.
    total : array, scalar, or None
        Prescribed sum [Pa], between the sums of the bounds.

    Returns
    -------
    array
        Traction within its bounds and of this sum. Points on a bound stay there unless the others cannot
        make up the sum.
    """
    if upper is None:
        cut = jnp.maximum(traction, lower)
        if total is None:
            return cut
        least = jnp.sum(jnp.broadcast_to(lower, cut.shape))
        return lower + (cut - lower) * ((total - least) / (jnp.sum(cut) - least))
    cut = jnp.clip(traction, lower, upper)
    if total is None:
        return cut
    moved = _moved_to_total(cut, (cut > lower) & (cut < upper), lower, upper, total)
    missing = jnp.abs(jnp.sum(moved) - total) > 1e-12 * jnp.sum(jnp.abs(moved))
    everywhere = jnp.ones(cut.shape, dtype=bool)
    return jax.lax.cond(
        missing, lambda t: _moved_to_total(t, everywhere, lower, upper, total), lambda t: t, moved
    )


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
    """Solve the problem of this module; call it inside a compiled function.

    Parameters
    ----------
    response : callable
        A, traction to displacement; symmetric and positive.
    estimate : callable
        Rough inverse of A, symmetric and positive; it only affects the number of iterations.
    target : array
        b [m].
    lower, upper : array
        Bounds [Pa], scalar or field; equal where no traction can act; no upper bound is None.
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

    def off_bounds(t: Array, g: Array | None) -> Array:
        """Points between their bounds or, given the gradient, about to leave one."""
        free = t > lower if g is None else (t > lower) | (g < 0.0)
        if upper is None:
            return free
        below = t < upper if g is None else (t < upper) | (g > 0.0)
        return free & below & (lower < upper)

    def misfit(t: Array, u: Array) -> tuple[Array, Array, Array, Array]:
        """Which pixels may move, their misfit without its common shift, how many they are, and the shift."""
        g = u - target
        if total is None:
            shift = jnp.zeros(())
        else:
            inside = off_bounds(t, None)
            shift = _masked_sum(inside, g) / jnp.sum(inside, dtype=g.dtype)
        g = g - shift
        moving = off_bounds(t, g)
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

        beyond = t_new < lower if upper is None else (t_new < lower) | (t_new > upper)
        t_new, u_new = jax.lax.cond(jnp.any(beyond), cut, lambda _: (t_new, u_new), None)
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
