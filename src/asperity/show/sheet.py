"""A drawing as data: lines, circles and texts in mm, which a figure and a DXF file show alike."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Point = tuple[float, float]
Style = Literal["outline", "thin", "axis", "break", "force", "frame"]
Align = Literal["left", "center", "right"]

#: Line width of each style on paper [mm], after ISO 128: wide outlines, narrow everything else.
LINE_WIDTHS: dict[Style, float] = {
    "outline": 0.5,
    "thin": 0.18,
    "axis": 0.18,
    "break": 0.25,
    "force": 0.35,
    "frame": 0.5,
}
#: Length of an arrowhead on paper [mm].
ARROW_LENGTH = 2.5
#: Height of capital letters on paper, normal and large [mm].
TEXT_HEIGHT, TITLE_HEIGHT = 2.5, 3.5


@dataclass(frozen=True)
class Circle:
    """A circle by its centre and radius [mm] and its kind of line."""

    centre: Point
    radius: float
    style: Style = "outline"


@dataclass(frozen=True)
class Line:
    """A line of a kind through points [mm], with arrowheads at ``"start"``, ``"end"``, ``"both"`` or nowhere."""

    points: tuple[Point, ...]
    style: Style = "thin"
    arrows: Literal["", "start", "end", "both"] = ""


@dataclass(frozen=True)
class Text:
    """One line of text, whose base line begins, is centred or ends ``at`` a point [mm].

    ``height`` of its capital letters on paper [mm].
    """

    at: Point
    text: str
    align: Align = "left"
    height: float = TEXT_HEIGHT


Item = Circle | Line | Text


@dataclass(frozen=True)
class Dimension:
    """What items say together: the distance of two points [mm], on a circle opposite each other if it is a diameter.

    ``items`` are among those of the sheet; the last one is the text.
    """

    ends: tuple[Point, Point]
    items: tuple[Item, ...]
    diameter: bool = False


@dataclass(frozen=True)
class Sheet:
    """A sheet of paper of a size [mm] with a drawing on it.

    ``scale`` is length on paper over true length [-]; ``origin``, where the origin of the drawing lies on the paper,
    from its lower left corner [mm]. Coordinates and radii of the items are true sizes [mm]; widths of lines, arrowheads
    and heights of texts are sizes on paper. ``areas`` of the views with their dimensions, of the notes and of the title
    block, on paper: left, right, lower and upper edge from its lower left corner [mm].
    """

    width: float
    height: float
    scale: float
    origin: Point
    items: tuple[Item, ...]
    dimensions: tuple[Dimension, ...] = ()
    areas: tuple[tuple[float, float, float, float], ...] = ()

    @property
    def window(self) -> tuple[float, float, float, float]:
        """Left, right, lower and upper edge of the paper in true size [mm]."""
        left, low = (-coordinate / self.scale for coordinate in self.origin)
        return left, left + self.width / self.scale, low, low + self.height / self.scale

    @property
    def texts(self) -> tuple[str, ...]:
        """All texts, in the order of the items."""
        return tuple(item.text for item in self.items if isinstance(item, Text))


def scale_text(scale: float) -> str:
    """A scale as drawings state it."""
    return f"{scale:.12g}:1" if scale >= 1.0 else f"1:{1.0 / scale:.12g}"
