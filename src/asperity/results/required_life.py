"""Whether the drive and its rolling bearings live as long as the joint file requires."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from asperity.branches.results import UnequalBranches
from asperity.results import RESULTS, Limit, Result
from asperity.results.branch_limits import shortest_life
from asperity.results.drive_table import results_of_joint
from asperity.results.limit_check import LimitCheck
from asperity.results.notes import film_band
from asperity.results.solved import SolvedJoint

_HOUR = 3600.0


def life_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    r"""The lives of the drive and of its rolling bearings, compared with the life that is required; empty without one.

    Under a duty the lives are those under the duty. Those of unequal branches are a lower bound: as if all branches
    were loaded like the worst, and under a duty

    .. math:: \frac1T \le \sum_j \frac{\varphi_j}{L_j}

    References
    ----------
    Equations (B8) and (L2) of :doc:`/equations`. The bound follows from Minkowski's inequality, as the Weibull slope
    exceeds 1.
    """
    if solved.required_life is None:
        return ()
    duty = bool(solved.joint.rolling.duty)
    own = solved.branches
    life = _equal_life(solved) if own is None else _own_life(solved, own)
    required, less = solved.required_life, "lower the preload, the torque or the speed, or"
    unknown = "no life to compare with the required one: " + (
        "the joint does not carry every load of its [[duty]]"
        if duty
        else "the joint slips, is loaded above shakedown, or stands (the speed is 0) and has no [[duty]]"
    )
    of_drive = _required(
        "duty_life" if duty else "drive_life",
        required,
        f"{less} make rollers larger or contacts longer",
        unknown,
    )
    of_drive = dataclasses.replace(of_drive, label=f"{of_drive.label}{_without_film_factor(solved)}")
    if own is not None:
        of_drive = dataclasses.replace(
            of_drive, label=f"{of_drive.label}, as if every branch were loaded like the worst"
        )
    of_bearings = results_of_joint(solved)["bearing_duty_life" if duty else "bearing_life"]
    limit = _required(of_bearings.name, required, f"{less} choose larger bearings or more of them", unknown)
    bearings = (
        LimitCheck(limit, name, value)
        for name, value in of_bearings.rows_of(solved).items()
        if not math.isnan(value)
    )
    return LimitCheck(of_drive, None, life), *bearings


def _without_film_factor(solved: SolvedJoint) -> str:
    """What the life of the drive leaves out where the oil film does not carry the load, to stand beside the verdict."""
    ratios = np.asarray(solved.result.rolling.film_ratio, dtype=float)
    known = ratios[np.isfinite(ratios)]
    if not known.size or film_band(float(known.min())) == "full":
        return ""
    least = float(known.min())
    return f", without a factor for the film ({film_band(least)} lubrication, lambda {least:.2g})"


def _equal_life(solved: SolvedJoint) -> float:
    """Life of a drive of equal branches [s]; nan where it slips, or stands without a duty."""
    rolling = solved.result.rolling
    hours = rolling.duty_life_hours if solved.joint.rolling.duty else rolling.life_hours.drive
    return float(np.asarray(hours)) * _HOUR


def _own_life(solved: SolvedJoint, own: UnequalBranches) -> float:
    """Life of a drive all of whose branches are loaded like the worst [s]; nan where they slip or stand."""
    duty = solved.joint.rolling.duty
    if not duty:
        return _HOUR * shortest_life(own.rolling)
    damage = 0.0
    for point, state in zip(duty, own.duty, strict=True):
        stands = state is not None and not float(point.sun_speed) > 0.0
        damage += 0.0 if stands else float(point.share) / shortest_life(state)
    return _HOUR / damage if damage else math.inf


def _required(name: str, seconds: float, remedy: str, unknown: str) -> Result:
    """A row of the table of results with the life that is required as its limit."""
    limit = Limit(
        "damage",
        "it lives as long as required",
        "it fails before the life that is required, rolling.required_life",
        remedy,
        lowest=seconds,
        inclusive=True,
        unknown=unknown,
    )
    return dataclasses.replace(RESULTS[name], name=f"required_{name}", limit=limit)
