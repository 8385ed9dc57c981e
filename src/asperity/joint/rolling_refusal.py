"""One joint that is to roll: up to which torque it does, by the program that solved it, and the refusal beyond."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Callable

import jax
import numpy as np

from asperity.errors import NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.evaluated import rolling_of
from asperity.joint.rolling import RollingResult
from asperity.joint.rolling_document import unknown_because
from asperity.joint.solve import Solution
from asperity.units import format_quantity

_LEAST = 0.5**30  # the capacity to 1e-9 of that at rest
_FURTHER = 8.0  # times as far from the guess, after a torque that took off less than a half
_POINTS = 3  # through which a parabola is drawn
_MISSES = 3  # of these in a row, and the interval is halved


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
    at_rest = solution.reverse_capacity if direction < 0.0 else solution.capacity

    rolling = rolling_of(numbers)

    def slip(torque: float) -> float:
        return _worst_slip(
            rolling(dataclasses.replace(numbers, output_torque=np.float64(direction * torque)))
        )

    own, ratio = direction * float(joint.output_torque), _worst_slip(solution.result.rolling)
    known = (own, ratio) if own > 0.0 and 0.0 < ratio < 1.0 else None
    return _largest(slip, float(at_rest.output_torque), known)


def _worst_slip(rolling: RollingResult) -> float:
    """Slip ratio of the worst contact in rolling; nan where the joint does not roll."""
    ratio = float(np.max(np.asarray(rolling.slip_ratio)))
    return ratio if np.isfinite(np.asarray(rolling.residual)) else math.nan


def _largest(
    slip: Callable[[float], float], at_rest: float, known: tuple[float, float] | None = None
) -> float:
    """The largest torque that rolls; the states form one interval from 0.

    Parameters
    ----------
    slip : callable
        Slip ratio of the worst contact under a torque; from 1 on it does not roll, nor where the ratio is nan.
    at_rest : float
        The torque that it is below.
    known : tuple of float, optional
        A torque that rolls, and its slip ratio.

    Notes
    -----
    The slip ratios of the torques that roll are extended to 1, and torques a little below and above that enclose the
    end. Where that is beyond the capacity at rest, or no torque is known that rolls, the joint may roll up to nearly
    that capacity, which is tried first.
    """
    if not math.isfinite(at_rest):
        return at_rest
    least = at_rest * _LEAST
    low, high, misses = 0.0, at_rest, 0
    rolled = [(0.0, 0.0)]  # a guess: no torque, no slip
    torque = at_rest - 0.9 * least
    if known is not None and known[0] < torque:
        low = known[0]
        rolled.append(known)
        torque = _next(rolled, low, high, 0.45 * least, misses, open_end=True)
    while high - low > least:
        width = high - low
        ratio = slip(torque)
        if ratio < 1.0:
            low = torque
            rolled.append((torque, ratio))
        else:
            high = torque
        misses = misses + 1 if high - low > 0.6 * width else 0
        torque = _next(rolled, low, high, 0.45 * least, misses, open_end=high == at_rest)
    return low


def _next(
    rolled: list[tuple[float, float]], low: float, high: float, error: float, misses: int, *, open_end: bool
) -> float:
    """The torque to try between one that rolls and one that does not, or is the open end of what may roll."""
    guess, off = _extended(rolled[-_POINTS:])
    margin = (error + off) * _FURTHER**misses
    if misses < _MISSES and low < guess < high + margin:
        for torque in (guess - margin, guess + margin):
            if low + 0.5 * error < torque < high:
                return torque
    if open_end and guess >= high:
        return high - 2.0 * error
    return 0.5 * (low + high)


def _extended(rolled: list[tuple[float, float]]) -> tuple[float, float]:
    """Where torques as a polynomial of their slip ratios reach a ratio of 1, and how far that may be off; or nan."""
    if any(two[1] <= one[1] for one, two in itertools.pairwise(rolled)):
        return math.nan, math.nan
    value = sum(
        torque * math.prod((1.0 - other) / (ratio - other) for _, other in rolled if other != ratio)
        for torque, ratio in rolled
    )
    if len(rolled) < _POINTS:
        return value, 0.0
    return value, 0.02 * abs(value - _extended(rolled[1:])[0])


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
