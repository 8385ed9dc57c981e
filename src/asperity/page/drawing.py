"""The shapes of a drive and the forces at its contacts, to be drawn in the browser."""

from __future__ import annotations

from typing import Any

import numpy as np

from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES
from asperity.drive.planar.layout import contact_angles, sector_rotation
from asperity.joint.description import Joint
from asperity.joint.planar.description import PlanarJoint, places, tracks_of
from asperity.joint.planar.evaluation import PlanarResult, driving_sense
from asperity.show.drive_drawing import Roller, rollers
from asperity.show.free_bodies import body_forces


def drive_shapes(joint: Joint, forces: DriveForces) -> dict[str, Any]:
    """Circles of the drive, and points, directions and sizes of the contact forces of its first branch.

    Parameters
    ----------
    joint : Joint
        One joint.
    forces : DriveForces
        Its forces.

    Returns
    -------
    dict
        ``rollers`` with centre and radius [m]; ``ring`` with its inner radius and wall [m]; ``forces``: for each
        contact the point where it acts [m], and normal and tangential force as vectors on the body named [N].
        Coordinates: the sun at the origin, the first planet on the positive y axis.
    """
    placed = rollers(joint.geometry)
    return {
        "rollers": [
            {"body": each.body, "x_m": each.centre[0], "y_m": each.centre[1], "radius_m": each.radius}
            for each in placed
        ],
        "ring": {
            "inner_radius_m": float(joint.geometry.ring_radius),
            "wall_m": float(joint.ring_wall_thickness),
        },
        "forces": _forces(joint, forces, {each.body: each for each in reversed(placed)}),
    }


def _forces(joint: Joint, forces: DriveForces, first: dict[str, Roller]) -> list[dict[str, Any]]:
    """Each contact once: on the planet where it has one, otherwise on the loading roller."""
    found: dict[str, dict[str, Any]] = {}
    for force in body_forces(joint, forces):
        if force.name == "pin" or (force.name.startswith("pw") and force.body != "planet"):
            continue
        roller = first[force.body]
        (x, y), (right, up) = force.place, force.direction
        entry = found.setdefault(
            force.name,
            {
                "contact": force.name,
                "on": force.body,
                "x_m": roller.centre[0] + roller.radius * x,
                "y_m": roller.centre[1] + roller.radius * y,
            },
        )
        entry["normal_N" if force.kind == "N" else "tangential_N"] = [force.size * right, force.size * up]
    return [found[name] for name in CONTACT_NAMES]


def planar_shapes(joint: PlanarJoint, result: PlanarResult) -> dict[str, Any]:
    """Circles of a planar drive, and the contact forces of its first sector.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        Its result.

    Returns
    -------
    dict
        ``rollers``: a circle for every track of every roller; ``rings`` with inner radius and wall [m]; ``forces`` on
        the first body of each contact, as :func:`drive_shapes` gives them.
    """
    drive, centres = joint.drive, np.asarray(joint.drive.centres)
    circles, rings = [], []
    for number, (body, shape) in enumerate(zip(drive.bodies, joint.shapes, strict=True)):
        name = body.name.replace("_", " ")
        radii = [float(radius) for radius, _ in tracks_of(joint, number)]
        if shape.kind == "ring":
            wall = 0.0 if shape.size is None else float(shape.size)
            rings += [{"body": name, "inner_radius_m": radius, "wall_m": wall} for radius in radii]
            continue
        bore = [0.5 * float(shape.size)] if shape.size is not None else []
        for sector in range(1 if body.place == "axis" else int(drive.sectors)):
            x, y = sector_rotation(drive, sector) @ centres[number]
            circles += [
                {"body": name, "x_m": float(x), "y_m": float(y), "radius_m": radius}
                for radius in sorted([*radii, *bore], reverse=True)
            ]
    first, _ = places(drive)
    angles = np.asarray(contact_angles(drive)[0])
    tangential = np.asarray(driving_sense(drive)) * np.asarray(result.forces.tangential)
    forces = []
    for k, contact in enumerate(drive.contacts):
        normal = np.array([np.cos(angles[k]), np.sin(angles[k])])
        x, y = centres[first[k]] + float(drive.first_radius[k]) * normal
        forces.append(
            {
                "contact": contact.name,
                "on": contact.first.replace("_", " "),
                "x_m": float(x),
                "y_m": float(y),
                "normal_N": (-float(result.forces.normal[k]) * normal).tolist(),
                "tangential_N": (-tangential[k] * np.array([-normal[1], normal[0]])).tolist(),
            }
        )
    return {"rollers": circles, "rings": rings, "forces": forces}
