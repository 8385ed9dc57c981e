"""Rows of the table of results of a drive: stresses and safeties of its rings and hollow rollers."""

from __future__ import annotations

import functools
from typing import Any

import jax.numpy as jnp

from asperity.joint.rims import bends
from asperity.results.result import Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

_stress = functools.partial(
    Result,
    group="stresses",
    dimension=Dimension.PRESSURE,
    display_unit="MPa",
    axis="body",
    positive=False,
    present=lambda solved: bends(solved.joint),
    note="tension positive, the larger of both rims, away from the contacts; nan for bodies that do not bend",
)
_safety = functools.partial(
    Result,
    group="stresses",
    dimension=Dimension.DIMENSIONLESS,
    display_unit="1",
    axis="body",
)
_REMEDY = "choose a thicker wall, a stronger material or less preload"


def _larger(name: str) -> Any:
    return lambda solved: jnp.max(getattr(solved.rims, name), axis=0)


def _pressed(solved: SolvedJoint) -> tuple[bool, ...]:
    shapes = solved.joint.shapes
    return tuple(
        acts and shape.pin_diameter is not None
        for acts, shape in zip(bends(solved.joint), shapes, strict=True)
    )


def _tires(solved: SolvedJoint) -> tuple[bool, ...]:
    materials = solved.joint.materials
    return tuple(
        acts and material.fatigue_strength is not None
        for acts, material in zip(bends(solved.joint), materials, strict=True)
    )


ROWS = (
    _stress("rim_stress", "largest hoop stress of a ring or hollow roller", value=_larger("stress")),
    _stress(
        "rim_stress_at_rest",
        "largest hoop stress of a ring or hollow roller by the preload alone",
        value=_larger("stress_at_rest"),
    ),
    _stress(
        "rim_stress_amplitude",
        "largest amplitude of the hoop stress that a point of a ring or hollow roller goes through",
        value=_larger("amplitude"),
    ),
    _stress(
        "bore_stress",
        "largest hoop stress of the bore of a roller on a pin",
        value=lambda solved: solved.rims.stress[0],
        note="tension positive, under the pressure of the pin too; nan without bearings.pin_diameter",
        present=_pressed,
    ),
    _safety(
        "rim_yield_safety",
        "safety of a ring or hollow roller against yield",
        value="rims.yield_safety",
        note="yield strength over the largest Mises stress of both rims, without torque and under it, in plane strain "
        "up to 12 % above that at the faces of a short body; nan for bodies "
        "that do not bend",
        present=lambda solved: bends(solved.joint),
        limit=Limit(
            "damage",
            "the rims of rings and hollow rollers stay elastic",
            "a ring or hollow roller yields at a rim, away from the contacts",
            _REMEDY,
            lowest=1.0,
        ),
    ),
    _safety(
        "rim_fatigue_safety",
        "safety of a ring or hollow roller against fatigue",
        value="rims.fatigue_safety",
        note="nan for bodies that do not bend, and without fatigue_strength of the material",
        present=_tires,
        limit=Limit(
            "damage",
            "the rims of rings and hollow rollers endure the passing contacts",
            "a ring or hollow roller breaks by fatigue at a rim, away from the contacts",
            _REMEDY,
            lowest=1.0,
        ),
    ),
)
