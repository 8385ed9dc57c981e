"""Unequal branches of a joint as a part of its JSON document."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.branch_limits import equal_branches_note, least_life
from asperity.joint.branch_results import BranchCapacity, BranchState, UnequalBranches

Document = dict[str, Any]


def branch_document(found: UnequalBranches) -> Document:
    """What unequal branches do to a joint, in SI units.

    Parameters
    ----------
    found : UnequalBranches
        What was found.

    Returns
    -------
    dict
        Nested tables; None where there is no number.
    """
    sizes = found.sizes
    support, life = sizes.sun_support_stiffness, least_life(found)
    return {
        "note": equal_branches_note(found),
        "sun_support_stiffness_N_per_m": support if math.isfinite(support) else None,
        "branches": [
            {
                "planet_deviation_m": float(sizes.planet[index]),
                "right_roller_deviation_m": float(sizes.right_roller[index]),
                "left_roller_deviation_m": float(sizes.left_roller[index]),
                "interference_m": float(found.interference[index]),
                "preload_N": float(found.preload[index]),
                "preload_over_equal_branches": float(found.preload[index]) / found.own_preload,
            }
            for index in range(sizes.planet.size)
        ],
        "without_torque": {"sun": _sun(found.rest)},
        "standing": _state(found.standing),
        "rolling": _state(found.rolling),
        "life_hours_like_the_worst_branch": life if math.isfinite(life) else None,
        "torque_capacity": _capacity(found.capacity),
        "rolling_torque_capacity": _capacity(found.rolling_capacity),
    }


def _sun(state: BranchState) -> Document:
    return {
        "displacement_m": [float(each) for each in state.sun_displacement],
        "force_N": [float(each) for each in state.sun_force],
    }


def _state(state: BranchState | None) -> Document | None:
    if state is None:
        return None
    return {
        "share": _numbers(state.share),
        "preload_N": [float(each) for each in state.preload],
        "slip_ratio": _numbers(state.slip_ratio),
        "contacts": {
            name: {
                limit: _numbers(values[index])
                for limit, values in state.limits.items()
                if np.ndim(values) == 2
            }
            for index, name in enumerate(CONTACT_NAMES)
        },
        "sun": _sun(state),
    }


def _numbers(values: np.ndarray) -> list[float | None]:
    return [float(each) if math.isfinite(each) else None for each in values]


def _capacity(capacity: BranchCapacity) -> Document:
    return {
        "first_slip_Nm": capacity.first_slip,
        "first_branch": capacity.branch + 1,
        "first_contact": capacity.contact_name,
        "all_slip_Nm": capacity.all_slip,
        "equal_branches_Nm": capacity.equal,
    }
