"""Incremental stiffness of a contact of constant area: normal, and tangential in full stick."""

from __future__ import annotations

import functools
from collections.abc import Callable

import jax
import jax.numpy as jnp
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.elastic_pair import positive
from asperity.bem.half_space import HalfSpace
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError

Response = Callable[[Array], Array]
#: Solution t, residual, direction, slope, t·b so far, iterations.
_Linear = tuple[Array, Array, Array, Array, Array, Array]


class ContactStiffness(Module):
    r"""Force per rigid displacement of a contact area of constant size without slip; SI units.

    ``stiffness``: force along the displacement over the displacement, and ``cross_stiffness``: that along the other
    tangential axis, zero for the normal stiffness [N/m; N/m per metre of length on a strip]. ``traction_rate``:
    traction per displacement, shape (\*grid) if normal, (2, \*grid) if tangential [Pa/m]. ``iterations`` of conjugate
    gradients; ``error_estimate``: relative error of the stiffness due to stopping them [-].
    """

    stiffness: Array
    cross_stiffness: Array
    traction_rate: Array
    iterations: Array
    error_estimate: Array


def conjugate_gradients(
    *,
    response: Response,
    estimate: Response,
    usable: Array,
    target: Array,
    tolerance: Array,
    max_iterations: Array,
) -> tuple[Array, Array, Array]:
    r"""Solve A t = b on the usable points, preconditioned; call it inside a compiled function.

    Returns t, the iterations used and the last value of :math:`r \cdot M r / t \cdot b`, M the rough inverse and r the
    residual. If M were the exact inverse, that ratio would be the relative error of :math:`t \cdot b`, which conjugate
    gradients approach from below; it is second order in the error of t.
    """

    def restricted(field: Array) -> Array:
        return jnp.where(usable, field, 0.0)

    def unfinished(state: _Linear) -> Array:
        _, _, _, slope, work, k = state
        return (slope > tolerance * work) & (k < max_iterations)

    def step(state: _Linear) -> _Linear:
        t, r, d, slope, work, k = state
        w = restricted(response(d))
        tau = slope / jnp.sum(d * w)
        r = r - tau * w
        z = restricted(estimate(r))
        new = jnp.sum(r * z)
        return t + tau * d, r, z + new / slope * d, new, work + tau * slope, k + 1

    z = restricted(estimate(target))
    zero = jnp.zeros(())
    first = (jnp.zeros_like(target), target, z, jnp.sum(target * z), zero, jnp.zeros((), dtype=jnp.int64))
    t, _, _, slope, work, k = jax.lax.while_loop(unfinished, step, first)
    return t, k, slope / work


@functools.partial(jax.jit, static_argnames="axis")
def _rate(
    half_space: HalfSpace, mask: Array, axis: int | None, tolerance: Array, max_iterations: Array
) -> tuple[Array, Array, Array]:
    """Traction per displacement along a tangential axis, or None for the normal, as :func:`conjugate_gradients`."""
    target = mask.astype(jnp.float64)
    response: Response = half_space.normal_displacement
    if axis is not None:
        mask, response = jnp.stack([mask, mask]), half_space.shear_displacement
        target = jnp.zeros(mask.shape).at[axis].set(target)
    return conjugate_gradients(
        response=response,
        estimate=half_space.traction_estimate,
        usable=mask,
        target=target,
        tolerance=tolerance,
        max_iterations=max_iterations,
    )


def _checked_mask(half_space: HalfSpace, contact_mask: ArrayLike, tolerance: float) -> Array:
    positive("tolerance", tolerance, "(relative)")
    mask = jnp.asarray(contact_mask)
    if mask.shape != half_space.shape or mask.dtype != jnp.bool_:
        raise InputError(
            f"contact_mask has shape {mask.shape} and type {mask.dtype}: the grid needs {half_space.shape} "
            "of bool"
        )
    touching = int(jnp.sum(mask))
    if touching == 0:
        raise InputError("contact_mask is empty: without contact there is no stiffness")
    if half_space.periodic and touching == mask.size:
        raise InputError(
            "contact_mask is full: a periodic interface in complete contact has no compliance of its own "
            "(the stiffness is infinite); lower the load"
        )
    return mask


