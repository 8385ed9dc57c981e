"""Partial slip of a contact under a history of shear: Coulomb's limit at every point."""

from __future__ import annotations

import functools

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.bounded_problem import BoundedSolution, bounded_solution
from asperity.bem.elastic_pair import positive
from asperity.bem.free_half_space import FreeHalfSpace
from asperity.bem.half_space import HalfSpace, pressure_on_grid
from asperity.bem.normal_contact import pressure_weighted_displacement, refuse_unconverged
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError

#: Largest difference between the sum of the traction and the prescribed force, over the sliding force, that
# is accepted.
_FORCE_TOLERANCE = 1e-9


class PartialSlip(Module):
    r"""A converged history of shear, one entry per step, of fields shape (steps, \*grid); SI units.

    ``tangential_force`` [N; N/m on a strip]; rigid tangential ``displacement`` of the bodies [m], zero at the start;
    ``stick_fraction``: share of the contact area with a traction below the friction limit [-]; ``friction_work``
    dissipated by slip since the start [J; J/m on a strip], from slip and traction point by point. Fields: shear
    ``traction`` [Pa], accumulated ``slip`` in the contact [m].

    ``iterations`` of conjugate gradients; ``residual``: root mean square misfit of displacement where it sticks, over
    the pressure-weighted displacement at sliding [-]; ``load_balance_error``: difference between the sum of the
    traction and the prescribed force over the sliding force [-].
    """

    tangential_force: Array
    displacement: Array
    stick_fraction: Array
    friction_work: Array
    traction: Array
    slip: Array
    iterations: Array
    residual: Array
    load_balance_error: Array


@functools.partial(jax.jit, static_argnames=("force_driven", "axis"))
def shear_history(
    half_space: HalfSpace,
    cap: Array,
    path: Array,
    rolled_pixels: Array | None,
    layer_compliance: Array | None,
    coupled_displacement: Array | None,
    force_driven: bool,
    axis: int,
    tolerance: Array,
    max_iterations: Array,
) -> tuple[BoundedSolution, Array, Array, Array]:
    r"""Stepwise solution of a history of shear, for a contact at rest or rolling along the first axis.

    .. math:: u(\tau) + u_p = \delta + s, \qquad s_k(x) = s_{k-1}(x + d_k) + \Delta s

    Solutions (their displacement is the slip s), stick fraction, friction work and force, one per step.
    """

    def response(traction: Array) -> Array:
        elastic = half_space.aligned_shear_displacement(traction, axis)
        return elastic if layer_compliance is None else elastic + layer_compliance * traction

    def estimate(displacement: Array) -> Array:
        if layer_compliance is None or not isinstance(half_space, FreeHalfSpace):
            return half_space.traction_estimate(displacement)
        return half_space.layered_traction_estimate(displacement, layer_compliance)

    sliding_displacement = pressure_weighted_displacement(cap, response(cap))
    sliding_force = jnp.sum(cap) * half_space.pixel_area
    contact = cap > 0.0
    by_pressure = jnp.zeros_like(cap) if coupled_displacement is None else coupled_displacement

    def step(carry: tuple[Array, Array, Array], given: tuple[Array, Array | None]) -> tuple[tuple, tuple]:
        traction, slip, work = carry
        value, pixels = given
        if pixels is not None:
            slip = jnp.roll(slip, -pixels, axis=0)
        target = slip - by_pressure
        solution = bounded_solution(
            response=response,
            estimate=estimate,
            target=target if force_driven else target + value,
            lower=-cap,
            upper=cap,
            total=value / half_space.pixel_area if force_driven else None,
            start=cap * (value / sliding_force) if force_driven and pixels is None else traction,
            scale=lambda t, u: sliding_displacement,
            tolerance=tolerance,
            max_iterations=max_iterations,
        )
        rigid = solution.shift if force_driven else value
        sticks = contact & (jnp.abs(solution.traction) < cap)
        new_slip = jnp.where(sticks, slip, solution.displacement + by_pressure - rigid)
        work = work - jnp.sum(solution.traction * (new_slip - slip)) * half_space.pixel_area
        stick = jnp.sum(sticks, dtype=cap.dtype) / jnp.sum(contact, dtype=cap.dtype)
        small = BoundedSolution(solution.traction, new_slip, rigid, solution.iterations, solution.residual)
        force = jnp.sum(solution.traction) * half_space.pixel_area
        return (solution.traction, new_slip, work), (small, stick, work, force)

    start = (jnp.zeros_like(cap), by_pressure, jnp.zeros(()))
    _, out = jax.lax.scan(step, start, (path, rolled_pixels))
    return out


