"""What a view consists of, whatever shows it: headings, sentences, figures, tables, warnings, pictures, listings."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TypedDict

from asperity.views.numbers import INFINITE, NONE


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
class Figure:
    """One number by which a joint is judged.

    Its name, the number as text, its unit, a few words on it, and the number itself in SI units, None where there is
    none.
    """

    name: str
    shown: str
    unit: str
    detail: str
    si: float | None

    @property
    def text(self) -> str:
        """The number with its unit."""
        return self.shown if self.shown in (NONE, INFINITE) else f"{self.shown} {self.unit}".strip()


@dataclass(frozen=True)
class Figures:
    """The numbers that are asked for first."""

    items: Sequence[Figure]


@dataclass(frozen=True)
class Table:
    """A table: what it shows, the titles of its columns with units below them, and its cells.

    ``words``: columns of words, which are aligned at the left and may be wrapped, the others are numbers; ``verdicts``:
    whether the last column says what has passed, its cells being ``pass``, ``FAIL`` or ``unknown``; ``shares``: how
    much of a whole or of a limit each row stands for [-], which a picture of the table may draw as bars.
    """

    title: str
    head: tuple[str, ...]
    rows: Sequence[tuple[str, ...]]
    words: tuple[int, ...] = (0,)
    verdicts: bool = False
    shares: Sequence[float | None] = ()


@dataclass(frozen=True)
class Warned:
    """A limit that is crossed: how serious that is, what it is and how far, what it means, and what to do."""

    severity: str
    about: str
    text: str
    meanings: tuple[str, ...]
    remedy: str


@dataclass(frozen=True)
class Warnings:
    """Limits that are crossed, the most serious first."""

    items: Sequence[Warned]


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


Block = Heading | Paragraph | Bullets | Figures | Table | Warnings | Picture | Listing


def figures_table(items: Sequence[Figure]) -> Table:
    """Figures as a table, for screens without cards."""
    rows = [(figure.name, figure.text, figure.detail) for figure in items]
    return Table("Key figures", ("quantity", "value", "what it is"), rows, words=(0, 1, 2))


class BlockDocument(TypedDict):
    """A block for JSON: its kind in lower case, and its fields."""

    kind: str


def block_documents(blocks: Iterable[Block]) -> list[BlockDocument]:
    """Blocks for JSON: the kind of each, and its fields by their names."""
    return [
        {"kind": type(block).__name__.lower(), **dataclasses.asdict(block)}  # type: ignore[typeddict-item]
        for block in blocks
    ]


@dataclass(frozen=True)
class Report:
    """A document: its title, and its content in order."""

    title: str
    blocks: tuple[Block, ...]

    @property
    def sections(self) -> tuple[str, ...]:
        """Headings, in order."""
        return tuple(block.text for block in self.blocks if isinstance(block, Heading))
