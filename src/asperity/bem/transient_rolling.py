"""Rolling under a history of force or displacement: stick and slip move with the material."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import field_on_grid
from asperity.bem.partial_slip import PartialSlip, solved_shear
from asperity.engine.module import Module
from asperity.errors import InputError


class TransientRolling(Module):
    """A converged history of rolling, one entry per step; SI units.

    ``rolled_distance`` along the first axis since the start [m]; ``creepage``: growth of the rigid displacement over
    the distance rolled in the step [-], not a number for steps at rest; ``shear``: forces, displacements, tractions,
    work and convergence.
    """

    rolled_distance: Array
    creepage: Array
    shear: PartialSlip


def layer_on_grid(layer_compliance: ArrayLike, pressure: np.ndarray) -> Array | None:
    """Layer compliance as a field [m/Pa], zero outside the contact; None without a layer."""
    layer = np.where(pressure > 0.0, np.asarray(layer_compliance, dtype=np.float64), 0.0)
    if not np.all(np.isfinite(layer)) or layer.min() < 0.0:
        raise InputError(
            "layer_compliance has values below zero or not finite in the contact: it must be at least 0 m/Pa"
        )
    return jnp.asarray(layer) if layer.max() > 0.0 else None


def transient_rolling(
    half_space: FreeHalfSpace,
    pressure: ArrayLike,
    *,
    friction_coefficient: float,
    axis: int,
    rolled_pixels: ArrayLike,
    layer_compliance: ArrayLike,
    tangential_force: ArrayLike | None = None,
    displacement: ArrayLike | None = None,
    tolerance: float = 1e-8,
    max_iterations: int = 2000,
) -> TransientRolling:
    r"""Roll a loaded contact, step by step, under a history of forces or rigid displacements.

    .. math::
        u_k(x) - u_{k-1}(x + d_k) - (\delta_k - \delta_{k-1}) = \Delta s, \qquad |\tau| \le \mu p, \qquad
        \Delta s = 0 \text{ where } |\tau| < \mu p, \quad \Delta s\,\tau \le 0 \text{ elsewhere}

    u is the relative tangential displacement by traction, pressure (unlike bodies) and layer, x moves with the
    contact, :math:`d_k` is the distance rolled in step k. Each step is the bounded minimisation of partial
    slip. A step of zero pixels shears the contact at rest.

    Parameters
    ----------
    half_space : FreeHalfSpace
        Elastic bodies and grid, which must extend beyond the contact by the longest step.
    pressure : array, shape (\*grid)
        Contact pressure [Pa], constant in the frame of the contact.
    friction_coefficient : float
        Coulomb's coefficient mu [-], positive.
    axis : {0, 1}
        Direction of traction and displacement: 0 is the rolling direction, 1 across it (along a strip's length).
    rolled_pixels : array of int, shape (steps,)
        Pixels by which the contact moves towards the end of the first axis in each step; negative rolls back.
    layer_compliance : array, scalar or shape (\*grid)
        Tangential displacement per traction of a thin layer between the bodies [m/Pa]; 0 for none.
    tangential_force : array, shape (steps,), optional
        Prescribed forces [N; N/m on a strip], each smaller than mu times the load. Give either these or
        ``displacement``.
    displacement : array, shape (steps,), optional
        Prescribed rigid displacements since the start [m]: creepage times rolled distance.
    tolerance : float
        Bound on the root mean square misfit of displacement in the stick zone, relative to the
        pressure-weighted displacement at sliding [-].
    max_iterations : int
        Maximum number of iterations per step.

    Returns
    -------
    TransientRolling
        Rolled distance, creepage, and the history of shear.

    Raises
    ------
    InputError
        As for :func:`~asperity.bem.partial_slip.partial_slip`; for rolled pixels that are not whole numbers, one
        for each step, or that move the contact off the grid; for a negative layer compliance.
    NoSolutionError
        If a step does not converge or its traction does not add up to the force.

    Notes
    -----
    The step is implicit and of first order: the steady creepage is low by a quarter of a per cent at 200
    pixels across the contact and steps of one pixel, and the error is proportional to the pixel size. Traction stays
    parallel to the axis. The pressure is not changed by the traction: exact for like bodies and Goodman's
    approximation for unlike ones (:func:`~asperity.bem.coupled_rolling.coupled_steady_rolling` couples both).
    On a strip the rigid displacement under a changing force depends on the reference distance; under a
    constant force it does not.

    References
    ----------
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, sections 4.2 and 5.2.2.
    """
    p = field_on_grid("pressure", pressure, half_space.shape)
    steps = np.atleast_1d(np.asarray(rolled_pixels))
    history = np.atleast_1d(np.asarray(displacement if tangential_force is None else tangential_force))
    if steps.ndim != 1 or not np.array_equal(steps, np.rint(steps)) or steps.shape != history.shape:
        raise InputError(
            f"rolled_pixels has shape {steps.shape}, the history {history.shape}: give one whole number of "
            "pixels for each step"
        )
    touching = np.flatnonzero(np.any(p.reshape(p.shape[0], -1) > 0.0, axis=1))
    room = 0 if touching.size == 0 else int(min(touching[0], p.shape[0] - 1 - touching[-1]))
    longest = int(np.abs(steps).max(initial=0.0))
    if longest > room:
        raise InputError(
            f"rolled_pixels reaches {longest} in one step: the grid extends {room} pixels beyond the contact "
            "and must extend at least as far as a step; enlarge the grid or shorten the steps"
        )
    unlike = float(half_space.pair.dundurs_constant) != 0.0
    if unlike and len(half_space.shape) == 2:
        raise InputError("unlike bodies can roll on a strip only; use a grid with one axis")
    shear = solved_shear(
        half_space,
        p,
        friction_coefficient=friction_coefficient,
        axis=axis,
        tangential_force=tangential_force,
        displacement=displacement,
        rolled_pixels=jnp.asarray(steps.astype(np.int64)),
        layer_compliance=layer_on_grid(layer_compliance, p),
        coupled_displacement=half_space.coupled_displacement(jnp.asarray(p))
        if unlike and axis == 0
        else None,
        tolerance=tolerance,
        max_iterations=max_iterations,
        what="rolling",
    )
    moved = jnp.asarray(steps.astype(np.float64)) * half_space.pixel_size[0]
    growth = jnp.diff(shear.displacement, prepend=0.0)
    rolls = moved != 0.0
    creepage = jnp.where(rolls, growth / jnp.where(rolls, moved, 1.0), jnp.nan)
    return TransientRolling(rolled_distance=jnp.cumsum(moved), creepage=creepage, shear=shear)
