"""Steady rolling of a line contact: stick and slip that are constant in the frame of the contact."""

from __future__ import annotations

import functools
import math

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.elastic_pair import positive
from asperity.bem.free_half_space import FreeHalfSpace, strip_integral
from asperity.bem.half_space import pressure_on_grid
from asperity.bem.transient_rolling import layer_on_grid
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError

#: Largest misfit, relative to the largest traction bound, at which Newton's method ends.
_TOLERANCE = 1e-11
#: Friction coefficients, relative to the given one, for which Newton's method solves in turn: the given one only
# or, if that fails, downwards from almost full stick.
_FRICTION_FACTORS = (np.ones(1), 2.0 ** np.arange(16.0, -1.0, -1.0))


class SteadyRolling(Module):
    """A converged state of steady rolling; SI units, first component in the rolling direction, second across.

    ``creepage``: growth of the rigid displacement per distance rolled, shape (2,) [-]; ``tangential_force`` per length
    of the contact, shape (2,) [N/m]; shear ``traction`` [Pa] and ``slip`` per distance rolled [-], shape (2, points);
    ``stick_fraction`` of the contact [-]; ``iterations``: Newton steps; ``residual``: largest misfit over the largest
    traction bound [-].
    """

    creepage: Array
    tangential_force: Array
    traction: Array
    slip: Array
    stick_fraction: Array
    iterations: Array
    residual: Array


def _transport(half_space: FreeHalfSpace, layer: Array, axes: tuple[int, ...]) -> Array:
    """Displacement behind minus displacement one pixel ahead, per traction [m/Pa], shape (axes, n, n)."""
    n, h = half_space.shape[0], half_space.pixel_size[0]
    distance = (jnp.arange(n)[:, None] - jnp.arange(n)[None, :]).astype(jnp.float64) * h

    def kernel(x: Array) -> Array:
        return strip_integral(x, pixel_size=h, reference_distance=h)

    elastic = kernel(distance) - kernel(distance + h)
    local = jnp.diag(layer) - jnp.diag(layer[1:], k=1)
    pair = half_space.pair
    compliance = (2.0 / pair.contact_modulus, 1.0 / pair.antiplane_modulus)
    return jnp.stack([compliance[axis] * elastic + local for axis in axes])


