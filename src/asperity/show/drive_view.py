"""The front view of a drive: outlines, axes, diameters and clearances."""

from __future__ import annotations

import math
from typing import NamedTuple

from asperity.drive.geometry import clearances
from asperity.joint.description import Joint
from asperity.show.dimension_lines import dimension, leader, made_bore, widths_below
from asperity.show.drive_drawing import Roller, rollers
from asperity.show.sheet import Circle, Item, Line, Point

#: Wall over inner radius of the ring from which on the drawing breaks it off.
LONGEST_WALL = 0.5
#: How much of a wall that is broken off is drawn, over the inner radius.
SHOWN_OF_BROKEN = 0.3
_WAVES = 24
#: How many clearances are drawn.
MOST_GAPS = 3
_LABEL_SPACING = 5.0  # between two labels [mm on paper]


class Gap(NamedTuple):
    """The free distance between two bodies.

    Parameters
    ----------
    letter : str
        Its letter in the drawing.
    words : str
        Between which bodies.
    size : float
        Free distance [mm]; negative where the bodies overlap.
    ends : tuple of tuple of float
        The points where the bodies are closest [mm].
    """

    letter: str
    words: str
    size: float
    ends: tuple[Point, Point]


class Ring(NamedTuple):
    """Radii of the ring as drawn.

    Parameters
    ----------
    inner, outer : float
        Its own radii [mm].
    shown : float
        Radius at which the drawing ends [mm]; less than ``outer`` where the wall is broken off.
    """

    inner: float
    outer: float
    shown: float

    @property
    def broken(self) -> bool:
        """Whether a part of the wall is left out."""
        return self.shown < self.outer


def ring_as_drawn(joint: Joint) -> Ring:
    """The ring, with a thick wall broken off.

    Parameters
    ----------
    joint : Joint
        One joint.

    Returns
    -------
    Ring
        Its radii [mm].
    """
    inner, wall = 1e3 * float(joint.geometry.ring_radius), 1e3 * float(joint.ring_wall_thickness)
    shown = wall if wall <= LONGEST_WALL * inner else SHOWN_OF_BROKEN * inner
    return Ring(inner, inner + wall, inner + shown)


def gaps(joint: Joint) -> list[Gap]:
    """The smallest free distances between rollers and ring, the smallest first.

    Parameters
    ----------
    joint : Joint
        One joint whose rollers touch as they should.

    Returns
    -------
    list of Gap
        At most :data:`MOST_GAPS`, each with the place where it is drawn: at the first planet or left of it.
    """
    size = {each.name: 1e3 * float(each.gap) for each in clearances(joint.geometry)}
    placed = _millimetres(rollers(joint.geometry))
    planet, _, left = placed[1:4]
    _, last_right, last_left = placed[-3:] if len(placed) == 4 else placed[4:7]  # left of the first planet
    ring = 1e3 * float(joint.geometry.ring_radius)
    found = [
        ("planet to ring", size["planet_to_ring"], ((0.0, planet.centre[1] + planet.radius), (0.0, ring))),
        ("rollers of one planet", size["rollers_of_planet"], _closest(last_right, last_left)),
    ]
    if len(placed) > 4:
        found += [
            ("neighbouring planets", size["planet_to_planet"], _closest(planet, placed[4])),
            ("rollers of two planets", size["rollers_of_neighbours"], _closest(left, last_right)),
            ("roller to next planet", size["roller_to_next_planet"], _closest(left, placed[4])),
        ]
    found.sort(key=lambda each: each[1])
    return [Gap(letter, *each) for letter, each in zip("ABC"[:MOST_GAPS], found, strict=False)]


def drive_view(
    joint: Joint,
    *,
    scale: float,
    labels_from: float,
    labels_above: float = -math.inf,
    interference: float | None = None,
) -> list[Item]:
    """Outlines, axes, diameters and clearances of a drive.

    Parameters
    ----------
    joint : Joint
        One joint.
    scale : float
        Length on paper over true length [-].
    labels_from : float
        Where the texts of the diameters begin, right of the sun [mm].
    labels_above : float, optional
        Above which they stand, over the sun [mm].
    interference : float or None, optional
        With which the ring is made [m]; None where it is not known.

    Returns
    -------
    list of Item
        The view, with the sun in the origin.

    Raises
    ------
    InputError
        As :func:`asperity.show.drive_drawing.rollers`.
    """
    placed, ring = _millimetres(rollers(joint.geometry)), ring_as_drawn(joint)
    items: list[Item] = [Circle(each.centre, each.radius) for each in placed]
    items.append(Circle((0.0, 0.0), ring.inner))
    items.append(break_line(ring.inner, ring.shown) if ring.broken else Circle((0.0, 0.0), ring.shown))
    pin = 0.5e3 * float(joint.bearings.pin_diameter)
    if pin > 0.0:
        items += [Circle(each.centre, pin) for each in placed if "loading" in each.body]
    items += _axes(placed, ring, scale)
    items += _ring_dimensions(ring, scale, interference)
    items += _diameters(placed, pin, scale, (labels_from, labels_above))
    return items + _gap_marks(gaps(joint), scale, -ring.shown - 4.0 / scale)


