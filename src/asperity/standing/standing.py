"""A joint that stands under torques of either sign: stiffness on every level, as it is and without slip; its drift."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.joint.description import Joint
from asperity.standing.over_torque import over_torque, standing_over_torque
from asperity.types import Array

#: Levels of the stiffness, from the simplest.
LEVELS = ("published", "series_with_bulk", "assembly")

#: Friction coefficient under which no contact slips at all: T/(mu N) is lost in the rounding of 1 − T/(mu N).
NO_SLIP_FRICTION = 1e30


class Standing(NamedTuple):
    """A joint at torques, as NumPy arrays. SI units.

    Whether the forces balance, and whether friction holds the torque, shape (torques,); T/(mu N) of each contact, shape
    (contacts, torques) [-]. Name of a level → incremental stiffness at the output, shape (torques,) [N·m/rad]: as the
    joint is, and under the same normal forces with so much friction that no contact slips.
    """

    solved: np.ndarray
    holds: np.ndarray
    slip_ratio: np.ndarray
    levels: dict[str, np.ndarray]
    levels_without_slip: dict[str, np.ndarray]


def standing_at(joint: Joint, torques: np.ndarray) -> Standing:
    """What a wind-up needs to know of a joint with any type of drive."""
    standing = standing_over_torque(joint, torques, no_slip_friction=NO_SLIP_FRICTION)
    with_slip, without_slip = (
        {name: np.asarray(getattr(standing, name))[:, k] for name in LEVELS} for k in range(2)
    )
    holds, ratio = np.asarray(standing.solved), np.asarray(standing.slip_ratio).T
    return Standing(np.asarray(standing.balanced), holds, ratio, with_slip, without_slip)


class BothSenses(Module):
    """One joint over output torques of either sign [N·m]. SI units; shape (n,).

    Incremental stiffnesses on the three levels at rest, play left out [N·m/rad], nan where a contact slips; the largest
    T/(mu N) of all contacts at rest. The drifts are the angle by which the output gives way to the torque in one turn
    of its own, with the sign of the torque [rad]: in steady rolling with the torque (the output falls behind), and
    against it (it runs ahead); nan where there is no steady rolling. ``efficiency`` of steady rolling [-], nan
    where it is unknown or the input stands.
    """

    torque: Array
    published: Array
    series_with_bulk: Array
    assembly: Array
    slip_ratio: Array
    driving_drift: Array
    braking_drift: Array
    efficiency: Array


def both_senses(*, joint: Joint, torque: Array | np.ndarray) -> BothSenses:
    """Stiffness and drift of a joint at given torques."""
    results = over_torque(joint, np.asarray(torque), no_slip_friction=NO_SLIP_FRICTION)
    slip = np.max(np.asarray(results.slip_ratio), axis=1)
    solved = np.asarray(results.solved)
    levels = {
        name: xp.asarray(np.where(solved, np.asarray(getattr(results, name))[:, 0], np.nan))
        for name in LEVELS
    }
    driving, braking = xp.asarray(results.drift).T
    return BothSenses(
        torque=xp.asarray(torque),
        **levels,
        slip_ratio=xp.asarray(np.where(solved, slip, np.nan)),
        driving_drift=driving,
        braking_drift=braking,
        efficiency=xp.asarray(results.efficiency),
    )


_TORQUES = 49
_OVER_TORQUE = 2.0  # end of the axis over the joint's own torque, where there is no capacity


class TorqueCurves(Module):
    """One joint over its output torque [N·m]. SI units; shape (n,); nan where a contact slips or nothing turns.

    Torsional stiffness at the output on the three levels [N·m/rad]; angle lost in one turn of the output [rad]; output
    over input power; power lost, without what the file has no numbers for [W]; fatigue life of the drive in hours and
    in turns of the output; the largest T/(mu N) of all contacts.
    """

    torque: np.ndarray
    published: np.ndarray
    series_with_bulk: np.ndarray
    assembly: np.ndarray
    drift_per_output_turn: np.ndarray
    efficiency: np.ndarray
    total_loss: np.ndarray
    life_hours: np.ndarray
    life_turns: np.ndarray
    slip_ratio: np.ndarray


def torque_curves(*, joint: Joint, torque_capacity: float) -> TorqueCurves:
    """Stiffness, drift and efficiency of a joint from no torque to its capacity."""
    output_torque = float(joint.output_torque)
    limited = math.isfinite(torque_capacity) and torque_capacity > 0.0
    largest = torque_capacity if limited else _OVER_TORQUE * abs(output_torque) or 1.0
    towards = np.linspace(0.0, 1.0, _TORQUES)
    # the curves are steep near gross slip
    torque = math.copysign(largest, output_torque) * (towards * (2.0 - towards) if limited else towards)
    results = over_torque(joint, torque, no_slip_friction=NO_SLIP_FRICTION)
    slip = np.max(np.asarray(results.slip_ratio), axis=1)
    holds = np.asarray(results.solved)
    levels = {name: np.where(holds, np.asarray(getattr(results, name))[:, 0], np.nan) for name in LEVELS}
    with_torque, against = np.asarray(results.drift).T
    return TorqueCurves(
        torque=torque,
        **levels,
        drift_per_output_turn=np.where(torque < 0.0, against, with_torque),
        efficiency=np.asarray(results.efficiency),
        total_loss=np.asarray(results.total_loss),
        life_hours=np.asarray(results.life_hours),
        life_turns=np.asarray(results.life_turns),
        slip_ratio=np.where(holds, slip, np.nan),
    )