@functools.partial(jax.jit, static_argnames="axes")
def _newton(
    half_space: FreeHalfSpace,
    cap: Array,
    layer: Array,
    free_slip: Array,
    given: Array,
    force_driven: Array,
    axes: tuple[int, ...],
    factors: Array,
    max_iterations: Array,
) -> tuple[Array, ...]:
    """Semi-smooth Newton's method, for the bounds times each of the factors in turn.

    ``free_slip`` is what one step adds to the displacement by pressure [m].
    """
    m, n, h = len(axes), half_space.shape[0], half_space.pixel_size[0]
    D = _transport(half_space, layer, axes)
    scale = 1.0 / jnp.max(jnp.abs(jnp.diagonal(D, axis1=1, axis2=2)))
    largest, sliding = jnp.max(cap), jnp.sum(cap) * h
    identity = jnp.eye(m)

    def slip(t: Array, xi: Array) -> Array:
        return jnp.einsum("kij,kj->ki", D, t) + free_slip - xi[:, None] * h

    def trial(t: Array, xi: Array, bound: Array) -> tuple[Array, Array, Array]:
        z = t - scale * slip(t, xi)
        size = jnp.sqrt(jnp.sum(z * z, axis=0))
        slides = size >= bound
        return z, jnp.where(slides & (size > 0.0), size, 1.0), slides

    def force_misfit(t: Array, xi: Array) -> Array:
        reach = jnp.max(jnp.abs(D)) * largest / h
        return jnp.where(force_driven, (jnp.sum(t, axis=1) * h - given) / sliding, (xi - given) / reach)

    def misfit(t: Array, xi: Array, bound: Array) -> Array:
        z, size, slides = trial(t, xi, bound)
        contact = t - jnp.where(slides, bound / size, 1.0) * z
        return jnp.concatenate([contact.ravel() / largest, force_misfit(t, xi)])

    def jacobian(t: Array, xi: Array, bound: Array) -> Array:
        z, size, slides = trial(t, xi, bound)
        normal = z / size
        # dF/dt = 1 - P (1 - r D), dF/dxi = -P r h, with P = 1 where it sticks.
        across = identity[:, :, None] - normal[:, None] * normal[None, :]
        P = jnp.where(slides, bound / size * across, identity[:, :, None])
        dz = jnp.eye(n)[None] - scale * D  # of component l, (m, n, n)
        block = -jnp.einsum("kli,lij->kilj", P, dz)
        block = block + jnp.einsum("kl,ij->kilj", identity, jnp.eye(n))
        top = jnp.concatenate(
            [block.reshape(m * n, m * n), -scale * h * P.transpose(0, 2, 1).reshape(m * n, m)], axis=1
        )
        reach = jnp.max(jnp.abs(D)) * largest / h
        rows = jnp.repeat(identity, n, axis=1) * jnp.where(force_driven, h / sliding, 0.0)[:, None]
        # If every point slips, the force does not depend on the creepage: take a step that reduces the misfit instead.
        corner = jnp.diag(jnp.where(force_driven & ~jnp.all(slides), 0.0, 1.0 / reach))
        return jnp.concatenate([top / largest, jnp.concatenate([rows, corner], axis=1)])

    def advanced(t: Array, xi: Array, bound: Array) -> tuple[Array, Array]:
        change = jnp.linalg.solve(jacobian(t, xi, bound), -misfit(t, xi, bound))
        return t + change[: m * n].reshape(m, n), xi + change[m * n :]

    def solved(start: tuple[Array, Array], factor: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        bound = factor * cap

        def unfinished(state: tuple[Array, Array, Array, Array]) -> Array:
            _, _, F, k = state
            return (jnp.max(jnp.abs(F)) > _TOLERANCE * factor) & (k < max_iterations)

        def step(state: tuple[Array, Array, Array, Array]) -> tuple[Array, Array, Array, Array]:
            t, xi, _, k = state
            t, xi = advanced(t, xi, bound)
            return t, xi, misfit(t, xi, bound), k + 1

        first = (*start, misfit(*start, bound), jnp.zeros((), dtype=jnp.int64))
        t, xi, F, k = jax.lax.while_loop(unfinished, step, first)
        return (t, xi), (k, jnp.max(jnp.abs(F)))

    # The start is the state without slip: from zero traction every point may seem to slip, and then no force
    # depends on the creepage.
    t0, xi0 = jnp.zeros((m, n)), jnp.where(force_driven, 0.0, given)
    t0, xi0 = advanced(t0, xi0, jnp.where(cap > 0.0, jnp.inf, 0.0))
    (t, xi), (k, F) = jax.lax.scan(solved, (t0, xi0), factors)
    _, _, slides = trial(t, xi, cap)
    return t, xi, slip(t, xi) / h, jnp.sum(t, axis=1) * h, slides, jnp.sum(k), F[-1]


def _prescribed(what: str, creepage: float | None, force: float | None) -> tuple[float, bool]:
    value = creepage if force is None else force
    if value is None or (creepage is None) == (force is None) or not np.isfinite(value):
        raise InputError(
            f"{what}_creepage = {creepage} and {what}_force = {force}: give one of them, a finite number"
        )
    return float(value), creepage is None


def _refuse_sliding(components: tuple[tuple[float, bool], ...], sliding_force: float) -> None:
    """Refuse forces under which the bodies slide."""
    force = math.hypot(*(value if forced else 0.0 for value, forced in components))
    if force >= sliding_force:
        raise InputError(
            f"tangential force of {force:g} N/m: the bodies slide at {sliding_force:g} N/m "
            "(friction coefficient times load); prescribe the creepage instead"
        )


def _converged(
    half_space: FreeHalfSpace,
    p: np.ndarray,
    mu: float,
    components: tuple[tuple[float, bool], ...],
    axes: tuple[int, ...],
    layer: Array | None,
    max_iterations: int,
) -> tuple[Array, ...]:
    """What :func:`_newton` finds, with friction raised in more steps until it converges."""
    by_pressure = np.zeros((len(axes), p.size))
    shift = np.asarray(half_space.coupled_displacement(jnp.asarray(np.append(p, 0.0))))
    by_pressure[0] = shift[:-1] - shift[1:]
    for factors in _FRICTION_FACTORS:
        *state, k, residual = _newton(
            half_space,
            jnp.asarray(mu * p),
            jnp.zeros(p.shape) if layer is None else layer,
            jnp.asarray(by_pressure),
            jnp.asarray([components[axis][0] for axis in axes]),
            jnp.asarray([components[axis][1] for axis in axes]),
            axes,
            jnp.asarray(factors),
            jnp.asarray(max_iterations),
        )
        if float(residual) <= _TOLERANCE:
            break
    if not float(residual) <= _TOLERANCE:
        raise NoSolutionError(
            f"steady rolling: not converged after {int(k)} Newton steps, relative misfit {float(residual):.3g}, "
            f"tolerance {_TOLERANCE:g}; increase max_iterations, or use transient_rolling"
        )
    return (*state, k, residual)


def steady_rolling(
    half_space: FreeHalfSpace,
    pressure: ArrayLike,
    *,
    friction_coefficient: float,
    layer_compliance: ArrayLike,
    longitudinal_creepage: float | None = None,
    longitudinal_force: float | None = None,
    lateral_creepage: float | None = None,
    lateral_force: float | None = None,
    max_iterations: int = 100,
) -> SteadyRolling:
    r"""Steady rolling of a line contact under given creepages or forces, with friction as a vector.

    .. math::
        s(x) = \frac{u(x) - u(x + h)}{h} - \xi, \qquad |\tau| \le \mu p, \qquad
        s = 0 \text{ where } |\tau| < \mu p, \quad s = -|s|\,\frac{\tau}{|\tau|} \text{ elsewhere}

    u is the relative tangential displacement, h the pixel; the contact rolls towards the end of the grid.

    Parameters
    ----------
    half_space : FreeHalfSpace
        Elastic bodies and grid of one axis.
    pressure : array, shape (points,)
        Contact pressure [Pa].
    friction_coefficient : float
        Coulomb's coefficient mu [-], positive.
    layer_compliance : array, scalar or shape (points,)
        Tangential displacement per traction of a thin layer between the bodies [m/Pa]; 0 for none.
    longitudinal_creepage, lateral_creepage : float, optional
        Prescribed creepages [-], in the rolling direction and across; a skew angle is a lateral creepage.
    longitudinal_force, lateral_force : float, optional
        Prescribed forces per length [N/m]; give either creepage or force for each direction.
    max_iterations : int
        Maximum number of Newton steps.

    Returns
    -------
    SteadyRolling
        Creepages, forces, tractions and slip.

    Raises
    ------
    InputError
        For a grid with two axes, fields that do not fit, or forces above the sliding force.
    NoSolutionError
        If Newton's method does not converge.

    Notes
    -----
    The state that :func:`~asperity.bem.transient_rolling.transient_rolling` reaches in steps of one pixel.
    The error of the creepage is of first order in the pixel size: extrapolation from two grids removes it. For
    unlike bodies the tangential displacement due to the pressure is included; the effect of the traction on the
    pressure is not (see :func:`~asperity.bem.coupled_rolling.coupled_steady_rolling`).

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, chapter 4. F. W. Carter, Proc. R.
    Soc. A 112 (1926) 151. P. Alart and A. Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353 (Newton's
    method for friction).
    """
    if len(half_space.shape) != 1:
        raise InputError(f"the grid has shape {half_space.shape}: steady rolling needs a strip (one axis)")
    mu = positive("friction_coefficient", friction_coefficient, "")
    p = pressure_on_grid(pressure, half_space.shape)
    components = (
        _prescribed("longitudinal", longitudinal_creepage, longitudinal_force),
        _prescribed("lateral", lateral_creepage, lateral_force),
    )
    _refuse_sliding(components, mu * float(p.sum()) * float(half_space.pixel_area))
    # Without lateral creepage or force nothing moves across the rolling direction: half the unknowns suffice.
    axes = (0,) if components[1][0] == 0.0 else (0, 1)
    layer = layer_on_grid(layer_compliance, p)
    t, xi, slip, tangential, slides, k, residual = _converged(
        half_space, p, mu, components, axes, layer, max_iterations
    )
    contact = jnp.asarray(p > 0.0)
    rows = jnp.asarray(axes)

    def both(values: Array) -> Array:
        return jnp.zeros((2, *values.shape[1:])).at[rows].set(values)

    return SteadyRolling(
        creepage=both(xi),
        tangential_force=both(tangential),
        traction=both(t),
        slip=jnp.where(contact, both(slip), 0.0),
        stick_fraction=jnp.sum(contact & ~slides, dtype=jnp.float64) / jnp.sum(contact, dtype=jnp.float64),
        iterations=k,
        residual=residual,
    )
