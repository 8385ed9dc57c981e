"""Frame and title block of a drawing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

import asperity
from asperity.errors import InputError, printable, quoted
from asperity.show.sheet import TEXT_HEIGHT, TITLE_HEIGHT, Circle, Item, Line, Point, Text, scale_text
from asperity.show.sheet_figure import text_width

#: From the edge of the paper to the frame of a drawing, and width and height of the title block [mm].
MARGIN, BLOCK_WIDTH, BLOCK_HEIGHT = 10.0, 95.0, 38.0
#: Width of the title block of ISO 7200, on sheets with room for it [mm].
WIDE_BLOCK = 180.0
_ROW = 8.0  # height of a row of cells [mm]
_LABEL_HEIGHT = 1.8


class Title(NamedTuple):
    """What somebody states about a drawing; empty where nobody does, which the block shows as a dash."""

    project: str = ""
    part: str = ""
    revision: str = ""
    date: str = ""
    material: str = ""
    sheet: str = "1 of 1"


_STATED = ("project", "part", "revision", "date")
_LONGEST = 60


def stated_title(stated: Mapping[str, str], *, option: str = "") -> Title:
    """A title block from its texts by name, or a refusal, which has ``option`` before the name."""
    for name, text in stated.items():
        if name not in _STATED:
            raise InputError(f"a title block has no '{name}'; it has {', '.join(_STATED)}")
        if not isinstance(text, str) or len(text) > _LONGEST:
            size = f"{len(text)}" if isinstance(text, str) else quoted(text)
            raise InputError(f"{option}{name}: at most {_LONGEST} characters, got {size}")
    return Title(**stated)


def frame(on_paper: Callable[[float, float], Point], width: float, height: float) -> Item:
    """The frame of a sheet of paper."""
    right, top = width - MARGIN, height - MARGIN
    corners = ((MARGIN, MARGIN), (right, MARGIN), (right, top), (MARGIN, top), (MARGIN, MARGIN))
    return Line(tuple(on_paper(*corner) for corner in corners), "frame")


def fitted(text: str, width: float, height: float = TEXT_HEIGHT) -> str:
    """A text on one line, its beginning left out where it is too wide [mm]."""
    shown = printable(text).replace("\n", " ").strip() or "–"
    cut = shown
    while text_width(cut, height) > width:
        shown = shown[max(1, len(shown) // 20) :]
        cut = f"…{shown}"
    return cut


def title_block(
    on_paper: Callable[[float, float], Point],
    left: float,
    width: float,
    scale: float,
    *,
    kind: str,
    name: str,
    title: Title,
) -> list[Item]:
    """What a drawing is called and by which numbers it goes, its scale, unit and projection: in the lower right corner.

    From an edge [mm] to the frame of a paper so wide [mm]. The symbol is that of first-angle projection (ISO 5456-2).
    """
    right, top = width - MARGIN, MARGIN + BLOCK_HEIGHT
    across = right - left

    def line(*points: Point) -> Line:
        return Line(tuple(on_paper(*point) for point in points), "frame")

    items: list[Item] = [
        line((left, MARGIN), (left, top), (right, top)),
        Text(on_paper(left + 2.0, top - 5.5), fitted(kind, across - 4.0, TITLE_HEIGHT), height=TITLE_HEIGHT),
        Text(
            on_paper(left + 2.0, top - 11.5),
            fitted(f"{name}   asperity {asperity.__version__}", across - 4.0),
        ),
    ]
    rows: list[list[tuple[str, str, float]]] = [
        [("Project", title.project, 0.62), ("Part", title.part, 0.38)],
        [("Material", title.material, 0.4), ("Revision", title.revision, 0.22), ("Date", title.date, 0.38)],
        [
            ("Scale", scale_text(scale), 0.2),
            ("Dimensions", "mm", 0.2),
            ("Sheet", title.sheet, 0.22),
            ("Projection", "", 0.38),
        ],
    ]
    for number, row in enumerate(rows):
        high, x = MARGIN + _ROW * (len(rows) - number), left
        items.append(line((left, high), (right, high)))
        for label, value, share in row:
            if x > left:
                items.append(line((x, high), (x, high - _ROW)))
            items.append(Text(on_paper(x + 1.0, high - 2.6), label, height=_LABEL_HEIGHT))
            if label != "Projection":
                shown = fitted(value, share * across - 3.0)
                items.append(Text(on_paper(x + 2.0, high - 6.9), shown))
            x += share * across
    return items + _first_angle(on_paper, (right - 10.0, MARGIN + 0.5 * _ROW - 0.5), scale)


def _first_angle(on_paper: Callable[[float, float], Point], middle: Point, scale: float) -> list[Item]:
    """The symbol of first-angle projection: a cone, and to its right what is seen from its left."""
    x, y = middle
    cone = ((-7.0, 1.0), (-7.0, -1.0), (-1.0, -2.4), (-1.0, 2.4), (-7.0, 1.0))
    return [
        Line(tuple(on_paper(x + u, y + v) for u, v in cone), "break"),
        *(Circle(on_paper(x + 5.0, y), radius / scale, "break") for radius in (1.0, 2.4)),
        Line((on_paper(x - 8.5, y), on_paper(x + 8.5, y)), "axis"),
        Line((on_paper(x + 5.0, y - 3.2), on_paper(x + 5.0, y + 3.2)), "axis"),
    ]
