"""Life of a drive under a duty: loads, speeds and their shares of the time."""

from __future__ import annotations

from collections.abc import Callable

import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.rolling_fatigue import life_at_reliability, spectrum_life
from asperity.joint.description import per_contact
from asperity.joint.rolling import RollingResult
from asperity.joint.rolling_conditions import RollingConditions
from asperity.joint.rolling_life import drive_lives
from asperity.types import Real


def duty_life(
    *, conditions: RollingConditions, planet_count: Real, rolled: Callable[[Array, Array], RollingResult]
) -> tuple[Array, Array]:
    r"""Life of the drive under its duty, in hours and in turns of the output.

    .. math:: \frac1{T_i} = \sum_j \varphi_j \frac{f_{ij}}{L_{ij}}

    for every track i under the loads j, then the tracks of all bodies together.

    Parameters
    ----------
    conditions : RollingConditions
        The duty, with at least one load, and the reliability.
    planet_count : Real
        Number of planets [-].
    rolled : callable
        Steady rolling of the joint at an output torque [N·m] and a speed of the sun [rad/s].

    Returns
    -------
    tuple of Array
        Hours and turns; nan where a contact slips or lifts off under one of the loads, infinite where nothing turns.

    References
    ----------
    Equation (B8) of :doc:`/equations`.
    """
    points = per_contact(conditions.duty)
    found = jax.vmap(rolled)(points.output_torque, points.sun_speed)
    turns_a_second = found.carrier_speed / (2.0 * jnp.pi)
    tracks = spectrum_life(
        lives=found.cycles,
        cycle_rates=found.cycles_per_turn * turns_a_second[:, None, None],
        time_shares=points.share[:, None, None],
    )
    hours = drive_lives(
        tracks=life_at_reliability(life=tracks, reliability=conditions.reliability) / 3600.0,
        planet_count=planet_count,
    ).drive
    turns = hours * 3600.0 * jnp.sum(points.share * turns_a_second, axis=0)
    return hours, turns
