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


def force_size(found: Document, components: Sequence[float]) -> float:
    """Size of a force on a member; that of rounding, beside the preloads, is none.

    Parameters
    ----------
    found : dict
        :func:`branch_document`.
    components : sequence of float
        Components of the force [N].

    Returns
    -------
    float
        Its size [N].
    """
    size, largest = math.hypot(*components), max(entry["preload_N"] for entry in found["branches"])
    return size if size > _ROUNDING * largest else 0.0


def branch_document(found: UnequalBranches) -> Document:
    """What unequal branches do to a joint, in SI units."""
    sizes = found.sizes
    support, life = sizes.sun_support_stiffness, least_life(found)
    document: Document = {
        "branch_is": found.noun,
        "note": equal_branches_note(found),
        "sun_support_stiffness_N_per_m": support if math.isfinite(support) else None,
        "branches": [
            {
                **{f"{name}_deviation_m": float(each[index]) for name, each in sizes.deviations.items()},
                "interference_m": float(found.interference[index]),
                "preload_N": float(found.preload[index]),
                "preload_over_equal_branches": float(found.preload[index]) / found.own_preload,
            }
            for index in range(found.preload.size)
        ],
        "without_torque": {"sun": _sun(found.rest), **_others(found.rest)},
        "standing": _state(found.standing, found.contact_names),
        "rolling": _state(found.rolling, found.contact_names),
        "life_hours_like_the_worst_branch": life if math.isfinite(life) else None,
        "torque_capacity": _capacity(found.capacity),
        "rolling_torque_capacity": _capacity(found.rolling_capacity),
    }
    if found.turning is not None:
        slipping = slipping_in_rolling(found)
        document["turning"] = {"unknown_because": [slipping] if slipping else [], **_turning(found.turning)}
    if found.stiffness is not None:
        document["output_stiffness_Nm_per_rad"] = found.stiffness if math.isfinite(found.stiffness) else None
    return document


def deviations(found: Document) -> dict[str, str]:
    """Keys of the deviations of each branch, and their names in words.

    Parameters
    ----------
    found : dict
        As :func:`asperity.results.branch_document.branch_document` makes it.

    Returns
    -------
    dict
        In the order of the document.
    """
    ending = "_deviation_m"
    return {
        key: key.removesuffix(ending).replace("_", " ")
        for key in found["branches"][0]
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


def _turning(found: BranchRolling) -> Document:
    """Drift and powers of all branches together, with the names that equal ones have."""
    power = found.power
    causes = {name: float(np.sum(getattr(power, name))) for name in ("creep", "skew", "hysteresis", "oil")}
    return {
        "speed_loss": _number(found.speed_loss),
        "drift_rad_per_output_turn": _number(found.drift_per_output_turn),
        "drift_rad_per_hour": _number(3600.0 * found.drift_rate),
        "output_speed_rad_per_s": _number(found.output_speed),
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