def solved_shear(
    half_space: HalfSpace,
    pressure: ArrayLike,
    *,
    friction_coefficient: float,
    axis: int,
    tangential_force: ArrayLike | None,
    displacement: ArrayLike | None,
    rolled_pixels: Array | None,
    layer_compliance: Array | None,
    coupled_displacement: Array | None,
    tolerance: float,
    max_iterations: int,
    what: str,
) -> PartialSlip:
    """The history of shear of checked input, or the error that it has none; arguments as for :func:`partial_slip`."""
    if axis not in (0, 1):
        raise InputError(f"axis = {axis}: the tangential directions are 0 and 1")
    mu = positive("friction_coefficient", friction_coefficient, "")
    positive("tolerance", tolerance, "(relative)")
    p = pressure_on_grid(pressure, half_space.shape)
    if (tangential_force is None) == (displacement is None):
        raise InputError("give either tangential_force or displacement, one value per step")
    force_driven = tangential_force is not None
    given = tangential_force if force_driven else displacement
    path = np.atleast_1d(np.asarray(given, dtype=np.float64))
    if path.ndim != 1 or not np.all(np.isfinite(path)):
        raise InputError(
            f"the history of shear must be a list of finite numbers, not an array of shape {path.shape}"
        )
    sliding_force = mu * float(p.sum()) * float(half_space.pixel_area)
    if force_driven and np.abs(path).max() >= sliding_force:
        unit = half_space.force_unit
        raise InputError(
            f"tangential_force reaches {np.abs(path).max():g} {unit}: the bodies slide at {sliding_force:g} {unit} "
            "(friction coefficient times load); prescribe the displacement instead"
        )
    solution, stick, work, force = shear_history(
        half_space,
        jnp.asarray(mu * p),
        jnp.asarray(path),
        rolled_pixels,
        layer_compliance,
        coupled_displacement,
        force_driven,
        axis,
        jnp.asarray(tolerance),
        jnp.asarray(max_iterations),
    )
    refuse_unconverged(what, solution, tolerance)
    balance = jnp.abs(force - jnp.asarray(path)) / sliding_force if force_driven else jnp.zeros_like(force)
    if not float(jnp.max(balance)) <= _FORCE_TOLERANCE:
        raise NoSolutionError(
            f"{what}: the traction differs from the prescribed force by {float(jnp.max(balance)):.3g} of the "
            "sliding force; the state is not in equilibrium, so no result is returned"
        )
    return PartialSlip(
        tangential_force=force,
        displacement=solution.shift,
        stick_fraction=stick,
        friction_work=work,
        traction=solution.traction,
        slip=jnp.where(jnp.asarray(p > 0.0), solution.displacement, 0.0),
        iterations=solution.iterations,
        residual=solution.residual,
        load_balance_error=balance,
    )


def partial_slip(
    half_space: HalfSpace,
    pressure: ArrayLike,
    *,
    friction_coefficient: float,
    axis: int,
    tangential_force: ArrayLike | None = None,
    displacement: ArrayLike | None = None,
    tolerance: float = 1e-8,
    max_iterations: int = 2000,
) -> PartialSlip:
    r"""Shear a loaded contact through a history of forces or displacements.

    .. math:: |\tau| \le \mu p, \qquad u(\tau) = \delta + s, \qquad
              \Delta s = 0 \text{ where } |\tau| < \mu p, \quad \Delta s\,\tau \le 0 \text{ elsewhere}

    Each step is a bounded minimisation that starts from the slip s of the previous step.

    Parameters
    ----------
    half_space : HalfSpace
        Elastic bodies and grid.
    pressure : array, shape (\*grid)
        Contact pressure [Pa], constant during the shear.
    friction_coefficient : float
        Coulomb's coefficient mu [-], positive.
    axis : {0, 1}
        Direction of the shear; on a strip 0 is across it and 1 along it.
    tangential_force : array, shape (steps,), optional
        Prescribed forces [N; N/m on a strip], each smaller than mu times the load. Give either these or
        ``displacement``.
    displacement : array, shape (steps,), optional
        Prescribed rigid displacements [m]; gross sliding is allowed.
    tolerance : float
        Bound on the root mean square misfit of displacement in the stick zone, relative to the
        pressure-weighted elastic displacement at sliding [-].
    max_iterations : int
        Maximum number of iterations per step.

    Returns
    -------
    PartialSlip
        Force, displacement, stick area, work, tractions and slip at each step.

    Raises
    ------
    InputError
        For fields that do not fit, none or two histories, a force above the sliding force, or an invalid direction.
    NoSolutionError
        If a step does not converge or its traction does not add up to the force.

    Notes
    -----
    The traction is taken parallel to the shear and slip across it is neglected, as by Cattaneo and
    Mindlin; exact for nu = 0, and within about one per cent of the displacement otherwise. The pressure is not
    changed by the shear, which holds for like materials. Within a step slip and traction are taken at its
    end, so the work of slip that changes along a step converges with the number of steps; the state itself
    does not depend on their number as long as the force changes monotonically.

    References
    ----------
    C. Cattaneo, Rend. Accad. Naz. Lincei 27 (1938) 342. R. D. Mindlin, J. Appl. Mech. 16 (1949) 259.
    J. J. Kalker, Three-Dimensional Elastic Bodies in Rolling Contact, 1990, section 4.2 (the minimum
    principle).
    """
    return solved_shear(
        half_space,
        pressure,
        friction_coefficient=friction_coefficient,
        axis=axis,
        tangential_force=tangential_force,
        displacement=displacement,
        rolled_pixels=None,
        layer_compliance=None,
        coupled_displacement=None,
        tolerance=tolerance,
        max_iterations=max_iterations,
        what="partial slip",
    )
