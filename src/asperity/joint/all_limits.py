"""All limits of one solved joint: those of its results, of unequal branches, and of the loads of its duty."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from asperity.joint.branch_limits import branch_checks
from asperity.joint.branch_results import BranchState
from asperity.joint.limit_check import LimitCheck, checked_limits
from asperity.joint.results import RESULTS, Limit, Result, SolvedJoint
from asperity.unit_table import Dimension
from asperity.units import format_quantity


def all_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Every limit of one solved joint.

    Parameters
    ----------
    solved : SolvedJoint
        One joint, without batch axes.

    Returns
    -------
    tuple of LimitCheck
        Those of its results, the most serious first, then :func:`further_checks`.
    """
    return checked_limits(solved) + further_checks(solved)


def further_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """The limits of one solved joint that are not those of a result.

    Parameters
    ----------
    solved : SolvedJoint
        One joint, without batch axes.

    Returns
    -------
    tuple of LimitCheck
        Of unequal branches, if it has some, and of the loads of its duty, if it has one.
    """
    found: tuple[LimitCheck, ...] = ()
    if solved.branches is not None:
        found = branch_checks(solved.branches, turns=float(solved.joint.sun_speed) != 0.0)
    return found + _duty_checks(solved)


def _duty_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """That the joint rolls under every load of its duty, and that none makes its surfaces flow."""
    joint, branches = solved.joint, solved.branches
    if not joint.rolling.duty:
        return ()
    pressure = np.asarray(solved.result.rolling.duty_shakedown_ratios)
    stuck = list(np.isnan(pressure))
    if branches is not None and branches.duty:
        pressure = np.array([_worst(each) for each in branches.duty])
        stuck = [each is None for each in branches.duty]
    loads = [
        f"load {number}, {format_quantity(float(point.output_torque), 'N*m')} with the {joint.ends[0]} at "
        f"{format_quantity(float(point.sun_speed), 'rpm')}"
        for number, point in enumerate(joint.rolling.duty, start=1)
    ]
    without = [load for load, sticks in zip(loads, stuck, strict=True) if sticks]
    found = [LimitCheck(_without_rolling(without), None, float(len(without)))]
    if not np.all(np.isnan(pressure)):
        known = RESULTS["shakedown_ratio"]
        row = dataclasses.replace(
            known, name="duty_shakedown_ratio", label=f"{known.label}, worst load of the duty"
        )
        found.append(LimitCheck(row, f"load {1 + int(np.nanargmax(pressure))}", float(np.nanmax(pressure))))
    return tuple(found)


def _worst(state: BranchState | None) -> float:
    """Hertz pressure over shakedown limit where it is largest; nan without a state, or in one that stands."""
    if state is None or "shakedown_ratio" not in state.limits:
        return math.nan
    return float(np.nanmax(state.limits["shakedown_ratio"]))


def _without_rolling(loads: list[str]) -> Result:
    """How many loads of a duty do not let the joint roll, with its limit."""
    return Result(
        "duty_loads_without_rolling",
        "loads of the duty under which the joint does not roll",
        Dimension.DIMENSIONLESS,
        "1",
        "duty_loads_without_rolling",
        limit=Limit(
            "function",
            "the joint rolls under every load of its duty",
            f"no steady rolling under {'; '.join(loads)}: a contact slips or lifts off, and there is no life under the "
            "duty",
            "lower these loads, or raise the preload or the friction coefficient",
            highest=0.0,
            inclusive=True,
        ),
    )
