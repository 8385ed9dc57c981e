"""The front view of a drive: outlines, axes, diameters and clearances."""

from __future__ import annotations

import math

from asperity.show.sheet import Line

#: Wall over inner radius of the ring from which on the drawing breaks it off.
LONGEST_WALL = 0.5
#: How much of a wall that is broken off is drawn, over the inner radius.
SHOWN_OF_BROKEN = 0.3
_WAVES = 24
#: How many clearances are drawn.
MOST_GAPS = 3


def break_line(inner: float, shown: float) -> Line:
    """A wavy line around the part of a ring that is drawn."""
    count = 16 * _WAVES
    amplitude = 0.03 * (shown - inner)
    points = []
    for index in range(count + 1):
        angle = 2.0 * math.pi * index / count
        radius = shown + amplitude * math.sin(_WAVES * angle)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return Line(tuple(points), "break")
