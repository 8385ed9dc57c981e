"""Joints of every type of drive from the tables of their files, with status and the results that they have."""

from __future__ import annotations

import functools
import json
from collections.abc import Iterable, Mapping
from typing import Any

from asperity.drive.layout.drive import Drive
from asperity.drive.layout.existence import neighbours
from asperity.drive.layout.wedge import wedges
from asperity.drive.state.state import ContactLaws
from asperity.engine.arrays import xp
from asperity.joint.description import Joint, bearing_names, pin_names
from asperity.joint.evaluation import JointResult, evaluated_with_laws
from asperity.joint.pin_bound import stiffness_bound
from asperity.joint.status import joint_status
from asperity.joint_file import build
from asperity.joint_file.accuracy import turn_errors_of
from asperity.joint_file.own_branches import joint_with_branches, parts_with_branches
from asperity.joint_file.part_names import with_structure
from asperity.joint_file.si_tables import Values, numbers, table_structure, with_numbers
from asperity.results import Result, result_values
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_drive
from asperity.types import Array


def results_of(tables: Mapping[str, Any]) -> dict[str, Result]:
    """Name → row of all results that the drive of a file has, with the names of its parts, whatever its numbers."""
    return _results_of_structure(table_structure(with_structure(dict(tables))))


@functools.lru_cache(maxsize=32)
def _results_of_structure(structure: str) -> dict[str, Result]:
    import jax

    values = json.loads(structure)
    shapes = [jax.ShapeDtypeStruct((), xp.float64) for _ in numbers(values)]
    bounds: list[str] = []

    def described(*scalars: Array) -> Drive:
        joint = parts_with_branches(with_numbers(values, scalars))
        bounds.append(stiffness_bound(joint))
        return joint.drive

    drive = jax.eval_shape(described, *shapes)
    pairs = tuple("_to_".join(pair) for pair in neighbours(drive))
    return results_of_drive(
        tuple(contact.name for contact in drive.contacts),
        tuple(body.name for body in drive.bodies),
        pairs,
        bearing_names(drive),
        pin_names(drive),
        has_wedges=bool(wedges(drive)),
        bound=bounds[0],
    )


def rows_of_file(tables: Mapping[str, Any], result: Result) -> tuple[int, ...]:
    """Which rows of a result the joint of a file has: the bearings that are rated, the bodies that bend."""
    present = result.present
    if present is None or not result.row_shape:
        return tuple(range(len(result.row_names)))
    values = with_structure(dict(tables))
    presence: list[bool] = []
    no_result: Any = None

    def ask(*scalars: Array) -> None:
        tables = with_numbers(values, scalars)
        presence.extend(present(_solved(tables, parts_with_branches(tables), no_result, None)))

    import jax

    jax.eval_shape(ask, *(jax.ShapeDtypeStruct((), xp.float64) for _ in numbers(values)))
    return tuple(int(row) for row, present in enumerate(presence) if present)


def _solved(tables: Values, joint: Joint, result: JointResult, laws: ContactLaws | None) -> SolvedJoint:
    """A joint with what is asked of it in tables in SI units."""
    solved = SolvedJoint(joint, result, laws)
    solved.required_life = tables.get("rolling", {}).get("required_life")
    if "form" in tables:
        solved.turn_errors = functools.partial(turn_errors_of, tables)
    return solved


def with_nominal_sizes(values: Values) -> Values:
    """Tables in SI units for :func:`evaluated_points`, in which changes of the radii are deviations of finished parts.

    It then adds to the interference what the deviations from the present values make of it; unchanged where the preload
    is stated as a force. The drive itself stays as large as it is where its contacts are listed, type ``planar``: the
    radii of finished parts need not close it.
    """
    return build.with_nominal_sizes(values)


def sizes_of_parts(values: Values, paths: Iterable[str]) -> tuple[str, ...]:
    """Those of dotted paths that are sizes of parts, whose deviations add to the interference of a drive.

    None where the preload is stated as a force, which no size moves.
    """
    if "interference" not in values["load"]:
        return ()
    tracks = build.toleranced_tracks(values, tuple(paths))
    return tuple(dict.fromkeys(track.path for track in tracks if track.path != "load.interference"))


def evaluated_points(
    values: Values, points: tuple[int, ...], results: tuple[str, ...]
) -> tuple[Array, dict[str, Array]]:
    """Status and results of the joints that tables of SI numbers and arrays describe; pure.

    Shape (points).
    """
    status, named = _pointwise(values, points, results)
    table = results_of(values)
    # where only the springs of the structure vary, one status serves all points
    return xp.broadcast_to(status, points), {
        name: xp.broadcast_to(value, (*table[name].row_shape, *points)) for name, value in named.items()
    }


def _pointwise(
    values: Values, points: tuple[int, ...], results: tuple[str, ...]
) -> tuple[Array, dict[str, Array]]:
    """The chain of a drive, which is written for one joint, at every point."""
    leaves = [xp.asarray(leaf, dtype=float) for leaf in numbers(values)]
    varied = [0 if leaf.ndim else None for leaf in leaves]
    flat = [xp.broadcast_to(leaf, points).reshape(-1) if leaf.ndim else leaf for leaf in leaves]

    def one(*scalars: Array) -> tuple[Array, dict[str, Array]]:
        tables = with_numbers(values, scalars)
        joint = joint_with_branches(tables)
        result, laws = evaluated_with_laws(joint)
        return joint_status(joint, result), result_values(results, _solved(tables, joint, result, laws))

    if not any(leaf.ndim for leaf in leaves):
        status, named = one(*leaves)
        return status, {
            name: value.reshape(*value.shape, *(1 for _ in points)) for name, value in named.items()
        }
    import jax

    status, named = jax.vmap(one, in_axes=varied, out_axes=-1)(*flat)
    return status.reshape(points), {
        name: value.reshape(*value.shape[:-1], *points) for name, value in named.items()
    }
