"""What already stands on a sheet, so that texts and leaders find a place that is free."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

from asperity.show.sheet import Circle, Item, Line, Point, Text
from asperity.show.sheet_figure import text_width

_BELOW, _AROUND = (
    0.9,
    0.8,
)  # of a text: letters below its base line, and the room that it keeps free [mm on paper]
_LEADER_DISTANCE = 1.0  # between two leaders [mm on paper]
#: Styles of lines that belong to the drive; texts and leaders may cross them.
_DRIVE = ("outline", "axis", "frame")


class Box(NamedTuple):
    """A rectangle by its edges [mm]."""

    left: float
    right: float
    low: float
    high: float

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


class Taken:
    """Texts and lines of a sheet; ``scale`` is length on paper over true length, ``paper`` where texts may stand."""

    def __init__(self, scale: float, paper: Box) -> None:
        self.scale = scale
        self._paper = paper
        self._boxes: list[Box] = []
        self._lines: list[tuple[Point, Point]] = []
        self._crossable: list[tuple[Point, Point]] = []

    def add(self, items: Iterable[Item], *, crossable: bool = False) -> None:
        """Take the place of items; leaders may cross lines that are ``crossable``, texts never."""
        for item in items:
            if isinstance(item, Text):
                if item.text.strip():
                    self._boxes.append(text_box(item, self.scale))
            elif isinstance(item, Line) and item.style not in _DRIVE:
                segments = self._crossable if crossable else self._lines
                segments += zip(item.points, item.points[1:], strict=False)

    def add_areas(self, items: Iterable[Item]) -> None:
        """Take whole areas of circles, as of bodies that are drawn apart, besides texts and lines."""
        for item in items:
            if isinstance(item, Circle):
                (x, y), radius = item.centre, item.radius
                self._boxes.append(Box(x - radius, x + radius, y - radius, y + radius))
            else:
                self.add([item])

    def add_box(self, box: Box) -> None:
        """Take a rectangle."""
        self._boxes.append(box)

    def has_room(self, items: Iterable[Item]) -> bool:
        """Whether the texts and leaders among items are on the paper and cover nothing."""
        for item in items:
            if isinstance(item, Text):
                box = text_box(item, self.scale)
                lines = (*self._lines, *self._crossable)
                if (
                    not box.is_inside(self._paper)
                    or any(box.meets(other) for other in self._boxes)
                    or any(box.is_crossed_by(*line) for line in lines)
                ):
                    return False
            elif isinstance(item, Line):
                for one, other in zip(item.points, item.points[1:], strict=False):
                    if any(box.is_crossed_by(one, other) for box in self._boxes) or any(
                        distance((one, other), line) * self.scale < _LEADER_DISTANCE for line in self._lines
                    ):
                        return False
        return True


def distance(one: tuple[Point, Point], other: tuple[Point, Point]) -> float:
    """Distance between two straight lines of finite length [mm]."""
    (a, b), (c, d) = one, other
    if _side(a, b, c) * _side(a, b, d) < 0.0 and _side(c, d, a) * _side(c, d, b) < 0.0:
        return 0.0
    return min(_from_line(a, c, d), _from_line(b, c, d), _from_line(c, a, b), _from_line(d, a, b))


def _side(a: Point, b: Point, c: Point) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _from_line(point: Point, a: Point, b: Point) -> float:
    x, y = b[0] - a[0], b[1] - a[1]
    length = x * x + y * y
    along = 0.0 if length == 0.0 else ((point[0] - a[0]) * x + (point[1] - a[1]) * y) / length
    along = min(max(along, 0.0), 1.0)
    return math.hypot(point[0] - a[0] - along * x, point[1] - a[1] - along * y)
