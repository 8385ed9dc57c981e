"""Paper: the formats of ISO 5457, the scales of ISO 5455, and points of a sheet in true size."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from asperity.show.box import Box, around_all, box_of
from asperity.show.sheet import Item, Point
from asperity.show.title_block import BLOCK_HEIGHT, BLOCK_WIDTH, MARGIN, Title, frame, title_block


class Format(NamedTuple):
    """A format of paper: its name, width and height [mm]."""

    name: str
    width: float
    height: float


#: Formats of ISO 5457, trimmed, from the smallest on.
FORMATS = (
    Format("A4 upright", 210.0, 297.0),
    Format("A4", 297.0, 210.0),
    Format("A3", 420.0, 297.0),
    Format("A2", 594.0, 420.0),
    Format("A1", 841.0, 594.0),
    Format("A0", 1189.0, 841.0),
)
#: Scales of ISO 5455, length on paper over true length, the largest first: 50:1 to 1:10000.
SCALES = (
    50.0,
    20.0,
    10.0,
    5.0,
    2.0,
    1.0,
    *(1.0 / (step * 10.0**power) for power in range(4) for step in (2, 5, 10)),
)


class Paper(NamedTuple):
    """Size of a sheet, origin of the drawing, from its lower left corner, width of its title block [mm], and scale."""

    width: float
    height: float
    middle: Point
    scale: float
    title_width: float = BLOCK_WIDTH

    def at(self, x: float, y: float) -> Point:
        """A point of the paper in true size [mm]."""
        return (x - self.middle[0]) / self.scale, (y - self.middle[1]) / self.scale

    def box(self, on_paper: Box) -> Box:
        """A part of the paper in true size [mm]."""
        (x, y), (u, v) = self.at(on_paper.left, on_paper.low), self.at(on_paper.right, on_paper.high)
        return Box(x, u, y, v)

    def boxed(self, items: Iterable[Item]) -> Box:
        """The box around items, on paper [mm]."""
        left, right, low, high = around_all(box_of(item, self.scale) for item in items)
        (x, y), scale = self.middle, self.scale
        return Box(x + scale * left, x + scale * right, y + scale * low, y + scale * high)

    @property
    def title_box(self) -> Box:
        """Where the title block stands, on paper [mm]."""
        right = self.width - MARGIN
        return Box(right - self.title_width, right, MARGIN, MARGIN + BLOCK_HEIGHT)

    def block(self, kind: str, name: str, title: Title) -> list[Item]:
        """Frame and title block."""
        block = title_block(
            self.at, self.title_box.left, self.width, self.scale, kind=kind, name=name, title=title
        )
        return [*block, frame(self.at, self.width, self.height)]


def extended_scale(size: float, *, room: float) -> float:
    """The largest of the scales at which a size [mm] fits in a room [mm], also beyond 50:1 and 1:10000."""
    steps = [step * 10.0**power for power in range(-12, 13) for step in (1, 2, 5)]
    return max(step for step in steps if step * size <= room * (1.0 + 1e-9))
