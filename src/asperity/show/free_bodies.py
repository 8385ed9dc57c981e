"""The bodies of one branch drawn apart, with the forces on each of them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES, triangle
from asperity.joint.description import Joint
from asperity.show.sheet import Align, Circle, Item, Line, Point, Text
from asperity.units import format_quantity

_ARROW = 10.0  # length of an arrow on paper [mm]
#: Between two bodies on paper [mm].
APART = 26.0
_LARGEST, _SMALLEST = 20.0, 5.0  # radii on paper [mm]
_LINE_SPACING = 4.2


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


def body_forces(joint: Joint, forces: DriveForces) -> list[BodyForce]:
    """Forces on planet and loading rollers of the first branch, without the centrifugal ones.

    Parameters
    ----------
    joint : Joint
        One joint.
    forces : DriveForces
        Its forces.

    Returns
    -------
    list of BodyForce
        Two for each contact and body, one for each pin.

    References
    ----------
    Zou et al. 2025, equations (2)–(4), with the signs of :func:`asperity.drive.equilibrium.balance_equations`.
    """
    geometry, sides = joint.geometry, triangle(joint.geometry)
    polar = math.atan2(float(sides.sin_polar), float(sides.cos_polar))
    direction = math.atan2(float(sides.sin_direction), float(sides.cos_direction))
    normal = dict(zip(CONTACT_NAMES, np.asarray(forces.normal, dtype=float), strict=True))
    tangential = dict(zip(CONTACT_NAMES, np.asarray(forces.tangential, dtype=float), strict=True))
    found: list[BodyForce] = []

    def contact(body: str, name: str, place: Point, along: Point) -> None:
        found.append(BodyForce(body, name, "N", place, _reversed(place), float(normal[name])))
        found.append(BodyForce(body, name, "T", place, along, float(tangential[name])))

    contact("planet", "sp", (0.0, -1.0), (1.0, 0.0))
    for side, letter, push, angle in (
        (1.0, "r", forces.pin_right, geometry.right_push_angle),
        (-1.0, "l", forces.pin_left, geometry.left_push_angle),
    ):
        roller = f"{'right' if side > 0.0 else 'left'} loading roller"
        outward = (side * math.sin(direction), math.cos(direction))
        radial = (side * math.sin(polar), math.cos(polar))
        inward_wedge = (-side * math.cos(polar), math.sin(polar))  # towards the planet, around the sun
        along = (math.cos(direction), -side * math.sin(direction))
        contact("planet", f"pw{letter}", outward, along)
        contact(roller, f"pw{letter}", _reversed(outward), _reversed(along))
        contact(roller, f"w{letter}o", radial, (side * inward_wedge[0], side * inward_wedge[1]))
        cosine, sine = math.cos(float(angle)), math.sin(float(angle))
        pushed = (
            cosine * inward_wedge[0] + sine * radial[0],
            cosine * inward_wedge[1] + sine * radial[1],
        )
        found.append(BodyForce(roller, "pin", "F", (0.0, 0.0), pushed, float(push)))
    return found


def free_bodies(joint: Joint, forces: DriveForces, *, centre: Point, scale: float) -> list[Item]:
    """Planet and loading rollers of one branch drawn apart: arrows for directions, numbers for sizes.

    Parameters
    ----------
    joint : Joint
        One joint.
    forces : DriveForces
        Its forces.
    centre : tuple of float
        Centre of the planet [mm in true size].
    scale : float
        Length on paper over true length [-]. On paper the view has a size of its own.

    Returns
    -------
    list of Item
        The view.
    """
    found = body_forces(joint, forces)
    planet, roller = (
        float(each) for each in (joint.geometry.planet_radius, joint.geometry.loading_roller_radius)
    )
    (shown,), (beside,) = body_outlines({"planet": [planet], "roller": [roller]}).values()
    radii = {"planet": shown}
    places = {"planet": (0.0, 0.0)}
    for each in found:
        if each.body == "planet" and each.name.startswith("pw") and each.kind == "N":
            name = f"{'right' if each.name == 'pwr' else 'left'} loading roller"
            radii[name] = beside
            apart = radii["planet"] + APART + radii[name]
            places[name] = (apart * each.place[0], apart * each.place[1])

    def on_sheet(x: float, y: float) -> Point:
        return centre[0] + x / scale, centre[1] + y / scale

    items: list[Item] = [Circle(on_sheet(*places[body]), radius / scale) for body, radius in radii.items()]
    items.append(Text(on_sheet(0.0, -1.2), "planet", "center"))
    for each in found:
        if each.size == 0.0:
            continue
        tail, tip = force_arrow(each, places[each.body], radii[each.body])
        items.append(Line((on_sheet(*tail), on_sheet(*tip)), "force", "end"))
    for each in found:
        if each.body == "planet" or not each.name.startswith("pw"):
            at, align = _label_place(each, places[each.body], radii[each.body])
            items.append(Text(on_sheet(*at), force_label(each), align))
    return items


def body_outlines(radii: dict[str, list[float]]) -> dict[str, list[float]]:
    """Radii of bodies on paper: the largest has a size that suits the arrows, and none is too small for them.

    Parameters
    ----------
    radii : dict
        Body → radii of its tracks [m].

    Returns
    -------
    dict
        Body → radii on paper [mm].
    """
    size = _LARGEST / max(radius for each in radii.values() for radius in each)
    return {name: [max(_SMALLEST, size * radius) for radius in each] for name, each in radii.items()}


def force_arrow(force: BodyForce, centre: Point, radius: float) -> tuple[Point, Point]:
    """Arrow of a force: normal forces end at the contact, tangential ones lie beside it, pins push from the axis.

    Parameters
    ----------
    force : BodyForce
        The force.
    centre : tuple of float
        Centre of the body on paper [mm].
    radius : float
        Radius of the body at the contact on paper [mm].

    Returns
    -------
    tuple of tuple of float
        Tail and tip on paper [mm].
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
    """Name and size of a force.

    Parameters
    ----------
    force : BodyForce
        The force.

    Returns
    -------
    str
        One line.
    """
    size = format_quantity(abs(force.size), "N")
    return {"N": f"{force.name}: N = {size}", "T": f"T = {size}", "F": f"pin: {size}"}[force.kind]


def _label_place(force: BodyForce, centre: Point, radius: float) -> tuple[Point, Align]:
    """Beside the contact, away from the middle of the view."""
    if force.name == "sp":
        side, x, y = 1.0, 6.0, -radius - 6.0
    else:
        side = -1.0 if (force.place[0] or centre[0]) < 0.0 else 1.0
        x, y = centre[0] + radius * force.place[0], centre[1] + radius * force.place[1]
        if force.kind == "F":
            x, y = x + side * (radius + 3.0), y - 1.2
        elif force.name.startswith("pw"):
            x, y = x + side * 12.0, y + 7.0
        else:
            x, y = x + side * 10.0, y + 9.0
    if force.kind == "T":
        y -= _LINE_SPACING
    return (x, y), "left" if side > 0.0 else "right"


def _reversed(vector: Point) -> Point:
    return -vector[0], -vector[1]
