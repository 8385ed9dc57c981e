"""The drawing of a drive: its view to scale, its sizes and clearances, and the forces on request."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

import asperity
from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES, angles, triangle
from asperity.errors import printable
from asperity.joint.description import Joint
from asperity.joint.either_kind import AnyJoint
from asperity.joint.planar.evaluation import PlanarForces
from asperity.show.dimension_lines import dimension, made_bore
from asperity.show.drive_view import drive_view, gaps, ring_as_drawn
from asperity.show.free_bodies import free_bodies
from asperity.show.sheet import (
    TEXT_HEIGHT,
    TITLE_HEIGHT,
    Item,
    Line,
    Point,
    Sheet,
    Text,
    scale_text,
    standard_scale,
)
from asperity.show.style import CONTACT_LABELS
from asperity.units import format_quantity

#: From the edge of the paper to the frame of a drawing [mm].
MARGIN = 10.0
_SPACING = 4.4  # between two lines of text
_LONGEST_TITLE = 42
#: Size of the paper, room of the view, and left edge of the column beside it, all in mm: A4 and A3.
PLAIN, WITH_FORCES = (297.0, 210.0, 150.0, 195.0), (420.0, 297.0, 220.0, 270.0)


def drive_sheet(
    joint: Joint, *, name: str, forces: DriveForces | None = None, interference: float | None = None
) -> Sheet:
    """Draw a drive to scale.

    Parameters
    ----------
    joint : Joint
        One joint.
    name : str
        What the drawing is called, for example the name of its file.
    forces : DriveForces, optional
        Its forces, to be drawn too.
    interference : float or None, optional
        With which it is made [m]; None where it is not known, as the sheet then says.

    Returns
    -------
    Sheet
        A4 across, or A3 across with forces, at the largest standard scale that fits.

    Raises
    ------
    InputError
        If the rollers cannot touch: the triangle of centres does not close.
    """
    width, height, room, column = PLAIN if forces is None else WITH_FORCES
    ring = ring_as_drawn(joint)
    scale = standard_scale(2.0 * ring.shown, room=room)
    middle = (MARGIN + 5.0 + 0.5 * room + 10.0, 0.5 * height + 8.0)
    items: list[Item] = []

    def on_paper(x: float, y: float) -> tuple[float, float]:
        return (x - middle[0]) / scale, (y - middle[1]) / scale

    def write(x: float, y: float, lines: Sequence[str], *, text_height: float = TEXT_HEIGHT) -> None:
        for index, line in enumerate(lines):
            items.append(Text(on_paper(x, y - index * _SPACING), line, height=text_height))

    sizes, smallest = _sizes(joint, interference), _clearances(joint)
    foot, above = MARGIN + 27.0, -math.inf
    if forces is None:
        lines = [*sizes, "", *smallest]
        write(column, foot + _SPACING * (len(lines) - 1), lines)
    else:
        level = foot + _SPACING * (len(sizes) - 1)
        write(column, level, sizes)
        write(column + 80.0, level, smallest)
        write(column, level + 4.5 * _SPACING, load_lines(joint, forces, part="branch"))
        room = width - MARGIN - column
        centre = on_paper(column + 0.5 * room, level + 62.0)
        apart = free_bodies(joint, forces, centre=centre, scale=scale, room=room - 4.0)
        above = max(each.at[1] for each in apart if isinstance(each, Text))  # numbers are the highest
        items += apart
        write(
            MARGIN + 5.0,
            height - MARGIN - 8.0,
            [f"{each}: {words}" for each, words in CONTACT_LABELS.items()],
        )
    left = (column - middle[0]) / scale
    items += drive_view(joint, scale=scale, labels_from=left, labels_above=above, interference=interference)
    items += title_block(on_paper, column, width, name, scale)
    items.append(frame(on_paper, width, height))
    return Sheet(width, height, scale, middle, tuple(items))


def forces_sheet(joint: Joint, forces: DriveForces) -> Sheet:
    """The forces on the bodies of one branch as a picture of its own.

    Parameters
    ----------
    joint : Joint
        One joint.
    forces : DriveForces
        Its forces.

    Returns
    -------
    Sheet
        A sheet of 170 mm by 140 mm.
    """
    items = free_bodies(joint, forces, centre=(0.0, 0.0), scale=1.0, room=166.0)
    words = [f"{contact}: {label}" for contact, label in CONTACT_LABELS.items()]
    for line, (x, y) in (
        *(
            (line, (-82.0, -43.0 - _SPACING * row))
            for row, line in enumerate(load_lines(joint, forces, part="branch"))
        ),
        *((line, (42.0, -38.4 + _SPACING * (4 - row))) for row, line in enumerate(words)),
    ):
        items.append(Text((x, y), line))
    return Sheet(170.0, 140.0, 1.0, (85.0, 57.0), tuple(items))


def frame(on_paper: Callable[[float, float], Point], width: float, height: float) -> Item:
    """The frame of a sheet of paper.

    Parameters
    ----------
    on_paper : callable
        From a place on paper [mm] to the drawing.
    width, height : float
        Size of the paper [mm].

    Returns
    -------
    Item
        A closed line.
    """
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
    """What a drawing is called, its scale and unit, in the lower right corner.

    Parameters
    ----------
    on_paper : callable
        From a place on paper [mm] to the drawing.
    column, width : float
        Left edge of the column beside the view, and width of the paper [mm].
    name : str
        What the drawing is called.
    scale : float
        Length on paper over true length [-].
    kind : str, optional
        What is drawn.

    Returns
    -------
    list of Item
        Lines and texts.
    """
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


def _sizes(joint: Joint, interference: float | None) -> list[str]:
    """What the view itself does not say."""
    found, ring = angles(triangle(joint.geometry)), ring_as_drawn(joint)
    degrees = {name: f"{math.degrees(float(getattr(found, name))):.3f}°" for name in ("polar", "wedge")}
    wall = f"ring: made bore {made_bore(ring.inner, interference)},"
    lines = [
        f"{round(float(joint.geometry.planet_count))} planets, two loading rollers each",
        wall,
        f"   outside ⌀{dimension(2.0 * ring.outer)}",
        *(["the wall is broken off at the wavy line"] if ring.broken else []),
        *_interference(joint, ring.inner, interference),
        f"contact length {_contact_lengths(joint)}",
        f"length of planets {dimension(1e3 * float(joint.planet_length))}, "
        f"of loading rollers {dimension(1e3 * float(joint.loading_roller_length))}",
        f"angle alpha, planet to loading roller, {degrees['polar']}",
        f"wedge angle beta {degrees['wedge']}",
    ]
    if not float(joint.bearings.pin_diameter) > 0.0:
        lines.append("no diameter of the pins in the file: axes only")
    return lines


def _interference(joint: Joint, radius: float, interference: float | None) -> list[str]:
    """By how much the bore is less than the diameter at which all just touch, and at which temperature."""
    if interference is None:
        return ["interference on the radius not known"]
    cold = "" if joint.fit is None else f" at {format_quantity(float(joint.fit.assembly_temperature), '°C')}"
    size = format_quantity(interference, "µm")
    return [
        f"interference {size} on the radius{cold}",
        f"   (all just touch in ⌀{dimension(2.0 * radius)})",
    ]


def _clearances(joint: Joint) -> list[str]:
    lines = ["Smallest clearances"]
    for gap in gaps(joint):
        overlap = "" if gap.size > 0.0 else "  OVERLAP"
        lines.append(f"{gap.letter}  {gap.words} {gap.size:.4g}{overlap}")
    return lines


def _contact_lengths(joint: Joint) -> str:
    lengths = [dimension(1e3 * float(np.asarray(each))) for each in joint.contact_lengths]
    if len(set(lengths)) == 1:
        return lengths[0]
    return ", ".join(f"{name} {length}" for name, length in zip(CONTACT_NAMES, lengths, strict=True))


def load_lines(joint: AnyJoint, forces: DriveForces | PlanarForces, *, part: str) -> list[str]:
    """What stands beside bodies that are drawn apart.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint.
    forces : DriveForces or PlanarForces
        Its forces.
    part : str
        What the bodies belong to.

    Returns
    -------
    list of str
        Lines.
    """
    entry, out = (name.replace("_", " ") for name in joint.ends)
    return [
        f"Forces on the bodies of one {part}, drawn apart, without centrifugal forces.",
        "Arrows show directions, not sizes.",
        f"Torque at the {entry} {format_quantity(float(forces.input_torque), 'N*m')}, "
        f"at the {out} {format_quantity(float(forces.output_torque), 'N*m')}.",
    ]
