"""The wind-up of a joint to be reported: refused beyond the capacity, and as one JSON document."""

from __future__ import annotations

import dataclasses
from typing import Any

from asperity.errors import InputError
from asperity.joint.capacity import capacity_document
from asperity.joint.description import Joint
from asperity.joint.solve import Solution, solve
from asperity.joint.windup import StiffnessLevel, Windup, windup


def examined_windup(
    joint: Joint,
    *,
    largest_torque: float | None,
    level: StiffnessLevel,
    stage_shares: tuple[float, float],
) -> tuple[Windup, tuple[Solution, Solution]]:
    """Wind-up of a joint in both directions, and its solution at the largest torque of each.

    Parameters
    ----------
    joint : Joint
        One joint.
    largest_torque : float or None
        Largest torque of the curve, of either sign [N·m]; None for the joint's own output torque.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness is integrated.
    stage_shares : tuple of float
        Bounds of the stages as shares of the largest torque [-].

    Returns
    -------
    tuple
        Curves and their figures; the solutions in the positive and in the negative direction.

    Raises
    ------
    InputError
        If the rollers do not fit, or the torque or the stages are out of range.
    NoSolutionError
        If the force balance does not close.
    """
    largest = abs(float(joint.output_torque) if largest_torque is None else largest_torque)
    if largest == 0.0:
        hint = "" if largest_torque is not None else "; state another one with --torque"
        raise InputError(f"a wind-up needs a torque that is not zero{hint}")
    speed = float(joint.sun_speed)
    forward, reverse = (  # refuses rollers that do not fit and a torque beyond the capacity of its direction
        solve(dataclasses.replace(joint, output_torque=sense * largest, sun_speed=sense * speed))
        for sense in (1.0, -1.0)
    )
    curve = windup(joint, largest_torque=largest, level=level, stage_shares=stage_shares)
    return curve, (forward, reverse)


def windup_document(
    curve: Windup, solutions: tuple[Solution, Solution], *, level: StiffnessLevel
) -> dict[str, Any]:
    """The figures of a wind-up in SI units, ready for :func:`json.dumps`.

    Parameters
    ----------
    curve : Windup
        Curves and figures.
    solutions : tuple of Solution
        The joint at the largest torque in the positive and in the negative direction.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness was integrated.

    Returns
    -------
    dict
        The unit at the end of every key; capacities as :func:`asperity.joint.capacity.capacity_document` says them.
    """
    forward, reverse = solutions
    return {
        "level": level,
        "torque_capacity": {
            **capacity_document(forward.capacity),
            "reverse": capacity_document(reverse.reverse_capacity),
        },
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
    }


def windup_columns(curve: Windup) -> dict[str, Any]:
    """The loading curves and both branches of the loop at the same torques, as columns.

    Parameters
    ----------
    curve : Windup
        Curves.

    Returns
    -------
    dict
        Name, with the unit at its end → array of shape (n,).
    """
    return {
        "torque_Nm": curve.torque,
        "loading_angle_rad": curve.angle,
        "incremental_stiffness_Nm_per_rad": curve.stiffness,
        "unloading_angle_rad": curve.unloading_angle,
        "reloading_angle_rad": curve.reloading_angle,
    }
