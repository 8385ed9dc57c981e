"""A sheet for each kind of roller and ring: view, section, and what the joint file states about it."""

from __future__ import annotations

import functools

from asperity.hardness_scales import hardness_words
from asperity.joint.description import Joint, body_masses, places, tracks_of
from asperity.joint.housing import ring_fit, seated
from asperity.joint_file.stated_parts import StatedParts
from asperity.show.arrangement import Room, arrange
from asperity.show.box import Box, around_all, box_of
from asperity.show.dimension_lines import diameter, dimension, toleranced
from asperity.show.drive_notes import crown_lines
from asperity.show.drive_sizes import Size, contact_interferences, counted_name, kinds, made_inside
from asperity.show.drive_view import cross, radii_of, rings_of
from asperity.show.placed_dimensions import place_dimensions, room_of_dimensions
from asperity.show.section_view import body_section, draw_section
from asperity.show.sheet import Circle, Dimension, Item, Sheet
from asperity.show.surface_symbol import symbols_of_tracks
from asperity.show.taken import Taken, around
from asperity.show.title_block import Title
from asperity.units import format_quantity

_BEYOND_AXES = 4.0  # of a view, with its axes [mm on paper]
_OF_CIRCLE = 36


def part_sheets(
    joint: Joint, *, name: str, stated: StatedParts, title: Title, interference: float | None = None
) -> dict[str, Sheet]:
    """Name of the first body of each kind → its sheet, mostly A4; the assembly is the sheet before.

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
    """The sheet of one part: section and view at one height, and what finds no room in them beside them."""
    sizes = _sizes(joint, body, stated, interference)
    circles = [Circle((0.0, 0.0), size.radius) for size in sizes if size.radius is not None]
    outlined = around_all(box_of(circle, 1.0) for circle in circles)
    lines = _lines(joint, body, stated, interference)
    listed: frozenset[int] = frozenset()
    while True:
        arranged = arrange(
            functools.cache(functools.partial(_rooms, joint, body, stated, sizes, listed)),
            [*(sizes[number].listed for number in sorted(listed)), *lines],
            origin=1,
            what=words,
            size=outlined.width,
        )
        paper, scale = arranged.paper, arranged.paper.scale
        room = paper.box(arranged.boxes[1])
        placed = place_dimensions(
            sizes, [], circles, view=outlined, paper=room, taken=Taken(scale, room), listed=listed
        )
        if not placed.unplaced:
            break
        listed |= placed.unplaced
    cut, lengths = _section_items(joint, body, stated, scale, paper.at(*arranged.origins[0])[0])
    front = [*circles, *cross((0.0, 0.0), outlined.right + 3.0 / scale, 0.0), *placed.items]
    groups = [front, cut, arranged.note_items()]
    return Sheet(
        paper.width,
        paper.height,
        scale,
        paper.middle,
        (*(item for group in groups for item in group), *paper.block(words, name, title)),
        (*placed.measured, *lengths),
        (*(paper.boxed(group) for group in groups), paper.title_box),
    )


def _rooms(
    joint: Joint, body: int, stated: StatedParts, sizes: list[Size], listed: frozenset[int], scale: float
) -> list[Room]:
    """The rooms of section and view at a scale."""
    cut, _ = _section_items(joint, body, stated, scale, 0.0)
    left, right_end, low, high = (scale * edge for edge in around_all(box_of(item, scale) for item in cut))
    along = body_section(joint, body, scale)
    reach = scale * max(size.radius or 0.0 for size in sizes)
    _, right, below = room_of_dimensions(sizes, [], listed, right=reach / scale, scale=scale)
    return [
        Room(Box(left, right_end, low, high), (scale * along.width, scale * (along.height + along.depth))),
        Room(
            Box(
                -reach - _BEYOND_AXES,
                reach + max(_BEYOND_AXES, right),
                -reach - max(_BEYOND_AXES, below),
                reach + _BEYOND_AXES,
            ),
            (2.0 * reach, 2.0 * reach),
        ),
    ]


def _section_items(
    joint: Joint, body: int, stated: StatedParts, scale: float, x: float
) -> tuple[list[Item], list[Dimension]]:
    """The section that begins at a place along the axis [mm] with its surface symbols, and its lengths."""
    along = body_section(joint, body, scale, stated.bodies[body].length)
    items, lengths = draw_section(along, x, low=-along.depth - 2.0 / scale, scale=scale)
    items += [item for length in lengths for item in length.items]
    inside = -1.0 if joint.shapes[body].kind == "ring" else 1.0  # below the axis a bore looks upwards
    surfaces = [
        (inside * 1e3 * float(radius), x + length.left, x + length.right, _symbol(stated, contacts))
        for (radius, contacts), length in zip(tracks_of(joint, body), along.lengths, strict=True)
    ]
    return [*items, *symbols_of_tracks(surfaces, scale)], lengths


def _symbol(stated: StatedParts, contacts: list[int]) -> tuple[str, ...]:
    """What the surface symbol of a track says; nothing where its contacts differ."""
    alike = {stated.symbols[number] for number in contacts}
    return alike.pop() if len(alike) == 1 else ()


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
        f"mass {format_quantity(float(body_masses(joint)[body]), 'g')}",
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
    return [*lines, *part.form, *_not_stated(part.form)]


def _not_stated(form: tuple[str, ...]) -> list[str]:
    """What of the form of a part the file does not state."""
    said = " ".join(form)
    missing = [word for word in ("roundness", "runout") if word not in said]
    return [f"{', '.join([*missing, 'edges'])}: not stated"]
