"""Life of a drive under a duty: loads, speeds and their shares of the time."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

from asperity.contact.rolling_fatigue import damage_shares, life_at_reliability, spectrum_life
from asperity.drive.state.state import BodiesOfContacts
from asperity.engine.arrays import xp
from asperity.engine.control import vectorised
from asperity.engine.module import Module
from asperity.joint.fit import per_contact
from asperity.rolling.conditions import RollingConditions
from asperity.rolling.life import drive_lives, failure_shares
from asperity.rolling.rolling import RollingResult
from asperity.types import Array, Real


class DutyLife(Module):
    """Life of a drive under its duty, and what each load does to it; loads first.

    ``hours`` and ``turns`` of the output are nan where a contact slips or lifts off under one of the loads, infinite
    where nothing turns. Of each load: its share in the damage of the drive [-], which add up to 1; the life under it
    alone [h]; and, for the worst contact, Hertz pressure over the shakedown limit, traction over what friction and skew
    leave, and oil film over roughness [-], nan where it does not roll.
    """

    hours: Array
    turns: Array
    damage_shares: Array
    load_hours: Array
    shakedown_ratios: Array
    slip_ratios: Array
    film_ratios: Array


def with_duty_life(
    rolling: RollingResult,
    *,
    conditions: RollingConditions,
    bodies: BodiesOfContacts,
    branches: Real,
    rolled: Callable[[Array, Array], RollingResult],
) -> RollingResult:
    """The joint that turns with its life under its duty, if it has one."""
    if not conditions.duty:
        return rolling
    life = duty_life(conditions=conditions, bodies=bodies, branches=branches, rolled=rolled)
    return dataclasses.replace(
        rolling,
        duty_life_hours=life.hours,
        duty_life_turns=life.turns,
        duty_damage_shares=life.damage_shares,
        duty_load_hours=life.load_hours,
        duty_shakedown_ratios=life.shakedown_ratios,
        duty_slip_ratios=life.slip_ratios,
        duty_film_ratios=life.film_ratios,
    )


def duty_life(
    *,
    conditions: RollingConditions,
    bodies: BodiesOfContacts,
    branches: Real,
    rolled: Callable[[Array, Array], RollingResult],
) -> DutyLife:
    r"""Life of the drive under its duty, in hours and in turns of the output.

    .. math:: \frac1{T_i} = \sum_j \varphi_j \frac{f_{ij}}{L_{ij}}, \qquad
              D_j = \sum_i s_i\,T_i\,\varphi_j \frac{f_{ij}}{L_{ij}}

    for every track i under the loads j, then the tracks of all bodies together. :math:`s_i` is the share of the
    failures that begin on track i, :func:`asperity.rolling.life.failure_shares`.

    Parameters
    ----------
    conditions : RollingConditions
        The duty, with at least one load, and the reliability.
    bodies : BodiesOfContacts
        Bodies of the contacts.
    branches : Real
        Number of branches [-].
    rolled : callable
        Steady rolling of the joint at an output torque [N·m] and a speed of the input [rad/s].

    Returns
    -------
    DutyLife
        Lives, and the share of each load in the damage.

    Notes
    -----
    The life of the drive falls by :math:`D_j` per cent where the damage by load j rises by one per cent.

    References
    ----------
    Equation (B8) of :doc:`/equations`.
    """
    points = per_contact(conditions.duty)
    rolling = vectorised(rolled)(points.output_torque, points.input_speed)
    turns_a_second = rolling.output_speed / (2.0 * xp.pi)
    spectrum = {
        "lives": _cycles(conditions, rolling),
        "cycle_rates": rolling.cycles_per_turn * turns_a_second[:, None, None],
        "time_shares": points.share[:, None, None],
    }
    tracks = spectrum_life(**spectrum)
    hours = drive_lives(
        bodies=bodies,
        tracks=life_at_reliability(life=tracks, reliability=conditions.reliability) / 3600.0,
        branches=branches,
    ).drive
    shares = damage_shares(**spectrum) * failure_shares(bodies=bodies, tracks=tracks, branches=branches)
    return DutyLife(
        hours=hours,
        turns=hours * 3600.0 * xp.sum(points.share * turns_a_second, axis=0),
        damage_shares=xp.sum(shares, axis=(1, 2)),
        load_hours=rolling.life_hours.drive,
        shakedown_ratios=xp.max(rolling.shakedown_ratio, axis=1),
        slip_ratios=xp.max(rolling.slip_ratio, axis=1),
        film_ratios=xp.min(rolling.film_ratio, axis=1),
    )


def _cycles(conditions: RollingConditions, rolling: RollingResult) -> Array:
    """Lives of the tracks under each load, in stress cycles; without a film, where nothing turns, no cycle counts."""
    if conditions.cleanliness is None:
        return rolling.cycles
    stands = (
        (rolling.output_speed == 0.0)[:, None] & (rolling.shakedown_ratio < 1.0) & (rolling.slip_ratio < 1.0)
    )
    return xp.where(stands[:, None], xp.inf, rolling.cycles)
