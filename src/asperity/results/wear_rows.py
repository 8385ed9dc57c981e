"""Rows of the table of results: how long wear lets a joint carry its loads, and what preload it leaves."""

from __future__ import annotations

import functools
import math
from typing import Any, NamedTuple

import numpy as np

from asperity.engine.arrays import uses_jax, xp
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.wear_document import at_life
from asperity.rolling.wear import joint_wear
from asperity.rolling.wear_life import wear_life
from asperity.unit_table import Dimension


class WornLife(NamedTuple):
    """Time until wear ends the grip of a contact [s] and preload after the required life [N]; why not known, if so."""

    time: Any
    preload: Any
    unknown: str


def worn_life(solved: SolvedJoint) -> WornLife:
    """How long wear lets a joint carry its loads, and what preload it leaves after the required life, if there is one.

    Of the points of a study by :func:`asperity.rolling.wear_life.wear_life`, of one joint by the whole course of its
    wear, which also says why something is not known.
    """
    joint = solved.joint
    if joint.wear_coefficients is None:
        return WornLife(math.nan, math.nan, "no life under wear: the file states no wear.coefficient")
    if joint.logarithmic_crowns is not None:
        return WornLife(
            math.nan, math.nan, "no life under wear: how profiles (NAME_profile) wear is not computed"
        )
    if joint.interference is None and joint.cam is None:
        why = "no life under wear: load.preload does not say what wear takes from it; state load.interference"
        return WornLife(math.nan, math.nan, why)
    if joint.interference is None:
        return WornLife(math.inf, solved.preload, "")
    coefficients = xp.stack([xp.asarray(each, dtype=float) for each in joint.wear_coefficients])
    largest = xp.max(coefficients)
    required = math.nan if solved.required_life is None else largest * solved.required_life
    if uses_jax(joint, required):
        found = wear_life(joint, coefficients / largest, required)
        return WornLife(found.time / largest, found.preload, "")
    return _of_course(joint, np.asarray(coefficients / largest), float(largest), float(required))


def _of_course(joint: Joint, coefficients: np.ndarray, largest: float, required: float) -> WornLife:
    """The same of one joint whose wear is known to be followed, by the course of its wear."""
    also = required if math.isfinite(required) else None
    try:
        wear = joint_wear(joint, coefficients, keeps_force=False, also=also, with_capacity=False)
    except (InputError, NoSolutionError) as error:
        return WornLife(math.nan, math.nan, f"no life under wear: {error}")
    assert wear.course is not None
    end = wear.ends[0]
    if end.kind == "flat":
        return WornLife(
            math.nan, math.nan, "no life under wear: a crown is worn flat before a contact slides"
        )
    preload = None if also is None else at_life(wear.course, also, wear.course.preload)
    return WornLife(end.coefficient_time / largest, math.nan if preload is None else preload, "")


def _time(solved: SolvedJoint) -> Any:
    return solved.once(worn_life).time


def _preload(solved: SolvedJoint) -> Any:
    return solved.once(worn_life).preload


_worn = functools.partial(
    Result,
    group="wear",
    present=lambda solved: (solved.joint.wear_coefficients is not None,),
    only="only a joint whose file states wear.coefficient has it",
)

ROWS = (
    _worn(
        "life_wear",
        "time until a contact slides by wear",
        Dimension.TIME,
        "h",
        _time,
        note="under the loads of the file or of its [[duty]], without the strokes of a cam, which keeps its force; "
        "infinite with a cam; nan with a preload that is stated as a force or where the input stands",
        place="wear.life_s",
    ),
    _worn(
        "preload_after_life",
        "preload after rolling.required_life",
        Dimension.FORCE,
        "N",
        _preload,
        present=lambda solved: (
            solved.joint.wear_coefficients is not None and solved.required_life is not None,
        ),
        only="only a joint whose file states wear.coefficient and rolling.required_life has it",
        note="nan where wear ends the grip of a contact before",
        place="wear.preload_after_life_N",
    ),
)
