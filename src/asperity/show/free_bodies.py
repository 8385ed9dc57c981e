"""The bodies of one branch drawn apart, with the forces on each of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from asperity.drive.force_balance import DriveForces
from asperity.drive.geometry import CONTACT_NAMES, triangle
from asperity.joint.description import Joint
from asperity.show.sheet import TEXT_HEIGHT, Align, Circle, Item, Line, Point, Text
from asperity.show.sheet_figure import text_width
from asperity.units import format_quantity

_ARROW = 10.0  # length of an arrow on paper [mm]
#: Between two bodies on paper [mm].
APART = 26.0
_LARGEST, _SMALLEST = 20.0, 5.0  # radii on paper [mm]
_LEAST_APART = 16.0  # so that their arrows have room
_SMALLEST_VIEW = 0.3  # share of these sizes that a view keeps at least
_LINE_SPACING = 4.2
_CLEAR = 2.0  # beside texts


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


def free_bodies(joint: Joint, forces: DriveForces, *, centre: Point, scale: float, room: float) -> list[Item]:
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
    room : float
        Width on paper that the view may have at most [mm]: its bodies are drawn smaller where they need more.

    Returns
    -------
    list of Item
        The view.
    """
    found = [each for each in body_forces(joint, forces) if each.size != 0.0 or each.body == "planet"]
    planet, roller = (
        float(each) for each in (joint.geometry.planet_radius, joint.geometry.loading_roller_radius)
    )
    for size in (*np.arange(1.0, _SMALLEST_VIEW, -0.05), _SMALLEST_VIEW):
        items = _view(found, planet, roller, float(size))
        if 2.0 * _half_width(items) <= room:
            break

    def on_sheet(point: Point) -> Point:
        return centre[0] + point[0] / scale, centre[1] + point[1] / scale

    moved: list[Item] = []
    for item in items:
        if isinstance(item, Circle):
            moved.append(Circle(on_sheet(item.centre), item.radius / scale))
        elif isinstance(item, Line):
            moved.append(Line(tuple(map(on_sheet, item.points)), item.style, item.arrows))
        else:
            moved.append(Text(on_sheet(item.at), item.text, item.align))
    return moved


def _view(found: Sequence[BodyForce], planet: float, roller: float, size: float) -> list[Item]:
    """Bodies, arrows and numbers around the planet, on paper [mm]."""
    (shown,), (beside,) = body_outlines({"planet": [planet], "roller": [roller]}, size=size).values()
    radii = {"planet": shown}
    places = {"planet": (0.0, 0.0)}
    for each in found:
        if each.body == "planet" and each.name.startswith("pw") and each.kind == "N":
            name = f"{'right' if each.name == 'pwr' else 'left'} loading roller"
            radii[name] = beside
            apart = radii["planet"] + max(size * APART, _LEAST_APART) + radii[name]
            places[name] = (apart * each.place[0], apart * each.place[1])
    items: list[Item] = [Circle(places[body], radius) for body, radius in radii.items()]
    items.append(Text((0.0, -1.2), "planet", "center"))
    arrows: dict[str, list[Point]] = {body: [] for body in radii}
    for each in found:
        if each.size != 0.0:
            ends = force_arrow(each, places[each.body], radii[each.body])
            arrows[each.body] += ends
            items.append(Line(ends, "force", "end"))
    sun = [force_label(each) for each in found if each.name == "sp" and each.size != 0.0]
    items += [Text((6.0, -radii["planet"] - 6.0 - _LINE_SPACING * row), line) for row, line in enumerate(sun)]
    for body, (x, y) in places.items():
        if body == "planet":
            continue
        of_body = [each for each in found if each.body == body]
        below = [force_label(each) for each in of_body if each.name.startswith("pw")]
        above = [force_label(each) for each in of_body if not each.name.startswith("pw")]
        highest = max([y + radii[body], *(point[1] for point in arrows[body])])
        lowest = min([y - radii[body], *(point[1] for point in arrows[body])])
        half = 0.5 * max((text_width(line) for line in above), default=0.0)
        middle = math.copysign(max(abs(x), half + _CLEAR), x)
        contact = (1.0 - radii[body] / math.hypot(x, y)) * x
        outwards: Align = "left" if x > 0.0 else "right"
        blocks: tuple[tuple[list[str], float, Align, float], ...] = (
            (above, middle, "center", highest + _CLEAR + _LINE_SPACING * (len(above) - 1)),
            (below, contact + math.copysign(_CLEAR, x), outwards, lowest - _CLEAR - TEXT_HEIGHT),
        )
        for lines, at, align, top in blocks:
            items += [Text((at, top - _LINE_SPACING * row), line, align) for row, line in enumerate(lines)]
    return items


def _half_width(items: Sequence[Item]) -> float:
    """How far a view reaches to either side of its middle [mm]."""
    reach = 0.0
    for item in items:
        if isinstance(item, Circle):
            ends = [abs(item.centre[0]) + item.radius]
        elif isinstance(item, Line):
            ends = [abs(x) for x, _ in item.points]
        else:
            width = text_width(item.text)
            ends = [abs(item.at[0]) + (0.5 * width if item.align == "center" else width)]
        reach = max(reach, *ends)
    return reach


def body_outlines(radii: dict[str, list[float]], *, size: float = 1.0) -> dict[str, list[float]]:
    """Radii of bodies on paper: the largest has a size that suits the arrows, and none is too small for them.

    Parameters
    ----------
    radii : dict
        Body → radii of its tracks [m].
    size : float, optional
        Size of the view over its usual one [-].

    Returns
    -------
    dict
        Body → radii on paper [mm].
    """
    largest = max(radius for each in radii.values() for radius in each)
    return {
        name: [max(_SMALLEST, size * _LARGEST * radius / largest) for radius in each]
        for name, each in radii.items()
    }


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


def _reversed(vector: Point) -> Point:
    return -vector[0], -vector[1]
