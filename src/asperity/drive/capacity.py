"""Torque capacity: the largest output torque that all contacts transmit without gross slip (A9)."""

from __future__ import annotations

import math
from collections.abc import Callable

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.force_balance import force_balance
from asperity.drive.mechanism import Mechanism
from asperity.types import Real

#: Doublings of a first guess after which a drive is taken as not limited by friction.
MOST_DOUBLINGS = 40
#: Share of the first guess below which a drive has no capacity at all.
SMALLEST_SHARE = 1e-12
_ROOT_TOLERANCE = 1e-12

_STEPS = 100  # doublings and halvings together: sixty halvings reach rounding, forty doublings 10^12 times the guess


class TorqueCapacity(eqx.Module):
    """Torque capacity of a preloaded drive.

    Parameters
    ----------
    output_torque : Array
        Capacity at the carrier [N·m]; infinite where the normal forces of the wedge grow faster than the traction, 0
        where a contact slips without torque.
    limiting_contact : Array
        Index of the contact that slips first, in the order of :data:`asperity.drive.geometry.CONTACT_NAMES` [-].
    """

    output_torque: Array
    limiting_contact: Array


def slip_ratio(*, normal_force: Real, tangential_force: Real, friction_coefficient: Real) -> Array:
    r"""Traction used over traction available, :math:`|T|/(\mu N)`.

    Parameters
    ----------
    normal_force, tangential_force : Real
        N and T of a contact [N].
    friction_coefficient : Real
        mu [-].

    Returns
    -------
    Array
        Ratio [-]; the contact slips grossly from 1 on. Infinite for a force without a normal load, 0 for neither.

    References
    ----------
    Amontons–Coulomb friction; Zou et al. 2025, equation (22).
    """
    limit = friction_coefficient * normal_force
    touching = limit > 0.0
    force = jnp.abs(tangential_force)
    return jnp.where(touching, force / jnp.where(touching, limit, 1.0), jnp.where(force > 0.0, jnp.inf, 0.0))


@eqx.filter_jit
def torque_capacity(*, mechanism: Mechanism, friction_coefficient: Real) -> TorqueCapacity:
    r"""Largest output torque at which every contact keeps :math:`T < \mu N`.

    .. math:: \max_i \frac{T_i(T_{out})}{\mu_i N_i(T_{out})} = 1

    Parameters
    ----------
    mechanism : Mechanism
        The preloaded drive.
    friction_coefficient : Real
        mu of the contacts, shape (1, ...) or (5, ...) [-].

    Returns
    -------
    TorqueCapacity
        Capacity [N·m] and the contact that limits it.

    Notes
    -----
    Doubling until a contact slips, then bisection, each point a full force balance. The derivatives are implicit.

    References
    ----------
    Equation (A9) of :doc:`/equations`.
    """

    def ratios(torque: Array) -> Array:
        forces = force_balance(mechanism=mechanism, output_torque=torque)
        return slip_ratio(
            normal_force=forces.normal,
            tangential_force=forces.tangential,
            friction_coefficient=friction_coefficient,
        )

    def excess(torque: Array) -> Array:
        return jnp.max(ratios(torque), axis=0) - 1.0

    sides = mechanism.sides
    unit = jnp.min(jnp.asarray(friction_coefficient), axis=0) * mechanism.preload * sides.roller_orbit
    unit = unit * mechanism.geometry.planet_count
    start = jnp.broadcast_to(unit, jnp.shape(mechanism.preload + 0.0 * unit + sides.roller_orbit))

    def narrow(_: int, bounds: tuple[Array, Array, Array]) -> tuple[Array, Array, Array]:
        """Double the upper bound until a contact slips there, then halve the interval."""
        lower, upper, bracketed = bounds
        trial = jnp.where(bracketed, 0.5 * (lower + upper), upper)
        slips = excess(trial) >= 0.0
        next_upper = jnp.where(slips, trial, jnp.where(bracketed, upper, 2.0 * upper))
        return jnp.where(slips, lower, trial), next_upper, bracketed | slips

    first = (jnp.zeros_like(start), start, jnp.zeros_like(start, dtype=bool))
    lower, upper, bracketed = jax.lax.stop_gradient(jax.lax.fori_loop(0, _STEPS, narrow, first))
    unlimited = ~bracketed
    slips_at_rest = bracketed & (lower == 0.0)
    ends = unlimited | slips_at_rest

    def divide(linear, right_side: Array) -> Array:  # type: ignore[no-untyped-def]
        return right_side / linear(jnp.ones_like(right_side))

    def bounded_excess(torque: Array) -> Array:
        return jnp.where(ends, torque - upper, excess(torque))

    # the root is known; custom_root gives it the implicit derivative
    root = jax.lax.custom_root(bounded_excess, upper, lambda _, found: found, divide)
    capacity = jnp.where(unlimited, jnp.inf, jnp.where(slips_at_rest, 0.0, root))
    return TorqueCapacity(
        output_torque=capacity,
        limiting_contact=jnp.argmax(ratios(jax.lax.stop_gradient(root)), axis=0),
    )


def capacity_by_search(*, slip_ratios: Callable[[float], np.ndarray], first_guess: float) -> TorqueCapacity:
    r"""Capacity of one drive from a function that gives the slip ratios of its contacts under a torque.

    .. math:: \max_i \frac{T_i(T_{out})}{\mu_i N_i(T_{out})} = 1

    Parameters
    ----------
    slip_ratios : callable
        Output torque [N·m] to T/(mu N) of the contacts, shape (5,) [-]; nan where the force balance does not close.
    first_guess : float
        Torque of the right order of magnitude, from which the doubling starts [N·m].

    Returns
    -------
    TorqueCapacity
        As :func:`torque_capacity` finds it, without derivatives; nan where the balance does not close at a torque that
        determines the capacity.

    Notes
    -----
    Doubling, then bisection: about fifty calls of an already compiled function take milliseconds, whereas compiling
    :func:`torque_capacity` takes seconds.

    References
    ----------
    Equation (A9) of :doc:`/equations`.
    """

    def excess(torque: float) -> float:
        return float(np.max(slip_ratios(torque))) - 1.0

    def found(torque: float, at: float) -> TorqueCapacity:
        return TorqueCapacity(np.asarray(torque), np.asarray(np.argmax(slip_ratios(at))))  # type: ignore[arg-type]

    lower = SMALLEST_SHARE * first_guess
    below = excess(lower)
    if not below < 0.0:
        return found(below if math.isnan(below) else 0.0, lower)
    upper = first_guess
    for _ in range(MOST_DOUBLINGS):
        above = excess(upper)
        if above >= 0.0:
            break
        if above < 0.0:  # a torque without a solution is skipped
            lower = upper
        upper *= 2.0
    else:
        return found(math.nan if math.isnan(above) else math.inf, lower)
    root = _root(excess, lower, upper)
    return found(root, upper if math.isnan(root) else root)


def _root(function: Callable[[float], float], lower: float, upper: float) -> float:
    """Sign change of a function from negative to positive, by bisection; nan where it has no value on the way."""
    while upper - lower > _ROOT_TOLERANCE * upper:
        middle = 0.5 * (lower + upper)
        value = function(middle)
        if math.isnan(value):
            return math.nan
        lower, upper = (lower, middle) if value >= 0.0 else (middle, upper)
    return upper
