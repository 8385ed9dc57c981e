"""Tables and figures as a terminal and a notebook show them."""

from __future__ import annotations

import functools
import html
import io
from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Table:
    """A table to read, with its title and those of its columns: the first column is text, the others are numbers."""

    head: tuple[str, ...]
    rows: Sequence[tuple[str, ...]]
    title: str = ""

    def text(self) -> str:
        """The table with columns of equal width."""
        cells = [tuple(cell.replace("\n", ", ") for cell in self.head), *self.rows]
        widths = [max(len(row[place]) for row in cells) for place in range(len(self.head))]
        lines = [
            "  ".join(
                cell.ljust(width) if place == 0 else cell.rjust(width)
                for place, (cell, width) in enumerate(zip(row, widths, strict=True))
            ).rstrip()
            for row in cells
        ]
        lines.insert(1, "─" * (sum(widths) + 2 * (len(widths) - 1)))
        return "\n".join([self.title, *lines] if self.title else lines)

    def html(self) -> str:
        """The table as HTML, every text escaped."""

        def row(cells: tuple[str, ...], kind: str) -> str:
            first, *others = (html.escape(cell).replace("\n", "<br>") for cell in cells)
            left = f'<{kind} style="text-align:left">{first}</{kind}>'
            return f"<tr>{left}{''.join(f'<{kind}>{cell}</{kind}>' for cell in others)}</tr>"

        title = f"<caption>{html.escape(self.title)}</caption>" if self.title else ""
        body = "".join(row(cells, "td") for cells in self.rows)
        return f"<table>{title}<thead>{row(self.head, 'th')}</thead><tbody>{body}</tbody></table>"


class Shown(ABC):
    """Something that a terminal shows as text, and a notebook as HTML."""

    @abstractmethod
    def _parts(self) -> list[str | Table]:
        """Lines and tables, in their order."""

    def __repr__(self) -> str:
        return "\n\n".join(part.text() if isinstance(part, Table) else part for part in self._parts())

    def _repr_html_(self) -> str:
        return "".join(
            part.html() if isinstance(part, Table) else f"<p>{html.escape(part).replace(chr(10), '<br>')}</p>"
            for part in self._parts()
        )


def displayed(figure: Figure) -> Figure:
    """The same figure, which a notebook shows by itself although it is made without pyplot."""
    shows: Any = figure
    shows._repr_png_ = functools.partial(_png, figure)
    return figure


def _png(figure: Figure) -> bytes:
    target = io.BytesIO()
    figure.savefig(target, format="png", dpi=100)
    return target.getvalue()


def frame(columns: dict[str, Any], *, index: Any = None, index_name: str = "") -> Any:
    """A pandas data frame of columns by title, with named rows; a ``MissingExtraError`` if pandas is not installed."""
    made = pandas().DataFrame(columns, index=index)
    if index_name:
        made.index.name = index_name
    return made


def pandas() -> Any:
    """The package pandas, or a ``MissingExtraError`` if it is not installed."""
    from asperity.extras import optional_module

    return optional_module("pandas", extra="study", needs="data frames need")
