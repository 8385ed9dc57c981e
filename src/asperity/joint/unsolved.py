"""A joint whose force balance does not close: which of its numbers is the cause, and where a solution lies."""

from __future__ import annotations

import dataclasses
import math
from typing import NamedTuple, NoReturn

import equinox as eqx
import jax
import numpy as np

from asperity.compilation import compile_fast
from asperity.drive.force_balance import BALANCE_TOLERANCE
from asperity.drive.geometry import CONTACT_NAMES
from asperity.errors import NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.evaluated import evaluated
from asperity.joint.evaluation import JointResult, evaluate
from asperity.units import format_quantity

#: Steps on the way from each number to a harmless value of it.
_STEPS = 24


class _Suspect(NamedTuple):
    """A number that can keep a balance from closing, and a value of it at which it does not."""

    path: tuple[str, ...]
    unit: str
    harmless: float


_SUSPECTS = (
    _Suspect(("output_torque",), "N*m", 0.0),
    _Suspect(("sun_speed",), "rpm", 0.0),
    _Suspect(("preload",), "N", math.inf),  # ten thousand times as much
    _Suspect(("geometry", "left_push_angle"), "deg", 0.0),
    _Suspect(("geometry", "right_push_angle"), "deg", 0.0),
    _Suspect(("bearings", "pin_friction_coefficient"), "1", 0.0),
    _Suspect(("bearings", "loading_roller_torque"), "N*m", 0.0),
    _Suspect(("bearings", "carrier_torque"), "N*m", 0.0),
)


def refuse_unsolved(joint: Joint, result: JointResult) -> None:
    """Refuse a joint whose force balance did not close, and say what would have to change.

    Parameters
    ----------
    joint : Joint
        One joint; numbers as NumPy arrays.
    result : JointResult
        Its result.

    Raises
    ------
    NoSolutionError
        With the cause, if one number alone decides; otherwise with the residuals.
    """
    if bool(result.solved):
        return
    if joint.closure_springs == "bulk_and_asperities":
        _refuse_plastic_springs(joint)
    remedies = _remedies(joint)
    if remedies:
        raise NoSolutionError(
            f"the force balance has no solution with these numbers; it has one if one of them changes alone: "
            f"{'; or '.join(remedies)}"
        )
    raise NoSolutionError(
        "the force balance did not close, and no single change of torque, speed, preload, push angles or bearing "
        f"friction closes it; {_residuals(result)}"
    )


def _residuals(result: JointResult) -> str:
    values = {"balance": result.forces.balance_residual, "closure": result.forces.closure_residual}
    known = [f"{float(value):.3g} ({name})" for name, value in values.items() if math.isfinite(float(value))]
    if not known:
        return "the forces overflowed: a number is far outside the sizes of a drive"
    return f"relative residual {' and '.join(known)}, allowed {BALANCE_TOLERANCE:g}"


def _refuse_plastic_springs(joint: Joint) -> None:
    """With asperities in the closure, every contact needs elastic spots at rest."""
    rest = dataclasses.replace(
        joint, closure_springs="bulk", output_torque=np.float64(0.0), sun_speed=np.float64(0.0)
    )
    result = evaluated(rest)
    ratio = np.asarray(result.diagnostics.critical_over_largest_spot)
    plastic = [name for name, value in zip(CONTACT_NAMES, ratio, strict=True) if value >= 1.0]
    if plastic and bool(result.solved):
        _no_asperity_springs(plastic, float(np.max(ratio)))


def _no_asperity_springs(contacts: list[str], ratio: float) -> NoReturn:
    raise NoSolutionError(
        f'closure_springs = "bulk_and_asperities" has no solution: without torque every spot of {", ".join(contacts)} '
        f"is plastic (critical over largest spot {ratio:.3g}, it must be below 1), where the contact law gives the "
        'asperities no stiffness; use closure_springs = "bulk", or a surface of larger fractal_dimension or smaller '
        "fractal_roughness"
    )


def _remedies(joint: Joint) -> list[str]:
    """Each number that would do alone, with the value nearest to its own at which the balance closes."""
    suspects, rows = [], []
    for suspect in _SUSPECTS:
        own = float(_at(joint, suspect.path))
        target = 1e4 * own if math.isinf(suspect.harmless) else suspect.harmless
        if own == target:
            continue
        share = np.linspace(0.0, 1.0, _STEPS + 1)[1:]
        way = own * (target / own) ** share if target > 0.0 else own * (1.0 - share)
        suspects.append(suspect)
        rows.append(way)
    if not suspects:
        return []
    count = _STEPS * len(suspects)
    batch: Joint = jax.tree.map(lambda leaf: np.full(count, float(leaf)), joint)
    for index, (suspect, way) in enumerate(zip(suspects, rows, strict=True)):
        column = np.array(_at(batch, suspect.path))
        column[index * _STEPS : (index + 1) * _STEPS] = way
        batch = _with(batch, suspect.path, column)
    solved = np.asarray(compile_fast(_solved, batch)(batch)).reshape(len(suspects), _STEPS)
    told = []
    for suspect, way, closes in zip(suspects, rows, solved, strict=True):
        if not closes[-1]:
            continue
        first = _STEPS - int(np.argmin(closes[::-1])) if not closes.all() else 0
        own = float(_at(joint, suspect.path))
        told.append(
            f"{suspect.path[-1]} {format_quantity(float(way[first]), suspect.unit, 3)} instead of "
            f"{format_quantity(own, suspect.unit, 3)}"
        )
    return told


def _solved(joint: Joint) -> np.ndarray:
    return evaluate(joint).solved  # type: ignore[return-value]


def _at(joint: Joint, path: tuple[str, ...]) -> np.ndarray:
    for name in path:
        joint = getattr(joint, name)
    return joint  # type: ignore[return-value]


def _with(joint: Joint, path: tuple[str, ...], value: np.ndarray) -> Joint:
    moved: Joint = eqx.tree_at(lambda whole: _at(whole, path), joint, value)
    return moved
