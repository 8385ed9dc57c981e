"""One table of numbers in a text: its columns with their headings, its numbers, and what the lines around it state."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.text_table.entries import Entry, entries
from asperity.text_table.headings import Heading, column_headings
from asperity.text_table.layout import Dialect, Layout, Line, finite_or_missing, table_layout

#: Lines around a table that are shown one by one.
_SHOWN_LINES = 2


@dataclass(frozen=True)
class TextTable:
    """A table of numbers of a text file.

    ``values`` of shape (rows, columns), nan where missing; ``headings`` of the columns; ``line_numbers`` of the rows in
    the file; ``corner``: text in the first field of the first row, empty without one; ``entries``: what other lines
    state; ``unused``: lines around the table that are neither headings nor entries; ``inside``: comments between rows;
    ``first_gap``: number of the first blank line between rows, 0 without one; ``source``: name of the file.
    """

    values: NDArray[np.float64]
    headings: tuple[Heading, ...]
    line_numbers: NDArray[np.int64]
    corner: str
    entries: tuple[Entry, ...]
    unused: tuple[Line, ...]
    inside: tuple[Line, ...]
    first_gap: int
    dialect: Dialect
    source: str

    @property
    def width(self) -> int:
        """Number of columns."""
        return self.values.shape[1]

    @property
    def row_words(self) -> str:
        """Its size in words."""
        rows, columns = self.values.shape
        return f"{rows} rows of {columns} column{'' if columns == 1 else 's'}"

    def left_out(self, known: Collection[str]) -> tuple[str, ...]:
        """Notes of the lines of a file that were not used; ``known`` are the keys of entries that are."""
        counts = [line for line in self.unused if line.text.strip() == str(len(self.values))]
        notes = [f"{line} counts the points" for line in counts]
        others = {line for line in self.unused if line not in counts}
        others |= {entry.line for entry in self.entries if entry.key not in known}
        around = sorted(others, key=lambda line: line.number)
        for lines, where in ((around, "around the table"), (self.inside, "between the rows")):
            if not lines:
                continue
            more = f" and {len(lines) - _SHOWN_LINES} more" if len(lines) > _SHOWN_LINES else ""
            notes.append(f"not used {where}: {', '.join(map(str, lines[:_SHOWN_LINES]))}{more}")
        return tuple(notes)


def _refuse_second_header(layout: Layout, source: str) -> None:
    """Raise if comments between rows state what lines above the table do: the file holds two tables.

    The same line, or the same key, apart from digits.
    """

    def said(lines: Iterable[Line]) -> dict[str, Line]:
        """Lines by the keys of their entries, and by all that they say."""
        whole = {re.sub(r"\d+", "0", " ".join(line.text.lower().split())): line for line in lines}
        return {entry.key: entry.line for entry in entries(lines)} | whole

    before, inside = said(layout.above), said(layout.inside)
    again = next((line for key, line in inside.items() if key in before), None)
    if again is not None:
        raise InputError(
            f"{source}: {again} stands between rows of numbers and states what a line above them does: the file holds "
            "two tables; save one table a file"
        )


def text_table(text: str, *, source: str, decimal: str = "auto", fewest_rows: int = 3) -> TextTable:
    """The table of a text from a file called ``source``; ``decimal``: "auto", "point" or "comma".

    An ``InputError`` with the line and what was read in it, if there is no table, there are two, a row is no row, or a
    number is infinite.
    """
    layout = table_layout(text, source=source, decimal=decimal, fewest_rows=fewest_rows)
    finite_or_missing(layout.values, layout.line_numbers, source=source)
    _refuse_second_header(layout, source)
    width = layout.values.shape[1]
    headings, used = column_headings(layout.above, layout.dialect, width)
    others = [line for line in (*layout.above, *layout.below) if line not in used]
    stated = entries(others)
    known = {entry.line for entry in stated}
    return TextTable(
        layout.values,
        headings,
        layout.line_numbers,
        layout.corner,
        stated,
        tuple(line for line in others if line not in known),
        layout.inside,
        layout.first_gap,
        layout.dialect,
        source,
    )
