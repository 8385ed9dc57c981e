"""Unequal branches of a joint as a part of its JSON document."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from asperity.branches.branches import AssembledBranches
from asperity.branches.results import BranchState, UnequalBranches, unequal_branches
from asperity.joint.solve import Solution
from asperity.joint.torque_limits import TorqueCapacity, limit_words
from asperity.types import Document

_ROUNDING = 1e-11  # of forces relative to the preloads
_EVEN = 1e-9  # relative difference of preloads up to which branches are alike


def force_size(branches: Document, components: Sequence[float]) -> float:
    """Size of a force on a member by its components [N]; that of rounding, beside the preloads, is none."""
    size, largest = math.hypot(*components), max(entry["preload_N"] for entry in branches["branches"])
    return size if size > _ROUNDING * largest else 0.0


def branch_document(branches: AssembledBranches, solution: Solution) -> Document:
    """What unequal branches do to a joint, in SI units."""
    unequal, result = unequal_branches(branches, solution.states), solution.result
    reverse, sizes = float(branches.joint.output_torque) < 0.0, unequal.sizes
    support = sizes.input_support_stiffness
    first, last, rolling = (
        (solution.reverse_first_slip, solution.reverse_standing_capacity, solution.reverse_rolling_capacity)
        if reverse
        else (solution.first_slip, solution.standing_capacity, solution.rolling_capacity)
    )
    return {
        "branch_is": unequal.noun,
        "note": _note(unequal),
        "sun_support_stiffness_N_per_m": support if math.isfinite(support) else None,
        "branches": [
            {
                **{f"{name}_deviation_m": float(values[index]) for name, values in sizes.deviations.items()},
                "interference_m": float(unequal.interference[index]),
                "preload_N": float(unequal.preload[index]),
                "preload_over_equal_branches": float(unequal.preload[index]) / unequal.equal_preload,
            }
            for index in range(unequal.preload.size)
        ],
        "without_torque": _sums(unequal.rest),
        "standing": _state(unequal.standing, result.diagnostics.slip_ratio),
        "rolling": _state(unequal.rolling, result.rolling.slip_ratio),
        "standing_torque_capacity": _capacity(branches, first) | {"all_slip_Nm": _number(last.output_torque)},
        "rolling_torque_capacity": _capacity(branches, rolling),
    }


def _note(unequal: UnequalBranches) -> str:
    """How much harder the most loaded branch is pressed than equal ones, in words."""
    hardest = int(np.argmax(unequal.preload))
    ratio, what = unequal.preload[hardest] / unequal.equal_preload, f"{unequal.noun} {hardest + 1}"
    if np.ptp(unequal.preload) <= _EVEN * unequal.preload[hardest]:
        what = f"every {unequal.noun}"
    return (
        f"All numbers are those of these branches, contact by contact: {what} is pressed {ratio:.3g} times as hard "
        "as equal ones."
    )


def deviations(branches: Document) -> dict[str, str]:
    """Keys of the deviations of each branch, and their names in words, in the order of the document."""
    ending = "_deviation_m"
    return {
        key: key.removesuffix(ending).replace("_", " ")
        for key in branches["branches"][0]
        if key.endswith(ending)
    }


def _sums(state: BranchState) -> Document:
    """Forces on the members on the axis; the displacement of the input."""
    forces = {name: list(map(float, force)) for name, force in state.centre_forces.items()}
    return {
        "sun": {
            "displacement_m": list(map(float, state.central_displacement)),
            "force_N": list(map(float, state.central_force)),
        },
        **({"central_forces_N": forces} if forces else {}),
    }


def _state(state: BranchState | None, slip_ratio: Any) -> Document | None:
    if state is None:
        return None
    worst = np.asarray(slip_ratio).reshape(state.torque.size, -1).max(axis=1)
    return {
        "share": _numbers(state.share),
        "slip_ratio": _numbers(worst),
        **_sums(state),
        "input_torque_Nm": _number(state.input_torque),
        "torques_Nm": {name: _number(torque) for name, torque in state.torques.items()},
    }


def _number(value: Any) -> float | None:
    number = float(value)
    return number if math.isfinite(number) else None


def _numbers(values: np.ndarray) -> list[float | None]:
    return [_number(value) for value in values]


def _capacity(branches: AssembledBranches, first: TorqueCapacity) -> Document:
    """The first limit of a contact: its torque, branch and contact; None where it is not that of a contact."""
    names, number = branches.equal.contact_names, int(first.limiting_contact)
    branch, contact = divmod(number, len(names))
    known = number < len(branches.joint.contact_names)
    return {
        "first_slip_Nm": _number(first.output_torque),
        "first_branch": branch + 1 if known else None,
        "first_contact": names[contact] if known else None,
        "first_event": limit_words(first, contacts=branches.joint.contact_names),
    }
