"""The wind-up of a joint that is going to be reported: refused beyond the capacity, and as one JSON document."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

from asperity.drive.capacity import TorqueCapacity
from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint import windup as loading
from asperity.joint.description import Joint
from asperity.joint.solve import solve
from asperity.joint.windup import StiffnessLevel, Windup


def examined_windup(
    joint: Joint,
    *,
    largest_torque: float | None,
    level: StiffnessLevel,
    stage_shares: tuple[float, float],
) -> tuple[Windup, TorqueCapacity]:
    """Wind-up of a joint, and its torque capacity.

    Parameters
    ----------
    joint : Joint
        One joint.
    largest_torque : float or None
        Largest torque of the curve [N·m]; None for the joint's own output torque.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness is integrated.
    stage_shares : tuple of float
        Bounds of the stages as shares of the largest torque [-].

    Returns
    -------
    tuple
        Curves and their figures; torque capacity.

    Raises
    ------
    InputError
        If the rollers do not fit, or the torque or the stages are out of range.
    NoSolutionError
        If the force balance does not close.
    """
    largest = float(joint.output_torque) if largest_torque is None else largest_torque
    joint = dataclasses.replace(joint, output_torque=largest)
    capacity = solve(joint).capacity  # refuses rollers that do not fit and a torque beyond the capacity
    return loading.windup(joint, largest_torque=largest, level=level, stage_shares=stage_shares), capacity


def windup_document(curve: Windup, capacity: TorqueCapacity, *, level: StiffnessLevel) -> dict[str, Any]:
    """The figures of a wind-up in SI units, ready for :func:`json.dumps`.

    Parameters
    ----------
    curve : Windup
        Curves and figures.
    capacity : TorqueCapacity
        Torque capacity of the joint.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness was integrated.

    Returns
    -------
    dict
        The unit at the end of every key; None where friction does not limit the torque.
    """
    limit = float(capacity.output_torque)
    finite = math.isfinite(limit)
    return {
        "level": level,
        "torque_capacity_Nm": limit if finite else None,
        "limiting_contact": CONTACT_NAMES[int(capacity.limiting_contact)] if finite else None,
        "largest_torque_Nm": float(curve.torque[-1]),
        "windup_rad": float(curve.angle[-1]),
        "hysteresis_rad": float(curve.hysteresis),
        "lost_motion_rad": float(curve.lost_motion),
        "dissipated_energy_J": float(curve.dissipated_energy),
        "stages": [
            {
                "name": f"K{index + 1}",
                "from_Nm": float(curve.stage_torque[index]),
                "to_Nm": float(curve.stage_torque[index + 1]),
                "stiffness_Nm_per_rad": float(curve.stage_stiffness[index]),
            }
            for index in range(3)
        ],
    }


def windup_columns(curve: Windup) -> dict[str, Any]:
    """The loading curve and both branches of the loop as columns, with the unit at the end of their names.

    Parameters
    ----------
    curve : Windup
        Curves.

    Returns
    -------
    dict
        Name → array of shape (n,).
    """
    return {
        "loading_torque_Nm": curve.torque,
        "loading_angle_rad": curve.angle,
        "incremental_stiffness_Nm_per_rad": curve.stiffness,
        "loop_torque_Nm": curve.loop_torque,
        "unloading_angle_rad": curve.unloading_angle,
        "reloading_angle_rad": curve.reloading_angle,
    }
