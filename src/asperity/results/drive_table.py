"""The table of results of a drive: the rows that it has, with its names."""

from __future__ import annotations

import dataclasses
import functools

from asperity.drive.layout.wedge import wedges
from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.table import RESULTS


@functools.lru_cache(maxsize=32)
def results_of_drive(
    contacts: tuple[str, ...],
    bodies: tuple[str, ...],
    neighbours: tuple[str, ...],
    bearings: tuple[str, ...],
    pins: tuple[str, ...],
    *,
    has_wedges: bool,
) -> dict[str, Result]:
    """Every result that a drive has."""
    names = {"contact": contacts, "body": bodies, "clearance": neighbours, "bearing": bearings, "pin": pins}
    rows = [_named(row, names) for row in RESULTS.values() if has_wedges or not row.needs_wedges]
    return {row.name: row for row in rows if row.row_names}


def results_of_joint(solved: SolvedJoint) -> dict[str, Result]:
    """Every result that a single solved joint has.

    Parameters
    ----------
    solved : SolvedJoint
        The joint.

    Returns
    -------
    dict
        Name → row.
    """
    return results_of_drive(
        *(solved.row_names(axis) for axis in ("contact", "body", "clearance", "bearing", "pin")),
        has_wedges=bool(wedges(solved.joint.drive)),
    )


def _named(row: Result, names: dict[str, tuple[str, ...]]) -> Result:
    if row.categories == ("none",):  # the contacts of the drive before it
        places = (*names["contact"], *row.categories)
        row = dataclasses.replace(
            row, categories=places, note=f"its number in the order {', '.join(places)}, from 0"
        )
    return dataclasses.replace(row, rows=names.get(row.axis, ()))
