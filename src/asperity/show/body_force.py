"""The bodies of one branch drawn apart, with the forces on each of them."""

from __future__ import annotations

import math
from typing import NamedTuple

from asperity.show.sheet import Point
from asperity.units import format_quantity

_ARROW = 10.0  # length of an arrow on paper [mm]
#: Between two bodies on paper [mm].
APART = 26.0
_LARGEST, _SMALLEST = 20.0, 5.0  # radii on paper [mm]


class BodyForce(NamedTuple):
    """One force on one body of the first branch, whose planet lies above the sun.

    Parameters
    ----------
    body : str
        ``planet``, ``right loading roller`` or ``left loading roller``.
    name : str
        The contact, or ``pin``.
    kind : str
        ``N`` normal, ``T`` tangential, ``F`` of a pin.
    place : tuple of float
        Where it acts: direction from the centre of the body to the contact; (0, 0) for a pin.
    direction : tuple of float
        Unit vector: to the right, upwards.
    size : float
        The force in this direction [N]; negative for the opposite one.
    """

    body: str
    name: str
    kind: str
    place: Point
    direction: Point
    size: float


def body_outlines(radii: dict[str, list[float]], *, size: float = 1.0) -> dict[str, list[float]]:
    """Radii of bodies on paper: the largest has a size that suits the arrows, and none is too small for them.

    [mm].
    """
    largest = max(radius for each in radii.values() for radius in each)
    return {
        name: [max(_SMALLEST, size * _LARGEST * radius / largest) for radius in each]
        for name, each in radii.items()
    }


def force_arrow(force: BodyForce, centre: Point, radius: float) -> tuple[Point, Point]:
    """Arrow of a force: normal forces end at the contact, tangential ones lie beside it, pins push from the axis.

    [mm].
    """
    x, y = centre[0] + radius * force.place[0], centre[1] + radius * force.place[1]
    step = math.copysign(_ARROW, force.size)
    e, f = step * force.direction[0], step * force.direction[1]
    if force.kind == "N":
        return (x - e, y - f), (x, y)
    if force.kind == "F":
        return (x, y), (x + e, y + f)
    x, y = x + 1.5 * force.place[0], y + 1.5 * force.place[1]
    return (x, y), (x + 0.8 * e, y + 0.8 * f)


def force_label(force: BodyForce) -> str:
    """Name and size of a force."""
    size = format_quantity(abs(force.size), "N")
    return {"N": f"{force.name}: N = {size}", "T": f"T = {size}", "F": f"pin: {size}"}[force.kind]
