"""The sizes of a drive in its view: dimension lines below, leaders at both sides, and what finds no room."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from asperity.show.dimension_lines import widths_below
from asperity.show.drive_sizes import Clearance, Size
from asperity.show.leader_places import Side, best_leader, levels
from asperity.show.sheet import Circle, Item
from asperity.show.taken import Box, Taken
from asperity.show.view_parts import MOST_GAPS

_BESIDE = 9.0  # of texts from the view [mm on paper]
_OTHER_SIDE = 12.0  # what a leader to the side that is not the usual one costs [mm on paper]


class Dimensions(NamedTuple):
    """What the view shows and what it does not.

    Parameters
    ----------
    items : list of Item
        Dimension lines, leaders and texts.
    unplaced : frozenset of int
        Numbers of the sizes for which there is no room.
    letters : dict
        Number of a clearance → its letter in the view.
    """

    items: list[Item]
    unplaced: frozenset[int]
    letters: dict[int, str]


def place_dimensions(
    sizes: Sequence[Size],
    clearances: Sequence[Clearance],
    outlines: list[Circle],
    *,
    reach: float,
    paper: Box,
    taken: Taken,
    listed: frozenset[int] = frozenset(),
) -> Dimensions:
    """Show sizes where they cover nothing."""
    scale, items = taken.scale, list[Item]()
    waiting = [number for number in range(len(sizes)) if number not in listed]
    rows: list[tuple[float, str]] = []
    for radius, number in sorted((sizes[n].radius or 0.0, n) for n in waiting if sizes[n].radius is not None):
        row = (radius, sizes[number].label)
        extensions, across = widths_below([*rows, row], -reach, scale=scale)[-1]
        if taken.has_room((*extensions, *across)):
            rows.append(row)
            taken.add(extensions, crossable=True)
            taken.add(across)
            items += [*extensions, *across]
            waiting.remove(number)
    heights = levels(paper.low, paper.high, scale)
    beside = reach + _BESIDE / scale
    right, left = Side(beside, "left", heights), Side(-beside, "right", heights)
    letters: dict[int, str] = {}
    for number, gap in enumerate(clearances):
        if len(letters) == MOST_GAPS:
            break
        letter = "ABC"[len(letters)]
        text = f"{letter} {gap.size:.4g}"
        found = gap.places and best_leader(
            text, gap.places, (right._replace(handicap=_OTHER_SIDE), left), outlines, taken
        )
        if found:
            letters[number] = letter
            taken.add(found)
            items += found
    unplaced = set()
    for number in waiting:
        size = sizes[number]
        found = size.places and best_leader(
            size.label, size.places, (right, left._replace(handicap=_OTHER_SIDE)), outlines, taken
        )
        if found:
            taken.add(found)
            items += found
        else:
            unplaced.add(number)
    return Dimensions(items, frozenset(unplaced), letters)
