"""Loads of a joint's pins, bearings, shafts and housing under every load of its file, as rows for their supplier."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np

import asperity

#: A load below this share of the largest one of its unit is what the sums of larger ones leave.
_ROUNDING = 1e-12
Document = dict[str, Any]
Row = tuple[str, str, str, str, Any]

#: What the lives of rolling bearings are.
RATED = (
    "Bearings: ISO 281 basic rating life, which nine in ten reach, by radial load and relative speed. Lubrication and "
    "cleanliness (a_ISO), axial loads and misalignment are yours to judge; the life holds for loads up to C/2."
)

#: What a table of loads says of branches that differ.
UNEQUAL = (
    "Branches of unequal sizes, [[branch]]: the bearings of the members on the axis carry what the branches leave "
    "unbalanced, rated ones the whole of it and the outside_force of their section as if both acted in one direction. "
    "Forces of the pins and lives of their bearings are those of the branch that loads them most; {pressed}. Weights "
    "and forces from outside are not counted."
)


def case_entry(
    name: str, output_torque: float, sun_speed: float, share: float | None, unknown_because: str | None
) -> Document:
    """One load of the joint as an entry of the document.

    Parameters
    ----------
    name : str
        What it is called.
    output_torque, sun_speed : float
        Torque at the output [N·m] and speed of the input [rad/s].
    share : float or None
        Share of the time; None outside a duty.
    unknown_because : str or None
        Why there are no loads; None where there are.

    Returns
    -------
    dict
        With units at the end of its keys.
    """
    return {
        "name": name,
        "output_torque_Nm": output_torque,
        "sun_speed_rad_per_s": sun_speed,
        "share": share,
        "unknown_because": unknown_because,
    }


def document_of_rows(
    cases: list[Document], rows: Iterable[Row], *, bearings: list[Document], notes: list[str]
) -> Document:
    """The document of loads, whatever the drive.

    Parameters
    ----------
    cases : list of dict
        From :func:`case_entry`.
    rows : iterable of tuple
        Part, position, quantity, SI unit, and one value for each case or one for all.
    bearings : list of dict
        Rolling bearings.
    notes : list of str
        What the numbers mean.

    Returns
    -------
    dict
        None where a value is not known or infinite, as every load of an unknown case; 0 where it is the rounding of
        larger ones of its unit.
    """
    unknown = np.array([case["unknown_because"] is not None for case in cases])
    whole = [
        (*words, unit, np.where(unknown & (unit != "rad/s"), math.nan, np.asarray(values, dtype=float)))
        for *words, unit, values in rows
    ]
    largest = {
        unit: max(
            (abs(x) for *_, other, each in whole if other == unit for x in each if np.isfinite(x)),
            default=0.0,
        )
        for unit in {row[-2] for row in whole}
    }
    return {
        "asperity_version": asperity.__version__,
        "cases": cases,
        "loads": [
            {
                "part": part,
                "position": position,
                "quantity": quantity,
                "unit": unit,
                "values": [_plain(value, _ROUNDING * largest[unit]) for value in values],
            }
            for part, position, quantity, unit, values in whole
        ],
        "bearings": bearings,
        "notes": notes,
    }


def _plain(value: Any, rounding: float) -> float | None:
    number = float(value)
    if not math.isfinite(number):
        return None
    return number if abs(number) > rounding else 0.0
