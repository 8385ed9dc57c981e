"""The front view of a drive: outlines and axes of its bodies, and the names of its contacts."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import contact_angles
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.housing import seated
from asperity.show.box import text_box
from asperity.show.sheet import Circle, Item, Line, Point, Text
from asperity.show.taken import Taken

#: Wall over inner radius of the ring from which on the drawing breaks it off.
LONGEST_WALL = 0.5
#: How much of a wall that is broken off is drawn, over the inner radius.
SHOWN_OF_BROKEN = 0.2
_WAVES = 24
#: How many clearances are drawn.
MOST_GAPS = 3


def break_line(inner: float, shown: float) -> Line:
    """A wavy line around the part of a ring that is drawn."""
    count = 16 * _WAVES
    amplitude = 0.03 * (shown - inner)
    points = []
    for index in range(count + 1):
        angle = 2.0 * math.pi * index / count
        radius = shown + amplitude * math.sin(_WAVES * angle)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return Line(tuple(points), "break")


_LONGEST_NAME = 16
_DISTANCES = (4.5, 6.0, 8.0, 11.0, 15.0, 20.0, 26.0)  # of a name from its contact [mm on paper]
_DIRECTIONS = 24
_PER_LINE, _PER_OUTLINE = (
    3.0,
    20.0,
)  # what an axis or an outline through a name costs, in mm of its distance on paper
_LINE_TOO_NEAR, _NO_ROOM = (
    1e2,
    1e3,
)  # where contacts lie close together, their lines may meet rather than their names


class RingOfBody(NamedTuple):
    """Radii [mm] of a ring as drawn.

    It ends at ``shown``, which is less than ``outer`` where the wall is broken off.
    """

    body: int
    inner: float
    outer: float
    shown: float


def rings_of(joint: Joint) -> list[RingOfBody]:
    """The rings of a drive, each with its track; a thick wall is broken off [mm]."""
    rings = []
    for number, shape in enumerate(joint.shapes):
        if shape.kind == "ring" and shape.size is not None:
            wall = 1e3 * float(shape.size)
            for inner in radii_of(joint, number):
                shown = wall if wall <= LONGEST_WALL * inner else SHOWN_OF_BROKEN * inner
                rings.append(RingOfBody(number, inner, inner + wall, inner + shown))
    return rings


def housing_of(joint: Joint, ring: RingOfBody) -> float | None:
    """Outer radius of the housing that holds a ring [mm]; None without one, or if the ring is broken off before it."""
    if joint.housing is None or not seated(joint)[ring.body] or ring.shown < ring.outer:
        return None
    return 1e3 * float(joint.housing.outer_radius)


def radii_of(joint: Joint, number: int) -> list[float]:
    """Radii of the tracks of a body [mm]."""
    return list(dict.fromkeys(1e3 * float(radius) for radius, _ in tracks_of(joint, number)))


def pin_diameter_of(joint: Joint, number: int) -> float:
    """Diameter of the pin of a body [mm]; 0 where it has none, or the joint does not state it."""
    diameter = joint.shapes[number].pin_diameter
    if diameter is None or joint.drive.bodies[number].place != "pin":
        return 0.0
    return 1e3 * float(diameter)


def copies_of(joint: Joint, number: int) -> list[Point]:
    """Centres of the copies of a body in all sectors [mm]."""
    x, y = (1e3 * float(coordinate) for coordinate in np.asarray(joint.drive.centres)[number])
    count = 1 if joint.drive.bodies[number].on_axis else round(float(joint.drive.sectors))
    turns = (2.0 * math.pi * sector / float(joint.drive.sectors) for sector in range(count))
    return [
        (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)) for turn in turns
    ]


def reach_of(joint: Joint) -> float:
    """Distance of the farthest point of the view from the axis [mm]."""
    rings = rings_of(joint)
    discs = [n for n in range(len(joint.shapes)) if n not in {ring.body for ring in rings}]
    return max(
        *(housing_of(joint, ring) or ring.shown for ring in rings),
        *(math.hypot(*copies_of(joint, n)[0]) + max(radii_of(joint, n)) for n in discs),
        0.0,
    )


def drive_view(joint: Joint, scale: float) -> list[Item]:
    """Outlines and axes of all bodies."""
    rings, beyond, in_frame = rings_of(joint), 3.0 / scale, joint.drive.layout.in_frame
    items: list[Item] = []
    orbits: list[float] = []
    for number, body in enumerate(joint.drive.bodies):
        mine = [ring for ring in rings if ring.body == number]
        for ring in mine:
            broken = ring.shown < ring.outer
            items.append(Circle((0.0, 0.0), ring.inner))
            items.append(break_line(ring.inner, ring.shown) if broken else Circle((0.0, 0.0), ring.shown))
            housing = housing_of(joint, ring)
            items += [] if housing is None else [Circle((0.0, 0.0), housing)]
        if mine:
            continue
        radii, bore = radii_of(joint, number), joint.shapes[number].bore_diameter
        for x, y in copies_of(joint, number):
            items += [Circle((x, y), radius) for radius in radii]
            if bore is not None:
                items.append(Circle((x, y), 0.5e3 * float(bore)))
            pin = pin_diameter_of(joint, number)
            # a solid roller has a bore as wide as its pin
            if pin and (bore is None or pin < 1e3 * float(bore)):
                items.append(Circle((x, y), 0.5 * pin))
            if in_frame or not body.on_axis:
                items += cross((x, y), min(max(radii) + beyond, 1.25 * max(radii)), math.atan2(y, x))
        if not body.on_axis:
            orbits.append(math.hypot(*copies_of(joint, number)[0]))
            if not any(math.isclose(orbits[-1], other) for other in orbits[:-1]):
                items.append(Circle((0.0, 0.0), orbits[-1], "axis"))
    return items if in_frame else items + cross((0.0, 0.0), reach_of(joint) + beyond, 0.0)


def cross(centre: Point, half: float, angle: float) -> list[Item]:
    """The two axes of a circle."""
    x, y = centre
    e, f = half * math.cos(angle), half * math.sin(angle)
    return [Line(((x - e, y - f), (x + e, y + f)), "axis"), Line(((x + f, y - e), (x - f, y + e)), "axis")]


def write_contact_names(joint: Joint, view: list[Item], taken: Taken) -> list[Item]:
    """Names of the contacts at their places in the first sector, off outlines and axes as far as there is room."""
    drive, scale = joint.drive, taken.scale
    first, _ = places(drive)
    angles, _ = contact_angles(drive)
    points = []
    for k in range(len(drive.contacts)):
        (x, y), radius = copies_of(joint, first[k])[0], 1e3 * float(drive.first_radius[k])
        points.append((x + radius * math.cos(float(angles[k])), y + radius * math.sin(float(angles[k]))))
    for x, y in points:  # no name covers the point of another contact
        tick = 0.5 / scale
        taken.add([Line(((x - tick, y), (x + tick, y)))], crossable=True)
    items: list[Item] = []
    for contact, at in zip(drive.contacts, points, strict=True):
        best, least = None, math.inf
        for distance in _DISTANCES:
            if distance >= least:
                break
            for index in range(_DIRECTIONS):
                turn = 2.0 * math.pi * (index + 0.5) / _DIRECTIONS
                e, f = distance / scale * math.cos(turn), distance / scale * math.sin(turn)
                tried = _name(contact.name, at, (at[0] + e, at[1] + f), scale)
                cost = distance + _lines_through(tried[1], view, scale)
                if cost < least:
                    cost += _LINE_TOO_NEAR * (not taken.has_room(tried[:1]))
                    cost += _NO_ROOM * (not taken.has_room(tried[1:]))
                if cost < least:
                    best, least = tried, cost
        if best is not None:
            taken.add(best)
            items += best
    return items


def _name(name: str, at: Point, end: Point, scale: float) -> tuple[Line, Text]:
    """A line from a contact and its name beside it."""
    short = name if len(name) <= _LONGEST_NAME else f"{name[:8]}…{name[-7:]}"
    side = 1.0 if end[0] >= at[0] else -1.0
    begin = (end[0] + 0.5 * side / scale, end[1] - 1.2 / scale)
    return Line((at, end)), Text(begin, short, "left" if side > 0.0 else "right")


def _lines_through(text: Text, view: list[Item], scale: float) -> float:
    """What the outlines and axes that run through a text cost."""
    box, cost = text_box(text, scale), 0.0
    for item in view:
        if isinstance(item, Circle):
            x, y = item.centre
            near = math.hypot(max(box.left - x, x - box.right, 0.0), max(box.low - y, y - box.high, 0.0))
            far = math.hypot(max(x - box.left, box.right - x), max(y - box.low, box.high - y))
            cost += (near < item.radius < far) * (_PER_OUTLINE if item.style == "outline" else _PER_LINE)
        elif isinstance(item, Line):
            cost += _PER_LINE * any(box.is_crossed_by(*ends) for ends in pairwise(item.points))
    return cost
