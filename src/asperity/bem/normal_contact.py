"""Frictionless normal contact of a rough surface with an elastic half-space."""

from __future__ import annotations

import jax
import jax.numpy as jnp
from jax import Array
from jax.typing import ArrayLike

from asperity.bem.bounded_problem import BoundedSolution, bounded_solution
from asperity.bem.elastic_pair import positive
from asperity.bem.half_space import HalfSpace, field_on_grid
from asperity.engine.module import Module
from asperity.errors import InputError, NoSolutionError

#: Largest relative difference between the sum of the pressure and the load that is accepted.
_LOAD_TOLERANCE = 1e-9


class NormalContact(Module):
    """A converged normal contact; fields of the shape of the grid, all else scalars, SI units.

    ``pressure`` [Pa] is exactly zero outside the contact; ``displacement`` of the surface [m], normal, both bodies
    together; ``gap`` of the surfaces [m], zero in elastic contact, negative by the plastic depth where the hardness
    limits the pressure, with its ``mean_gap`` over the grid. ``normal_force``: load, the sum of the pressure [N; N/m on
    a strip]. ``approach``: rigid displacement of the rough body towards the half-space [m], from first contact of its
    highest point at height zero; relative to infinity, to the reference distance (strip) or to the mean plane
    (periodic).

    ``real_contact_area``: of the pixels that carry pressure [m^2; m on a strip], and ``contact_fraction``, it over the
    nominal area [-]. ``iterations`` of conjugate gradients; ``residual``: root mean square of the gap inside the
    contact over the pressure-weighted mean displacement [-]; ``load_balance_error``: relative difference between the
    sum of the pressure and the prescribed load [-].
    """

    half_space: HalfSpace
    pressure: Array
    displacement: Array
    gap: Array
    normal_force: Array
    approach: Array
    real_contact_area: Array
    contact_fraction: Array
    mean_gap: Array
    iterations: Array
    residual: Array
    load_balance_error: Array


def pressure_weighted_displacement(pressure: Array, displacement: Array) -> Array:
    """Mean displacement weighted by the pressure: twice the elastic energy over the load [m]."""
    return jnp.sum(pressure * displacement) / jnp.sum(pressure)


@jax.jit
def _solved(
    half_space: HalfSpace,
    heights: Array,
    force: Array,
    hardness: Array | None,
    start: Array | None,
    tolerance: Array,
    max_iterations: Array,
) -> tuple[BoundedSolution, dict[str, Array]]:
    total = force / half_space.pixel_area
    if start is None:
        start = half_space.flattening_pressure(heights)
    solution = bounded_solution(
        response=half_space.normal_displacement,
        estimate=half_space.traction_estimate,
        target=heights,
        lower=jnp.zeros(()),
        upper=hardness,
        total=total,
        start=start,
        scale=pressure_weighted_displacement,
        tolerance=tolerance,
        max_iterations=max_iterations,
    )
    carried = jnp.sum(solution.traction) * half_space.pixel_area
    fraction = jnp.mean(solution.traction > 0.0, dtype=heights.dtype)
    gap = solution.displacement - heights - solution.shift
    return solution, {
        "gap": gap,
        "normal_force": carried,
        "real_contact_area": fraction * half_space.nominal_area,
        "contact_fraction": fraction,
        "mean_gap": jnp.mean(gap),
        "load_balance_error": jnp.abs(carried / force - 1.0),
    }


def normal_contact(
    half_space: HalfSpace,
    heights: ArrayLike,
    *,
    normal_force: float,
    hardness: float | None = None,
    start: NormalContact | None = None,
    tolerance: float = 1e-8,
    max_iterations: int = 2000,
) -> NormalContact:
    r"""Normal contact of a rigid rough surface with an elastic half-space under a given load.

    .. math:: g = u(p) - h + \delta \ge 0,\quad p \ge 0,\quad p\,g = 0,\quad \int p = F_n

    By superposition this is also the contact of two rough elastic bodies: h is then the sum of both
    roughnesses and the moduli those of the pair.

    Parameters
    ----------
    half_space : HalfSpace
        Elastic bodies and grid, periodic or free.
    heights : array, shape (\*grid)
        Height of the rough body towards the half-space, summits positive [m].
    normal_force : float
        Load [N; N/m on a strip], positive.
    hardness : float, optional
        Upper limit of the pressure [Pa]; without it the contact is elastic at any pressure.
    start : NormalContact, optional
        Initial solution at a similar load on the same grid; saves iterations and does not change the result.
    tolerance : float
        Bound on the root mean square gap inside the contact, relative to the pressure-weighted mean displacement [-].
    max_iterations : int
        Maximum number of iterations.

    Returns
    -------
    NormalContact
        Pressure, gap, area, approach and convergence.

    Raises
    ------
    InputError
        For heights that do not fit, a load that is not positive, or one that the capped pressure cannot carry.
    NoSolutionError
        If the iteration does not converge or the pressure does not add up to the load.

    Notes
    -----
    Small slopes, no friction, no adhesion. The hardness limit is perfect plasticity of each surface point
    (Almqvist et al. 2007): it limits the pressure but does not displace material laterally. The approach is
    that of the given heights: subtract their maximum to obtain the approach from first contact.

    References
    ----------
    I. A. Polonsky and L. M. Keer, Wear 231 (1999) 206. A. Almqvist et al., Wear 262 (2007) 205 (hardness).
    R. Hiptmair, Comput. Math. Appl. 52 (2006) 699 (preconditioning by the opposite operator).
    """
    h = jnp.asarray(field_on_grid("heights", heights, half_space.shape))
    unit = half_space.force_unit
    force = positive("normal_force", normal_force, unit)
    limit = float("inf") if hardness is None else positive("hardness", hardness, "Pa")
    positive("tolerance", tolerance, "(relative)")
    capacity = limit * float(half_space.nominal_area)
    if force >= capacity:
        raise InputError(
            f"normal_force = {force:g} {unit}: a surface of hardness {limit:g} Pa carries less than "
            f"{capacity:g} {unit} on this grid; reduce the load"
        )
    solution, derived = _solved(
        half_space,
        h,
        jnp.asarray(force),
        None if hardness is None else jnp.asarray(limit),
        None if start is None else start.pressure,
        jnp.asarray(tolerance),
        jnp.asarray(max_iterations),
    )
    refuse_unconverged("normal contact", solution, tolerance)
    if not float(derived["load_balance_error"]) <= _LOAD_TOLERANCE:
        raise NoSolutionError(
            f"normal contact: the pressure adds up to {float(derived['normal_force']):.9g} {unit} instead of "
            f"{force:.9g} {unit}; the state is not in equilibrium, so no result is returned"
        )
    return NormalContact(
        half_space=half_space,
        pressure=solution.traction,
        displacement=solution.displacement,
        approach=solution.shift,
        iterations=solution.iterations,
        residual=solution.residual,
        **derived,
    )


def refuse_unconverged(what: str, solution: BoundedSolution, tolerance: float) -> None:
    """Raise :class:`NoSolutionError` unless the solution is converged to the tolerance [-] and finite."""
    residual, iterations = float(jnp.max(solution.residual)), int(jnp.max(solution.iterations))
    if not residual <= tolerance or not bool(jnp.all(jnp.isfinite(solution.traction))):
        raise NoSolutionError(
            f"{what}: not converged after {iterations} iterations, relative residual {residual:.3g}, "
            f"tolerance {tolerance:.3g}; increase max_iterations or the tolerance"
        )
