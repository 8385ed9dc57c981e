"""The bodies of one sector of a drive drawn apart, with the forces on each of them and between them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import Drive, contact_angles, driving_sense
from asperity.joint.body_shape import BodyShape
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.show.box import Box, around_all, box_of, text_box
from asperity.show.sheet import TEXT_HEIGHT, Align, Circle, Item, Line, Point, Text
from asperity.units import format_quantity

_BEYOND = 13.0  # of a label beyond its contact on paper [mm]
_LINE_SPACING = 4.2
_ROOM_FOR_NAME = 12.0  # least radius of a body with its name in it [mm]
_FOR_LABELS = 24.0  # beside a row of bodies [mm]
#: Where the letter of an arrow is tried: beyond its free end, and to its side, from that end [mm].
_AT_ARROW = (
    *((2.2, 0.0), (1.5, 2.0), (1.5, -2.0), (0.0, 2.5), (0.0, -2.5)),
    *((-4.0, 2.6), (-4.0, -2.6), (-7.0, 2.6), (-7.0, -2.6), (4.0, 0.0), (3.0, 3.0), (3.0, -3.0)),
    *((along, across) for along in (5.5, 2.0, -2.0, -6.0) for across in (0.0, 4.5, -4.5, 6.0, -6.0)),
)
#: Where a label is tried: distances from its body [mm], and turns from the direction of its force [rad].
_DISTANCES = (4.0, 8.0, 13.0, 18.0, 24.0, 32.0)
_TURNS = (0.0, 0.3, -0.3, 0.6, -0.6, 0.9, -0.9)
_FAR_TURNS = (1.2, -1.2, 1.6, -1.6, 2.0, -2.0, 2.5, -2.5, 3.1)
_ARROW = 10.0  # length of an arrow on paper [mm]
_PER_TEXT = 10  # a text that a letter covers counts as so many lines
_BESIDE_LETTER = 1.0  # to each side of a text [mm]
#: Between two bodies on paper [mm].
BODY_DISTANCE = 26.0
_LARGEST, _SMALLEST = 20.0, 5.0  # radii on paper [mm]


def free_bodies(joint: Joint, result: JointResult, *, middle: Point, room: float, scale: float) -> list[Item]:
    """Bodies off the axis of one sector drawn apart: arrows for directions, numbers for sizes."""
    drive, numbers = joint.drive, drawn_apart(joint.drive)
    names = [drive.bodies[number].name for number in numbers]
    forces = [force for force in body_forces(joint, result) if force.body in names]
    tracks = {
        name: [(float(radius), contacts) for radius, contacts in tracks_of(joint, number)]
        for name, number in zip(names, numbers, strict=True)
    }
    radii = body_outlines(
        {
            name: [*(radius for radius, _ in tracks[name]), *_bore(joint.shapes[number])]
            for name, number in zip(names, numbers, strict=True)
        }
    )
    of_contact = {
        (name, drive.contacts[k].name): shown
        for name, body_tracks in tracks.items()
        for (_, contacts), shown in zip(body_tracks, radii[name], strict=False)  # the bore is the last
        for k in contacts
    }
    centres = _centres(joint, names, forces, {name: max(sizes) for name, sizes in radii.items()}, room)
    drawn = [force for force in forces if force.size != 0.0]
    arrows = [
        force_arrow(f, centres[f.body], of_contact.get((f.body, f.name), max(radii[f.body]))) for f in drawn
    ]
    bodies = {name: (centres[name], max(sizes)) for name, sizes in radii.items()}
    outlines = [Circle(centres[name], radius) for name, sizes in radii.items() for radius in sizes]
    labels = _Labels(list(bodies.values()), arrows, outlines)
    for force, (tail, tip) in zip(drawn, arrows, strict=True):
        labels.letter(force.kind, *((tip, tail) if force.kind == "N" else (tail, tip)))
    for name, (centre, radius) in bodies.items():
        words = name.replace("_", " ")
        if min(radii[name]) > _ROOM_FOR_NAME and not drive.layout.in_frame:  # no arrow points into it
            labels.write((words,), (centre[0], centre[1] - 6.0), "center")
        else:
            labels.find((words,), centre, radius, (0.0, 1.0))
    for contact in joint.drive.contacts:
        here = [force for force in forces if force.name == contact.name and force.size != 0.0]
        for body in dict.fromkeys(force.body for force in here):
            mine = [force for force in here if force.body == body]
            # its partner has the same numbers
            lines = tuple(map(force_label, mine)) if body == here[0].body else (contact.name,)
            labels.find(lines, *bodies[body], mine[0].place)
    for force in forces:
        if force.kind == "F" and force.size != 0.0:
            towards = (-force.direction[0], -force.direction[1]) if force.size > 0.0 else force.direction
            labels.find((force_label(force),), *bodies[force.body], towards)
    left, right, low, high = labels.extent
    over = max(0.5 * (right - left - room), 0.0)

    def on_sheet(x: float, y: float) -> Point:
        return (
            middle[0] + (x - 0.5 * (left + right) - over) / scale,
            middle[1] + (y - 0.5 * (low + high)) / scale,
        )

    return [
        *(Circle(on_sheet(*circle.centre), circle.radius / scale) for circle in outlines),
        *(Line((on_sheet(*tail), on_sheet(*tip)), "force", "end") for tail, tip in arrows),
        *(Text(on_sheet(*text.at), text.text, text.align) for text in labels.texts),
    ]


def drawn_apart(drive: Drive) -> tuple[int, ...]:
    """Numbers of the bodies that are drawn with their forces: those off the axis, or those that the frame holds."""
    if not drive.layout.in_frame:
        return drive.floating
    return tuple(number for number, body in enumerate(drive.bodies) if body.place != "axis")


def _bore(shape: BodyShape) -> list[float]:
    """Radius of the bore of a hollow roller [m]."""
    return [] if shape.bore_diameter is None else [0.5 * float(shape.bore_diameter)]


class _Labels:
    """Texts on paper that cover neither bodies and arrows nor each other, as far as there is room."""

    def __init__(
        self, bodies: list[tuple[Point, float]], arrows: list[tuple[Point, Point]], outlines: list[Circle]
    ) -> None:
        self.texts: list[Text] = []
        self._bodies, self._arrows, self._outlines = bodies, arrows, outlines
        self._boxes: list[Box] = []

    @property
    def extent(self) -> Box:
        """The box around all bodies, arrows and texts."""
        drawn: list[Item] = [*self._outlines, *(Line(ends) for ends in self._arrows)]
        return around_all([*self._boxes, *(box_of(item, 1.0) for item in drawn)])

    def letter(self, letter: str, start: Point, end: Point) -> None:
        """Write the letter of an arrow at its free end, or beside it."""
        far = math.dist(start, end)
        e, f = (end[0] - start[0]) / far, (end[1] - start[1]) / far
        tried: list[tuple[int, int, Text, Box]] = []
        for along, across in _AT_ARROW:
            x, y = end[0] + along * e - across * f, end[1] + along * f + across * e
            text = Text((x, y - 0.5 * TEXT_HEIGHT), letter, "center")
            box = text_box(text, 1.0)
            crossed = sum(box.is_crossed_by(*arrow) for arrow in self._arrows)
            crossed += sum(_crosses(box, circle) for circle in self._outlines)
            crossed += _PER_TEXT * sum(box.meets(other) for other in self._boxes)
            tried.append((crossed, len(tried), text, box))
        _, _, text, box = min(tried, key=lambda each: each[:2])
        self.texts.append(text)
        self._boxes.append(box._replace(left=box.left - _BESIDE_LETTER, right=box.right + _BESIDE_LETTER))

    def write(self, lines: tuple[str, ...], at: Point, align: Align) -> None:
        """Write lines below each other, the first at a place."""
        self._boxes.append(_box(lines, at, align))
        self.texts += [
            Text((at[0], at[1] - _LINE_SPACING * row), line, align) for row, line in enumerate(lines)
        ]

    def find(self, lines: tuple[str, ...], centre: Point, radius: float, direction: Point) -> None:
        """Write lines outside a body, as near as possible in a direction."""
        angle = math.atan2(direction[1], direction[0])
        free = [
            (at, align)
            for turns in (_TURNS, _FAR_TURNS)
            for beyond in _DISTANCES
            for turn in turns
            for at, align in _beside(lines, centre, radius + beyond, angle + turn)
            if self._is_free(_box(lines, at, align))
        ]
        self.write(lines, *(free or _beside(lines, centre, radius + _BEYOND, angle))[0])

    def _is_free(self, box: Box) -> bool:
        """Whether a text may stand there."""
        return not (
            any(box.is_crossed_by(*arrow) for arrow in self._arrows)
            or any(_distance(box, centre) < radius for centre, radius in self._bodies)
            or any(box.meets(other) for other in self._boxes)
        )


def _distance(box: Box, point: Point) -> float:
    """Distance of a box from a point, 0 within it."""
    x, y = point
    return math.hypot(max(box.left - x, x - box.right, 0.0), max(box.low - y, y - box.high, 0.0))


def _crosses(box: Box, circle: Circle) -> bool:
    """Whether the line of a circle runs through a box."""
    x, y = circle.centre
    far = math.hypot(max(x - box.left, box.right - x), max(y - box.low, box.high - y))
    return _distance(box, circle.centre) < circle.radius < far


def _beside(lines: tuple[str, ...], centre: Point, far: float, angle: float) -> list[tuple[Point, Align]]:
    """A place at a distance from a centre: to the right of it, or to the left."""
    x, y = centre[0] + far * math.cos(angle), centre[1] + far * math.sin(angle)
    at = (x, y + 0.5 * _LINE_SPACING * (len(lines) - 1) - 1.2)
    return [(at, "left" if math.cos(angle) > -1e-9 else "right")]


def _box(lines: tuple[str, ...], at: Point, align: Align) -> Box:
    """The box around lines of text, with what it keeps free [mm]."""
    box = around_all(
        text_box(Text((at[0], at[1] - _LINE_SPACING * row), line, align), 1.0)
        for row, line in enumerate(lines)
    )
    return box._replace(left=box.left - _BESIDE_LETTER, right=box.right + _BESIDE_LETTER)


def _centres(
    joint: Joint, names: list[str], forces: list[BodyForce], radii: dict[str, float], room: float
) -> dict[str, Point]:
    """Centres of the bodies on paper: each beside the body that it touches, in the direction of the contact."""
    towards = {(force.body, force.name): force.place for force in forces if force.kind == "N"}
    centres: dict[str, Point] = {names[0]: (0.0, 0.0)}
    waiting = [contact for contact in joint.drive.contacts if contact.sector == 0]
    for _ in names:
        for contact in waiting:
            for one, other in ((contact.first, contact.second), (contact.second, contact.first)):
                if one in centres and other in names and other not in centres:
                    far = radii[one] + BODY_DISTANCE + radii[other]
                    x, y = towards[one, contact.name]
                    centres[other] = (centres[one][0] + far * x, centres[one][1] + far * y)
    row, level = list(centres), 0.0
    # bodies that touch only bodies on the axis: beside each other, as many as there is room for
    for name in names:
        if name in centres:
            continue
        left = min(x - radii[other] for other, (x, _) in centres.items())
        edge = max(centres[other][0] + radii[other] for other in row)
        if edge + BODY_DISTANCE + 2.0 * radii[name] - left > room - _FOR_LABELS:
            low = min(y - radii[other] for other, (_, y) in centres.items())
            row, edge, level = [], left - BODY_DISTANCE, low - BODY_DISTANCE - radii[name]
        centres[name] = (edge + BODY_DISTANCE + radii[name], level)
        row.append(name)
    return centres


def body_forces(joint: Joint, result: JointResult) -> list[BodyForce]:
    """Forces on the bodies of the first sector under the joint's torque, without the centrifugal ones.

    For each contact the normal and the tangential force on its first and on its second body, then the force of each pin
    on its roller, and of the bearings on each body in a frame. Bodies on the axis have these forces from every sector.
    Equation (M1) of :doc:`/equations`, with the signs of :func:`asperity.drive.layout.drive.incidence`.
    """
    drive = joint.drive
    names = [body.name for body in drive.bodies]
    angles = np.asarray(contact_angles(drive))
    tangential = np.asarray(driving_sense(drive)) * np.asarray(result.forces.tangential)
    forces = []
    for k, contact in enumerate(drive.contacts):
        normal = float(result.forces.normal[k])
        for side, body in enumerate(places(drive)):
            x, y = math.cos(angles[side][k]), math.sin(angles[side][k])
            # the rim of a ring is pushed outwards, and the other way round
            sign = 1.0 if side == 1 and contact.internal else -1.0
            forces += [
                BodyForce(names[body[k]], contact.name, "N", (x, y), (sign * x, sign * y), normal),
                BodyForce(
                    names[body[k]], contact.name, "T", (x, y), (sign * y, -sign * x), -float(tangential[k])
                ),
            ]
    for pin, number in enumerate(drive.pinned):
        x, y = (float(coordinate) for coordinate in np.asarray(drive.centres)[number])
        outward = (x / math.hypot(x, y), y / math.hypot(x, y))
        cosine, sine = math.cos(float(drive.push_angles[pin])), math.sin(float(drive.push_angles[pin]))
        push = (cosine * outward[1] + sine * outward[0], -cosine * outward[0] + sine * outward[1])
        forces.append(BodyForce(names[number], "pin", "F", (0.0, 0.0), push, -float(result.forces.pins[pin])))
    return [*forces, *(_of_bearing(body, forces) for body in names if drive.layout.in_frame)]


def _of_bearing(body: str, forces: list[BodyForce]) -> BodyForce:
    """The force of its bearings on a body in the frame, which balances all others."""
    sums = [-math.fsum(f.size * f.direction[axis] for f in forces if f.body == body) for axis in (0, 1)]
    size = math.hypot(*sums)
    direction = (sums[0] / size, sums[1] / size) if size > 0.0 else (0.0, 0.0)
    return BodyForce(body, "bearing", "F", (0.0, 0.0), direction, size)


class BodyForce(NamedTuple):
    """One force on one body of the first branch, whose planet lies above the sun.

    ``body``: ``planet``, ``right loading roller`` or ``left loading roller``; ``name``: the contact, ``pin`` or
    ``bearing``; ``kind``: ``N`` normal, ``T`` tangential, ``F`` of a pin or bearing. ``place``: direction from the
    centre of the body to the contact, (0, 0) for a pin; ``direction``: unit vector, to the right and upwards; ``size``:
    the force in this direction [N], negative for the opposite one.
    """

    body: str
    name: str
    kind: str
    place: Point
    direction: Point
    size: float


def body_outlines(radii: dict[str, list[float]], *, size: float = 1.0) -> dict[str, list[float]]:
    """Radii of bodies on paper: the largest has a size that suits the arrows, and none is too small for them.

    [mm].
    """
    largest = max(radius for sizes in radii.values() for radius in sizes)
    return {
        name: [max(_SMALLEST, size * _LARGEST * radius / largest) for radius in sizes]
        for name, sizes in radii.items()
    }


def force_arrow(force: BodyForce, centre: Point, radius: float) -> tuple[Point, Point]:
    """Arrow of a force: normal forces end at the contact, tangential ones lie beside it, pins push from the axis.

    [mm].
    """
    x, y = centre[0] + radius * force.place[0], centre[1] + radius * force.place[1]
    step = math.copysign(_ARROW, force.size)
    e, f = step * force.direction[0], step * force.direction[1]
    if force.kind == "N":
        return (x - e, y - f), (x, y)
    if force.kind == "F":
        return (x, y), (x + e, y + f)
    x, y = x + 1.5 * force.place[0], y + 1.5 * force.place[1]
    return (x, y), (x + 0.8 * e, y + 0.8 * f)


def force_label(force: BodyForce) -> str:
    """Name and size of a force."""
    size = format_quantity(abs(force.size), "N")
    return {"N": f"{force.name}: N = {size}", "T": f"T = {size}", "F": f"{force.name}: F = {size}"}[
        force.kind
    ]
