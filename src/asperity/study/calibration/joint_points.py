"""Stiffness or drift of joints at torques, with derivatives by their unknown numbers, whatever their drive."""

from __future__ import annotations

import json
from typing import Literal, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.part_names import with_tracks
from asperity.joint_file.si_tables import Values, numbers, replace_values, table_structure, with_numbers
from asperity.standing.over_torque import BATCH, curve_program
from asperity.standing.standing import LEVELS, NO_SLIP_FRICTION
from asperity.standing.windup import StiffnessLevel

#: What a curve shows of a joint.
Shown = StiffnessLevel | Literal["drift"]


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
    filled = replace_values(with_tracks(values), dict(zip(paths, map(float, one), strict=True)))
    base = np.array(numbers(filled), dtype=float)
    nothing = with_numbers(filled, iter(np.zeros(base.size)))
    asked = paths if slopes else ()
    directions = [np.array(numbers(replace_values(nothing, {path: 1.0})), dtype=float) for path in asked]
    different, place = np.unique(torque, return_inverse=True)
    chosen = place, np.where(torque < 0.0, 1, 0) if shown == "drift" else np.where(slips, 0, 1)
    structure, by = table_structure(filled), []
    curve: dict[str, np.ndarray] = {}
    for direction in directions or [np.zeros(base.size)]:
        curve, along = _over(structure, base, direction, different)
        by.append(along[shown][chosen])
    value, ratio, holds = curve[shown][chosen], curve["slip_ratio"].max(axis=1)[place], curve["solved"][place]
    if shown != "drift":
        value = np.where(holds, value, np.nan)  # else the equations are not solved
    return JointPoints(
        value,
        np.stack(by, axis=-1)[:, : len(asked)],
        np.where(holds, ratio, np.fmax(ratio, 1.0)),
        np.isfinite(value),
    )


def _over(
    structure: str, base: np.ndarray, direction: np.ndarray, torque: np.ndarray
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """A joint at different torques, and its derivative along a direction of the numbers of its file."""
    filled = np.concatenate([torque, np.full(-torque.size % BATCH, torque[-1])])
    parts = []
    for part in filled.reshape(-1, BATCH):
        program = compile_fast(_directional, base, direction, part, options=(structure,))
        parts.append(jax.tree.map(np.asarray, program(base, direction, part)))
    both: tuple[dict[str, np.ndarray], dict[str, np.ndarray]] = jax.tree.map(
        lambda *leaves: np.concatenate(leaves)[: torque.size], *parts
    )
    return both


def _directional(
    structure: str, base: Array, direction: Array, torques: Array
) -> tuple[dict[str, Array], dict[str, Array]]:
    """Curves of a joint over torques, and the slopes of stiffness and drift along a direction of its numbers."""
    tables = json.loads(structure)

    def slopes_and_curves(rows: Array) -> tuple[dict[str, Array], dict[str, Array]]:
        joint = joint_with_branches(with_numbers(tables, rows))
        shown = curve_program(joint, torques, jnp.asarray(NO_SLIP_FRICTION))
        return {name: shown[name] for name in (*LEVELS, "drift")}, shown

    _, slopes, values = jax.jvp(slopes_and_curves, (base,), (direction,), has_aux=True)
    return values, slopes
