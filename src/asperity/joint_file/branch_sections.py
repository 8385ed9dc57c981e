"""Sections ``[[branch]]`` of every type of drive: sizes of each branch, where they differ."""

from __future__ import annotations

from typing import Annotated

from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section

Deviation = Annotated[Quantity, limits.DEVIATION]


class BranchEntry(Section):
    """One planet with its loading rollers; write [[branch]] above each, as many as planets."""

    planet_deviation: Deviation | None = None
    """Radius of this planet above planet_radius; 0 if absent."""
    right_roller_deviation: Deviation | None = None
    """Radius of its right loading roller above loading_roller_radius; 0 if absent."""
    left_roller_deviation: Deviation | None = None
    """Radius of its left loading roller above loading_roller_radius; 0 if absent."""


class PlanetaryBranch(Section):
    """One planet; write [[branch]] above each, as many as planets, counter-clockwise."""

    planet_deviation: Deviation | None = None
    """Radius of this planet above planet_radius; 0 if absent."""


class MultirollerBranch(Section):
    """One roller of each row, the second row's next counter-clockwise.

    Write [[branch]] above each, as many as rollers in a row, counter-clockwise.
    """

    first_row_deviation: Deviation | None = None
    """Large radius of the first row's roller above first_row_radius; 0 if absent."""
    first_row_small_deviation: Deviation | None = None
    """Its small radius above first_row_small_radius; 0 if absent."""
    second_row_deviation: Deviation | None = None
    """Large radius of the second row's roller above second_row_radius; 0 if absent."""
    second_row_small_deviation: Deviation | None = None
    """Its small radius above second_row_small_radius; 0 if absent."""


class SteppedPlanetBranch(Section):
    """One stepped planet; write [[branch]] above each, as many as planets, counter-clockwise."""

    planet_deviation: Deviation | None = None
    """Radius of the track in the grounded ring above planet_radius; 0 if absent."""
    planet_second_deviation: Deviation | None = None
    """Radius of the track in the driven ring above planet_second_radius; 0 if absent."""


def refuse_branches(section_count: int, *, count: int, what: str, by_interference: bool) -> None:
    """Refuse sections ``[[branch]]`` that do not belong to their drive."""
    if section_count != count:
        raise InputError(f"the drive has {count} {what}, but there are {section_count} sections [[branch]]")
    if not by_interference:
        raise InputError(
            "[[branch]] needs load.interference in place of load.preload: sizes make no preload that a spring holds"
        )
