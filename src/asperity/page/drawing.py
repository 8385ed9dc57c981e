"""The shapes of a drive and the forces at its contacts, to be drawn in the browser."""

from __future__ import annotations

from typing import Any

from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.description import Joint
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
