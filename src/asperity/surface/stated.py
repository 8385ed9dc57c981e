"""What a user states about the file of a surface: units, spacing, decimal sign, column, missing points."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

from asperity.errors import InputError
from asperity.surface.file_formats import metres_per_unit
from asperity.surface.topography import Topography

#: A spacing that is stated may differ from that of the file by such a share: it is printed in few digits.
SAME_SPACING = 0.01


@dataclass(frozen=True)
class Stated:
    """What is stated beside a file; None where the file itself has to say it.

    ``position_unit`` and ``height_unit``: units, or lengths of one count such as ``"0.5 nm"``; ``spacing`` of the
    points [m]; ``decimal`` sign of a text, "auto", "point" or "comma"; ``column`` of the heights in a text by its name
    or its number from 1; ``no_data``: number that marks missing points in the unit of the file, or several with commas
    between them, or "none" if every number is a height.
    """

    position_unit: str | None = None
    height_unit: str | None = None
    spacing: float | None = None
    decimal: str = "auto"
    column: str | None = None
    no_data: str | None = None

    def __post_init__(self) -> None:
        if self.spacing is not None and not (self.spacing > 0.0 and math.isfinite(self.spacing)):
            raise InputError(f"the spacing is {self.spacing} m; it must be a positive length")
        self.missing_marks()

    @property
    def all_are_heights(self) -> bool:
        """Whether it is stated that no number marks a missing point."""
        return self.no_data is not None and self.no_data.strip().lower() == "none"

    def missing_marks(self) -> tuple[float, ...]:
        """The stated numbers that mark missing points; none where none is stated."""
        if self.no_data is None or self.all_are_heights:
            return ()
        try:
            marks = tuple(map(float, re.split(r"\s*[,;]\s*", self.no_data.strip())))
        except ValueError:
            marks = (math.nan,)
        if any(map(math.isnan, marks)):
            raise InputError(
                f"'{self.no_data}' marks no missing point; give the number that does, such as -9999, several with "
                "commas between them, or none",
                options=["no-data"],
            )
        return marks

    def unused_decimal(self) -> str:
        """A note that the decimal sign has no meaning for a file that is no text; empty where none is stated."""
        return (
            "" if self.decimal == "auto" else "the stated decimal sign is not used: it is that of text files"
        )

    def metres(self, what: str) -> float | None:
        """The stated unit of what is measured, position or height [m]; None where none is stated."""
        unit = self.position_unit if what == "position" else self.height_unit
        return None if unit is None else metres_per_unit(unit)


def with_its_sizes(topography: Topography, stated: Stated, path: Path, kind: str) -> Topography:
    """The surface of a file that has its units and sizes; what is stated beside it must agree, or is not used.

    An ``InputError`` if a unit other than the metre, another spacing, a column or a mark of missing points is stated.
    """
    for unit, name in ((stated.height_unit, "height-unit"), (stated.position_unit, "position-unit")):
        if unit is not None and metres_per_unit(unit) != 1.0:
            raise InputError(
                f"{path.name} ({kind}) has its units, not {unit}; do not state a unit", options=[name]
            )
    for given, name in (
        (stated.column, "column"),
        (", ".join(f"{mark:g}" for mark in stated.missing_marks()) or None, "no-data"),
    ):
        if given is not None:
            raise InputError(
                f"{path.name} ({kind}) is no table of text: '{given}' has no meaning for it; do not state it",
                options=[name],
            )
    spacing = stated.spacing
    if spacing is not None and abs(spacing - topography.spacing) > SAME_SPACING * topography.spacing:
        raise InputError(
            f"{path.name} ({kind}) has a distance of its points of {topography.spacing:.6g} m, not {spacing:.6g} m; do "
            "not state it",
            options=["spacing"],
        )
    return topography.with_heights(topography.heights, stated.unused_decimal())
