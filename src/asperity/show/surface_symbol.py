"""The symbol of a surface on a drawing, after ISO 21920-1: any process, on an extension line of the surface."""

from __future__ import annotations

import math
from collections.abc import Sequence

from asperity.show.sheet import TEXT_HEIGHT, Item, Line, Point, Text
from asperity.show.sheet_figure import text_width

_SHORT, _LONG = 3.5, 8.0  # heights of the arms of letters of 2.5 mm [mm on paper]
_SLOPE = math.tan(math.radians(60.0))
_LINE = 3.4  # between two base lines [mm on paper]
_FROM_FACE, _BEYOND = 2.0, 3.0  # of a symbol from the part, and of the extension line beyond it [mm on paper]


def surface_symbol(lines: Sequence[str], at: Point, scale: float) -> list[Item]:
    """Arms that stand on a surface at a point [mm], and what is required of it under the line at the longer one."""
    wide = max(map(text_width, lines))
    high = _LONG + _LINE * (len(lines) - 1)

    def on(x: float, y: float) -> Point:
        return at[0] + x / scale, at[1] + y / scale

    end = high / _SLOPE
    arms = Line(
        (on(-_SHORT / _SLOPE, _SHORT), on(0.0, 0.0), on(end, high), on(end + wide + 2.0, high)), "break"
    )
    return [
        arms,
        *(
            Text(on(end + 0.8, high - 1.0 - TEXT_HEIGHT - _LINE * row), line)
            for row, line in enumerate(lines)
        ),
    ]


def symbols_of_tracks(
    tracks: Sequence[tuple[float, float, float, Sequence[str]]], scale: float
) -> list[Item]:
    """Symbols of the tracks of a part on extension lines: that of the first one left of it, that of the last one right.

    Of each track from left to right the height of its surface and its two ends [mm], and the lines of its symbol, none
    for no symbol. Tracks between others have no room for one; the notes state their surfaces too.
    """
    items: list[Item] = []
    for number, (height, left, right, lines) in enumerate(tracks):
        if not lines or 0 < number < len(tracks) - 1:
            continue
        if number == 0:
            face, vertex = left, left - (_FROM_FACE + width_of(lines)) / scale
            far = vertex - _BEYOND / scale
        else:
            face, vertex = right, right + (_FROM_FACE + _SHORT / _SLOPE) / scale
            far = vertex + _BEYOND / scale
        items.append(Line(((face, height), (far, height)), "thin"))
        items += surface_symbol(lines, (vertex, height), scale)
    return items


def width_of(lines: Sequence[str]) -> float:
    """Width of a symbol right of the point on which it stands [mm on paper]."""
    return (_LONG + _LINE * (len(lines) - 1)) / _SLOPE + max(map(text_width, lines)) + 2.0
