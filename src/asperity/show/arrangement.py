"""Which format and scale a drawing has, and where on the sheet its views and notes stand."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from asperity.errors import InputError
from asperity.show.box import Box, around_all, covered
from asperity.show.notes import SPACING, columns_of
from asperity.show.paper import FORMATS, SCALES, Format, Paper, extended_scale
from asperity.show.sheet import TEXT_HEIGHT, Item, Point, Text, scale_text
from asperity.show.sheet_figure import text_width
from asperity.show.title_block import BLOCK_HEIGHT, BLOCK_WIDTH, MARGIN, WIDE_BLOCK

_INSET = 2.0  # of everything from the frame [mm]
_GAP = 4.0  # at least between two views, or a view and notes [mm]
_NARROWEST = 64.0  # a column of notes [mm]
_WIDEST = 130.0
_WRAP = 0.96  # of the width of a column that its lines fill; pictures of few dots draw letters wider
_LARGEST_ENLARGED = 420.0  # width of a sheet on which something is drawn larger than it is [mm]
_WIDE_ENOUGH = 400.0  # of a sheet for a wide title block [mm]
_LINES_BESIDE_TITLE = math.floor((BLOCK_HEIGHT - _INSET) / SPACING)
#: Area of views with their dimensions, notes and title block over that of the sheet, which a sheet has at least if it
#: can.
LEAST_DRAWN = 0.35
#: Likewise of the outlines of the views alone, without and beside forces.
_LEAST_OUTLINED, _BESIDE_FORCES = 0.11, 0.07
_LEAST_SEEN = 5.0  # size of the drawing on paper below which nobody sees anything on it [mm]


class Room(NamedTuple):
    """The room that a view takes on paper, from its own origin [mm].

    ``outlined``: width and height of its outlines [mm]; ``level``: whether its axis is at the height of that of the
    other views; otherwise it may stand anywhere.
    """

    box: Box
    outlined: tuple[float, float] = (0.0, 0.0)
    level: bool = True


#: Origins of the views, places of the lines of the notes, and width of the title block, all on paper [mm].
_Tried = tuple[list[Point], list[tuple[Point, str]], float]


class Arrangement(NamedTuple):
    """A sheet with room for everything: ``origins`` of the views, their ``boxes`` and all notes, on paper [mm].

    ``drawn``: share of the sheet that all this covers with the title block, ``outlined``: share of the outlines of the
    views of the drive or part, which is at least ``least_outlined`` on a sheet that is not too large.
    """

    paper: Paper
    origins: tuple[Point, ...]
    boxes: tuple[Box, ...]
    notes: tuple[tuple[Point, str], ...]
    drawn: float
    outlined: float
    least_outlined: float

    def note_items(self) -> list[Item]:
        """The notes as texts in true size."""
        return [Text(self.paper.at(*at), line) for at, line in self.notes]


def arrange(
    views: Callable[[float], Sequence[Room]],
    lines: Sequence[str],
    *,
    origin: int,
    what: str,
    size: float,
    formats: Sequence[Format] = FORMATS,
    filled: bool = True,
) -> Arrangement:
    """The smallest sheet on which a drawing is large, at the largest scale at which everything fits on it.

    Sheets beyond A3 have no enlargements. Where no sheet is filled it is the one with the largest share of outlines.

    ``views`` from a scale to the rooms of the views, from left to right; ``lines`` of the notes; ``origin``: number of
    the view whose origin is that of the drawing; ``what`` is drawn, and its ``size`` [mm], for refusals; ``filled``:
    whether the sheet has to be filled, otherwise it is the first one of the ``formats`` on which there is room.
    """
    found = [one for form in formats if (one := largest_on(form, views, lines, origin)) is not None]
    good = [
        one
        for one in found
        if not filled or (one.drawn >= LEAST_DRAWN and one.outlined >= one.least_outlined)
    ]
    best = next(iter(good or sorted(found, key=lambda one: -one.outlined)), None)
    if best is None or size * best.paper.scale < _LEAST_SEEN:
        raise InputError(_refusal(what, size, best))
    return best


def _refusal(what: str, size: float, best: Arrangement | None) -> str:
    """Why there is no sheet, and which scale one would need."""
    if best is None:
        needed = scale_text(extended_scale(size, room=FORMATS[-1].height - 2.0 * MARGIN))
        return (
            f"{what} is {size:.4g} mm across and fits on no sheet up to A0: it would need a scale of {needed}, and "
            f"those of ISO 5455 end at {scale_text(SCALES[-1])}; check the units of its sizes"
        )
    needed = scale_text(extended_scale(size, room=0.5 * FORMATS[0].width))
    return (
        f"{what} is {size:.4g} mm across: a drawing would need a scale of {needed} to show it, and the largest at "
        f"which all its views fit on a sheet is {scale_text(best.paper.scale)}; check the units of its sizes"
    )


def largest_on(
    form: Format, views: Callable[[float], Sequence[Room]], lines: Sequence[str], origin: int
) -> Arrangement | None:
    """The arrangement on a format at the largest scale that fits, one that fills it if there is one; or None."""
    for scale in SCALES:
        if scale > 1.0 and form.width > _LARGEST_ENLARGED:
            continue
        rooms = views(scale)
        tried = [_arrangement(form, scale, rooms, each, origin) for each in _arrangements(form, rooms, lines)]
        if tried:
            enough = (one for one in tried if one.drawn >= LEAST_DRAWN)
            return next(enough, max(tried, key=lambda one: one.drawn))
    return None


def _arrangement(
    form: Format, scale: float, rooms: Sequence[Room], tried: _Tried, origin: int
) -> Arrangement:
    """A sheet with its views and notes in places that were tried."""
    places, texts, title_width = tried
    boxes = tuple(room.box.moved(place) for room, place in zip(rooms, places, strict=True))
    paper = Paper(form.width, form.height, places[origin], scale, title_width)
    area = form.width * form.height
    drawn = covered([*boxes, *([_around_notes(texts)] if texts else []), paper.title_box]) / area
    outlined = sum(math.prod(room.outlined) for room in rooms) / area
    least = _LEAST_OUTLINED if all(room.level for room in rooms) else _BESIDE_FORCES
    return Arrangement(paper, tuple(places), boxes, tuple(texts), drawn, outlined, least)


def _around_notes(texts: Sequence[tuple[Point, str]]) -> Box:
    """The box around notes [mm]."""
    return around_all(Box(x, x + text_width(line), y, y + TEXT_HEIGHT) for (x, y), line in texts)


def _arrangements(form: Format, rooms: Sequence[Room], lines: Sequence[str]) -> Iterator[_Tried]:
    """Notes in a band beside the title block or in a column above it; beside a wide one if the sheet has room."""
    yield from _with_band(form, rooms, lines, BLOCK_WIDTH)
    yield from _with_column(form, rooms, lines)
    if form.width >= _WIDE_ENOUGH:
        yield from _with_band(form, rooms, lines, WIDE_BLOCK)


def _with_column(form: Format, rooms: Sequence[Room], lines: Sequence[str]) -> Iterator[_Tried]:
    """Notes above the title block, and a view that need not be level above them if it does not stand in the row."""
    low, high = MARGIN + BLOCK_HEIGHT + _GAP, form.height - MARGIN - _INSET
    right = form.width - MARGIN - _INSET
    free = None if not rooms or rooms[-1].level else rooms[-1]
    for in_row in (True, False) if free else (True,):
        wide = BLOCK_WIDTH - _INSET if in_row or free is None else max(BLOCK_WIDTH - _INSET, free.box.width)
        texts = columns_of(lines, _WRAP * wide, 1)[0]
        top = low + SPACING * len(texts)
        above = 0.0 if in_row or free is None else free.box.height + _GAP
        if top + above > high:
            continue
        row = rooms if in_row else rooms[:-1]
        places = _row(row, Box(MARGIN + _INSET, right - wide - _GAP, MARGIN + _INSET, high))
        if places is None:
            continue
        if not in_row and free is not None:
            middle = 0.5 * (right - wide + right), 0.5 * (top + _GAP + high)
            places.append(_centred(free, middle))
        left = right - wide
        notes = [((left, top - SPACING * (row + 1)), line) for row, line in enumerate(texts)]
        yield places, notes, BLOCK_WIDTH


def _with_band(
    form: Format, rooms: Sequence[Room], lines: Sequence[str], title_width: float
) -> Iterator[_Tried]:
    """Notes in columns left of the title block, and all views above."""
    left, right = MARGIN + _INSET, form.width - MARGIN - title_width - _GAP
    most = math.floor((right - left + _GAP) / (_NARROWEST + _GAP))
    tried = []
    for count in range(1, most + 1):
        wide = min(_WIDEST, (right - left - (count - 1) * _GAP) / count)
        columns = columns_of(lines, _WRAP * wide, count)
        tried.append((max(map(len, columns)), wide, columns))
    for rows, wide, columns in sorted(tried, key=lambda each: max(each[0], _LINES_BESIDE_TITLE))[:1]:
        top = MARGIN + max(BLOCK_HEIGHT, _INSET + SPACING * rows)
        room = Box(left, form.width - MARGIN - _INSET, top + _GAP, form.height - MARGIN - _INSET)
        places = _row(rooms, room)
        if places is not None:
            notes = [
                ((left + number * (wide + _GAP), top - SPACING * (row + 1) + 1.0), line)
                for number, column in enumerate(columns)
                for row, line in enumerate(column)
            ]
            yield places, notes, title_width


def _row(rooms: Sequence[Room], inside: Box) -> list[Point] | None:
    """Origins of views beside each other, spread over a box [mm]; None if they do not fit into it."""
    level = [room for room in rooms if room.level]
    low, high = min(room.box.low for room in level), max(room.box.high for room in level)
    spare = inside.width - sum(room.box.width for room in rooms)
    if (
        spare < _GAP * (len(rooms) - 1)
        or high - low > inside.height
        or any(room.box.height > inside.height for room in rooms)
    ):
        return None
    between = max(_GAP, spare / (len(rooms) + 1)) if len(rooms) > 1 else 0.0
    x = inside.left + 0.5 * (spare - between * (len(rooms) - 1))
    axis = inside.low + 0.5 * (inside.height - high - low)
    origins = []
    for room in rooms:
        y = axis if room.level else 0.5 * (inside.low + inside.high - room.box.low - room.box.high)
        origins.append((x - room.box.left, y))
        x += room.box.width + between
    return origins


def _centred(room: Room, middle: Point) -> Point:
    """The origin of a view around a middle [mm]."""
    return middle[0] - 0.5 * (room.box.left + room.box.right), middle[1] - 0.5 * (
        room.box.low + room.box.high
    )
