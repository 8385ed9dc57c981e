"""Dimensions of a view: below it, and on leaders beside it, where they cover nothing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from asperity.show.box import Box, text_box
from asperity.show.dimension_lines import room_below, widths_below
from asperity.show.drive_sizes import Clearance, Size
from asperity.show.drive_view import MOST_GAPS
from asperity.show.sheet import Circle, Dimension, Item, Line, Point, Text
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Side, Taken, best_leader, levels

_BESIDE = 9.0  # of texts from the view [mm on paper]
_OF_TEXT = 3.0  # around a text at its leader [mm on paper]
_OTHER_SIDE = 12.0  # what a leader to the side that is not the usual one costs [mm on paper]


class Dimensions(NamedTuple):
    """Dimension lines, leaders and texts of the view.

    ``unplaced``: numbers of the sizes for which there is no room; ``letters``: number of a clearance → its letter in
    the view; ``measured``: what the items say together.
    """

    items: list[Item]
    unplaced: frozenset[int]
    letters: dict[int, str]
    measured: list[Dimension]


def place_dimensions(
    sizes: Sequence[Size],
    clearances: Sequence[Clearance],
    outlines: list[Circle],
    *,
    view: Box,
    paper: Box,
    taken: Taken,
    listed: frozenset[int] = frozenset(),
    letters: str = "ABC",
) -> Dimensions:
    """Show sizes where they cover nothing: below or beside a ``view`` and within the ``paper`` that it has."""
    scale, items, measured = taken.scale, list[Item](), list[Dimension]()
    waiting = [number for number in range(len(sizes)) if number not in listed]
    rows: list[tuple[float, str]] = []
    for radius, number in sorted((sizes[n].radius or 0.0, n) for n in waiting if sizes[n].below):
        row = (radius, sizes[number].label)
        below = widths_below([*rows, row], view.low, scale=scale)[-1]
        if taken.has_room(below.items):
            rows.append(row)
            taken.add(below.items[:2], crossable=True)
            taken.add(below.items[2:])
            measured.append(below)
            items += below.items
            waiting.remove(number)
    heights = levels(paper.low, paper.high, scale)
    right = Side(view.right + _BESIDE / scale, "left", heights)
    left = Side(view.left - _BESIDE / scale, "right", heights)
    lettered: dict[int, str] = {}
    for number, gap in enumerate(clearances):
        if len(lettered) == len(letters):
            break
        letter = letters[len(lettered)]
        text = f"{letter} {gap.size:.4g}"
        leader = gap.places and best_leader(
            text, gap.places, (right._replace(handicap=_OTHER_SIDE), left), outlines, taken
        )
        if leader:
            lettered[number] = letter
            taken.add(leader)
            items += leader
            measured.append(Dimension(_marked(leader), tuple(leader)))
    unplaced = set()
    for number in waiting:
        size = sizes[number]
        leader = size.places and best_leader(
            size.label, size.places, (right, left._replace(handicap=_OTHER_SIDE)), outlines, taken
        )
        if leader:
            taken.add(leader)
            items += leader
            ends = _marked(leader) if size.radius is None else _opposite(leader, size)
            measured.append(Dimension(ends, tuple(leader), diameter=size.radius is not None))
        else:
            unplaced.add(number)
    return Dimensions(items, frozenset(unplaced), lettered, measured)


def room_of_dimensions(
    sizes: Sequence[Size],
    clearances: Sequence[Clearance],
    listed: frozenset[int],
    *,
    right: float,
    scale: float,
) -> tuple[float, float, float]:
    """Room for dimensions left, right and below a view, whose right edge is at ``right`` [mm]: on paper [mm]."""
    shown = [size for number, size in enumerate(sizes) if number not in listed]
    gaps = [text_width(f"A {gap.size:.4g}") for gap in clearances if gap.places][:MOST_GAPS]
    beside = [_BESIDE + _OF_TEXT + text_width(size.label) for size in shown if not size.below]
    rows = [(size.radius or 0.0, size.label) for size in shown if size.below]
    for (radius, label), row in zip(rows, widths_below(rows, 0.0, scale=scale), strict=True):
        text = row.items[-1]
        if (
            isinstance(text, Text) and text_box(text, scale).right > radius
        ):  # beside its line, or else on a leader
            beside += [scale * (text_box(text, scale).right - right), _BESIDE + _OF_TEXT + text_width(label)]
    return _BESIDE + _OF_TEXT + max(gaps) if gaps else 0.0, max(beside, default=0.0), room_below(len(rows))


def _marked(leader: Sequence[Item]) -> tuple[Point, Point]:
    """The ends of the distance that a mark with its leader measures."""
    one, other = next(
        item.points for item in leader if isinstance(item, Line) and item.arrows in ("", "both")
    )
    return one, other


def _opposite(leader: Sequence[Item], size: Size) -> tuple[Point, Point]:
    """The tip of a leader to a circle, and the point of the circle opposite to it."""
    tip = next(item.points[0] for item in leader if isinstance(item, Line))
    e, f = next(place.outward for place in size.places if place.tip == tip and place.outward is not None)
    across = 2.0 * (size.radius or 0.0)
    return tip, (tip[0] - across * e, tip[1] - across * f)
