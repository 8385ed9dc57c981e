"""All limits of one solved joint: those of its results, of the loads of its duty, and of the life it is to reach."""

from __future__ import annotations

import copy
import dataclasses
import math

import numpy as np

from asperity.contact.life_factor import LEAST_FILM_RATIO
from asperity.engine.arrays import xp
from asperity.results import RESULTS, Limit, Result
from asperity.results.accuracy_rows import accuracy_of_solved
from asperity.results.film_bands import film_band
from asperity.results.limit_check import LimitCheck, checked_limits
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.results.wear_limits import wear_checks
from asperity.rolling.conditions import DutyPoint
from asperity.rolling.document import no_duty_factor_because, no_factor_because
from asperity.types import Array
from asperity.unit_table import Dimension
from asperity.units import format_quantity

_HOUR = 3600.0


def all_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Every limit of one solved joint."""
    return checked_limits(solved) + further_checks(solved)


def further_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """The limits of one solved joint that are not those of a result."""
    return _duty_checks(solved) + life_checks(solved) + turn_checks(solved) + wear_checks(solved)


def _duty_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """That the joint carries every load of its duty, and that none makes its surfaces flow or breaks its rims."""
    joint = solved.joint
    if not joint.rolling.duty:
        return ()
    pressure = np.asarray(solved.result.rolling.duty_shakedown_ratios)
    ratios = np.asarray(solved.result.rolling.duty_slip_ratios)
    stuck = [_does_not_carry(solved, *point) for point in zip(joint.rolling.duty, ratios, strict=True)]
    loads = [
        f"load {number}, {format_quantity(float(point.output_torque), 'N*m')} with the {joint.ends[0]} at "
        f"{format_quantity(float(point.input_speed), 'rpm')}"
        for number, point in enumerate(joint.rolling.duty, start=1)
    ]
    without = [load for load, sticks in zip(loads, stuck, strict=True) if sticks]
    checks = [LimitCheck(_not_carried(without), None, float(len(without)))]
    if not np.all(np.isnan(pressure)):
        known = RESULTS["shakedown_ratio"]
        row = dataclasses.replace(
            known, name="duty_shakedown_ratio", label=f"{known.label}, worst load of the duty"
        )
        checks.append(LimitCheck(row, f"load {1 + int(np.nanargmax(pressure))}", float(np.nanmax(pressure))))
    return (*checks, *_duty_rims(solved, stuck))


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


def _does_not_carry(solved: SolvedJoint, point: DutyPoint, slip_ratio: float) -> bool:
    """Whether the joint does not carry a load: in rolling, or standing where the input stands."""
    if float(point.input_speed) > 0.0:
        return not slip_ratio < 1.0
    torque = float(point.output_torque)
    capacity = solved.reverse_standing_capacity if torque < 0.0 else solved.standing_capacity
    return not abs(torque) < float(capacity.output_torque)


def _not_carried(loads: list[str]) -> Result:
    """Result with its limit for the number of loads of a duty that the joint does not carry."""
    return Result(
        "duty_loads_not_carried",
        "duty loads not carried",
        Dimension.DIMENSIONLESS,
        "1",
        "duty_loads_not_carried",
        limit=Limit(
            "function",
            "every load of the duty is carried without gross slip",
            f"not carried: {'; '.join(loads)}; a contact slips as a whole or lifts off, or the load is beyond what is "
            "computed; there is no life under the duty",
            "lower these loads below the torque capacity (in rolling where the input turns), or raise the capacity",
            highest=0.0,
            inclusive=True,
        ),
    )


def life_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """The lives of the drive and of its rolling bearings, compared with the life that is required; empty without one.

    Under a duty the lives are those under the duty. Without life.cleanliness the life of the drive has no factor for
    the oil film: where the film is not full at every contact, under every load of the duty, the life may be too short,
    but it is never long enough.

    References
    ----------
    Equations (B8), (F6) and (L2) of :doc:`/equations`.
    """
    if solved.required_life is None:
        return ()
    duty = bool(solved.joint.rolling.duty)
    required, less = float(solved.required_life), "lower the preload, the torque or the speed, or"
    unknown = f"no rating life to compare with the required life: {_no_life_because(solved)}"
    missing, life = _no_film_factor(solved), _life_of_drive(solved)
    remedy = f"{less} make rollers larger or contacts longer"
    if missing and life >= required:
        remedy = (
            "state life.cleanliness: the life then has the factor a_ISO of ISO 281 for this film; smoother surfaces "
            "raise λ"
        )
    of_drive = required_life_row("duty_life" if duty else "drive_life", required, remedy, unknown, missing)
    words = "rating life under the duty" if duty else "rating life"
    of_drive = dataclasses.replace(of_drive, label=words)
    of_bearings = results_of_joint(solved)["bearing_duty_life" if duty else "bearing_life"]
    limit = required_life_row(
        of_bearings.name, required, f"{less} choose larger bearings or more of them", unknown
    )
    bearings = (
        LimitCheck(limit, name, value)
        for name, value in of_bearings.rows_of(solved).items()
        if not math.isnan(value)
    )
    return LimitCheck(of_drive, None, life), *bearings


def _no_life_because(solved: SolvedJoint) -> str:
    """Why there is no life of the drive to compare with the one that is required."""
    joint, result = solved.joint, solved.result
    if joint.rolling.duty:
        return no_duty_factor_because(joint, result.rolling) or "a load of the [[duty]] is not carried"
    return no_factor_because(joint, result) or (
        "the joint slips, exceeds the shakedown limit, or stands (speed 0) without a [[duty]]"
    )


def _no_film_factor(solved: SolvedJoint) -> str:
    """What the life of the drive lacks where its oil film is not full; empty where it is full or not known.

    Empty also where lives have the factor, by life.cleanliness.
    """
    rolling = solved.result.rolling
    if solved.joint.rolling.cleanliness is not None:
        return ""
    of_loads = rolling.duty_film_ratios if solved.joint.rolling.duty else rolling.film_ratio
    ratios = np.asarray(of_loads, dtype=float)
    known = ratios[np.isfinite(ratios)]
    if not known.size or film_band(float(known.min())) == "full":
        return ""
    least = float(known.min())
    return f"no film factor, λ {format_quantity(least, '1', 2)}"


def film_too_thin(solved: SolvedJoint) -> Array:
    """Whether lives are to have a factor for the oil film and a film is too thin for one, shape (...)."""
    rolling = solved.result.rolling
    of_loads = rolling.duty_film_ratios if solved.joint.rolling.duty else rolling.film_ratio
    stated = solved.joint.rolling.cleanliness is not None
    return xp.asarray(stated & xp.any(of_loads < LEAST_FILM_RATIO, axis=0))


def _life_of_drive(solved: SolvedJoint) -> float:
    """Life of the drive [s]; nan where it slips, or stands without a duty."""
    rolling = solved.result.rolling
    hours = rolling.duty_life_hours if solved.joint.rolling.duty else rolling.life_hours.drive
    return float(np.asarray(hours)) * _HOUR


def turn_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """What form errors do over a turn: the largest slip ratio, and the transmission error, if one is allowed.

    Empty where nobody states form errors; nan where the joint does not roll.
    """
    if solved.over_turn is None:
        return ()
    accuracy = solved.once(accuracy_of_solved)
    checks = []
    allowed = solved.allowed_transmission_error
    if allowed is not None:
        error = math.nan if accuracy is None else float(accuracy.transmission_error.worst)
        checks.append(LimitCheck(_transmission_error(allowed), None, error))
    if accuracy is None:
        return (*checks, LimitCheck(_TURN_SLIP, None, math.nan))
    slip = accuracy.slip + accuracy.budget("slip").worst
    worst = int(np.argmax(slip))
    return (*checks, LimitCheck(_TURN_SLIP, accuracy.contact_names[worst], float(slip[worst])))


_NOT_TURNING = "no turn to judge: the joint does not roll steadily under its torque"
_TURN_SLIP = dataclasses.replace(
    RESULTS["turn_slip_ratio"],
    limit=Limit(
        "accuracy",
        "no contact slips within a turn, whatever the phases of the form errors",
        "a contact may slip within a turn, where the form errors of the parts meet; the numbers of 'asperity accuracy' "
        "are of first order and do not hold there",
        "state smaller form errors, let the input float (compliance.sun_support_stiffness), lower the torque, or raise "
        "the preload",
        highest=1.0,
        unknown=_NOT_TURNING,
    ),
)


def _transmission_error(allowed: float) -> Result:
    """Result with its limit for the transmission error that is allowed [rad]."""
    return dataclasses.replace(
        RESULTS["transmission_error"],
        limit=Limit(
            "function",
            "the output deviates from even rotation by less than rolling.allowed_transmission_error",
            "the output may deviate from even rotation by more than rolling.allowed_transmission_error",
            "'asperity accuracy' says which parts make it; 'asperity tolerances --keep transmission_error' what the "
            "drawing may allow",
            highest=allowed,
            inclusive=True,
            unknown=_NOT_TURNING,
        ),
    )


def required_life_row(name: str, seconds: float, remedy: str, unknown: str, missing: str = "") -> Result:
    """A row of the table of results, a life, with the life that is required as its limit [s]."""
    limit = Limit(
        "function",
        "the rating life reaches rolling.required_life",
        "the rating life is shorter than rolling.required_life" + (f" ({missing})" if missing else ""),
        remedy,
        lowest=seconds,
        inclusive=True,
        unknown=unknown,
        missing=missing,
    )
    return dataclasses.replace(RESULTS[name], name=f"required_{name}", limit=limit)
