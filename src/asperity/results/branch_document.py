"""Unequal branches of a joint as a part of its JSON document."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from asperity.branches.results import BranchCapacity, BranchRolling, BranchState, UnequalBranches
from asperity.results.branch_limits import equal_branches_note, least_life, slipping_in_rolling

Document = dict[str, Any]

_ROUNDING = 1e-11  # of forces relative to the preloads


def force_size(branches: Document, components: Sequence[float]) -> float:
    """Size of a force on a member; that of rounding, beside the preloads, is none.

    Parameters
    ----------
    branches : dict
        :func:`branch_document`.
    components : sequence of float
        Components of the force [N].

    Returns
    -------
    float
        Its size [N].
    """
    size, largest = math.hypot(*components), max(entry["preload_N"] for entry in branches["branches"])
    return size if size > _ROUNDING * largest else 0.0


def branch_document(branches: UnequalBranches) -> Document:
    """What unequal branches do to a joint, in SI units."""
    sizes = branches.sizes
    support, life = sizes.sun_support_stiffness, least_life(branches)
    document: Document = {
        "branch_is": branches.noun,
        "note": equal_branches_note(branches),
        "sun_support_stiffness_N_per_m": support if math.isfinite(support) else None,
        "branches": [
            {
                **{f"{name}_deviation_m": float(each[index]) for name, each in sizes.deviations.items()},
                "interference_m": float(branches.interference[index]),
                "preload_N": float(branches.preload[index]),
                "preload_over_equal_branches": float(branches.preload[index]) / branches.own_preload,
            }
            for index in range(branches.preload.size)
        ],
        "without_torque": {"sun": _sun(branches.rest), **_others(branches.rest)},
        "standing": _state(branches.standing, branches.contact_names),
        "rolling": _state(branches.rolling, branches.contact_names),
        "life_hours_like_the_worst_branch": life if math.isfinite(life) else None,
        "torque_capacity": _capacity(branches.capacity),
        "rolling_torque_capacity": _capacity(branches.rolling_capacity),
    }
    if branches.turning is not None:
        slipping = slipping_in_rolling(branches)
        document["turning"] = {
            "unknown_because": [slipping] if slipping else [],
            **_turning(branches.turning),
        }
    if branches.stiffness is not None:
        document["output_stiffness_Nm_per_rad"] = (
            branches.stiffness if math.isfinite(branches.stiffness) else None
        )
    return document


def deviations(branches: Document) -> dict[str, str]:
    """Keys of the deviations of each branch, and their names in words.

    Parameters
    ----------
    branches : dict
        As :func:`asperity.results.branch_document.branch_document` makes it.

    Returns
    -------
    dict
        In the order of the document.
    """
    ending = "_deviation_m"
    return {
        key: key.removesuffix(ending).replace("_", " ")
        for key in branches["branches"][0]
        if key.endswith(ending)
    }


def _sun(state: BranchState) -> Document:
    return {
        "displacement_m": [float(each) for each in state.sun_displacement],
        "force_N": [float(each) for each in state.sun_force],
    }


def _others(state: BranchState) -> Document:
    if not state.centre_forces:
        return {}
    return {
        "central_forces_N": {
            name: [float(each) for each in force] for name, force in state.centre_forces.items()
        }
    }


def _state(state: BranchState | None, contacts: tuple[str, ...]) -> Document | None:
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
            for index, name in enumerate(contacts)
        },
        "sun": _sun(state),
        **_others(state),
        "input_torque_Nm": _number(state.input_torque),
        "torques_Nm": {name: _number(torque) for name, torque in state.torques.items()},
        "speeds_rad_per_s": {name: _number(speed) for name, speed in state.speeds.items()},
    }


def _turning(branches: BranchRolling) -> Document:
    """Drift and powers of all branches together, with the names that equal ones have."""
    power = branches.power
    causes = {name: float(np.sum(getattr(power, name))) for name in ("creep", "skew", "hysteresis", "oil")}
    return {
        "speed_loss": _number(branches.speed_loss),
        "drift_rad_per_output_turn": _number(branches.drift_per_output_turn),
        "drift_rad_per_hour": _number(3600.0 * branches.drift_rate),
        "output_speed_rad_per_s": _number(branches.output_speed),
        "efficiency": _number(power.efficiency),
        "input_power_W": _number(power.input),
        "output_power_W": _number(power.output),
        "losses_W": {
            name: _number(loss)
            for name, loss in {**causes, "bearings": power.bearings, "total": power.loss}.items()
        },
    }


def _number(value: Any) -> float | None:
    number = float(value)
    return number if math.isfinite(number) else None


def _numbers(values: np.ndarray) -> list[float | None]:
    return [_number(each) for each in values]


def _capacity(capacity: BranchCapacity) -> Document:
    return {
        "first_slip_Nm": capacity.first_slip,
        "first_branch": capacity.branch + 1,
        "first_contact": capacity.contact_name,
        "first_event": capacity.event,
        "all_slip_Nm": capacity.all_slip if math.isfinite(capacity.all_slip) else None,
        "equal_branches_Nm": capacity.equal,
    }
