"""Rectangles on a sheet: what they meet, and those around texts, circles and lines."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from asperity.show.sheet import Circle, Item, Point, Text
from asperity.show.sheet_figure import text_width

_BELOW, _AROUND = (
    0.9,
    0.8,
)  # of a text: letters below its base line, and the room that it keeps free [mm on paper]


class Box(NamedTuple):
    """A rectangle by its edges [mm]."""

    left: float
    right: float
    low: float
    high: float

    @property
    def width(self) -> float:
        """From left to right [mm]."""
        return self.right - self.left

    @property
    def height(self) -> float:
        """From its lower to its upper edge [mm]."""
        return self.high - self.low

    def moved(self, by: Point) -> Box:
        """The same box somewhere else."""
        x, y = by
        return Box(x + self.left, x + self.right, y + self.low, y + self.high)

    def meets(self, other: Box) -> bool:
        """Whether it overlaps another one."""
        return (
            self.left < other.right
            and other.left < self.right
            and self.low < other.high
            and other.low < self.high
        )

    def is_inside(self, other: Box) -> bool:
        """Whether it lies within another one."""
        return (
            other.left <= self.left
            and self.right <= other.right
            and other.low <= self.low
            and self.high <= other.high
        )

    def is_crossed_by(self, one: Point, other: Point) -> bool:
        """Whether a straight line between two points runs through it."""
        (x, y), (u, v) = one, other
        if (x < self.left and u < self.left) or (x > self.right and u > self.right):
            return False  # most lines are far away
        if (y < self.low and v < self.low) or (y > self.high and v > self.high):
            return False
        first, last = 0.0, 1.0
        for start, end, low, high in (
            (one[0], other[0], self.left, self.right),
            (one[1], other[1], self.low, self.high),
        ):
            if start == end:
                if not low < start < high:
                    return False
                continue
            enter, leave = sorted(((low - start) / (end - start), (high - start) / (end - start)))
            first, last = max(first, enter), min(last, leave)
        return first < last


def text_box(text: Text, scale: float) -> Box:
    """The room of a text in true size, with a margin; ``scale`` is length on paper over true length."""
    wide = text_width(text.text, text.height)
    left = text.at[0] - {"left": 0.0, "center": 0.5, "right": 1.0}[text.align] * wide / scale
    low = text.at[1] - (_BELOW + _AROUND) / scale
    return Box(
        left - _AROUND / scale,
        left + (wide + _AROUND) / scale,
        low,
        low + (_BELOW + 2.0 * _AROUND + text.height) / scale,
    )


def box_of(item: Item, scale: float) -> Box:
    """The box around a text with its margin, a circle or a line, in true size."""
    if isinstance(item, Text):
        return text_box(item, scale)
    if isinstance(item, Circle):
        (x, y), radius = item.centre, item.radius
        return Box(x - radius, x + radius, y - radius, y + radius)
    x_values, y_values = zip(*item.points, strict=True)
    return Box(min(x_values), max(x_values), min(y_values), max(y_values))


def around_all(boxes: Iterable[Box]) -> Box:
    """The smallest box around others."""
    left, right, low, high = zip(*boxes, strict=True)
    return Box(min(left), max(right), min(low), max(high))


def covered(boxes: Iterable[Box]) -> float:
    """Area of what boxes cover together [mm²], what several cover counted once."""
    given = list(boxes)
    edges = sorted({x for box in given for x in (box.left, box.right)})
    area = 0.0
    for left, right in pairwise(edges):
        reached = -float("inf")
        for box in sorted((b for b in given if b.left <= left and right <= b.right), key=lambda b: b.low):
            area += (right - left) * max(0.0, box.high - max(box.low, reached))
            reached = max(reached, box.high)
    return area
