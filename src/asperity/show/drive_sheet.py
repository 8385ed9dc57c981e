"""The drawing of a drive: frame, view with dimensions, what the view does not say, and the forces on request."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import groupby

import numpy as np

import asperity
from asperity.drive.layout.drive import CARRIER, speed_ratio
from asperity.drive.layout.wedge import wedge_angles, wedges
from asperity.errors import printable
from asperity.joint.description import Joint, contact_values, tracks_of
from asperity.joint.evaluation import JointForces, JointResult
from asperity.joint_file.part_names import WEDGE_TYPE
from asperity.show.dimension_lines import dimension
from asperity.show.drive_sizes import (
    Clearance,
    Size,
    contact_interferences,
    drive_clearances,
    place_dimensions,
    sizes,
)
from asperity.show.drive_view import drive_view, reach_of, write_contact_names
from asperity.show.free_bodies import free_bodies
from asperity.show.sheet import (
    TEXT_HEIGHT,
    TITLE_HEIGHT,
    Circle,
    Item,
    Line,
    Point,
    Sheet,
    Text,
    scale_text,
    standard_scale,
)
from asperity.show.sheet_figure import text_width
from asperity.show.taken import Box, Taken, text_box
from asperity.units import format_quantity

_FOOT = 37.0  # of the texts above the title block on paper [mm]
_SPACING = 4.4
#: From the edge of the paper to the frame of a drawing [mm].
MARGIN = 10.0
_LONGEST_TITLE = 42
#: Size of the paper, room of the view, and left edge of the column beside it, all in mm: A4 and A3.
PLAIN, WITH_FORCES = (297.0, 210.0, 150.0, 195.0), (420.0, 297.0, 220.0, 270.0)


def drive_sheet(
    joint: Joint,
    *,
    name: str,
    result: JointResult | None = None,
    loaded: Joint | None = None,
    interference: float | None = None,
) -> Sheet:
    """Draw a drive to scale.

    Parameters
    ----------
    joint : Joint
        One joint whose drive can exist.
    name : str
        What the drawing is called, for example the name of its file.
    result : JointResult, optional
        Its result, if the forces on the bodies are to be drawn too.
    loaded : Joint, optional
        Whose forces these are where the sectors differ, every sector by itself; the same joint if absent.
    interference : float or None, optional
        With which the drive is made where the joint states a force [m]; None where it is not known.

    Returns
    -------
    Sheet
        A4 across, or A3 across with forces, at the largest standard scale that fits. Tracks of a stepped roller are
        circles about one centre, although they lie in different planes. A size for which the view has no room is said
        beside it. Rings are drawn at the radii at which all contacts just touch.
    """
    width, height, room, column = PLAIN if result is None else WITH_FORCES
    reach = reach_of(joint)
    scale = standard_scale(2.0 * reach, room=room)
    middle = (MARGIN + 15.0 + 0.5 * room, 0.5 * height + 8.0)

    def on_paper(x: float, y: float) -> Point:
        return (x - middle[0]) / scale, (y - middle[1]) / scale

    view = drive_view(joint, scale)
    outlines = [item for item in view if isinstance(item, Circle) and item.style == "outline"]
    block = title_block(on_paper, column, width, name, scale, kind=_kind(joint))
    paper = Box(*_edges(on_paper, MARGIN + 2.0, width - MARGIN - 2.0, MARGIN + 2.0, height - MARGIN - 2.0))
    all_sizes, clearances = sizes(joint, scale, interference), drive_clearances(joint)
    listed = frozenset(n for n, size in enumerate(all_sizes) if not size.places)
    while True:  # what finds no room is listed, and the list needs room
        taken = Taken(scale, paper)
        taken.add_box(Box(*_edges(on_paper, column - 4.0, width, 0.0, _FOOT - 4.0)))
        lines = _lines(
            joint, all_sizes, clearances, listed, dict.fromkeys(range(len(clearances)), "C"), interference
        )
        beside = _beside(loaded or joint, result, lines, on_paper, (width, height, column), scale)
        taken.add_areas(beside)
        names = write_contact_names(joint, view, taken)
        placed = place_dimensions(
            all_sizes, clearances, outlines, reach=reach, paper=paper, taken=taken, listed=listed
        )
        if not placed.unplaced:
            break
        listed |= placed.unplaced
    lines = _lines(joint, all_sizes, clearances, listed, placed.letters, interference)
    beside = _beside(loaded or joint, result, lines, on_paper, (width, height, column), scale)
    items = [*view, *placed.items, *names, *beside, *block, frame(on_paper, width, height)]
    return Sheet(width, height, scale, middle, tuple(items))


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


def _edges(
    on_paper: Callable[[float, float], Point], left: float, right: float, low: float, high: float
) -> tuple[float, float, float, float]:
    (x, y), (u, v) = on_paper(left, low), on_paper(right, high)
    return x, u, y, v


def _kind(joint: Joint) -> str:
    words = "planetary" if joint.type == WEDGE_TYPE else joint.type.replace("_", " ")
    return f"{words[0].upper()}{words[1:]} traction drive"


def _beside(
    joint: Joint,
    result: JointResult | None,
    lines: Sequence[str],
    on_paper: Callable[[float, float], Point],
    paper: tuple[float, float, float],
    scale: float,
) -> list[Item]:
    """The column beside the view: the list above the title block, and the forces above it."""
    width, height, column = paper
    across = width - MARGIN - column
    wrap = [part for line in lines for part in wrapped(line, 0.93 * across)]
    high = height - MARGIN - 10.0
    share = min(1.0, (high - _FOOT) / (_SPACING * len(wrap)))
    spacing = share * _SPACING
    top = _FOOT + spacing * len(wrap)
    items: list[Item] = [
        Text(on_paper(column, top - spacing * row), line, height=share * TEXT_HEIGHT)
        for row, line in enumerate(wrap)
    ]
    if result is None:
        return items
    loads = load_lines(joint, result.forces)
    low = top + _SPACING * (len(loads) + 2)
    items += [Text(on_paper(column, low - _SPACING * (row + 1)), line) for row, line in enumerate(loads)]
    centre = on_paper(0.5 * (column + width - MARGIN), 0.5 * (low + height - MARGIN))
    return items + free_bodies(joint, result, middle=centre, room=across, scale=scale)


def _lines(
    joint: Joint,
    all_sizes: Sequence[Size],
    clearances: Sequence[Clearance],
    listed: frozenset[int],
    letters: dict[int, str],
    interference: float | None,
) -> list[str]:
    """Lines of text beside the view: ratio, members, sizes without a leader, clearances and contacts."""
    drive = joint.drive
    lines = [
        f"ratio {format_quantity(float(speed_ratio(drive)), '1', 5)}",
        f"{drive.input.replace('_', ' ')} in, {drive.output.replace('_', ' ')} out, "
        f"{drive.grounded.replace('_', ' ')} grounded",
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
        lines.append("tracks of stepped rollers lie in different planes")
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
    return lines + [
        f"{contact.name}: {contact.first.replace('_', ' ')} – {contact.second.replace('_', ' ')}"
        + ("" if alike else f", length {length}")
        + _interference(joint, contact.second, less)
        for contact, length, less in zip(
            drive.contacts, lengths, contact_interferences(joint, interference), strict=True
        )
    ]


def _interference(joint: Joint, ring: str, less: float | None) -> str:
    """Words for the interference of a contact with a ring; empty for none."""
    if less == 0.0:
        return ""
    if less is None:
        force = (
            ""
            if joint.preload is None
            else f" by a preload of {format_quantity(float(np.asarray(joint.preload)), 'N')}"
        )
        return f", interference{force}"
    cold = "" if joint.fit is None else f" at {format_quantity(float(joint.fit.assembly_temperature), '°C')}"
    return (
        f", interference {format_quantity(less, 'µm')} on the radius{cold}, in the ⌀ of the "
        f"{ring.replace('_', ' ')}"
    )


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


def frame(on_paper: Callable[[float, float], Point], width: float, height: float) -> Item:
    """The frame of a sheet of paper."""
    right, top = width - MARGIN, height - MARGIN
    corners = ((MARGIN, MARGIN), (right, MARGIN), (right, top), (MARGIN, top), (MARGIN, MARGIN))
    return Line(tuple(on_paper(*corner) for corner in corners), "frame")


def title_block(
    on_paper: Callable[[float, float], Point],
    column: float,
    width: float,
    name: str,
    scale: float,
    *,
    kind: str = "Planetary traction drive",
) -> list[Item]:
    """What a drawing is called, its scale and unit, in the lower right corner."""
    title = printable(name).replace("\n", " ")
    shown = title if len(title) <= _LONGEST_TITLE else f"…{title[1 - _LONGEST_TITLE :]}"
    top, left = MARGIN + 22.0, column - 3.0
    edge = (on_paper(left, MARGIN), on_paper(left, top), on_paper(width - MARGIN, top))
    return [
        Line(edge, "frame"),
        Text(on_paper(column, top - 6.5), kind, height=TITLE_HEIGHT),
        Text(on_paper(column, top - 12.5), shown),
        Text(
            on_paper(column, top - 18.5),
            f"Scale {scale_text(scale)}   dimensions in mm   asperity {asperity.__version__}",
        ),
    ]


def load_lines(joint: Joint, forces: JointForces) -> list[str]:
    """What stands beside bodies that are drawn apart."""
    sectors = "one sector" if joint.unlike is None else "all sectors"
    entry, out = (name.replace("_", " ") for name in joint.ends)
    return [
        f"Forces on the bodies of {sectors}, drawn apart, without centrifugal forces.",
        "Arrows show directions, not sizes.",
        f"Torque at the {entry} {format_quantity(float(forces.input_torque), 'N*m')}, "
        f"at the {out} {format_quantity(float(forces.output_torque), 'N*m')}.",
    ]
