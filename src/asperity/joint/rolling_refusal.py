"""One joint that is to roll: up to which torque it does, by the program that solved it, and the refusal beyond."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import jax
import numpy as np

from asperity.compilation import compile_fast
from asperity.errors import NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.evaluation import evaluate
from asperity.joint.rolling_document import unknown_because
from asperity.joint.solve import Solution
from asperity.units import format_quantity

_HALVINGS = 30  # the capacity to 1e-9 of that at rest
#: Most joints roll up to nearly their capacity at rest: shares 2^-k below it that are tried first.
_NEAR_THE_END = (30, 20, 10)


def rolling_capacity_of(joint: Joint, solution: Solution, *, direction: float) -> float:
    """Torque capacity in rolling of one solved joint.

    The same number as the smaller of :func:`asperity.joint.rolling_capacity.rolling_torque_capacity` and the capacity
    at rest, by the program that is compiled already.

    Parameters
    ----------
    joint : Joint
        One joint.
    solution : Solution
        What it does at rest.
    direction : float
        +1 for positive torques, −1 for negative ones [-].

    Returns
    -------
    float
        A positive torque [N·m], at most the capacity at rest, which it is below where equal creep on both sides of a
        planet loads the weaker side more; infinite or nan where the capacity at rest is.
    """
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    program = compile_fast(evaluate, numbers)
    at_rest = solution.reverse_capacity if direction < 0.0 else solution.capacity

    def rolls(torque: float) -> bool:
        result = program(dataclasses.replace(numbers, output_torque=np.float64(direction * torque)))
        rolling = result.rolling
        return bool(
            np.isfinite(np.asarray(rolling.residual)) and np.all(np.asarray(rolling.slip_ratio) < 1.0)
        )

    return _largest(rolls, float(at_rest.output_torque))


def _largest(rolls: Callable[[float], bool], at_rest: float) -> float:
    """The largest torque that rolls, by halving; the states form one interval from 0."""
    if not math.isfinite(at_rest):
        return at_rest
    low, high = 0.0, at_rest
    for power in _NEAR_THE_END:
        edge = at_rest * (1.0 - 0.5**power)
        if rolls(edge):
            low = edge
            break
        high = edge
    while high - low > at_rest * 0.5**_HALVINGS:
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
        Its torque capacity in rolling, in the direction of its torque [N·m].

    Raises
    ------
    NoSolutionError
        With the reason, and the capacity.
    """
    if np.isfinite(np.asarray(solution.result.rolling.residual)):
        return
    reasons = "; ".join(unknown_because(joint, solution.result))
    own = float(joint.output_torque)
    torque, limit = (format_quantity(value, "N*m") for value in (own, math.copysign(capacity, own)))
    known = f"the joint rolls up to {limit}" if capacity > 0.0 else "it never rolls"
    raise NoSolutionError(
        f"{reasons}: the output torque is {torque}, {known}; lower the torque or the skew, or raise the preload or the "
        "friction coefficient"
    )
