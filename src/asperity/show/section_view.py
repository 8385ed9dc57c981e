"""Sections of a drive and of its parts along the axis: what is long, and where the tracks of a body are."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from asperity.joint.description import Joint, contact_values, places, track_lengths, tracks_of
from asperity.show.dimension_lines import toleranced, width_below
from asperity.show.drive_view import rings_of
from asperity.show.sheet import Dimension, Item, Line
from asperity.show.sheet_figure import text_width

_BETWEEN = 2.0  # planes whose distance nobody states [mm on paper]
_HATCHING = 2.5  # between two lines [mm on paper]
_LONGEST_NAMES = 32.0  # of the contacts at a length [mm on paper]


class Block(NamedTuple):
    """A part of a section between two distances from the axis, and two places along it [mm].

    ``broken``: whether its upper end is broken off.
    """

    low: float
    high: float
    left: float
    right: float
    hatched: bool = False
    broken: bool = False


class Length(NamedTuple):
    """A length along the axis: from where to where [mm], and what the drawing says of it."""

    left: float
    right: float
    words: str


class Section(NamedTuple):
    """A section: blocks, lines at places that are seen beyond (bores), centre lines by their heights [mm], lengths."""

    blocks: tuple[Block, ...]
    edges: tuple[tuple[float, float, float], ...]
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
    """Half a section of a drive, developed along its contacts; ``tolerances`` of the contact lengths [m]."""
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
    rings = {ring.body: ring for ring in rings_of(joint)}
    blocks: list[Block] = []
    edges: list[tuple[float, float, float]] = []
    for body, centre in centres.items():
        mine: list[Block] = []
        for high, contacts, long in _tracks(joint, body):
            half, middle = 0.5 * long, middles[contacts[0]]
            if body in rings:
                shown = rings[body].shown if len(centres) > 1 else rings[body].outer
                walls = [(centre + high, centre + shown + high - rings[body].inner)]
                if len(centres) == 1:
                    walls += [(-up, -low) for low, up in walls]
                    blocks.append(Block(-high, high, middle - half, middle + half))
            else:
                walls = [(max(centre - high, 0.0) if len(centres) > 1 else centre - high, centre + high)]
            broken = body in rings and len(centres) > 1 and rings[body].shown < rings[body].outer
            mine += [Block(low, up, middle - half, middle + half, body in rings, broken) for low, up in walls]
        if body not in rings:
            for one, other in pairwise(mine):  # what joins two tracks
                low, up = max(one.low, other.low), min(one.high, other.high)
                blocks.append(Block(low, up, one.right, other.left))
            bore = joint.shapes[body].bore_diameter
            if bore is not None:
                left, right = min(block.left for block in mine), max(block.right for block in mine)
                edges += [(centre + side * 0.5e3 * float(bore), left, right) for side in (-1.0, 1.0)]
        blocks += mine
    unique = dict.fromkeys(blocks)
    axes = dict.fromkeys(centre for body, centre in centres.items() if body not in rings)
    return Section(tuple(unique), tuple(dict.fromkeys(edges)), (*dict.fromkeys((0.0, *axes)),), tuple(stated))


def draw_section(
    section: Section, x: float, *, low: float, scale: float
) -> tuple[list[Item], list[Dimension]]:
    """Lines of a section that begins at a place along the axis [mm], its lengths below a height [mm]."""
    items: list[Item] = []
    left = x - min(block.left for block in section.blocks)
    for block in section.blocks:
        a, b = left + block.left, left + block.right
        corners = ((a, block.high), (a, block.low), (b, block.low), (b, block.high), (a, block.high))
        items.append(Line(corners[: 4 if block.broken else 5], "outline"))
        if block.broken:
            c, up = 0.125 * (b - a), 0.5 / scale
            waves = [(a + n * c, block.high + up * (0, 1, 0, -1)[n % 4]) for n in range(9)]
            items.append(Line(tuple(waves), "break"))
        if block.hatched:
            items += _hatching(a, b, block.low, block.high, _HATCHING / scale)
    items += [Line(((left + a, y), (left + b, y)), "outline") for y, a, b in section.edges]
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


def _hatching(left: float, right: float, low: float, high: float, step: float) -> list[Item]:
    """Lines at 45 degrees across a rectangle [mm]."""
    lines: list[Item] = []
    count = math.floor((right - left + high - low) / (math.sqrt(2.0) * step))
    for index in range(count + 1):
        offset = (index + 0.5) * math.sqrt(2.0) * step  # of x + low - y from the lower left corner, upwards
        begin = (left, low + offset) if offset < high - low else (left + offset - high + low, high)
        end = (left + offset, low) if offset < right - left else (right, low + offset - right + left)
        if begin[0] < right and end[1] < high:
            lines.append(Line((begin, end), "thin"))
    return lines
