"""What already stands on a sheet, and where a leader and its text find a place that is free."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np

from asperity.show.box import Box, text_box
from asperity.show.dimension_lines import SHOULDER, leader
from asperity.show.sheet import Align, Circle, Item, Line, Point, Text

_LEADER_DISTANCE = 1.0  # between two leaders [mm on paper]
#: Styles of lines that belong to the drive; texts and leaders may cross them.
_DRIVE = ("outline", "axis", "frame")


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


_STEP = 2.5  # between two levels that are tried [mm on paper]
_MOST_TRIED = 400
_NEAR = 1.5  # of an arrow to another outline, where it may seem to mean that one [mm on paper]
# what a leader costs, in mm of its length on paper
_PER_LEVEL, _PER_OUTLINE, _PER_SLANT, _PER_NEAR, _ALONG_MARK = 0.5, 12.0, 12.0, 15.0, 30.0


class Place(NamedTuple):
    """Where a leader may begin [mm].

    ``outward``: unit vector along which it comes best, away from its outline, None where it makes no difference;
    ``mark``: what is drawn with it, for example a dimension line across a wall; the leader then has no arrow.
    """

    tip: Point
    outward: Point | None = None
    mark: tuple[Line, ...] = ()


class Side(NamedTuple):
    """A column of texts beside the view, at levels [mm]; its leaders end at ``x`` [mm].

    ``align`` is ``left`` for the column right of the view, whose texts begin there; ``handicap`` is what a leader on
    this side costs besides [mm on paper].
    """

    x: float
    align: Align
    levels: tuple[float, ...]
    handicap: float = 0.0


def levels(low: float, high: float, scale: float) -> tuple[float, ...]:
    """Levels between two heights, none of them at the height of the axis [mm]."""
    step = _STEP / scale
    first, last = math.ceil(low / step - 0.5), math.floor(high / step - 0.5)
    return tuple(step * (number + 0.5) for number in range(last, first - 1, -1))


def around(centre: Point, radius: float, start: float, count: int) -> list[Place]:
    """Places on a circle."""
    places = []
    for index in range(count):
        angle = start + 2.0 * math.pi * (index + 0.5) / count
        e, f = math.cos(angle), math.sin(angle)
        places.append(Place((centre[0] + radius * e, centre[1] + radius * f), (e, f)))
    return places


def best_leader(
    text: str, places: Sequence[Place], sides: Sequence[Side], circles: Sequence[Circle], taken: Taken
) -> list[Item] | None:
    """The leader that is short, level, crosses few outlines, and has room with its text and its mark."""
    scale = taken.scale
    tried: list[tuple[float, int, int, float]] = []
    for number, side in enumerate(sides):
        free = tuple(y for y in side.levels if taken.has_room([_items(text, places[0], side, y, scale)[-1]]))
        if not free:
            continue
        costs = _costs(places, side._replace(levels=free), circles, scale)
        for index in np.argsort(costs, axis=None, kind="stable")[:_MOST_TRIED]:
            which, level = np.unravel_index(int(index), costs.shape)
            tried.append((float(costs[which, level]), number, int(which), free[level]))
    for _, number, chosen, height in sorted(tried)[:_MOST_TRIED]:
        items = _items(text, places[chosen], sides[number], height, scale)
        if taken.has_room(items):
            return items
    return None


def _items(text: str, place: Place, side: Side, level: float, scale: float) -> list[Item]:
    """Mark, leader and text."""
    end = (side.x, level)
    words = leader(place.tip, end, text, scale=scale, align=side.align, arrow=not place.mark)
    return [*place.mark, *words]


def _costs(places: Sequence[Place], side: Side, circles: Sequence[Circle], scale: float) -> np.ndarray:
    """Cost of every leader [mm on paper], shape (places, levels)."""
    x = side.x - (SHOULDER if side.align == "left" else -SHOULDER) / scale
    tips = np.array([place.tip for place in places])[:, None]
    ends = np.stack([np.full(len(side.levels), x), np.array(side.levels)], axis=-1)[None]
    along = ends - tips
    length = np.hypot(along[..., 0], along[..., 1])
    normals = np.array([(0.0, 0.0) if place.outward is None else place.outward for place in places])[:, None]
    marks = np.array([_direction(place.mark) for place in places])[:, None]
    directed = np.any(normals != 0.0, axis=-1)
    slant = np.where(directed, 1.0 - (along * normals).sum(axis=-1) / length, 0.0)
    centres = np.array([circle.centre for circle in circles]).reshape(-1, 2)
    radii = np.array([circle.radius for circle in circles])
    from_tip = abs(np.hypot(*(tips - centres).transpose(2, 0, 1)) - radii)  # of each tip from each outline
    near = ((from_tip > 1e-6 * radii) & (from_tip < _NEAR / scale)).any(axis=1)
    return (
        side.handicap
        + scale * (length + _PER_LEVEL * abs(along[..., 1]))
        + _PER_OUTLINE * crossings(tips + 0.5 / scale * along / length[..., None], ends, centres, radii)
        + _PER_SLANT * slant
        + _PER_NEAR * near[:, None]
        + _ALONG_MARK * ((along * marks).sum(axis=-1) / length) ** 2
    )


def _direction(mark: tuple[Line, ...]) -> Point:
    """Unit vector along a mark."""
    if not mark:
        return 0.0, 0.0
    (x, y), (u, v) = mark[0].points
    far = math.dist((x, y), (u, v))
    return (u - x) / far, (v - y) / far


def crossings(starts: np.ndarray, ends: np.ndarray, centres: np.ndarray, radii: np.ndarray) -> np.ndarray:
    """How often straight lines cross circles, shape (...)."""
    one, other = np.broadcast_arrays(starts, ends)
    from_one, along = centres - one[..., None, :], (other - one)[..., None, :]
    share = np.clip((from_one * along).sum(axis=-1) / (along**2).sum(axis=-1), 0.0, 1.0)
    closest = np.hypot(*np.moveaxis(from_one - share[..., None] * along, -1, 0))
    first = np.hypot(*np.moveaxis(from_one, -1, 0)) > radii
    last = np.hypot(*np.moveaxis(centres - other[..., None, :], -1, 0)) > radii
    counted = np.where(first & last, 2 * (closest < radii), first.astype(int) ^ last.astype(int))
    return counted.sum(axis=-1)
