"""Stiffness or drift of joints at torques, with derivatives by their unknown numbers, whatever their drive."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any, Literal, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from asperity.compilation import program_for_few
from asperity.engine import trees
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.part_names import with_structure
from asperity.joint_file.si_tables import Values, numbers, replace_values, table_structure, with_numbers
from asperity.standing.over_torque import curve_program
from asperity.standing.standing import NO_SLIP_FRICTION
from asperity.standing.windup import StiffnessLevel
from asperity.types import Array

#: What a curve shows of a joint.
Shown = StiffnessLevel | Literal["drift"]
#: Torques of one call: one program serves curves of any number of points.
_BATCH = 50


class JointPoints(NamedTuple):
    """Sets of unknown numbers at torques, shape (sets, torques). SI units.

    ``value`` is the incremental stiffness at the output [N·m/rad] or the drift per output turn [rad], without meaning
    where the joint does not exist; ``slopes``, its derivatives, shape (sets, torques, unknowns), no unknowns where they
    are not asked for; ``slip_ratio``, largest T/(mu N) of the joint that stands, 1 at least where friction does not
    hold; ``exists``, whether the joint has a solution.
    """

    value: np.ndarray
    slopes: np.ndarray
    slip_ratio: np.ndarray
    exists: np.ndarray


def joint_points(
    values: Values,
    paths: tuple[str, ...],
    sets: np.ndarray,
    *,
    torque: np.ndarray,
    slips: np.ndarray,
    shown: Shown,
    slopes: bool,
) -> JointPoints:
    """What joints show at torques."""
    points = [_of_one_set(values, paths, row, torque, slips, shown, slopes) for row in sets]
    return JointPoints(*(np.stack(parts) for parts in zip(*points, strict=True)))


def _of_one_set(
    values: Values,
    paths: tuple[str, ...],
    one: np.ndarray,
    torque: np.ndarray,
    slips: np.ndarray,
    shown: Shown,
    slopes: bool,
) -> JointPoints:
    """The chain that is written for one joint: one set, assembled once, at all torques."""
    filled = replace_values(with_structure(values), dict(zip(paths, map(float, one), strict=True)))
    base = np.array(numbers(filled), dtype=float)
    nothing = with_numbers(filled, iter(np.zeros(base.size)))
    asked = paths if slopes else ()
    directions = [np.array(numbers(replace_values(nothing, {path: 1.0})), dtype=float) for path in asked]
    different, place = np.unique(torque, return_inverse=True)
    chosen = place, np.where(torque < 0.0, 1, 0) if shown == "drift" else np.where(slips, 0, 1)
    asked_of, by = (table_structure(filled), shown), [np.zeros((torque.size, 0))]
    curve: dict[str, np.ndarray] = {}
    for direction in directions:
        curve, along = _over(_directional, asked_of, different, base, direction)
        by.append(along[chosen][:, None])
    if not directions:
        curve = _over(_curves, asked_of, different, base)
    value, ratio, holds = curve[shown][chosen], curve["slip_ratio"].max(axis=1)[place], curve["solved"][place]
    if shown != "drift":
        value = np.where(holds, value, np.nan)  # else the equations are not solved
    return JointPoints(
        value, np.concatenate(by, axis=1), np.where(holds, ratio, np.fmax(ratio, 1.0)), np.isfinite(value)
    )


def _over(
    function: Callable[..., Any], options: tuple[str, str], torque: np.ndarray, *given: np.ndarray
) -> Any:
    """What a function of options, of numbers of a joint and of torques gives at different torques."""
    filled = np.concatenate([torque, np.full(-torque.size % _BATCH, torque[-1])])
    parts = []
    for part in filled.reshape(-1, _BATCH):
        # a posterior calls the curves thousands of times
        program = program_for_few(function, *given, part, options=options, often=function is _curves)
        parts.append(trees.map(np.asarray, program(*given, part)))
    return trees.map(lambda *leaves: np.concatenate(leaves)[: torque.size], *parts)


def _curves(structure: str, shown: str, base: Array, torques: Array) -> dict[str, Array]:
    """Curves of a joint over torques."""
    joint = joint_with_branches(with_numbers(json.loads(structure), base))
    return curve_program(joint, torques, jnp.asarray(NO_SLIP_FRICTION), shown)


def _directional(
    structure: str, shown: str, base: Array, direction: Array, torques: Array
) -> tuple[dict[str, Array], Array]:
    """Curves of a joint over torques, and the slope of what is shown along a direction of its numbers."""

    def slope_and_curves(rows: Array) -> tuple[Array, dict[str, Array]]:
        curves = _curves(structure, shown, rows, torques)
        return curves[shown], curves

    _, slope, values = jax.jvp(slope_and_curves, (base,), (direction,), has_aux=True)
    return values, slope
