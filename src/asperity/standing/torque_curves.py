"""A joint over its output torque: stiffness on every level, drift, efficiency and slip from one compiled program."""

from __future__ import annotations

import math

import equinox as eqx
import numpy as np

from asperity.joint.description import Joint
from asperity.standing.over_torque import over_torque
from asperity.standing.standing import LEVELS, NO_SLIP_FRICTION

_TORQUES = 49
_OVER_TORQUE = 2.0  # end of the axis over the joint's own torque, where there is no capacity


class TorqueCurves(eqx.Module):
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
