"""Dimension lines and leaders with their texts, for the drawings of every drive."""

from __future__ import annotations

import math
from collections.abc import Iterable

from asperity.library.tolerance_grades import LARGEST_SIZE, grade_within
from asperity.show.sheet import ARROW_LENGTH, Align, Dimension, Line, Point, Text
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
    """A length [mm] as a drawing states it: six digits, no trailing zeros."""
    return f"{value:.6g}"


def toleranced(value: float, tolerance: float) -> str:
    """A length and its tolerance to either side [mm], to a twentieth of the tolerance; the length alone without one."""
    if not tolerance > 0.0:
        return dimension(value)
    decimals = max(0, 1 - math.floor(math.log10(tolerance)))
    return f"{value:.{decimals}f} ±{tolerance:.{decimals}f}"


def diameter(radius: float, tolerance: float) -> str:
    """A diameter by its radius [mm], with its tolerance and standard grade by that of the radius [mm]."""
    graded = tolerance > 0.0 and 2e-3 * radius <= LARGEST_SIZE
    grade = grade_within(2e-3 * radius, 4e-3 * tolerance) if graded else ""
    return f"⌀{toleranced(2.0 * radius, 2.0 * tolerance)}" + (f" ({grade})" if grade else "")


def made_bore(radius: float, interference: float | None, tolerance: float = 0.0) -> str:
    """The diameter to which a ring is made, by radii and their tolerance [mm] and an interference [m]."""
    if interference is None:
        return f"{diameter(radius, tolerance)} less 2 × interference"
    made = radius - 1e3 * interference
    if interference == 0.0 or tolerance > 0.0:
        return diameter(made, tolerance)
    decimals = max(4, 2 - math.floor(math.log10(2e3 * abs(interference))))
    return "⌀" + f"{2.0 * made:.{decimals}f}".rstrip("0").rstrip(".")


def leader(
    tip: Point, end: Point, text: str, *, scale: float, align: Align = "left", arrow: bool = True
) -> tuple[Line, Text]:
    """A line from an outline or a mark to a text beside it."""
    x, y = end
    side = -1.0 if align == "right" else 1.0
    line = Line((tip, (x - side * SHOULDER / scale, y), end), arrows="start" if arrow else "")
    return line, Text((x + side * 1.0 / scale, y - _LOWERED / scale), text, align)


def width_below(
    ends: tuple[float, float],
    text: str,
    *,
    begin: float,
    low: float,
    row: int,
    scale: float,
    beside: bool = False,
) -> Dimension:
    """A dimension line in a row below a view; its first two items are the extension lines, from a height.

    Its text stands ``beside`` it, or above it if there is room.
    """
    left, right = ends
    y, end = low - row * _ROW / scale, low - (row * _ROW + _BEYOND) / scale
    extensions = Line(((left, begin), (left, end))), Line(((right, begin), (right, end)))
    marks = distance_mark(((left, y), (right, y)), scale=scale)
    half = 0.5 * (right - left) * scale
    at = 0.5 * (left + right) + _FROM_AXIS / scale, y + 1.0 / scale
    if beside or _FROM_AXIS + text_width(text) + _FROM_LINE >= half:
        outside = _FROM_LINE + (2.0 * ARROW_LENGTH if len(marks) > 1 else 0.0)
        at = right + outside / scale, y + (-_LOWERED if beside else 1.0) / scale
    return Dimension(((left, begin), (right, begin)), (*extensions, *marks, Text(at, text)))


def widths_below(widths: Iterable[tuple[float, str]], low: float, *, scale: float) -> list[Dimension]:
    """Diameters of circles about the origin as dimension lines below each other."""
    return [
        width_below((-half, half), text, begin=0.0, low=low, row=row, scale=scale)
        for row, (half, text) in enumerate(widths, start=1)
    ]


def room_below(rows: int) -> float:
    """Height of so many dimension lines below a view [mm on paper]."""
    return rows * _ROW + 2.0 * _BEYOND if rows else 0.0


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
