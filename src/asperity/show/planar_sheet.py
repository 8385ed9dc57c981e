"""The drawing of a planar drive: every roller and ring to scale, with the sizes of its bodies and its contacts."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.drive.planar.layout import CARRIER, contact_angles, speed_ratio
from asperity.joint.planar.description import PlanarJoint, places, tracks_of
from asperity.joint.planar.evaluation import PlanarResult
from asperity.show.drive_sheet import PLAIN, WITH_FORCES, frame, load_lines, title_block
from asperity.show.drive_view import LONGEST_WALL, break_line, dimension
from asperity.show.planar_free_bodies import planar_free_bodies
from asperity.show.sheet import Circle, Item, Line, Point, Sheet, Text, standard_scale
from asperity.units import format_quantity

_FOOT = 37.0  # of the texts above the title block on paper [mm]
_MARGIN, _SPACING = 10.0, 4.4
_SHOWN_OF_BROKEN = 0.3  # of the inner radius of a ring


class _Ring(NamedTuple):
    inner: float
    outer: float
    shown: float


def planar_sheet(joint: PlanarJoint, *, name: str, result: PlanarResult | None = None) -> Sheet:
    """Draw a planar drive to scale.

    Parameters
    ----------
    joint : PlanarJoint
        One joint whose drive can exist.
    name : str
        What the drawing is called, for example the name of its file.
    result : PlanarResult, optional
        Its result, if the forces on the bodies are to be drawn too.

    Returns
    -------
    Sheet
        A4 across, or A3 across with forces, at the largest standard scale that fits. Tracks of a stepped roller are
        circles about one centre, although they lie in different planes.
    """
    drive = joint.drive
    width, height, room, column = PLAIN if result is None else WITH_FORCES
    rings = _rings(joint)
    reach = max([ring.shown for ring in rings.values()] + [_reach(joint)])
    scale = standard_scale(2.0 * reach, room=room)
    middle = (_MARGIN + 15.0 + 0.5 * room, 0.5 * height + 8.0)

    def on_paper(x: float, y: float) -> Point:
        return (x - middle[0]) / scale, (y - middle[1]) / scale

    items: list[Item] = []
    for number, body in enumerate(drive.bodies):
        copies = 1 if body.place == "axis" else round(float(drive.sectors))
        for sector in range(copies):
            items += _body(joint, number, sector, rings, scale)
    items += _contact_labels(joint, scale)
    lines = _sizes(joint, rings)
    top = 0.5 * height + 0.5 * _SPACING * len(lines)
    if result is not None:
        top = _FOOT + _SPACING * len(lines)
        loads = load_lines(joint, result.forces, part="sector")
        low = top + _SPACING * (len(loads) + 1)
        items += [Text(on_paper(column, low - _SPACING * (row + 1)), line) for row, line in enumerate(loads)]
        centre = on_paper(0.5 * (column + width - _MARGIN), 0.5 * (low + height - _MARGIN))
        across = width - _MARGIN - column
        items += planar_free_bodies(joint, result, middle=centre, room=across, scale=scale)
    items += [Text(on_paper(column, top - _SPACING * row), line) for row, line in enumerate(lines)]
    items += title_block(on_paper, column, width, name, scale, kind=_kind(joint))
    items.append(frame(on_paper, width, height))
    return Sheet(width, height, scale, middle, tuple(items))


def planar_forces_sheet(joint: PlanarJoint, result: PlanarResult) -> Sheet:
    """The forces on the bodies of one sector as a picture of its own.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        Its result.

    Returns
    -------
    Sheet
        A sheet of 170 mm by 140 mm.
    """
    items = planar_free_bodies(joint, result, middle=(0.0, 5.0), room=166.0, scale=1.0)
    for row, line in enumerate(load_lines(joint, result.forces, part="sector")):
        items.append(Text((-82.0, -56.0 - _SPACING * row), line))
    return Sheet(170.0, 140.0, 1.0, (85.0, 68.0), tuple(items))


def _kind(joint: PlanarJoint) -> str:
    words = joint.type.replace("_", " ")
    return f"{words[0].upper()}{words[1:]} traction drive"


def _rings(joint: PlanarJoint) -> dict[int, _Ring]:
    """Radii of the rings [mm]; a thick wall is broken off."""
    found = {}
    for number, shape in enumerate(joint.shapes):
        if shape.kind == "ring" and shape.size is not None:
            inner = 1e3 * float(tracks_of(joint, number)[0][0])
            wall = 1e3 * float(shape.size)
            shown = wall if wall <= LONGEST_WALL * inner else _SHOWN_OF_BROKEN * inner
            found[number] = _Ring(inner, inner + wall, inner + shown)
    return found


def _reach(joint: PlanarJoint) -> float:
    """Distance of the farthest point of a roller from the axis [mm]."""
    orbits = np.hypot(*np.asarray(joint.drive.centres).T)
    return 1e3 * max(
        float(orbits[number]) + float(radius)
        for number, shape in enumerate(joint.shapes)
        if shape.kind != "ring"
        for radius, _ in tracks_of(joint, number)
    )


def _copy(joint: PlanarJoint, number: int, sector: int) -> Point:
    x, y = (1e3 * float(each) for each in np.asarray(joint.drive.centres)[number])
    turn = 2.0 * math.pi * sector / float(joint.drive.sectors)
    return x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)


def _body(joint: PlanarJoint, number: int, sector: int, rings: dict[int, _Ring], scale: float) -> list[Item]:
    """Outlines and axes of one body."""
    beyond = 3.0 / scale
    if number in rings:
        ring = rings[number]
        outside: Item = (
            Circle((0.0, 0.0), ring.shown) if ring.shown == ring.outer else break_line(ring.inner, ring.shown)
        )
        reach = ring.shown + beyond
        return [
            Circle((0.0, 0.0), ring.inner),
            outside,
            Line(((-reach, 0.0), (reach, 0.0)), "axis"),
            Line(((0.0, -reach), (0.0, reach)), "axis"),
        ]
    x, y = centre = _copy(joint, number, sector)
    radii = [1e3 * float(radius) for radius, _ in tracks_of(joint, number)]
    items: list[Item] = [Circle(centre, radius) for radius in radii]
    shape = joint.shapes[number]
    if shape.bore_diameter is not None:
        items.append(Circle(centre, 0.5e3 * float(shape.bore_diameter)))
    if joint.drive.bodies[number].place != "axis":
        angle, half = math.atan2(y, x), min(max(radii) + beyond, 1.25 * max(radii))
        e, f = half * math.cos(angle), half * math.sin(angle)
        items += [
            Line(((x - e, y - f), (x + e, y + f)), "axis"),
            Line(((x + f, y - e), (x - f, y + e)), "axis"),
        ]
        if sector == 0:
            items.append(Circle((0.0, 0.0), math.hypot(x, y), "axis"))
    return items


def _contact_labels(joint: PlanarJoint, scale: float) -> list[Item]:
    """Names of the contacts at their places in the first sector."""
    drive = joint.drive
    first, _ = places(drive)
    angles, _ = contact_angles(drive)
    items: list[Item] = []
    taken: list[Point] = []
    for k, contact in enumerate(drive.contacts):
        x, y = _copy(joint, first[k], 0)
        angle, radius = float(angles[k]), 1e3 * float(drive.first_radius[k])
        at = (x + radius * math.cos(angle), y + radius * math.sin(angle))
        step = 5.0 / scale
        text = (at[0] + step, at[1] + 0.6 * step)
        while any(abs(text[0] - x) < 2.0 * step and abs(text[1] - y) < 0.7 * step for x, y in taken):
            text = (text[0], text[1] - 0.8 * step)
        taken.append(text)
        items += [Line((at, text)), Text((text[0] + 0.5 / scale, text[1] - 1.2 / scale), contact.name)]
    return items


def _sizes(joint: PlanarJoint, rings: dict[int, _Ring]) -> list[str]:
    """What the view itself does not say."""
    drive = joint.drive
    lines = [
        f"ratio {format_quantity(float(speed_ratio(drive)), '1', 5)}",
        f"{drive.input.replace('_', ' ')} in, {drive.output.replace('_', ' ')} out, "
        f"{drive.grounded.replace('_', ' ')} grounded",
        "",
    ]
    orbits = 1e3 * np.hypot(*np.asarray(drive.centres).T)
    for number, body in enumerate(drive.bodies):
        words = body.name.replace("_", " ")
        if number in rings:
            ring = rings[number]
            lines.append(
                f"{words}: inside ⌀{dimension(2.0 * ring.inner)}, wall {dimension(ring.outer - ring.inner)}"
            )
            if ring.shown < ring.outer:
                lines.append("  its wall is broken off at the wavy line")
            continue
        radii = [1e3 * float(radius) for radius, _ in tracks_of(joint, number)]
        sizes = ", ".join(f"⌀{dimension(2.0 * radius)}" for radius in radii)
        shape = joint.shapes[number]
        if shape.bore_diameter is not None:
            sizes += f", bore ⌀{dimension(1e3 * float(shape.bore_diameter))}"
        lines.append(
            f"{words}: {sizes}"
            if body.place == "axis"
            else f"{round(float(drive.sectors))} × {words}: {sizes}, axes on ⌀{dimension(2.0 * float(orbits[number]))}"
        )
        if body.place != "axis":
            gap = 2.0 * float(orbits[number]) * math.sin(math.pi / float(drive.sectors)) - 2.0 * max(radii)
            lines.append(f"  clearance between neighbours {gap:.4g}")
    if any(body.place == "pin" for body in drive.bodies) and drive.grounded != CARRIER:
        pinned = ", ".join(drive.bodies[body].name.replace("_", " ") for body in drive.pinned)
        lines.append(f"pins of the carrier: {pinned}")
    if any(len(tracks_of(joint, number)) > 1 for number in range(len(drive.bodies))):
        lines.append("tracks of stepped rollers lie in different planes")
    lines += ["", "contacts"]
    lines += [
        f"  {contact.name}: {contact.first.replace('_', ' ')} – {contact.second.replace('_', ' ')}"
        for contact in drive.contacts
    ]
    return lines