def _millimetres(found: list[Roller]) -> list[Roller]:
    return [Roller(b, (1e3 * x, 1e3 * y), 1e3 * r) for b, (x, y), r in found]


def _closest(one: Roller, other: Roller) -> tuple[Point, Point]:
    """The points of two circles on the line of their centres."""
    (x, y), (u, v) = one.centre, other.centre
    distance = math.dist(one.centre, other.centre)
    e, f = (u - x) / distance, (v - y) / distance
    return (x + one.radius * e, y + one.radius * f), (u - other.radius * e, v - other.radius * f)


def break_line(inner: float, shown: float) -> Line:
    """A wavy line around the part of a ring that is drawn.

    Parameters
    ----------
    inner, shown : float
        Inner radius, and radius at which the drawing ends [mm].

    Returns
    -------
    Line
        Closed.
    """
    count = 16 * _WAVES
    amplitude = 0.03 * (shown - inner)
    points = []
    for index in range(count + 1):
        angle = 2.0 * math.pi * index / count
        radius = shown + amplitude * math.sin(_WAVES * angle)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return Line(tuple(points), "break")


def _axes(placed: list[Roller], ring: Ring, scale: float) -> list[Item]:
    """Axes of the drive and of every roller, and the circles on which they lie."""
    beyond = 3.0 / scale
    reach = ring.shown + beyond
    items: list[Item] = [
        Line(((-reach, 0.0), (reach, 0.0)), "axis"),
        Line(((0.0, -reach), (0.0, reach)), "axis"),
        Circle((0.0, 0.0), math.hypot(*placed[1].centre), "axis"),
        Circle((0.0, 0.0), math.hypot(*placed[2].centre), "axis"),
    ]
    for each in placed[1:]:
        x, y = each.centre
        angle, half = math.atan2(y, x), min(each.radius + beyond, 1.25 * each.radius)
        e, f = half * math.cos(angle), half * math.sin(angle)
        items.append(Line(((x - e, y - f), (x + e, y + f)), "axis"))
        if "loading" in each.body:  # the circle of the axes crosses too flat at small rollers
            items.append(Line(((x + f, y - e), (x - f, y + e)), "axis"))
    return items


def _ring_dimensions(ring: Ring, scale: float, interference: float | None) -> list[Item]:
    """Diameters of the ring below the view: its bore as it is made."""
    widths = [(ring.inner, made_bore(ring.inner, interference))]
    if not ring.broken:
        widths.append((ring.outer, f"⌀{dimension(2.0 * ring.outer)}"))
    return [
        item for parts in widths_below(widths, -ring.shown, scale=scale) for part in parts for item in part
    ]


def _diameters(placed: list[Roller], pin: float, scale: float, corner: Point) -> list[Item]:
    """Leaders from circles near the first planet to a column of texts at the right, above and beside a corner."""
    labels_from, above = corner
    sun, planet, roller = placed[:3]
    count = (len(placed) - 1) // 3
    between = math.pi / 2.0 - math.pi / max(count, 2)  # the free direction right of the first planet
    targets = [
        (_on(roller.centre, roller.radius, 0.6), f"loading roller ⌀{dimension(2.0 * roller.radius)}"),
        (_on(planet.centre, planet.radius, 0.5), f"planet ⌀{dimension(2.0 * planet.radius)}"),
        (
            _on((0.0, 0.0), math.hypot(*roller.centre), math.atan2(roller.centre[1], roller.centre[0]) - 0.3),
            f"axes of loading rollers ⌀{dimension(2.0 * math.hypot(*roller.centre))}",
        ),
        (
            _on((0.0, 0.0), planet.centre[1], 0.5 * (math.pi / 2.0 + between)),
            f"axes of planets ⌀{dimension(2.0 * planet.centre[1])}",
        ),
        (_on((0.0, 0.0), sun.radius, between), f"sun ⌀{dimension(2.0 * sun.radius)}"),
    ]
    if pin > 0.0:
        targets.append((_on(roller.centre, pin, 0.3), f"pin ⌀{dimension(2.0 * pin)}"))
    targets.sort(key=lambda each: -each[0][1])
    spacing = _LABEL_SPACING / scale
    top = max(targets[0][0][1], 0.5 * spacing * len(targets), above + spacing * (len(targets) + 1))
    items: list[Item] = []
    for index, (target, text) in enumerate(targets):
        items += leader(target, (labels_from, top - index * spacing), text, scale=scale)
    return items


def _on(centre: Point, radius: float, angle: float) -> Point:
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)


def _gap_marks(found: list[Gap], scale: float, left: float) -> list[Item]:
    """A line across each gap, and a leader to its letter and size left of the view."""
    items: list[Item] = []
    middles = {gap: tuple(0.5 * (a + b) for a, b in zip(*gap.ends, strict=True)) for gap in found}
    spacing, below = _LABEL_SPACING / scale, math.inf
    for gap in sorted(found, key=lambda each: -middles[each][1]):
        x, y = middles[gap]
        below = min(below - spacing, y)
        items.append(Line(gap.ends, "break"))
        text = f"{gap.letter} {gap.size:.4g}"
        items += leader((x, y), (left, below), text, scale=scale, align="right", arrow=False)
    return items
