"""The sizes of a drive: what is said of each, and where in the view it is shown."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.existence import neighbours
from asperity.joint.description import Joint, places
from asperity.joint.housing import ring_fit, seated
from asperity.joint_file.stated_parts import StatedPart
from asperity.show.dimension_lines import (
    diameter,
    dimension,
    distance_mark,
    made_bore,
    toleranced,
)
from asperity.show.drive_view import (
    MOST_GAPS,
    RingOfBody,
    copies_of,
    housing_of,
    pin_diameter_of,
    radii_of,
    rings_of,
)
from asperity.show.sheet import Circle, Line, Point
from asperity.show.taken import Place, around, distance

_MOST_COPIES = 8
_OF_ROLLER, _OF_AXES, _OF_WALL = 24, 72, 36  # places around a circle


class Size(NamedTuple):
    """A size that the drawing shows or the list says.

    ``of``: whose size, in the list; ``listed``: what it says after that; ``label``: what the view says. ``places``:
    where a leader to it may begin; ``radius`` of the circle whose diameter it is [mm], None for a wall; ``below``:
    whether it can stand below the view, since the circle is about the axis.
    """

    of: str
    listed: str
    label: str
    places: tuple[Place, ...]
    radius: float | None = None
    below: bool = False


class Clearance(NamedTuple):
    """The free distance [mm] between two rollers off the axis, or between one and a ring, and between which in words.

    ``places``: where a line can be drawn between them, none where other rollers lie between; ``alike``: whether they
    are copies of one roller in neighbouring sectors.
    """

    words: str
    size: float
    places: tuple[Place, ...]
    alike: bool = False


def sizes(
    joint: Joint, scale: float, interference: float | None = None, stated: Sequence[StatedPart] | None = None
) -> list[Size]:
    """Diameters of the tracks, bores and circles of axes, inner diameters and walls of the rings, each kind once."""
    listed: list[Size] = []
    rings = rings_of(joint)
    for kind in kinds(joint, stated):
        part = stated[kind[0]] if stated else StatedPart("", ())
        name = _together([_words(joint, number) for number in kind])
        mine = [ring for ring in rings if ring.body == kind[0]]
        for ring in mine:
            wall = toleranced(ring.outer - ring.inner, 1e3 * part.wall)
            circle = _around_axis(ring.inner)
            held = ", in its housing" if seated(joint)[ring.body] else ""
            text = f"{made_inside(joint, ring, interference, part)}{held}"
            listed.append(
                Size(name, f"inside {text}", f"{name} inside {text}", tuple(circle), ring.inner, below=True)
            )
            housing = housing_of(joint, ring)
            if housing is not None:
                text = f"outside ⌀{dimension(2.0 * housing)}"
                listed.append(
                    Size(
                        "housing", text, f"housing {text}", tuple(_around_axis(housing)), housing, below=True
                    )
                )
            marks = [] if ring.shown < ring.outer else _walls(circle, ring.inner, ring.outer, scale)
            broken = ", broken off at the wavy line" if ring.shown < ring.outer else ""
            listed.append(Size(name, f"wall {wall}{broken}", f"wall of {name} {wall}", tuple(marks)))
        if mine:
            continue
        on_axis = joint.drive.bodies[kind[0]].on_axis
        counted = counted_name(joint, kind)
        for radius in radii_of(joint, kind[0]):
            text = diameter(radius, 1e3 * part.tolerance(1e-3 * radius))
            listed.append(Size(counted, text, f"{counted} {text}", _on(joint, kind, radius), radius))
        bore = joint.shapes[kind[0]].bore_diameter
        if bore is not None:
            half = 0.5e3 * float(bore)
            text = f"bore {diameter(half, 0.5e3 * part.bore)}"
            listed.append(Size(counted, text, f"{counted}, {text}", _on(joint, kind, half), half))
        pin = pin_diameter_of(joint, kind[0])
        if pin:
            text = f"pin ⌀{dimension(pin)}"
            listed.append(Size(counted, text, f"{counted}, {text}", _on(joint, kind, 0.5 * pin), 0.5 * pin))
        if not on_axis:
            x, y = copies_of(joint, kind[0])[0]
            orbit, text = math.hypot(x, y), f"⌀{dimension(2.0 * math.hypot(x, y))}"
            circle = around((0.0, 0.0), orbit, math.atan2(y, x), _OF_AXES)
            listed.append(Size(counted, f"axes on {text}", f"axes of {name} {text}", tuple(circle), orbit))
    return listed


def _around_axis(radius: float) -> list[Place]:
    """Places on a circle about the axis."""
    return around((0.0, 0.0), radius, 0.0, _OF_WALL)


def contact_interferences(joint: Joint, interference: float | None = None) -> list[float | None]:
    """By how much the radius of the ring in each contact is too small [m]; 0 without a ring."""
    drive = interference if joint.interference is None else float(joint.interference)
    both = zip(joint.drive.contacts, np.asarray(joint.pattern), strict=True)
    shares = [float(share) if contact.internal else 0.0 for contact, share in both]
    return [0.0 if share == 0.0 else None if drive is None else share * drive for share in shares]


def made_inside(
    joint: Joint, ring: RingOfBody, interference: float | None, part: StatedPart, *, free: bool = False
) -> str:
    """Inner diameter of a ring as it must be made: in its housing, or ``free`` before it is pressed in."""
    _, second = places(joint.drive)
    less = next(
        contact_interference
        for number, contact_interference in enumerate(contact_interferences(joint, interference))
        if second[number] == ring.body
        and math.isclose(1e3 * float(joint.drive.second_radius[number]), ring.inner)
    )
    if free and less is not None and seated(joint)[ring.body]:
        less -= 0.5 * float(ring_fit(joint, ring.body, working=False).bore_change)
    return made_bore(ring.inner, less, 1e3 * part.tolerance(1e-3 * ring.inner))


def drive_clearances(joint: Joint) -> list[Clearance]:
    """Free distances between copies of one roller in next sectors, and the smallest between different rollers."""
    names = [body.name for body in joint.drive.bodies]
    rings = {ring.body for ring in rings_of(joint)}
    discs = [
        Circle(centre, max(radii_of(joint, number)))
        for number in range(len(names))
        if number not in rings
        for centre in copies_of(joint, number)
    ]
    gaps = []
    for one, other in neighbours(joint.drive):
        i, j = names.index(one), names.index(other)
        if j in rings:
            if all(len(radii_of(joint, number)) == 1 for number in (i, j)):
                gaps.append(_to_ring(joint, i, j, discs))
            continue
        if any(joint.drive.bodies[number].on_axis for number in (i, j)):
            continue
        if i != j and any(len(radii_of(joint, number)) > 1 for number in (i, j)):
            continue  # their tracks may lie in different planes
        radii = max(radii_of(joint, i)), max(radii_of(joint, j))
        pairs = [
            (math.dist(a, b), a, b)
            for a in copies_of(joint, i)
            for b in copies_of(joint, j)
            if math.dist(a, b) > 0.0
        ]
        if not pairs:
            continue
        nearest = min(pairs)[0]
        between = [_gap(a, b, radii) for far, a, b in pairs if far < nearest * (1.0 + 1e-9)]
        size = nearest - sum(radii)
        open_ones = [ends for ends in between if size > 0.0 and not _blocked(ends, discs)]
        marks = tuple(Place(_middle(ends), None, (Line(ends, "break"),)) for ends in open_ones)
        gaps.append(Clearance(f"{_words(joint, i)} to {_words(joint, j)}", size, marks, i == j))
    gaps.sort(key=lambda gap: gap.size)
    return [gap for rank, gap in enumerate(gaps) if rank < MOST_GAPS or gap.alike]


def _to_ring(joint: Joint, number: int, ring: int, discs: list[Circle]) -> Clearance:
    """Free distance between a roller and a ring that it does not touch."""
    (radius,), (inner,) = radii_of(joint, number), radii_of(joint, ring)
    orbit = math.hypot(*copies_of(joint, number)[0])
    between = [
        tuple((x * reach / orbit, y * reach / orbit) for reach in (orbit + radius, inner))
        for x, y in copies_of(joint, number)
    ]
    size = inner - orbit - radius
    open_ones = [(one, two) for one, two in between if size > 0.0 and not _blocked((one, two), discs)]
    marks = tuple(Place(_middle(ends), None, (Line(ends, "break"),)) for ends in open_ones)
    return Clearance(f"{_words(joint, number)} to {_words(joint, ring)}", size, marks)


def _words(joint: Joint, number: int) -> str:
    return joint.drive.bodies[number].name.replace("_", " ")


def counted_name(joint: Joint, kind: Sequence[int]) -> str:
    """Number and name of a kind of body: ``3 × planet``."""
    count = 1 if joint.drive.bodies[kind[0]].on_axis else round(float(joint.drive.sectors)) * len(kind)
    name = _together([_words(joint, number) for number in kind])
    return name if count == 1 else f"{count} × {name}"


def _together(names: list[str]) -> str:
    """Names of alike rollers as one, with the words in which they all end said once."""
    words = [name.split() for name in names]
    tail: list[str] = []
    while len(names) > 1 and all(len(name) > 1 for name in words) and len({name[-1] for name in words}) == 1:
        tail.insert(0, words[0][-1])
        words = [name[:-1] for name in words]
    return " ".join([" and ".join(" ".join(name) for name in words), *tail])


def kinds(joint: Joint, stated: Sequence[StatedPart] | None = None) -> list[tuple[int, ...]]:
    """Numbers of the bodies, those of one size, orbit, material and tolerance together."""
    rings = {ring.body for ring in rings_of(joint)}
    alike: dict[tuple[object, ...], tuple[int, ...]] = {}
    for number, body in enumerate(joint.drive.bodies):
        bore = joint.shapes[number].bore_diameter
        orbit = math.hypot(*copies_of(joint, number)[0])
        part = stated[number] if stated else None
        key: tuple[object, ...] = (
            tuple(dimension(radius) for radius in sorted(radii_of(joint, number))),
            None if bore is None else dimension(1e3 * float(bore)),
            dimension(orbit),
            *(
                (part.material, part.bore, part.length, *sorted(track[1] for track in part.tracks))
                if part
                else ()
            ),
        )
        if body.on_axis or number in rings:
            key = (number,)
        alike[key] = (*alike.get(key, ()), number)
    return list(alike.values())


def _on(joint: Joint, kind: tuple[int, ...], radius: float) -> tuple[Place, ...]:
    """Places on a circle of some copies of a kind, those at the sides of the view."""
    centres = sorted((centre for n in kind for centre in copies_of(joint, n)), key=lambda xy: -abs(xy[0]))
    return tuple(
        place
        for x, y in centres[:_MOST_COPIES]
        for place in around((x, y), radius, math.atan2(y, x), _OF_ROLLER)
    )


def _walls(circle: list[Place], inner: float, outer: float, scale: float) -> list[Place]:
    """Dimension lines across a wall."""
    marks = []
    for tip, _, _ in circle:
        end = (tip[0] * outer / inner, tip[1] * outer / inner)
        marks.append(Place(_middle((tip, end)), None, distance_mark((tip, end), scale=scale)))
    return marks


def _middle(ends: tuple[Point, Point]) -> Point:
    return 0.5 * (ends[0][0] + ends[1][0]), 0.5 * (ends[0][1] + ends[1][1])


def _gap(a: Point, b: Point, radii: tuple[float, float]) -> tuple[Point, Point]:
    """Points of two circles on the line of their centres, where they are closest."""
    far = math.dist(a, b)
    e, f = (b[0] - a[0]) / far, (b[1] - a[1]) / far
    return (a[0] + radii[0] * e, a[1] + radii[0] * f), (b[0] - radii[1] * e, b[1] - radii[1] * f)


def _blocked(ends: tuple[Point, Point], discs: list[Circle]) -> bool:
    """Whether other rollers lie between the ends."""
    inset = 0.01
    (x, y), (u, v) = ends
    e, f = inset * (u - x), inset * (v - y)
    line = (x + e, y + f), (u - e, v - f)
    return any(distance((disc.centre, disc.centre), line) < disc.radius for disc in discs)
