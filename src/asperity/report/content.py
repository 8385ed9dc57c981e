"""What a report consists of, whatever shows it: headings, sentences, tables and their numbers, pictures, listings."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from asperity.units import format_quantity


@dataclass(frozen=True)
class Heading:
    """A heading that begins a section."""

    text: str


@dataclass(frozen=True)
class Paragraph:
    """Sentences, emphasised or not.

    ``passed``: whether they say that everything passed, or that something failed; None if they say neither.
    """

    text: str
    strong: bool = False
    passed: bool | None = None


@dataclass(frozen=True)
class Bullets:
    """A list of sentences."""

    items: Sequence[str]


@dataclass(frozen=True)
class Table:
    """A table: what it shows, the titles of its columns with units, and its cells.

    ``words``: columns of words, which are aligned at the left and may be wrapped, the others are numbers; ``verdicts``:
    whether the last column says what has passed, its cells being ``pass``, ``FAIL`` or ``unknown``.
    """

    title: str
    head: tuple[str, ...]
    rows: Sequence[tuple[str, ...]]
    words: tuple[int, ...] = (0,)
    verdicts: bool = False


@dataclass(frozen=True)
class Picture:
    """A picture as SVG; its title is also read to those who cannot see it.

    ``sheet``: whether it is a sheet of paper of its own, to be shown in full size.
    """

    title: str
    svg: str
    sheet: bool = False


@dataclass(frozen=True)
class Listing:
    """A text that is shown as it is, letter by letter."""

    text: str


Block = Heading | Paragraph | Bullets | Table | Picture | Listing


@dataclass(frozen=True)
class Report:
    """A document: its title, and its content in order."""

    title: str
    blocks: tuple[Block, ...]

    @property
    def sections(self) -> tuple[str, ...]:
        """Headings, in order."""
        return tuple(block.text for block in self.blocks if isinstance(block, Heading))


#: What stands in place of a number that is infinite.
INFINITE = "infinite"


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A quantity [SI] with the unit to show, ``um`` as µm, in so many significant digits.

    a dash where there is none.
    """
    if value is None or math.isnan(value):
        return "–"
    return INFINITE if math.isinf(value) else format_quantity(value, re.sub(r"\bum\b", "µm", unit), digits)


def number(value: float | None, factor: float = 1.0) -> str:
    """A number times a factor with four digits, without its unit; a dash where there is none."""
    return "–" if value is None else quantity(value * factor, "1")


def percent(value: float | None) -> str:
    """A share in percent, number and sign; a dash where there is none."""
    if value is None:
        return "–"
    shown = number(value, 100.0)
    return shown if shown == INFINITE else f"{shown} %"
