"""Unequal branches of a joint as a part of its JSON document."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from asperity.joint.branch_results import BranchCapacity, BranchState, UnequalBranches
from asperity.joint.branch_sizes import BranchSizes

Document = dict[str, Any]


def branch_document(found: UnequalBranches, sizes: BranchSizes) -> Document:
    """What unequal branches do to a joint, in SI units.

    Parameters
    ----------
    found : UnequalBranches
        What was found.
    sizes : BranchSizes
        Sizes of the branches.

    Returns
    -------
    dict
        Nested tables; None where there is no number.
    """
    support = sizes.sun_support_stiffness
    return {
        "sun_support_stiffness_N_per_m": support if math.isfinite(support) else None,
        "branches": [
            {
                "planet_deviation_m": float(sizes.planet[index]),
                "right_roller_deviation_m": float(sizes.right_roller[index]),
                "left_roller_deviation_m": float(sizes.left_roller[index]),
                "interference_m": float(found.interference[index]),
                "preload_N": float(found.preload[index]),
            }
            for index in range(sizes.planet.size)
        ],
        "without_torque": {"sun": _sun(found.rest)},
        "standing": _state(found.standing),
        "rolling": _state(found.rolling),
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
        "share": [float(each) for each in state.share],
        "preload_N": [float(each) for each in state.preload],
        "slip_ratio": [None if np.isnan(each) else float(each) for each in state.slip_ratio],
        "sun": _sun(state),
    }


def _capacity(capacity: BranchCapacity) -> Document:
    return {
        "first_slip_Nm": capacity.first_slip,
        "first_branch": capacity.branch + 1,
        "first_contact": capacity.contact_name,
        "all_slip_Nm": capacity.all_slip,
        "equal_branches_Nm": capacity.equal,
    }