def _stiffness(
    what: str,
    half_space: HalfSpace,
    contact_mask: ArrayLike,
    axis: int | None,
    tolerance: float,
    max_iterations: int,
) -> ContactStiffness:
    mask = _checked_mask(half_space, contact_mask, tolerance)
    rate, k, error = _rate(half_space, mask, axis, jnp.asarray(tolerance), jnp.asarray(max_iterations))
    main, cross = jnp.sum(rate), jnp.zeros(())
    if axis is not None:
        main, cross = jnp.sum(rate[axis]), jnp.sum(rate[1 - axis])
    if not float(error) <= tolerance or not float(main) > 0.0:
        raise NoSolutionError(
            f"{what}: not converged after {int(k)} iterations, estimated relative error {float(error):.3g}, "
            f"tolerance {tolerance:.3g}; increase max_iterations or the tolerance"
        )
    area = half_space.pixel_area
    return ContactStiffness(main * area, cross * area, rate, k, error)


def normal_stiffness(
    half_space: HalfSpace, contact_mask: ArrayLike, *, tolerance: float = 1e-7, max_iterations: int = 1000
) -> ContactStiffness:
    r"""Incremental normal stiffness of a contact, :math:`\mathrm dF_n/\mathrm d\delta`.

    .. math::
        \int_{\text{contact}} K_n(x - y)\, p'(y)\, \mathrm dy = 1 \text{ on the contact},
        \qquad k_n = \int p'

    Parameters
    ----------
    half_space : HalfSpace
        Elastic bodies and grid.
    contact_mask : array of bool, shape (\*grid)
        Where the bodies touch: ``contact.pressure > 0``.
    tolerance : float
        Bound on the estimated relative error of the stiffness [-].
    max_iterations : int
        Maximum number of iterations.

    Returns
    -------
    ContactStiffness
        Stiffness and pressure rate.

    Raises
    ------
    InputError
        If the mask does not fit the grid, is empty, or full on a periodic half-space.
    NoSolutionError
        If the iteration does not converge.

    Notes
    -----
    The area is kept constant, but the result is also the derivative of the load of the *growing* contact: the
    pressure vanishes at the edge, so a change of area carries load of second order only (on a grid
    up to its resolution). On a periodic half-space the displacement is relative to the mean plane: this is
    the stiffness of the interface alone, dF/d(mean gap) with opposite sign.

    References
    ----------
    J. R. Barber, Proc. R. Soc. A 459 (2003) 53. K. L. Johnson, Contact Mechanics, 1985, section 3.8: 2 E a
    for a disc.
    """
    return _stiffness("normal stiffness", half_space, contact_mask, None, tolerance, max_iterations)


def tangential_stiffness(
    half_space: HalfSpace,
    contact_mask: ArrayLike,
    *,
    axis: int,
    tolerance: float = 1e-7,
    max_iterations: int = 1000,
) -> ContactStiffness:
    r"""Incremental tangential stiffness of a contact in full stick.

    .. math::
        \int_{\text{contact}} K_{ij}(x - y)\, \tau_j'(y)\, \mathrm dy = \delta_{i,\text{axis}}
        \text{ on the contact}, \qquad k_t = \int \tau_{\text{axis}}'

    Both components of the shear traction are unknown; they are coupled unless Poisson's ratio is zero.

    Parameters
    ----------
    half_space : HalfSpace
        Elastic bodies and grid.
    contact_mask : array of bool, shape (\*grid)
        Where the bodies touch: ``contact.pressure > 0``.
    axis : {0, 1}
        Direction of the displacement; on a strip 0 is across it and 1 along it.
    tolerance : float
        Bound on the estimated relative error of the stiffness [-].
    max_iterations : int
        Maximum number of iterations.

    Returns
    -------
    ContactStiffness
        Stiffness, cross stiffness and traction rate.

    Raises
    ------
    InputError
        If the mask does not fit the grid, is empty, or full on a periodic half-space; if the axis is neither 0 nor 1.
    NoSolutionError
        If the iteration does not converge.

    Notes
    -----
    Infinitesimal shear after full normal loading: no point slips yet. Exact for like materials; for unlike
    ones the coupling to the normal problem through Dundurs' second constant is neglected.

    References
    ----------
    R. D. Mindlin, J. Appl. Mech. 16 (1949) 259: 8 G* a for a disc. K. L. Johnson, Contact Mechanics, 1985,
    section 3.6.
    """
    if axis not in (0, 1):
        raise InputError(f"axis = {axis}: the tangential directions are 0 and 1")
    return _stiffness("tangential stiffness", half_space, contact_mask, axis, tolerance, max_iterations)
