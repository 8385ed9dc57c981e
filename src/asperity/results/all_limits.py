"""All limits of one solved joint: those of its results, of unequal branches, and of the loads of its duty."""

from __future__ import annotations

import copy
import dataclasses
import math

import numpy as np

from asperity.branches.results import BranchState
from asperity.results import RESULTS, Limit, Result
from asperity.results.branch_limits import branch_checks
from asperity.results.drive_table import results_of_joint
from asperity.results.limit_check import LimitCheck, checked_limits
from asperity.results.required_life import life_checks
from asperity.results.solved import SolvedJoint
from asperity.rolling.conditions import DutyPoint
from asperity.unit_table import Dimension
from asperity.units import format_quantity


def all_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Every limit of one solved joint."""
    return checked_limits(solved) + further_checks(solved)


def further_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """The limits of one solved joint that are not those of a result."""
    found: tuple[LimitCheck, ...] = ()
    if solved.branches is not None:
        found = branch_checks(solved.branches, turns=float(solved.joint.sun_speed) != 0.0)
    return found + _duty_checks(solved) + life_checks(solved)


def _duty_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """That the joint carries every load of its duty, and that none makes its surfaces flow or breaks its rims."""
    joint, branches = solved.joint, solved.branches
    if not joint.rolling.duty:
        return ()
    pressure = np.asarray(solved.result.rolling.duty_shakedown_ratios)
    ratios = np.asarray(solved.result.rolling.duty_slip_ratios)
    stuck = [_equal_slip(solved, *each) for each in zip(joint.rolling.duty, ratios, strict=True)]
    if branches is not None and branches.duty:
        pressure = np.array([_worst(each) for each in branches.duty])
        stuck = [each is None or _slips(each) for each in branches.duty]
    loads = [
        f"load {number}, {format_quantity(float(point.output_torque), 'N*m')} with the {joint.ends[0]} at "
        f"{format_quantity(float(point.sun_speed), 'rpm')}"
        for number, point in enumerate(joint.rolling.duty, start=1)
    ]
    without = [load for load, sticks in zip(loads, stuck, strict=True) if sticks]
    found = [LimitCheck(_not_carried(without), None, float(len(without)))]
    if not np.all(np.isnan(pressure)):
        known = RESULTS["shakedown_ratio"]
        row = dataclasses.replace(
            known, name="duty_shakedown_ratio", label=f"{known.label}, worst load of the duty"
        )
        found.append(LimitCheck(row, f"load {1 + int(np.nanargmax(pressure))}", float(np.nanmax(pressure))))
    return (*found, *_duty_rims(solved, stuck))


def _duty_rims(solved: SolvedJoint, stuck: list[bool]) -> list[LimitCheck]:
    """That the rims of rings and hollow rollers bear every load of the duty that the joint carries."""
    worst: dict[tuple[str, str], LimitCheck] = {}
    rows = [row for row in results_of_joint(solved).values() if row.limit is not None and row.of_rims]
    if not any(row.rows_of(solved) for row in rows):
        return []
    for number, (rims, sticks) in enumerate(zip(solved.duty_rims, stuck, strict=True), start=1):
        if sticks:
            continue
        under = copy.copy(solved)
        under.rims = rims
        for row in rows:
            for place, value in row.rows_of(under).items():
                known = worst.get((row.name, place))
                if math.isnan(value) or (known is not None and known.value <= value):
                    continue
                duty = dataclasses.replace(
                    row, name=f"duty_{row.name}", label=f"{row.label}, worst load of the duty"
                )
                where = f"{place}, load {number}" if place else f"load {number}"
                worst[row.name, place] = LimitCheck(duty, where, value)
    return list(worst.values())


def _equal_slip(solved: SolvedJoint, point: DutyPoint, slip_ratio: float) -> bool:
    """Whether equal branches do not carry a load: in rolling, or standing where the input stands."""
    if float(point.sun_speed) > 0.0:
        return not slip_ratio < 1.0
    torque = float(point.output_torque)
    capacity = solved.reverse_capacity if torque < 0.0 else solved.capacity
    return not abs(torque) < float(capacity.output_torque)


def _worst(state: BranchState | None) -> float:
    """Hertz pressure over shakedown limit where it is largest; nan without a state, or in one that stands."""
    if state is None or "shakedown_ratio" not in state.limits:
        return math.nan
    return float(np.nanmax(state.limits["shakedown_ratio"]))


def _slips(state: BranchState) -> bool:
    """Whether a contact of a joint that turns slips as a whole."""
    return "shakedown_ratio" in state.limits and not np.nanmax(state.slip_ratio) < 1.0


def _not_carried(loads: list[str]) -> Result:
    """How many loads of a duty the joint does not carry, with its limit."""
    return Result(
        "duty_loads_not_carried",
        "loads of the duty that the joint does not carry",
        Dimension.DIMENSIONLESS,
        "1",
        "duty_loads_not_carried",
        limit=Limit(
            "function",
            "the joint carries every load of its duty without gross slip",
            f"not carried: {'; '.join(loads)}; a contact slips as a whole or lifts off, or the load is beyond what is "
            "computed, and the life under the duty does not hold",
            "lower these loads below the torque capacity, in rolling where the joint turns, or raise the capacity by "
            "what its limit asks for",
            highest=0.0,
            inclusive=True,
        ),
    )
