"""The shapes of a drive and the forces at its contacts, to be drawn in the browser."""

from __future__ import annotations

from typing import Any

import numpy as np

from asperity.drive.layout.drive import sector_rotation
from asperity.joint.description import Joint, places, tracks_of
from asperity.joint.evaluation import JointResult
from asperity.show.body_force import BodyForce
from asperity.show.free_bodies import body_forces


def drive_shapes(joint: Joint, result: JointResult) -> dict[str, Any]:
    """Circles of a drive, and the contact forces of its first sector."""
    drive, centres = joint.drive, np.asarray(joint.drive.centres)
    circles, rings = [], []
    for number, (body, shape) in enumerate(zip(drive.bodies, joint.shapes, strict=True)):
        name = body.name.replace("_", " ")
        radii = [float(radius) for radius, _ in tracks_of(joint, number)]
        if shape.kind == "ring":
            wall = 0.0 if shape.size is None else float(shape.size)
            rings += [{"body": name, "inner_radius_m": radius, "wall_m": wall} for radius in radii]
            continue
        for sector in range(1 if body.on_axis else int(drive.sectors)):
            x, y = sector_rotation(drive, sector) @ centres[number]
            circles += [
                {"body": name, "x_m": float(x), "y_m": float(y), "radius_m": radius}
                for radius in sorted([*radii, *_bore(joint, number)], reverse=True)
            ]
    known = bool(np.all(np.isfinite(np.asarray(result.forces.normal))))
    found = body_forces(joint, result)
    return {
        "rollers": circles,
        "rings": rings,
        "forces": _contact_forces(joint, found) if known else [],
        "bodies": [_free_body(joint, number, found) for number in drive.floating if known],
    }


def _bore(joint: Joint, number: int) -> list[float]:
    """Radius of the bore of a hollow roller [m]."""
    bore = joint.shapes[number].bore_diameter
    return [] if bore is None else [0.5 * float(bore)]


def _contact_forces(joint: Joint, found: list[BodyForce]) -> list[dict[str, Any]]:
    """The forces of each contact on its first body, where they act."""
    centres = np.asarray(joint.drive.centres)
    entries = []
    for k, (contact, number) in enumerate(zip(joint.drive.contacts, places(joint.drive)[0], strict=True)):
        normal, tangential = (
            next(
                each
                for each in found
                if (each.name, each.kind, each.body) == (contact.name, kind, contact.first)
            )
            for kind in ("N", "T")
        )
        x, y = centres[number] + float(joint.drive.first_radius[k]) * np.array(normal.place)
        entries.append(
            {
                "contact": contact.name,
                "on": contact.first.replace("_", " "),
                "x_m": float(x),
                "y_m": float(y),
                "normal_N": _vector(normal),
                "tangential_N": _vector(tangential),
            }
        )
    return entries


def _free_body(joint: Joint, number: int, found: list[BodyForce]) -> dict[str, Any]:
    """One roller with the forces on it: its tracks and bore, and where around its axis each force acts."""
    body = joint.drive.bodies[number].name
    return {
        "body": body.replace("_", " "),
        "radii_m": [*(float(radius) for radius, _ in tracks_of(joint, number)), *_bore(joint, number)],
        "forces": [
            {
                "name": each.name,
                "kind": {"N": "normal", "T": "tangential", "F": "pin"}[each.kind],
                "radius_m": 0.0 if each.kind == "F" else _track(joint, each),
                "place": list(each.place),
                "force_N": _vector(each),
            }
            for each in found
            if each.body == body
        ],
    }


def _track(joint: Joint, force: BodyForce) -> float:
    """Radius of the track on which the force of a contact acts [m]."""
    for k, contact in enumerate(joint.drive.contacts):
        if contact.name == force.name:
            mine = joint.drive.first_radius if contact.first == force.body else joint.drive.second_radius
            return float(mine[k])
    raise KeyError(force.name)


def _vector(force: BodyForce) -> list[float]:
    return [force.size * each for each in force.direction]
