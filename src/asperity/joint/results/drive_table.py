"""The table of results of another drive than that of Zou et al.: the rows that it has, with its names."""

from __future__ import annotations

import dataclasses
import functools
import math

from asperity.joint.capacity import LIMITING_CONTACTS
from asperity.joint.results.result import Result, SolvedJoint
from asperity.joint.results.table import RESULTS

_LABELS = {
    "preload": "normal force of the first contact in the assembled drive",
    "speed_ratio": "speed ratio, input over output",
    "envelope_diameter": "outer diameter of the largest body",
}
#: What is said of the paper's sun holds for the input of any drive.
_OF_THE_SUN = (
    ("at the sun", "at the input"),
    ("where the sun stands", "where the input stands"),
    ("[sun_bearing] or [carrier_bearing]", "[input_bearing] or [output_bearing]"),
)


@functools.lru_cache(maxsize=32)
def results_of_drive(
    contacts: tuple[str, ...],
    bodies: tuple[str, ...],
    neighbours: tuple[str, ...],
    bearings: tuple[str, ...],
) -> dict[str, Result]:
    """Every result that a planar drive has.

    Parameters
    ----------
    contacts, bodies, neighbours, bearings : tuple of str
        Names of its contacts and bodies, of the pairs of bodies that must not touch, and of its rolling bearings.

    Returns
    -------
    dict
        Name → the row of :data:`asperity.joint.results.RESULTS`, with the names of this drive; without those that only
        the drive of Zou et al. 2025 has.
    """
    names = {"contact": contacts, "body": bodies, "clearance": neighbours, "bearing": bearings}
    rows = [_named(row, names) for row in RESULTS.values() if not row.wedge_only]
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
    return results_of_drive(*(solved.row_names(axis) for axis in ("contact", "body", "clearance", "bearing")))


def _named(row: Result, names: dict[str, tuple[str, ...]]) -> Result:
    if row.name == "speed_ratio":  # of either sign
        row = dataclasses.replace(
            row, highest_limit=math.inf, note="negative: they turn in opposite directions"
        )
    if row.categories is LIMITING_CONTACTS:
        places = (*names["contact"], LIMITING_CONTACTS[-1])
        row = dataclasses.replace(
            row, categories=places, note=f"its number in the order {', '.join(places)}, from 0"
        )
    label, note = _LABELS.get(row.name, row.label), row.note
    for papers, any_drive in _OF_THE_SUN:
        label, note = label.replace(papers, any_drive), note.replace(papers, any_drive)
    return dataclasses.replace(row, label=label, note=note, rows=names.get(row.axis))
