"""A drawing as a figure: black on white, at its scale when it is printed in full size."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

from asperity.show.sheet import ARROW_LENGTH, LINE_WIDTHS, TEXT_HEIGHT, Circle, Line, Point, Sheet, Text
from asperity.types import Document

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_MM_PER_INCH, _POINTS_PER_INCH = 25.4, 72.0
_FONT = "DejaVu Sans"
_CAP_HEIGHT = 0.729  # of this font, over its size
_DASHES: Document = {"axis": (0, (24.0, 6.0, 3.0, 6.0))}


def sheet_figure(sheet: Sheet) -> Figure:
    """A sheet as a matplotlib figure of the size of the paper."""
    from matplotlib import patches
    from matplotlib.figure import Figure

    figure = Figure(figsize=(sheet.width / _MM_PER_INCH, sheet.height / _MM_PER_INCH), facecolor="white")
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.axis("off")
    left, right, low, high = sheet.window
    axes.set(xlim=(left, right), ylim=(low, high))
    for item in sheet.items:
        if isinstance(item, Text):
            axes.text(
                *item.at,
                item.text,
                ha=item.align,
                va="baseline",
                fontsize=_points(item.height / _CAP_HEIGHT),
                color="black",
                family=_FONT,
                parse_math=False,
                bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.0},  # no line runs through a word
            )
            continue
        line: Document = {
            "linewidth": _points(LINE_WIDTHS[item.style]),
            "linestyle": _DASHES.get(item.style, "-"),
            "color": "black",
        }
        if isinstance(item, Circle):
            axes.add_patch(patches.Circle(item.centre, item.radius, fill=False, **line))
            continue
        axes.plot(*zip(*item.points, strict=True), solid_joinstyle="miter", solid_capstyle="butt", **line)
        for head in arrowheads(item, length=ARROW_LENGTH / sheet.scale):
            axes.add_patch(patches.Polygon(head, closed=True, facecolor="black", edgecolor="none"))
    return figure


@lru_cache(maxsize=4096)
def text_width(text: str, height: float = TEXT_HEIGHT) -> float:
    """Width [mm] of a line of text on paper with capital letters of a height [mm]."""
    text = text.rstrip()
    return (_advance(text) + _overhang(text[-1])) * height / _CAP_HEIGHT if text else 0.0


def _advance(text: str) -> float:
    """Where the next letter would begin, over the size of the font."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import text_to_path

    width, _, _ = text_to_path.get_text_width_height_descent(
        text, FontProperties(family=_FONT, size=1.0), ismath=False
    )
    return float(width)


@lru_cache
def _overhang(letter: str) -> float:
    """By how much the ink of a letter goes beyond where the next one begins, over the size of the font."""
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    text = f"|{letter}"  # a letter without ink alone is no path
    ink = TextPath((0.0, 0.0), text, size=1.0, prop=FontProperties(_FONT)).get_extents().x1
    return float(ink) - _advance(text)


def arrowheads(line: Line, *, length: float) -> list[tuple[Point, Point, Point]]:
    """Triangles at the ends of a line, the tip first [mm]."""
    ends = {"start": [(line.points[0], line.points[1])], "end": [(line.points[-1], line.points[-2])], "": []}
    ends["both"] = ends["start"] + ends["end"]
    heads = []
    for (x, y), (u, v) in ends[line.arrows]:
        distance = math.hypot(u - x, v - y)
        if distance == 0.0:
            continue
        e, f = (u - x) / distance, (v - y) / distance
        half = length / (3.0 if line.style == "force" else 6.0)
        x0, y0 = x + length * e, y + length * f
        heads.append(((x, y), (x0 - half * f, y0 + half * e), (x0 + half * f, y0 - half * e)))
    return heads


def _points(millimetres: float) -> float:
    return millimetres * _POINTS_PER_INCH / _MM_PER_INCH
