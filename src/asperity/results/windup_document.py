"""The wind-up of a joint to be reported: refused beyond the capacity, and as one JSON document."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np

from asperity.errors import InputError
from asperity.joint.description import Joint
from asperity.joint.pin_bound import bound_document
from asperity.joint.solve import Solution, solve_joint
from asperity.results.document import capacities_document
from asperity.rolling.document import unknown_because
from asperity.rolling.onset import RollingOnset, rolling_onset
from asperity.standing import STAGE_SHARES
from asperity.standing.windup import StiffnessLevel, Windup, windup
from asperity.types import Document


def examined_windup(
    joint: Joint,
    *,
    largest_torque: float | None,
    level: StiffnessLevel,
    stage_shares: tuple[float, float] = STAGE_SHARES,
) -> tuple[Windup, tuple[Solution, Solution]]:
    """Wind-up of a joint in both directions, and its solutions at the largest positive and negative torque.

    The largest torque has either sign [N·m], None for the joint's own. An ``InputError`` if the rollers do not fit, or
    the torque or the stages are out of range; a ``NoSolutionError`` if the force balance does not close.
    """
    largest = abs(float(joint.output_torque) if largest_torque is None else largest_torque)
    if largest == 0.0:
        hint = "" if largest_torque is not None else "; state another one with --torque"
        raise InputError(f"a wind-up needs a torque that is not zero{hint}")
    speed = abs(float(joint.input_speed))
    forward, reverse = (  # refuses rollers that do not fit and a torque beyond the capacity of its direction
        solve_joint(dataclasses.replace(joint, output_torque=way * largest, input_speed=way * speed))
        for way in (1.0, -1.0)  # it turns with its torque, as the friction of its bearings has it
    )
    curve = windup(joint, largest_torque=largest, level=level, stage_shares=stage_shares)
    return curve, (forward, reverse)


def windup_onsets(
    joint: Joint, curve: Windup, solutions: tuple[Solution, Solution], *, creep_share: float
) -> tuple[RollingOnset | None, RollingOnset | None]:
    """What becomes of both ends of a wind-up when the joint turns there; None where there is no steady rolling.

    ``creep_share``: creep over wind-up up to which the static curve is said to hold [-]; an ``InputError`` if it is not
    positive and finite.
    """
    forward, reverse = (
        rolling_onset(joint=joint, result=solution.result, windup=angle, creep_share=creep_share)
        for solution, angle in zip(solutions, (curve.angle[-1], -curve.angle[0]), strict=True)
    )
    return forward, reverse


def windup_document(
    joint: Joint,
    curve: Windup,
    solutions: tuple[Solution, Solution],
    onsets: tuple[RollingOnset | None, RollingOnset | None],
    *,
    level: StiffnessLevel,
) -> Document:
    """The figures of a wind-up in SI units, ready for :func:`json.dumps`, the unit at the end of every key.

    Angles of ``rolling`` are without sign; capacities as :func:`asperity.joint.torque_limits.capacity_document` says
    them.
    """
    forward, reverse = solutions
    return {
        "level": level,
        **bound_document(joint),
        "of_own_branches": joint.unlike is not None,
        "standing_torque_capacity": capacities_document(*solutions),
        "largest_torque_Nm": float(curve.torque[-1]),
        "windup_rad": float(curve.angle[-1]),
        "reverse_windup_rad": -float(curve.angle[0]),
        "hysteresis_rad": float(curve.hysteresis),
        "lost_motion_rad": float(curve.lost_motion),
        "dissipated_energy_J": float(curve.dissipated_energy),
        "stages": [
            {
                "name": f"K{index + 1}",
                "from_Nm": float(curve.stage_torque[index]),
                "to_Nm": float(curve.stage_torque[index + 1]),
                "stiffness_Nm_per_rad": float(curve.stage_stiffness[index]),
                "reverse_stiffness_Nm_per_rad": float(curve.reverse_stage_stiffness[index]),
            }
            for index in range(3)
        ],
        "rolling": {**_rolling(joint, forward, onsets[0]), "reverse": _rolling(joint, reverse, onsets[1])},
    }


def windup_capacities(document: Document) -> tuple[float, float]:
    """Torque capacities standing of both directions as positive torques [N·m], of :func:`windup_document`.

    Infinite where there are none, or where the joint may carry more than what is computed.
    """
    capacity = document["standing_torque_capacity"]
    forward, reverse = (
        math.inf
        if direction["output_torque_Nm"] is None or direction["is_lower_bound"]
        else float(direction["output_torque_Nm"])
        for direction in (capacity, capacity["reverse"])
    )
    return forward, reverse


def _rolling(joint: Joint, solution: Solution, onset: RollingOnset | None) -> Document:
    if onset is None:
        return {"unknown_because": unknown_because(joint, solution.result)}
    contacts = onset.contacts

    def both(angle: Any) -> dict[str, float]:
        return {"input_rad": float(contacts.input_angle * angle), "output_rad": float(angle)}

    return {
        "unknown_because": [],
        "creep_share_of_windup": float(onset.creep_share),
        "static_curve_up_to": both(onset.static_angle),
        "steady_creep_from": both(onset.steady_angle),
        "drift_rad_per_output_turn": float(contacts.drift_per_output_turn),
        "drift_line_offset_rad": -float(onset.missing_angle),
        "swing_without_drift": both(onset.still_angle),
        "contacts": {
            name: {
                "width_m": 2.0 * float(np.asarray(contacts.half_width)[k]),
                "rolls_its_width_in": both(np.asarray(onset.width_angle)[k]),
                "share_of_drift": float(np.asarray(contacts.share)[k]),
            }
            for k, name in enumerate(joint.contact_names)
        },
    }


def windup_columns(curve: Windup) -> Document:
    """The loading curves and both branches of the loop at the same torques: names with units → arrays of shape (n,)."""
    return {
        "torque_Nm": curve.torque,
        "loading_angle_rad": curve.angle,
        "incremental_stiffness_Nm_per_rad": curve.stiffness,
        "unloading_angle_rad": curve.unloading_angle,
        "reloading_angle_rad": curve.reloading_angle,
    }


def rolling_columns(onset: RollingOnset) -> Document:
    """The curve beyond a wind-up, and what swings of the same angles lose: names with units → arrays of shape (n,)."""
    return {
        "input_angle_rad": onset.contacts.input_angle * onset.angle,
        "output_angle_rad": onset.angle,
        "angle_behind_rad": onset.lag,
        "drift_per_swing_rad": onset.swing_drift,
    }
