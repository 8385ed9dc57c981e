"""Dimension lines and leaders with their texts, for the drawings of every drive."""

from __future__ import annotations

import math
from collections.abc import Iterable

from asperity.show.sheet import ARROW_LENGTH, Align, Line, Point, Text
from asperity.show.sheet_figure import text_width

#: Of a leader beside its text [mm on paper].
SHOULDER = 3.0
_ROW, _BEYOND = (
    7.0,
    1.5,
)  # of dimension lines below each other, and of extension lines beyond them [mm on paper]
_LOWERED = 1.2  # base line of a text below the middle of its letters [mm on paper]
_FROM_AXIS, _FROM_LINE = 6.0, 2.0  # of the text of a diameter from the axis, or from an extension line
_ROOM_FOR_ARROWS = 3.0 * ARROW_LENGTH


def dimension(value: float) -> str:
    """A length as a drawing states it: mm, six digits, no trailing zeros.

    Parameters
    ----------
    value : float
        The length [mm].

    Returns
    -------
    str
        The number alone.
    """
    return f"{value:.6g}"


def made_bore(radius: float, interference: float | None) -> str:
    """The diameter to which a ring is made."""
    if interference is None:
        return f"⌀{dimension(2.0 * radius)} less 2 × interference"
    if interference == 0.0:
        return f"⌀{dimension(2.0 * radius)}"
    decimals = max(4, 2 - math.floor(math.log10(2e3 * abs(interference))))
    return "⌀" + f"{2.0 * radius - 2e3 * interference:.{decimals}f}".rstrip("0").rstrip(".")


def leader(
    tip: Point, end: Point, text: str, *, scale: float, align: Align = "left", arrow: bool = True
) -> tuple[Line, Text]:
    """A line from an outline or a mark to a text beside it."""
    x, y = end
    side = -1.0 if align == "right" else 1.0
    line = Line((tip, (x - side * SHOULDER / scale, y), end), arrows="start" if arrow else "")
    return line, Text((x + side * 1.0 / scale, y - _LOWERED / scale), text, align)


def widths_below(
    widths: Iterable[tuple[float, str]], low: float, *, scale: float
) -> list[tuple[tuple[Line, Line], tuple[Line, Text]]]:
    """Diameters of circles about the origin as dimension lines below each other."""
    dimensions = []
    for row, (half, text) in enumerate(widths, start=1):
        y, end = low - row * _ROW / scale, low - (row * _ROW + _BEYOND) / scale
        extensions = Line(((-half, 0.0), (-half, end))), Line(((half, 0.0), (half, end)))
        across = Line(((-half, y), (half, y)), arrows="both")
        fits = _FROM_AXIS + text_width(text) + _FROM_LINE < half * scale
        x = _FROM_AXIS / scale if fits else half + _FROM_LINE / scale
        dimensions.append((extensions, (across, Text((x, y + 1.0 / scale), text))))
    return dimensions


def distance_mark(ends: tuple[Point, Point], *, scale: float) -> tuple[Line, ...]:
    """A dimension line between two points: its arrows inside, or outside where it is short on paper."""
    (x, y), (u, v) = ends
    length = math.dist(*ends)
    if length * scale >= _ROOM_FOR_ARROWS:
        return (Line(ends, arrows="both"),)
    beyond = 2.0 * ARROW_LENGTH / scale / length
    e, f = beyond * (u - x), beyond * (v - y)
    return (
        Line(((x - e, y - f), (x, y)), arrows="end"),
        Line(ends),
        Line(((u + e, v + f), (u, v)), arrows="end"),
    )
