"""What a joint does with equal branches, also where only its own, of unlike sizes, carry the torque."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import equinox as eqx
import jax
import numpy as np

from asperity.branches.results import UnequalBranches
from asperity.drive.stiffness.torsional_stiffness import TorsionalStiffness
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.solve import Solution, solve_joint

_SHARE = 0.9  # of the torque that equal branches carry
_UNDER_TORQUE = (
    "contacts",
    "contact_torsional_stiffness",
    "interfaces",
    "published",
    "series_with_bulk",
    "assembly",
    "diagnostics",
    "rolling",
    "forces",
)


def solve_equal_branches(joint: Joint) -> tuple[Solution, bool]:
    """What a joint does with equal branches, where it may have others that carry more.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    solution : Solution
        What it does; under a smaller torque where equal branches do not carry its own.
    carries : bool
        Whether equal branches carry its own torque.

    Raises
    ------
    InputError, NoSolutionError
        As :func:`asperity.joint.solve.solve_joint`, if the reason is not the size of the torque.
    """
    torque = float(joint.output_torque)
    try:
        return solve_joint(joint), True
    except (InputError, NoSolutionError) as refusal:
        try:
            free = solve_joint(dataclasses.replace(joint, output_torque=0.0))
        except (InputError, NoSolutionError):
            raise refusal from None
        limit = float((free.reverse_capacity if torque < 0.0 else free.capacity).output_torque)
        if not limit <= abs(torque):
            raise
    return solve_joint(dataclasses.replace(joint, output_torque=math.copysign(_SHARE * limit, torque))), False


def without_state(solution: Solution, output_torque: float, own: UnequalBranches) -> Solution:
    """A solution of equal branches under a torque that only a joint's own branches carry."""

    def unknown(leaf: Any) -> Any:
        array = np.asarray(leaf)
        return np.full_like(array, np.nan) if np.issubdtype(array.dtype, np.floating) else array

    def under_torque(each: Any) -> tuple[Any, ...]:
        return tuple(getattr(each.result, name) for name in _UNDER_TORQUE)

    masked = [jax.tree.map(unknown, part) for part in under_torque(solution)]
    masked[-1] = dataclasses.replace(masked[-1], output_torque=np.asarray(output_torque, dtype=float))
    empty: Solution = eqx.tree_at(under_torque, solution, masked)
    empty = eqx.tree_at(lambda each: each.result.solved, empty, np.asarray(False))
    return _with_sums(empty, own)


def _with_sums(empty: Solution, own: UnequalBranches) -> Solution:
    """With what all branches of a joint do together, whatever each of them does."""
    if own.standing is not None:
        torque = np.asarray(own.standing.input_torque)
        empty = eqx.tree_at(lambda each: each.result.forces.input_torque, empty, torque)
    if own.stiffness is not None:
        squared = float(empty.result.speed_ratio) ** 2
        whole = TorsionalStiffness(sun=own.stiffness / squared, output=own.stiffness)
        empty = eqx.tree_at(lambda each: each.result.assembly.stiffness, empty, whole)
    if own.turning is not None:
        names = [field.name for field in dataclasses.fields(own.turning)]
        sums = tuple(jax.tree.map(np.asarray, getattr(own.turning, name)) for name in names)
        empty = eqx.tree_at(
            lambda each: tuple(getattr(each.result.rolling, name) for name in names), empty, sums
        )
    return empty
