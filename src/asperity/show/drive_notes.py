"""What stands beside the view of a drive: ratio, sizes without a leader, clearances, contacts, parts and loads."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import groupby

import numpy as np

from asperity.drive.layout.drive import CARRIER, speed_ratio
from asperity.drive.layout.wedge import wedge_angles, wedges
from asperity.hardness_scales import hardness_words
from asperity.joint.description import Joint, contact_values, tracks_of
from asperity.joint.evaluation import JointForces
from asperity.joint_file.stated_parts import StatedParts
from asperity.show.dimension_lines import dimension
from asperity.show.drive_sizes import Clearance, Size, contact_interferences, counted_name, kinds
from asperity.units import format_quantity


def drive_lines(
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
    if joint.housing is not None:
        smaller = format_quantity(float(joint.housing.interference), "µm")
        lines.append(f"housing: {stated.housing}, bore {smaller} smaller than its ring; length not stated")
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
    """Crowns and profiles of the tracks of a body."""
    lines = []
    for track in stated.bodies[body].tracks:
        names = ", ".join(track.contacts)
        if track.crown is not None:
            lines.append(f"crown of track {names}: radius {dimension(1e3 * track.crown)} along the axis")
        if track.profile:
            lines.append(f"profile of track {names} along the axis: {track.profile}")
    return lines


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
