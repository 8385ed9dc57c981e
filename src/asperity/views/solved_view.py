"""A solved joint with its document: what every view of it reads."""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass

from asperity.results.result import Result
from asperity.results.solved import SolvedJoint
from asperity.results.table import results_of_joint
from asperity.types import Document
from asperity.views.blocks import Table
from asperity.views.numbers import number, number_in, unit_words, words


@dataclass(frozen=True)
class SolvedView:
    """A solved joint, and its document.

    ``made_interference`` is that with which the ring is made [m], None where it is not known or not asked for.
    """

    solved: SolvedJoint
    document: Document
    made_interference: float | None = None

    @functools.cached_property
    def rows(self) -> dict[str, Result]:
        """Every result that the joint has, by name."""
        return results_of_joint(self.solved)

    def value(self, name: str) -> float | None:
        """A number of the whole joint [SI], None where it is not known or infinite."""
        value = next(iter(self.rows[name].rows_of(self.solved).values()), math.nan)
        return value if math.isfinite(value) else None

    def contact_table(self, name: str, title: str) -> list[Table]:
        """The table of a name with a line for each contact: the results whose column stands in it, in their order.

        A column without any number is left out, and a table without any column is none.
        """
        contacts = self.solved.row_names("contact")
        columns = [(head, cells) for head, cells in self._columns(name) if any(cells.values())]
        if not columns:
            return []
        rows = [
            (words(contact), *(cells.get(contact) or number(None) for _, cells in columns))
            for contact in contacts
        ]
        return [Table(title, ("contact", *(head for head, _ in columns)), rows)]

    def _columns(self, table: str) -> Iterator[tuple[str, dict[str, str]]]:
        """Heads of the columns of a table, and contact → number as text, empty where there is none."""
        for row in self.rows.values():
            if row.column is None or row.column.table != table:
                continue
            unit = row.column.unit or row.display_unit
            values = {
                contact: "" if math.isnan(value) else number_in(value * row.column.factor, unit)
                for contact, value in row.rows_of(self.solved).items()
            }
            yield f"{row.column.head}\n{row.column.unit_shown or unit_words(unit) or '-'}", values
