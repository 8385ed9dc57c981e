"""The drawing of a drive: frame, view with dimensions, what the view does not say, and the forces on request."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import CARRIER, speed_ratio
from asperity.drive.layout.wedge import wedge_angles, wedges
from asperity.drive.types import TYPES
from asperity.hardness_scales import hardness_words
from asperity.joint.description import Joint, contact_values, tracks_of
from asperity.joint.evaluation import JointForces, JointResult
from asperity.joint_file.stated_parts import StatedParts
from asperity.show.dimension_lines import dimension
from asperity.show.drive_sizes import (
    Clearance,
    Size,
    contact_interferences,
    counted_name,
    drive_clearances,
    kinds,
    place_dimensions,
    sizes,
)
from asperity.show.drive_view import drive_view, reach_of, write_contact_names
from asperity.show.free_bodies import free_bodies
from asperity.show.section_view import draw_section, drive_section, planes
from asperity.show.sheet import TEXT_HEIGHT, Circle, Dimension, Item, Line, Point, Sheet, Text, standard_scale
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Box, Taken, text_box
from asperity.show.title_block import BLOCK_HEIGHT, MARGIN, Title, frame, title_block
from asperity.units import format_quantity

_FOOT = MARGIN + BLOCK_HEIGHT + 5.0  # of the texts above the title block on paper [mm]
_SPACING = 4.4
_CAPTION = ("Section along the axis,", "developed through the contacts")
#: Size of the paper, room of the view, left edge of the column beside it, and room of the section, all in mm: A4, A3.
PLAIN, WITH_SECTION = (297.0, 210.0, 150.0, 195.0, 0.0), (420.0, 297.0, 150.0, 300.0, 60.0)
WITH_FORCES = (420.0, 297.0, 220.0, 270.0, 0.0)


class Paper(NamedTuple):
    """Size of a sheet, left edge of the column beside the view, origin of the drawing, all on paper [mm], and scale."""

    width: float
    height: float
    column: float
    middle: Point
    scale: float

    def at(self, x: float, y: float) -> Point:
        """A point of the paper in true size [mm]."""
        return (x - self.middle[0]) / self.scale, (y - self.middle[1]) / self.scale

    def box(self, left: float, right: float, low: float, high: float) -> Box:
        """A part of the paper in true size [mm]."""
        (x, y), (u, v) = self.at(left, low), self.at(right, high)
        return Box(x, u, y, v)

    @property
    def inside(self) -> Box:
        """Where texts may stand."""
        edge = MARGIN + 2.0
        return self.box(edge, self.width - edge, edge, self.height - edge)

    def block(self, kind: str, name: str, title: Title) -> list[Item]:
        """Frame and title block."""
        left = self.column - 3.0
        block = title_block(self.at, left, self.width, self.scale, kind=kind, name=name, title=title)
        return [*block, frame(self.at, self.width, self.height)]


def drive_sheet(
    joint: Joint,
    *,
    name: str,
    result: JointResult | None = None,
    loaded: Joint | None = None,
    interference: float | None = None,
    stated: StatedParts | None = None,
    title: Title | None = None,
    section: bool = False,
) -> Sheet:
    """Draw a drive to scale.

    ``joint``: one joint whose drive can exist; ``name``: what the drawing is called, for example the name of its file;
    ``result``, if the forces on the bodies are to be drawn too, and ``loaded``, whose forces these are where the
    sectors differ, every sector by itself. ``interference`` with which the drive is made where the joint states a force
    [m], None where it is not known; ``stated``: tolerances, materials, crowns and surfaces of its parts, without them
    the drawing shows sizes alone; ``title``: what the title block says, dashes if None; ``section``: whether the sheet
    has a section along the axis, unless it has forces.

    A4 across, or A3 across with a section or with forces, at the largest standard scale that fits. Tracks of a stepped
    roller are circles about one centre, although they lie in different planes. A size for which the view has no room is
    said beside it. Rings are drawn at the radii at which all contacts just touch.
    """
    with_section = section and result is None
    width, height, room, column, aside = (
        WITH_FORCES if result is not None else WITH_SECTION if with_section else PLAIN
    )
    reach = reach_of(joint)
    size, lengths = 2.0 * reach, None if stated is None else stated.lengths
    if with_section:
        flat = drive_section(joint, math.inf)
        across = max(5.0, aside - 18.0 - 2.0 * len(planes(joint)))
        size = max(size, room * flat.width / across, room * flat.height / (0.5 * height - 40.0))
    scale = standard_scale(size, room=room)
    middle = (MARGIN + 15.0 + 0.5 * room + 1.1 * aside, 0.5 * height + 8.0)
    paper = Paper(width, height, column, middle, scale)
    view = drive_view(joint, scale)
    outlines = [item for item in view if isinstance(item, Circle) and item.style == "outline"]
    cut, measured = list[Item](), list[Dimension]()
    if with_section:
        x, _ = paper.at(MARGIN + 8.0, 0.0)
        along = drive_section(joint, scale, lengths)
        cut, measured = draw_section(along, x, low=-2.0 / scale, scale=scale)
        above = along.height + (2.0 * _SPACING + 2.0) / scale
        cut += [
            Text((x - 4.0 / scale, above - row * _SPACING / scale), words)
            for row, words in enumerate(_CAPTION)
        ]
    bodies, parts = None if stated is None else stated.bodies, stated if result is None else None
    all_sizes, clearances = sizes(joint, scale, interference, bodies), drive_clearances(joint)
    listed = frozenset(n for n, size in enumerate(all_sizes) if not size.places)
    while True:  # what finds no room is listed, and the list needs room
        taken = Taken(scale, paper.inside)
        taken.add_box(paper.box(column - 4.0, width, 0.0, _FOOT - 4.0))
        letters = dict.fromkeys(range(len(clearances)), "C")
        lines = _lines(joint, all_sizes, clearances, listed, letters, interference, parts)
        if with_section:
            taken.add_areas(cut)
            taken.add_areas(item for dimension in measured for item in dimension.items)
            taken.add_box(paper.box(MARGIN, MARGIN + 12.0 + along.width * scale, 0.0, height))
        beside = _beside(loaded or joint, result, lines, paper)
        taken.add_areas(beside)
        names = write_contact_names(joint, view, taken)
        placed = place_dimensions(
            all_sizes, clearances, outlines, reach=reach, paper=paper.inside, taken=taken, listed=listed
        )
        if not placed.unplaced:
            break
        listed |= placed.unplaced
    lines = _lines(joint, all_sizes, clearances, listed, placed.letters, interference, parts)
    beside = _beside(loaded or joint, result, lines, paper)
    items = [*view, *placed.items, *names, *cut, *beside]
    items += [item for dimension in measured for item in dimension.items]
    items += paper.block(_kind(joint), name, title or Title())
    return Sheet(width, height, scale, middle, tuple(items), (*placed.measured, *measured))


def forces_sheet(joint: Joint, result: JointResult) -> Sheet:
    """The forces on the bodies of one sector, or of all that differ, as a picture of its own."""
    items = free_bodies(joint, result, middle=(0.0, 5.0), room=166.0, scale=1.0)
    boxes = [text_box(item, 1.0) for item in items if isinstance(item, Text)]
    boxes += [_around(item) for item in items if not isinstance(item, Text)]
    wider = max(0.0, -84.0 - min(box.left for box in boxes))
    higher = max(0.0, max(box.high for box in boxes) - min(box.low for box in boxes) - 108.0)
    for row, line in enumerate(load_lines(joint, result.forces)):
        items.append(Text((-82.0, -56.0 - 0.5 * higher - _SPACING * row), line))
    return Sheet(170.0 + wider, 140.0 + higher, 1.0, (85.0 + wider, 68.0 + 0.5 * higher), tuple(items))


def _around(item: Circle | Line) -> Box:
    """The box around a circle or a line."""
    if isinstance(item, Circle):
        (x, y), radius = item.centre, item.radius
        return Box(x - radius, x + radius, y - radius, y + radius)
    x_values, y_values = zip(*item.points, strict=True)
    return Box(min(x_values), max(x_values), min(y_values), max(y_values))


def _kind(joint: Joint) -> str:
    words = TYPES[joint.type].words
    return f"{words[0].upper()}{words[1:]} traction drive"


def _beside(joint: Joint, result: JointResult | None, lines: Sequence[str], paper: Paper) -> list[Item]:
    """The column beside the view: the list above the title block, and the forces above it."""
    texts = wrapped_texts(paper, lines)
    if result is None:
        return [*texts]
    left, right = paper.column, paper.width - MARGIN
    loads = load_lines(joint, result.forces)
    top = texts[0].at[1] * paper.scale + paper.middle[1]
    low = top + _SPACING * (len(loads) + 2)
    texts += [Text(paper.at(left, low - _SPACING * (row + 1)), line) for row, line in enumerate(loads)]
    centre = paper.at(0.5 * (left + right), 0.5 * (low + paper.height - MARGIN))
    return [*texts, *free_bodies(joint, result, middle=centre, room=right - left, scale=paper.scale)]


def wrapped_texts(paper: Paper, lines: Sequence[str]) -> list[Text]:
    """Lines in the column above the title block, smaller where they are too many."""
    wrap = [part for line in lines for part in wrapped(line, 0.93 * (paper.width - MARGIN - paper.column))]
    share = min(1.0, (paper.height - MARGIN - 10.0 - _FOOT) / (_SPACING * len(wrap)))
    spacing = share * _SPACING
    top = _FOOT + spacing * len(wrap)
    return [
        Text(paper.at(paper.column, top - spacing * row), line, height=share * TEXT_HEIGHT)
        for row, line in enumerate(wrap)
    ]


def _lines(
    joint: Joint,
    all_sizes: Sequence[Size],
    clearances: Sequence[Clearance],
    listed: frozenset[int],
    letters: dict[int, str],
    interference: float | None,
    stated: StatedParts | None,
) -> list[str]:
    """Lines of text beside the view: ratio, members, sizes without a leader, clearances, contacts and parts."""
    drive = joint.drive
    lines = [
        f"ratio {format_quantity(float(speed_ratio(drive)), '1', 5)}",
        f"{drive.input.replace('_', ' ')} in, {drive.output.replace('_', ' ')} out, "
        f"{drive.ground.replace('_', ' ')} grounded",
    ]
    if any(body.place == "pin" for body in drive.bodies) and drive.grounded != CARRIER:
        pinned = ", ".join(drive.bodies[body].name.replace("_", " ") for body in drive.pinned)
        lines.append(f"pins of the carrier: {pinned}")
    unsaid = [all_sizes[number] for number in sorted(listed)]
    for of, group in groupby(unsaid, key=lambda size: size.of):
        lines.append(f"{of}: {', '.join(size.listed for size in group)}")
    if wedges(drive):
        angles = wedge_angles(drive)
        lines.append(
            f"angle alpha, planet to loading roller, {math.degrees(angles.polar):.5g}°; "
            f"wedge angle beta {math.degrees(angles.wedge):.5g}°"
        )
    lengths_of = {
        body.name.replace("_", " "): dimension(1e3 * float(shape.length))
        for body, shape in zip(drive.bodies, joint.shapes, strict=True)
        if shape.length is not None
    }
    if lengths_of:
        lines.append(f"length of {', of '.join(f'{name} {length}' for name, length in lengths_of.items())}")
    if any(len(tracks_of(joint, number)) > 1 for number in range(len(drive.bodies))):
        lines.append("tracks of stepped rollers lie in different planes, whose distances are not stated")
    if clearances:
        lines += ["", "Clearances"]
        lines += [
            f"{letters.get(number, '–')}  {gap.words} {gap.size:.4g}" for number, gap in enumerate(clearances)
        ]
    lengths = [
        dimension(1e3 * float(length)) for length in np.asarray(contact_values(joint, joint.contact_lengths))
    ]
    alike = len(set(lengths)) == 1
    lines += ["", f"Contacts, length {lengths[0]}" if alike else "Contacts"]
    lines += [
        f"{contact.name}: {contact.first.replace('_', ' ')} – {contact.second.replace('_', ' ')}"
        + ("" if alike else f", length {length}")
        + (_pressed(joint) if drive.layout.in_frame else _interference(joint, contact.second, less))
        for contact, length, less in zip(
            drive.contacts, lengths, contact_interferences(joint, interference), strict=True
        )
    ]
    if stated is not None:
        lines += ["", "Parts", *part_lines(joint, stated)]
    return lines


def _pressed(joint: Joint) -> str:
    """Words for what presses the contact of bodies in a frame."""
    spring = joint.pressing_stiffness
    by = "" if spring is None else f" by a spring of {format_quantity(float(np.asarray(spring)), 'N/mm')}"
    if joint.preload is not None:
        return f", pressed with {format_quantity(float(np.asarray(joint.preload)), 'N')}{by}"
    size = float(np.asarray(joint.interference))
    if spring is not None:
        return f", pressed{by}, {format_quantity(size, 'mm')} from first touch"
    return f", centres {format_quantity(size, 'µm')} nearer to each other than the sum of both radii"


def _interference(joint: Joint, ring: str, less: float | None) -> str:
    """Words for the interference of a contact with a ring; empty for none."""
    if less == 0.0:
        return ""
    if less is None:
        if joint.preload is None:
            return ", interference"
        return f", interference by a preload of {format_quantity(float(np.asarray(joint.preload)), 'N')}"
    cold = "" if joint.fit is None else f" at {format_quantity(float(joint.fit.assembly_temperature), '°C')}"
    ring = ring.replace("_", " ")
    return f", interference {format_quantity(less, 'µm')} on the radius{cold}, in the ⌀ of the {ring}"


def part_lines(joint: Joint, stated: StatedParts) -> list[str]:
    """Number, material and crowns of each kind of body, and the surfaces of the contacts."""
    lines = []
    for kind in kinds(joint, stated.bodies):
        lines.append(f"{counted_name(joint, kind)}: {material_words(joint, stated, kind[0])}")
        lines += crown_lines(stated, kind[0])
    surfaces = dict.fromkeys(stated.surfaces)
    for surface in surfaces:
        names = [name for name, of in zip(joint.contact_names, stated.surfaces, strict=True) if of == surface]
        lines.append(f"surface of {'all contacts' if len(surfaces) == 1 else ', '.join(names)}: {surface}")
    return lines


def material_words(joint: Joint, stated: StatedParts, body: int) -> str:
    """Material of a body with its hardness."""
    hardness = hardness_words(pressure=float(joint.materials[body].hardness))
    return f"{stated.bodies[body].material}, hardness {hardness}"


def crown_lines(stated: StatedParts, body: int) -> list[str]:
    """Crowns of the tracks of a body."""
    return [
        f"crown of track {', '.join(track.contacts)}: radius {dimension(1e3 * track.crown)} along the axis"
        for track in stated.bodies[body].tracks
        if track.crown is not None
    ]


_INDENT = "   "


def wrapped(text: str, width: float) -> list[str]:
    """Break a line of normal height between words, and within a word that is too long."""
    if text_width(text) <= width:
        return [text]
    cut = _longest(text, width)
    space = text.rfind(" ", 1, cut + 1)
    if space > 0 and text[:space].strip():
        return [text[:space], *wrapped(f"{_INDENT}{text[space:].strip()}", width)]
    joint = text.rfind("_", cut // 2, cut)  # of a name in several words
    cut = cut if joint < 0 else joint + 1
    return [text[:cut], *wrapped(f"{_INDENT}{text[cut:]}", width)]


def _longest(text: str, width: float) -> int:
    """Number of letters of the longest beginning that fits, more than the indent."""
    low, high = len(_INDENT) + 1, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if text_width(text[:middle]) <= width else (low, middle - 1)
    return low


def load_lines(joint: Joint, forces: JointForces) -> list[str]:
    """What stands beside bodies that are drawn apart."""
    of = "" if joint.drive.sectors == 1 else " of one sector" if joint.unlike is None else " of all sectors"
    entry, out = (name.replace("_", " ") for name in joint.ends)
    return [
        f"Forces on the bodies{of}, drawn apart, without centrifugal forces.",
        "Arrows show directions, not sizes.",
        f"Torque at the {entry} {format_quantity(float(forces.input_torque), 'N*m')}, "
        f"at the {out} {format_quantity(float(forces.output_torque), 'N*m')}.",
    ]
