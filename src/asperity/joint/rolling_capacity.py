"""The largest torque under which a joint can roll."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import jax
import numpy as np

from asperity.compilation import compile_fast
from asperity.errors import NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.rolling_document import unknown_because
from asperity.joint.solve import Solution, solve_program
from asperity.units import format_quantity

_HALVINGS = 40


def rolling_torque_capacity(joint: Joint, solution: Solution) -> float:
    """Largest output torque under which a joint has a steady rolling state.

    Parameters
    ----------
    joint : Joint
        One joint.
    solution : Solution
        What it does at rest.

    Returns
    -------
    float
        At most the capacity at rest, which it is below where equal creep on both sides of a planet loads the weaker
        side more; infinite or nan where the capacity at rest is [N·m].
    """
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    program = compile_fast(solve_program, numbers)

    def rolls(torque: float) -> bool:
        result, *_ = program(dataclasses.replace(numbers, output_torque=np.float64(torque)))
        return bool(np.isfinite(np.asarray(result.rolling.residual)))

    return _largest(rolls, float(solution.capacity.output_torque))


def _largest(rolls: Callable[[float], bool], at_rest: float) -> float:
    """The largest torque that rolls, by halving; the states form one interval from 0."""
    if not math.isfinite(at_rest):
        return at_rest
    low, high = 0.0, at_rest
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if rolls(middle) else (low, middle)
    return low


def refuse_no_rolling(joint: Joint, solution: Solution, capacity: float) -> None:
    """Refuse a joint that stands but has no steady rolling state.

    Parameters
    ----------
    joint : Joint
        One joint.
    solution : Solution
        What it does at rest.
    capacity : float
        Its torque capacity in rolling [N·m].

    Raises
    ------
    NoSolutionError
        With the reason, and the capacity.
    """
    if np.isfinite(np.asarray(solution.result.rolling.residual)):
        return
    reasons = "; ".join(unknown_because(joint, solution.result))
    torque = format_quantity(float(joint.output_torque), "N*m")
    known = (
        f"the joint rolls up to {format_quantity(capacity, 'N*m')}" if capacity > 0.0 else "it never rolls"
    )
    raise NoSolutionError(
        f"{reasons}: the output torque is {torque}, {known}; lower the torque or the skew, or raise the preload or the "
        "friction coefficient"
    )
