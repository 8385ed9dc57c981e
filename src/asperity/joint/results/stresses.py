"""Rows of the table of results: stresses and safeties of the ring and of hollow rollers, away from the contacts."""

from __future__ import annotations

import functools
from collections.abc import Callable

from asperity.joint.results.result import Limit, Result, SolvedJoint
from asperity.unit_table import Dimension

_stress = functools.partial(
    Result,
    group="stresses",
    dimension=Dimension.PRESSURE,
    display_unit="MPa",
    axis="rim",
    positive=False,
    wedge_only=True,
)
_safety = functools.partial(
    Result, group="stresses", dimension=Dimension.DIMENSIONLESS, display_unit="1", wedge_only=True
)
_BODIES = (("ring", "the ring"), ("planet", "a hollow planet"), ("loading_roller", "a hollow loading roller"))


def _bends(body: str) -> Callable[[SolvedJoint], bool]:
    """Whether a joint has this body with a rim that is not held: only then its rims are what limits it."""

    def bends(solved: SolvedJoint) -> bool:
        joint = solved.joint
        if body == "ring":
            return joint.ring_support in ("free", "elastic_housing")
        return getattr(joint, f"{body}_bore") is not None

    return bends


def _rows(body: str, words: str) -> tuple[Result, ...]:
    bends = _bends(body)
    absent = "" if body == "ring" else "nan for solid ones; "
    note = f"{absent}tension positive; away from the contacts on their rim"
    remedy = "choose a thicker wall, a stronger material or less preload"

    def tires(solved: SolvedJoint) -> tuple[bool, ...]:
        return (bends(solved) and getattr(solved.joint.bodies, body).fatigue_strength is not None,)

    return (
        _stress(
            f"{body}_stress",
            f"largest hoop stress of {words}",
            value=f"rims.{body}.stress",
            note=note,
        ),
        _stress(
            f"{body}_stress_at_rest",
            f"largest hoop stress of {words} by the preload alone",
            value=f"rims.{body}.stress_at_rest",
            note=note,
        ),
        _stress(
            f"{body}_stress_mean",
            f"mean hoop stress that a point of {words} goes through",
            value=f"rims.{body}.mean",
            note=note,
        ),
        _stress(
            f"{body}_stress_amplitude",
            f"amplitude of the hoop stress that a point of {words} goes through",
            value=f"rims.{body}.amplitude",
            note=note,
        ),
        _safety(
            f"{body}_yield_safety",
            f"safety of {words} against yield",
            value=f"rims.{body}.yield_safety",
            note=f"{absent}yield strength over the largest Mises stress of both rims, without torque and under it, in "
            "plane strain up to 12 % above that at the faces of a short body",
            present=lambda solved: (bends(solved),),
            limit=Limit(
                "damage",
                f"the rims of {words} stay elastic",
                f"{words} yields at a rim, away from the contacts",
                remedy,
                lowest=1.0,
            ),
        ),
        _safety(
            f"{body}_fatigue_safety",
            f"safety of {words} against fatigue",
            value=f"rims.{body}.fatigue_safety",
            note=f"{absent}nan without fatigue_strength of its material",
            present=tires,
            limit=Limit(
                "damage",
                f"the rims of {words} endure the passing contacts",
                f"{words} breaks by fatigue at a rim, away from the contacts",
                remedy,
                lowest=1.0,
            ),
        ),
    )


ROWS = tuple(row for body, words in _BODIES for row in _rows(body, words))
