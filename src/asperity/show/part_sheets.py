"""A sheet for each kind of roller and ring: view, section, and what the joint file states about it."""

from __future__ import annotations

import math

from asperity.hardness_scales import hardness_words
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.housing import ring_fit, seated
from asperity.joint_file.stated_parts import StatedParts
from asperity.show.dimension_lines import diameter, dimension, toleranced
from asperity.show.drive_sheet import PLAIN, Paper, crown_lines, wrapped_texts
from asperity.show.drive_sizes import (
    Size,
    contact_interferences,
    counted_name,
    kinds,
    made_inside,
    place_dimensions,
)
from asperity.show.drive_view import cross, radii_of, rings_of
from asperity.show.section_view import body_section, draw_section
from asperity.show.sheet import Circle, Item, Sheet, standard_scale
from asperity.show.taken import Taken, around
from asperity.show.title_block import Title
from asperity.units import format_quantity

_VIEW, _SECTION, _MIDDLE = (
    90.0,
    30.0,
    (128.0, 120.0),
)  # room and place of the view, room of the section on paper [mm]
_LEFT = 24.0  # edge of the section on paper [mm]
_OF_CIRCLE = 36


def part_sheets(
    joint: Joint, *, name: str, stated: StatedParts, title: Title, interference: float | None = None
) -> dict[str, Sheet]:
    """Name of the first body of each kind → its sheet, A4 across; the assembly is the sheet before.

    ``interference`` as for :func:`asperity.show.drive_sheet.drive_sheet`.
    """
    alike = kinds(joint, stated.bodies)
    sheets = {}
    for number, kind in enumerate(alike, start=2):
        own = title._replace(material=stated.bodies[kind[0]].material, sheet=f"{number} of {len(alike) + 1}")
        words = counted_name(joint, kind)
        first = joint.drive.bodies[kind[0]].name
        sheets[first] = _part_sheet(joint, kind[0], words, name, stated, own, interference)
    return sheets


def _part_sheet(
    joint: Joint,
    body: int,
    words: str,
    name: str,
    stated: StatedParts,
    title: Title,
    interference: float | None,
) -> Sheet:
    sizes = _sizes(joint, body, stated, interference)
    reach = max(size.radius or 0.0 for size in sizes)
    flat = body_section(joint, body, math.inf)
    scale = standard_scale(max(2.0 * reach, flat.width * _VIEW / _SECTION), room=_VIEW)
    paper = Paper(*PLAIN[:2], PLAIN[3], _MIDDLE, scale)
    section, lengths = draw_section(
        body_section(joint, body, scale, stated.bodies[body].length),
        paper.at(_LEFT, 0.0)[0],
        low=-reach - 2.0 / scale,
        scale=scale,
    )
    circles = [Circle((0.0, 0.0), size.radius) for size in sizes if size.radius is not None]
    listed: frozenset[int] = frozenset()
    lines = _lines(joint, body, stated, interference)
    while True:
        unsaid = [sizes[number].listed for number in sorted(listed)]
        beside = wrapped_texts(paper, [*unsaid, *lines])
        taken = Taken(scale, paper.inside)
        taken.add_areas(beside)
        placed = place_dimensions(
            sizes, [], circles, reach=reach, paper=paper.inside, taken=taken, listed=listed
        )
        if not placed.unplaced:
            break
        listed |= placed.unplaced
    items: list[Item] = [
        *circles,
        *cross((0.0, 0.0), reach + 3.0 / scale, 0.0),
        *placed.items,
        *section,
        *beside,
    ]
    items += [item for length in lengths for item in length.items]
    items += paper.block(words, name, title)
    return Sheet(paper.width, paper.height, scale, _MIDDLE, tuple(items), (*placed.measured, *lengths))


def _sizes(joint: Joint, body: int, stated: StatedParts, interference: float | None) -> list[Size]:
    """Diameters of a body."""
    part, shape = stated.bodies[body], joint.shapes[body]
    rings = [ring for ring in rings_of(joint) if ring.body == body]
    texts = {
        ring.inner: f"{made_inside(joint, ring, interference, part, free=True)}, made bore" for ring in rings
    }
    texts |= {ring.outer: diameter(ring.outer, 0.0) for ring in rings}
    if not rings:
        texts = {r: diameter(r, 1e3 * part.tolerance(1e-3 * r)) for r in radii_of(joint, body)}
        if shape.bore_diameter is not None:
            half = 0.5e3 * float(shape.bore_diameter)
            texts[half] = f"bore {diameter(half, 0.5e3 * part.bore)}"
    return [
        Size("", text, text, tuple(around((0.0, 0.0), radius, 0.0, _OF_CIRCLE)), radius, below=True)
        for radius, text in texts.items()
    ]


def _lines(joint: Joint, body: int, stated: StatedParts, interference: float | None) -> list[str]:
    """What the file states about a part, and what it does not."""
    part, shape, material = stated.bodies[body], joint.shapes[body], joint.materials[body]
    lines = [
        f"material {part.material}",
        f"hardness {hardness_words(pressure=float(material.hardness))}",
        f"yield strength {format_quantity(float(material.yield_strength), 'MPa')}",
        *crown_lines(stated, body),
    ]
    _, second = places(joint.drive)
    less = contact_interferences(joint, interference)
    for radius, contacts in tracks_of(joint, body):
        names = ", ".join(joint.contact_names[number] for number in contacts)
        for surface in dict.fromkeys(stated.surfaces[number] for number in contacts):
            lines.append(f"surface of track {names}: {surface}")
        if second[contacts[0]] == body and less[contacts[0]]:
            size = format_quantity(less[contacts[0]] or 0.0, "µm")
            touching = dimension(2e3 * float(radius))
            lines.append(f"interference {size} on the radius: all contacts just touch at ⌀{touching}")
        if not part.tolerance(float(radius)):
            lines.append(f"tolerance of track {names}: not stated")
    if shape.kind == "ring" and shape.size is not None:
        lines.append(f"wall {toleranced(1e3 * float(shape.size), 1e3 * part.wall)}")
    if joint.housing is not None and seated(joint)[body]:
        larger = format_quantity(float(joint.housing.interference), "µm")
        narrower = format_quantity(float(ring_fit(joint, body, working=False).bore_change), "µm")
        lines.append(f"outer diameter {larger} larger than the bore of the housing")
        lines.append(f"made bore: before it is pressed in, which narrows it by {narrower}")
    if shape.length is None:
        lines.append("length: that of the contact line; no other is stated")
    if len(tracks_of(joint, body)) > 1:
        lines.append("distance between the tracks along the axis: not stated")
    return [*lines, "roundness, runout, edges: not stated"]
