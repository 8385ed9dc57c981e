"""The shapes of a drive and the forces at its contacts, to be drawn in the browser."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.description import Joint
from asperity.show.drive_drawing import Roller, rollers

Point = tuple[float, float]


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
    sun, planet, right, left = placed[:4]
    return {
        "rollers": [
            {"body": each.body, "x_m": each.centre[0], "y_m": each.centre[1], "radius_m": each.radius}
            for each in placed
        ],
        "ring": {
            "inner_radius_m": float(joint.geometry.ring_radius),
            "wall_m": float(joint.ring_wall_thickness),
        },
        "forces": _forces(sun, planet, right, left, forces),
    }


def _forces(
    sun: Roller, planet: Roller, right: Roller, left: Roller, forces: DriveForces
) -> list[dict[str, Any]]:
    """Signs of equations (2) to (4): a positive T_sp pushes the planet clockwise, the other T hold it back."""
    towards_right, towards_left = _unit(planet.centre, right.centre), _unit(planet.centre, left.centre)
    out_right, out_left = _unit(sun.centre, right.centre), _unit(sun.centre, left.centre)
    # contact: point, direction of N and of T on the body
    places: dict[str, tuple[str, Point, Point, Point]] = {
        "sp": ("planet", _along(planet, (0.0, -1.0)), (0.0, 1.0), (1.0, 0.0)),
        "pwr": ("planet", _along(planet, towards_right), _back(towards_right), _clockwise(towards_right)),
        "pwl": ("planet", _along(planet, towards_left), _back(towards_left), _clockwise(towards_left)),
        "wro": (
            "right loading roller",
            _along(right, out_right),
            _back(out_right),
            _back(_clockwise(out_right)),
        ),
        "wlo": ("left loading roller", _along(left, out_left), _back(out_left), _back(_clockwise(out_left))),
    }
    found = []
    for index, name in enumerate(CONTACT_NAMES):
        body, point, normal, tangential = places[name]
        sizes = float(np.asarray(forces.normal)[index]), float(np.asarray(forces.tangential)[index])
        found.append(
            {
                "contact": name,
                "on": body,
                "x_m": point[0],
                "y_m": point[1],
                "normal_N": [sizes[0] * part for part in normal],
                "tangential_N": [sizes[1] * part for part in tangential],
            }
        )
    return found


def _unit(start: Point, end: Point) -> Point:
    x, y = end[0] - start[0], end[1] - start[1]
    length = math.hypot(x, y)
    return x / length, y / length


def _along(roller: Roller, direction: Point) -> Point:
    return (
        roller.centre[0] + roller.radius * direction[0],
        roller.centre[1] + roller.radius * direction[1],
    )


def _back(direction: Point) -> Point:
    return -direction[0], -direction[1]


def _clockwise(direction: Point) -> Point:
    """A quarter turn clockwise."""
    return direction[1], -direction[0]
