"""Limits of wear: that a joint with a wear coefficient carries its loads over the life that is required."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.results.limit_check import LimitCheck
from asperity.results.result import Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.results.wear_document import at_life
from asperity.rolling.wear import joint_wear
from asperity.unit_table import Dimension

_REMEDY = (
    "raise the interference (load.interference), lower the torque or the speed, make rollers larger or contacts "
    "longer, or lower the wear coefficient, by oil or harder surfaces; 'asperity wear' says how it goes over time"
)


class WornLife(NamedTuple):
    """Time to the first slide [s] and preload after the required life [N], and why they are not known, if so."""

    time: float
    preload: float
    unknown: str


def wear_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Time to the first contact that slides by wear, and preload after the required life; equation (W4).

    Empty without a required life or a wear coefficient.
    """
    if solved.required_life is None or solved.joint.wear_coefficients is None:
        return ()
    found = solved.once(worn_life)
    life = Result(
        "life_wear",
        "time until a contact slides by wear",
        Dimension.TIME,
        "h",
        "life_wear",
        limit=Limit(
            "function",
            "wear leaves the grip of every contact for rolling.required_life",
            "wear lets a contact slide before rolling.required_life",
            _REMEDY,
            lowest=solved.required_life,
            inclusive=True,
            unknown=found.unknown,
        ),
    )
    preload = Result(
        "preload_after_life",
        "preload after rolling.required_life",
        Dimension.FORCE,
        "N",
        "preload_after_life",
        limit=Limit(
            "function",
            "wear leaves a preload that carries the load",
            "wear leaves no preload",
            _REMEDY,
            lowest=0.0,
            unknown=found.unknown or "the joint does not carry its load so long",
        ),
    )
    return LimitCheck(life, None, found.time), LimitCheck(preload, None, found.preload)


def worn_life(solved: SolvedJoint) -> WornLife:
    """How long wear lets a joint carry its loads, and what preload it leaves after the required life."""
    joint, required = solved.joint, solved.required_life
    assert joint.wear_coefficients is not None
    assert required is not None
    if joint.interference is None and joint.cam is None:
        why = "no life under wear: load.preload does not say what wear takes from it; state load.interference"
        return WornLife(math.nan, math.nan, why)
    coefficients = np.array([float(each) for each in joint.wear_coefficients])
    largest = float(coefficients.max())
    return _found(joint, coefficients / largest, largest, required)


def _found(joint: Joint, coefficients: np.ndarray, largest: float, required: float) -> WornLife:
    """The same of a joint whose wear is known to be followed."""
    try:
        wear = joint_wear(
            joint,
            coefficients,
            keeps_force=joint.interference is None,
            also=largest * required,
            with_capacity=False,
        )
    except (InputError, NoSolutionError) as error:
        return WornLife(math.nan, math.nan, f"no life under wear: {error}")
    if wear.course is None:
        return WornLife(math.inf, wear.now.preload, "")
    time = math.inf if wear.first_slide is None else wear.first_slide.coefficient_time / largest
    preload = at_life(wear.course, largest * required, wear.course.preload)
    return WornLife(time, math.nan if preload is None else preload, "")
