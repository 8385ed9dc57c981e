"""Where a drive is cut for its section: the ends of the cutting line, their arrows and letters, after ISO 128-3."""

from __future__ import annotations

import math
from collections.abc import Sequence

from asperity.joint.description import Joint, places
from asperity.show.drive_view import copies_of, radii_of, reach_of, rings_of
from asperity.show.sheet import TITLE_HEIGHT, Item, Line, Point, Text

#: The section and both ends of its cutting line.
LETTER = "A"
_FROM_VIEW, _LONG, _ARROW, _TO_LETTER = 1.0, 5.0, 7.0, 3.0  # of an end of the line [mm on paper]
_AT_BEND = 2.0  # of the line on each side of a bend [mm on paper]


def cutting_path(joint: Joint) -> list[Point]:
    """The cutting line [mm]: from outside through one contact after the other to the axis, and out again.

    It comes out through another sector, or, of bodies in a frame, which have one sector, beyond the first body.
    """
    chain, ring = _chain(joint)
    centres = [copies_of(joint, body)[0] for body in chain]
    if ring is None:
        radii = [max(radii_of(joint, body)) for body in (chain[0], chain[-1])]
        begin = _beyond(centres[1], centres[0], radii[0])
        return [_beyond(centres[-2], centres[-1], radii[1]), *reversed(centres), begin]
    x, y = centres[-1]
    share = reach_of(joint) / math.hypot(x, y)
    out = [*centres, (x * share, y * share)]
    sectors = round(float(joint.drive.sectors))
    turn = 2.0 * math.pi * (sectors // 2) / sectors
    e, f = math.cos(turn), math.sin(turn)
    return [*reversed(out), *((x * e - y * f, x * f + y * e) for x, y in out[1:])]


def _chain(joint: Joint) -> tuple[list[int], int | None]:
    """Numbers of bodies that touch each other, from the axis outwards, and that of the ring beyond them, if any."""
    first, second = places(joint.drive)
    rings = {ring.body for ring in rings_of(joint)}
    start = next(number for number in range(len(joint.drive.bodies)) if number not in rings)
    ways = {start: [start]}
    for _ in joint.drive.bodies:
        for number, contact in enumerate(joint.drive.contacts):
            if contact.sector == 0:
                for one, other in ((first[number], second[number]), (second[number], first[number])):
                    if one in ways and one not in rings:
                        ways.setdefault(other, [*ways[one], other])
    found = next((body for body in ways if body in rings), None)
    if found is not None and len(ways[found]) > 2:
        return ways[found][:-1], found
    return max(ways.values(), key=len), None


def _beyond(one: Point, other: Point, far: float) -> Point:
    """A point on the line from one point through another, so far beyond that [mm]."""
    share = far / math.dist(one, other)
    return other[0] + share * (other[0] - one[0]), other[1] + share * (other[1] - one[1])


def cutting_marks(joint: Joint, scale: float) -> list[Item]:
    """Both ends of the cutting line with arrows to the left, where its section stands, and its bends."""
    path = cutting_path(joint)
    items = [
        *_end(path[1], path[0], scale, turned=1.0),
        *_end(path[-2], path[-1], scale, turned=-1.0),
    ]
    for before, at, after in zip(path, path[1:], path[2:], strict=False):
        if is_bent((before, at, after)):
            one, other = _towards(at, before, _AT_BEND / scale), _towards(at, after, _AT_BEND / scale)
            items.append(Line((one, at, other), "outline"))
    return items


def is_bent(path: Sequence[Point]) -> bool:
    """Whether a line through points has a bend."""
    return any(
        abs((a[0] - b[0]) * (c[1] - b[1]) - (a[1] - b[1]) * (c[0] - b[0]))
        > 1e-6 * math.dist(a, b) * math.dist(b, c)
        for a, b, c in zip(path, path[1:], path[2:], strict=False)
    )


def _towards(one: Point, other: Point, far: float) -> Point:
    """A point so far from one on the line to another [mm]."""
    share = far / math.dist(one, other)
    return one[0] + share * (other[0] - one[0]), one[1] + share * (other[1] - one[1])


def _end(inner: Point, outer: Point, scale: float, *, turned: float) -> list[Item]:
    """A wide line beyond the view, an arrow that says from where one looks, and the letter beside it."""
    far = math.dist(inner, outer)
    e, f = (outer[0] - inner[0]) / far, (outer[1] - inner[1]) / far
    u, v = -turned * f, turned * e  # along the arrow

    def at(out: float, back: float) -> Point:
        return outer[0] + (out * e - back * u) / scale, outer[1] + (out * f - back * v) / scale

    tip = at(_FROM_VIEW + _LONG, 0.0)
    x, y = at(_FROM_VIEW + _LONG, _ARROW + _TO_LETTER)
    return [
        Line((at(_FROM_VIEW, 0.0), tip), "outline"),
        Line((at(_FROM_VIEW + _LONG, _ARROW), tip), "thin", "end"),
        Text((x, y - 0.5 * TITLE_HEIGHT / scale), LETTER, "center", TITLE_HEIGHT),
    ]
