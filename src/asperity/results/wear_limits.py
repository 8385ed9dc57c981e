"""Limits of wear: that a joint with a wear coefficient carries its loads over the life that is required."""

from __future__ import annotations

import dataclasses

from asperity.results.limit_check import LimitCheck
from asperity.results.result import Limit
from asperity.results.solved import SolvedJoint
from asperity.results.table import RESULTS
from asperity.results.wear_rows import worn_life

_REMEDY = (
    "raise the interference (load.interference), lower the torque or the speed, make rollers larger or contacts "
    "longer, or lower the wear coefficient, by oil or harder surfaces; 'asperity wear' says how it goes over time"
)


def wear_checks(solved: SolvedJoint) -> tuple[LimitCheck, ...]:
    """Time to the first contact that slides by wear, and preload after the required life; equation (W4).

    Empty without a required life or a wear coefficient.
    """
    if solved.required_life is None or solved.joint.wear_coefficients is None:
        return ()
    found = solved.once(worn_life)
    life = dataclasses.replace(
        RESULTS["life_wear"],
        limit=Limit(
            "function",
            "wear leaves the grip of every contact for rolling.required_life",
            "wear lets a contact slide before rolling.required_life",
            _REMEDY,
            lowest=float(solved.required_life),
            inclusive=True,
            unknown=found.unknown,
        ),
    )
    preload = dataclasses.replace(
        RESULTS["preload_after_life"],
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
