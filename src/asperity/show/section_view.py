"""Sections of a drive and of its parts along the axis: what is long, and where the tracks of a body are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from asperity.joint.description import Joint, contact_values, places, track_lengths, tracks_of
from asperity.show.dimension_lines import toleranced, width_below
from asperity.show.drive_view import housing_of, rings_of
from asperity.show.sheet import Dimension, Item, Line, Point
from asperity.show.sheet_figure import text_width

_BETWEEN = 2.0  # planes whose distance nobody states [mm on paper]
_HATCHING = 2.5  # between two lines [mm on paper]
_LONGEST_NAMES = 32.0  # of the contacts at a length [mm on paper]


class Block(NamedTuple):
    """A part of a section between two distances from the axis, and two places along it [mm].

    ``hatched``: 1 upwards to the right, -1 downwards, as of the part beside it, 0 for a part that is not cut;
    ``broken``: 1 if its upper end is broken off, -1 if its lower end is.
    """

    low: float
    high: float
    left: float
    right: float
    hatched: int = 0
    broken: int = 0

    @property
    def mirrored(self) -> Block:
        """The same on the other side of the axis."""
        return self._replace(low=-self.high, high=-self.low, broken=-self.broken)


class Length(NamedTuple):
    """A length along the axis: from where to where [mm], and what the drawing says of it."""

    left: float
    right: float
    words: str


class Section(NamedTuple):
    """A section: blocks, edges that are seen beyond them, centre lines by their heights [mm], lengths."""

    blocks: tuple[Block, ...]
    edges: tuple[tuple[Point, Point], ...]
    axes: tuple[float, ...]
    lengths: tuple[Length, ...]

    @property
    def width(self) -> float:
        """Along the axis [mm]."""
        return max(block.right for block in self.blocks) - min(block.left for block in self.blocks)

    @property
    def height(self) -> float:
        """Above the axis [mm]."""
        return max(block.high for block in self.blocks)

    @property
    def depth(self) -> float:
        """Below the axis [mm]."""
        return -min(block.low for block in self.blocks)


def planes(joint: Joint) -> list[list[int]]:
    """Numbers of the contacts that lie in one plane across the axis, since they share a track with each other."""
    groups: list[set[int]] = [{number} for number in range(len(joint.drive.contacts))]
    for body in range(len(joint.drive.bodies)):
        for _, contacts in tracks_of(joint, body):
            shared = [group for group in groups if group & set(contacts)]
            groups = [group for group in groups if not group & set(contacts)]
            groups.append(set().union(*shared))
    return sorted(sorted(group) for group in groups)


def heights(joint: Joint) -> dict[int, float]:
    """Distances of the centres from the axis in a section that follows the contacts: number of a body → [mm].

    Of a ring, that of the centre of its track; the section is developed into one plane, so that all contacts touch.
    """
    first, second = places(joint.drive)
    rings = {ring.body for ring in rings_of(joint)}
    start = next(number for number in range(len(joint.drive.bodies)) if number not in rings)
    orbit = 1e3 * float(np.hypot(*np.asarray(joint.drive.centres)[start]))
    placed = {start: orbit}
    for _ in joint.drive.contacts:
        for number, contact in enumerate(joint.drive.contacts):
            inner, outer = first[number], second[number]
            one, other = (
                1e3 * float(radii[number]) for radii in (joint.drive.first_radius, joint.drive.second_radius)
            )
            step = one - other if contact.internal else one + other
            if inner in placed:
                placed.setdefault(outer, placed[inner] + step)
            elif outer in placed:
                placed[inner] = placed[outer] - step if contact.internal else placed[outer] + step
    return placed


def drive_section(joint: Joint, scale: float, tolerances: Sequence[float] | None = None) -> Section:
    """A section of a drive, developed along its contacts; ``tolerances`` of the contact lengths [m].

    Above the axis and below it alike, unless the bodies are held in a frame: the section follows two sectors.
    """
    lengths = 1e3 * np.asarray(contact_values(joint, joint.contact_lengths))
    tolerances = tolerances or [0.0] * len(lengths)
    middles: dict[int, float] = {}
    stated: list[Length] = []
    right = 0.0
    for contacts in planes(joint):
        bodies = {body for side in places(joint.drive) for body in (side[number] for number in contacts)}
        wide = max(long for body in bodies for _, on, long in _tracks(joint, body) if set(on) & set(contacts))
        middle = right + 0.5 * wide
        middles |= dict.fromkeys(contacts, middle)
        for length, tolerance in dict.fromkeys((lengths[n], tolerances[n]) for n in contacts):
            alike = [n for n in contacts if (lengths[n], tolerances[n]) == (length, tolerance)]
            names = ", ".join(joint.contact_names[n] for n in alike)
            names = names if text_width(names) <= _LONGEST_NAMES else f"{len(alike)} contacts"
            words = f"{names}: {toleranced(length, 1e3 * tolerance)}"
            stated.append(Length(middle - 0.5 * length, middle + 0.5 * length, words))
        right += wide + _BETWEEN / scale
    return _section(joint, heights(joint), middles, stated)


def body_section(joint: Joint, body: int, scale: float, tolerance: float = 0.0) -> Section:
    """The section of one body about its own axis; ``tolerance`` of its length [m]."""
    middles: dict[int, float] = {}
    stated: list[Length] = []
    right = 0.0
    for _, contacts, wide in _tracks(joint, body):
        middles |= dict.fromkeys(contacts, right + 0.5 * wide)
        stated.append(Length(right, right + wide, toleranced(wide, 1e3 * tolerance)))
        right += wide + _BETWEEN / scale
    return _section(joint, {body: 0.0}, middles, stated)


def _tracks(joint: Joint, body: int) -> list[tuple[float, list[int], float]]:
    """Radius [mm], contacts and length [mm] of each track of a body."""
    return [
        (1e3 * float(radius), contacts, 1e3 * float(length))
        for (radius, contacts), length in zip(tracks_of(joint, body), track_lengths(joint, body), strict=True)
    ]


def _section(
    joint: Joint, centres: dict[int, float], middles: dict[int, float], stated: list[Length]
) -> Section:
    """The section of bodies with their centres at heights [mm] and their contacts at places along the axis [mm]."""
    rings = {ring.body for ring in rings_of(joint)}
    alone, both_sides = len(centres) == 1, not joint.drive.layout.in_frame
    blocks: list[Block] = []
    axes = [0.0]
    for body, centre in centres.items():
        if body in rings:
            mine = _ring_blocks(joint, body, centre, middles, alone=alone)
        else:
            mine = _roller_blocks(joint, body, centre, middles)
            axes.append(centre)
        if both_sides and (body in rings or centre > 0.0):
            mine += [block.mirrored for block in mine]
            axes += [] if body in rings else [-centre]
        blocks += mine
    edges = [
        edge
        for body in rings & set(centres)
        for high, contacts, long in _tracks(joint, body)
        for edge in _seen_beyond(centres[body] + high, middles[contacts[0]], long, blocks)
    ]
    return Section(
        tuple(dict.fromkeys(blocks)), tuple(dict.fromkeys(edges)), tuple(dict.fromkeys(axes)), tuple(stated)
    )


def _ring_blocks(
    joint: Joint, body: int, centre: float, middles: dict[int, float], *, alone: bool
) -> list[Block]:
    """The wall of a ring, whole if it is drawn ``alone``, otherwise with the housing that holds it."""
    ring = next(ring for ring in rings_of(joint) if ring.body == body)
    housing = None if alone else housing_of(joint, ring)
    blocks = []
    for high, contacts, long in _tracks(joint, body):
        left, right = middles[contacts[0]] - 0.5 * long, middles[contacts[0]] + 0.5 * long
        low, wall = centre + high, (ring.outer if alone else ring.shown) - ring.inner
        blocks.append(Block(low, low + wall, left, right, 1, int(not alone and ring.shown < ring.outer)))
        if housing is not None:
            blocks.append(Block(low + wall, low + wall + housing - ring.outer, left, right, -1))
    return blocks


def _roller_blocks(joint: Joint, body: int, centre: float, middles: dict[int, float]) -> list[Block]:
    """A roller: its tracks and what joins them; a hollow one is cut, a solid one is not."""
    tracks = []
    for radius, contacts, long in _tracks(joint, body):
        middle = middles[contacts[0]]
        tracks.append((radius, middle - 0.5 * long, middle + 0.5 * long))
    spans = list(tracks)
    for (radius, _, end), (other, begin, _) in pairwise(tracks):
        spans.append((min(radius, other), end, begin))
    bore = joint.shapes[body].bore_diameter
    if bore is None:
        return [Block(centre - radius, centre + radius, left, right) for radius, left, right in spans]
    half = 0.5e3 * float(bore)
    walls = [Block(half, radius, left, right, -1) for radius, left, right in spans]
    inside = Block(-half, half, min(left for _, left, _ in spans), max(right for *_, right in spans))
    return [
        block._replace(low=centre + block.low, high=centre + block.high)
        for block in (*walls, *(wall.mirrored for wall in walls), inside)
    ]


def _seen_beyond(
    inner: float, middle: float, long: float, blocks: Sequence[Block]
) -> list[tuple[Point, Point]]:
    """The edges of a bore behind the section, from one side of the ring to the other, where no part hides them."""
    edges: list[tuple[Point, Point]] = []
    for x in (middle - 0.5 * long, middle + 0.5 * long):
        height = -inner
        hiding = sorted((b.low, b.high) for b in blocks if b.left - 1e-9 <= x <= b.right + 1e-9)
        for low, high in (*hiding, (inner, inner)):
            if height + 1e-9 < low <= inner + 1e-9:
                edges.append(((x, height), (x, low)))
            height = max(height, high)
    return edges


def draw_section(
    section: Section, x: float, *, low: float, scale: float
) -> tuple[list[Item], list[Dimension]]:
    """Lines of a section that begins at a place along the axis [mm], its lengths below a height [mm]."""
    items: list[Item] = []
    left = x - min(block.left for block in section.blocks)
    for block in section.blocks:
        a, b = left + block.left, left + block.right
        corners = [(a, block.high), (a, block.low), (b, block.low), (b, block.high), (a, block.high)]
        if block.broken < 0:
            corners = [(a, block.low), (a, block.high), (b, block.high), (b, block.low)]
        items.append(Line(tuple(corners[:4] if block.broken else corners), "outline"))
        if block.broken:
            end, up = block.high if block.broken > 0 else block.low, 0.5 / scale
            waves = [(a + n * 0.125 * (b - a), end + up * (0, 1, 0, -1)[n % 4]) for n in range(9)]
            items.append(Line(tuple(waves), "break"))
        if block.hatched:
            items += _hatching(block._replace(left=a, right=b), _HATCHING / scale)
    items += [Line(((left + x, y), (left + u, v)), "outline") for (x, y), (u, v) in section.edges]
    beyond = 3.0 / scale
    items += [Line(((x - beyond, y), (x + section.width + beyond, y)), "axis") for y in section.axes]
    dimensions = []
    for row, length in enumerate(sorted(section.lengths, key=lambda length: -length.right), start=1):
        ends = left + length.left, left + length.right
        within = [
            b for b in section.blocks if b.left <= length.left + 1e-9 and length.right <= b.right + 1e-9
        ]
        begin = min((block.low for block in within), default=0.0)
        dimensions.append(
            width_below(ends, length.words, begin=begin, low=low, row=row, scale=scale, beside=True)
        )
    return items, dimensions


def _hatching(block: Block, step: float) -> list[Item]:
    """Lines at 45 degrees across a part that is cut [mm]."""
    left, right, low, high, rise = block.left, block.right, block.low, block.high, block.hatched
    lines: list[Item] = []
    count = math.floor((right - left + high - low) / (math.sqrt(2.0) * step))
    for index in range(count + 1):
        offset = (
            (index + 0.5) * math.sqrt(2.0) * step
        )  # of the line from the corner that it begins at, along the edge
        begin = (left, low + offset) if offset < high - low else (left + offset - high + low, high)
        end = (left + offset, low) if offset < right - left else (right, low + offset - right + left)
        if begin[0] < right and end[1] < high:
            both = [(x, low + high - y if rise > 0 else y) for x, y in (begin, end)]
            lines.append(Line((both[0], both[1]), "thin"))
    return lines
