"""Blocks as a terminal shows them, by rich."""

from __future__ import annotations

import functools
import io
import re
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import IO, TYPE_CHECKING, Any

from asperity.errors import printable
from asperity.views.blocks import (
    Block,
    Bullets,
    Figures,
    Heading,
    Listing,
    Paragraph,
    Picture,
    Table,
    Warnings,
    figures_table,
)

if TYPE_CHECKING:
    from rich.console import Console

#: Letters of a line, unless the terminal has fewer.
WIDEST = 100

_GAP = 3  # letters between two columns
_SHORT_WORDS = 24  # letters of a column of words that wraps, unless one word has more
_SHORTEST_WORDS = 16  # letters of such a column before columns move to a further table
_LONGEST_WORD = 40  # letters of a word that is kept whole
_SHORT_CELL = 20  # letters of a line of a number with words behind it
_SHORTEST_LINES = (24, 20, 16, 12, 0)  # letters to which heads and such cells give way, in turn

_VERDICT_STYLES = {"pass": "green", "FAIL": "bold red"}


def console_on(stream: IO[str]) -> Console:
    """A console of rich on a stream, whose texts cannot style it or control it themselves."""
    made: Console = _console_class()(file=stream, highlight=False, soft_wrap=False)
    return made


@functools.cache
def _console_class() -> Any:
    from rich.console import Console

    class PlainTextConsole(Console):
        """Texts are printed with their control characters written out."""

        def render_str(self, text: str, **options: Any) -> Any:
            return super().render_str("\n".join(map(printable, text.split("\n"))), **options)

    return PlainTextConsole


def plain_text(blocks: Iterable[Block]) -> str:
    """Blocks as text without colours, as a terminal shows them."""
    stream = io.StringIO()
    target = console_on(stream)
    target.width = WIDEST
    show(target, blocks)
    return "\n".join(line.rstrip() for line in stream.getvalue().rstrip().split("\n"))


def show(target: Console, blocks: Iterable[Block]) -> None:
    """Print blocks in their order, an empty line behind each; pictures are for other screens."""
    for block in blocks:
        if isinstance(block, Picture):
            continue
        _show(target, block)
        if not isinstance(block, Heading):
            target.print()


def _show(target: Console, block: Block) -> None:
    match block:
        case Heading(text):
            print_wrapped(target, text, indent=0, style="bold")
        case Paragraph(text, strong, passed):
            style = "bold" if strong else None
            if passed is False:
                style = "bold red"
            for line in text.split("\n"):
                print_wrapped(target, line, indent=0, style=style)
        case Bullets(items):
            for item in items:
                print_wrapped(target, f"  {item}", indent=4)
        case Figures(figures):
            _show_table(target, replace(figures_table(figures), title=""), head=False)
        case Table():
            for number, part in enumerate(fitting(block, target.width)):
                if number:
                    target.print()
                _show_table(target, part)
        case Warnings(warned):
            print_wrapped(target, "Warnings, most serious first", indent=0, style="bold")
            for one in warned:
                print_wrapped(target, f"  {one.about}: {one.text}", indent=4, style="yellow")
                for meaning in one.meanings:
                    print_wrapped(target, f"    {meaning}", indent=4)
                if one.remedy:
                    print_wrapped(target, f"    What to do: {one.remedy}", indent=4)
        case Listing(text):
            target.print(text, markup=False, soft_wrap=True)


def print_wrapped(target: Console, text: str, *, indent: int, style: str | None = None) -> None:
    """Print a sentence, its later lines indented."""
    target.print(
        textwrap.fill(text, target.width, subsequent_indent=" " * indent, break_on_hyphens=False),
        markup=False,
        soft_wrap=True,
        style=style,
    )


def fitting(shown: Table, width: int) -> Iterator[Table]:
    """A table in parts that fit a width, so that no number is cut; the columns of words begin each of them.

    First heads and long cells give way, line by line; what still does not fit stands in further tables.
    """
    if _needed(shown) <= width:
        yield shown
        return
    for letters in _SHORTEST_LINES:
        narrow = _narrow(shown, letters)
        if _needed(narrow) <= width:
            yield narrow
            return
    narrow = replace(narrow, rows=[tuple(map(_parted, row)) for row in narrow.rows])
    if _needed(narrow, _SHORTEST_WORDS) <= width:
        yield narrow
        return
    leading = [place for place in shown.words if place == shown.words.index(place)]
    numbers = [place for place in range(len(shown.head)) if place not in leading]
    title, taken = shown.title, list(leading)
    for place in numbers:
        if len(taken) > len(leading) and _needed(_chosen(narrow, [*taken, place], title)) > width:
            yield _chosen(narrow, taken, title)
            title, taken = f"{shown.title} (continued)" if shown.title else "", list(leading)
        taken.append(place)
    yield _chosen(narrow, taken, title)


def _columns(shown: Table) -> list[tuple[str, ...]]:
    """Cells of each column."""
    return [tuple(row[place] for row in shown.rows) for place in range(len(shown.head))]


def _chosen(shown: Table, places: Sequence[int], title: str) -> Table:
    """Some of the columns of a table."""
    return replace(
        shown,
        title=title,
        head=tuple(shown.head[place] for place in places),
        rows=[tuple(row[place] for place in places) for row in shown.rows],
        words=tuple(index for index, place in enumerate(places) if place in shown.words),
    )


def _narrow(shown: Table, letters: int) -> Table:
    """A table whose heads have no longer lines than their cells, or than so many letters, as far as words allow."""
    columns = [
        cells if place in shown.words else tuple(_wrapped(cell, max(letters, _SHORT_CELL)) for cell in cells)
        for place, cells in enumerate(_columns(shown))
    ]
    head = []
    for text, cells in zip(shown.head, columns, strict=True):
        lines = (line for cell in cells for line in cell.split("\n"))
        head.append(_wrapped(text, max(letters, *map(len, text.split()), *map(len, lines), 1)))
    return replace(shown, head=tuple(head), rows=list(zip(*columns, strict=True)))


def _parted(cell: str) -> str:
    """A cell whose long words, such as the names of keys and files, have lines that end between their parts."""
    return re.sub(rf"(?=\S{{{_SHORT_WORDS + 1}}})(\S{{1,{_SHORT_WORDS - 1}}}[._/])", r"\1\n", cell)


def _wrapped(text: str, letters: int) -> str:
    """Lines of a text, none of which has more letters unless a single word or a number with its unit has."""
    return "\n".join(
        part
        for line in text.split("\n")
        for part in textwrap.wrap(line, letters, break_long_words=False, break_on_hyphens=False) or [""]
    )


def _needed(shown: Table, short: int = _SHORT_WORDS) -> int:
    """Letters that a table needs in a line; columns of words need no more than ``short``, or their longest word."""
    widths = []
    for place, (head, cells) in enumerate(zip(shown.head, _columns(shown), strict=True)):
        texts = (head, *cells)
        lines = max(len(line) for text in texts for line in text.split("\n"))
        if place in shown.words:
            word = max((len(word) for text in texts for word in text.split()), default=0)
            lines = min(lines, max(short, min(word, _LONGEST_WORD)))
        widths.append(lines)
    return sum(widths) + _GAP * len(widths) - 1


def _show_table(target: Console, shown: Table, *, head: bool = True) -> None:
    """Print a table: numbers at the right, words at the left and wrapped, its title in bold."""
    from rich import box
    from rich.markup import escape
    from rich.table import Table as RichTable

    lines = box.SIMPLE_HEAD if head and target.encoding.lower().startswith("utf") else None
    if shown.title:
        print_wrapped(target, shown.title, indent=0, style="bold")
    made = RichTable(
        box=lines,
        pad_edge=False,
        show_edge=False,
        show_header=head,
    )
    for place, column in enumerate(shown.head):
        in_words = place in shown.words
        made.add_column(
            escape(column),
            justify="left" if in_words else "right",
            overflow="fold" if in_words else "ellipsis",
            no_wrap=not in_words,
        )
    for row in shown.rows:
        cells = [escape(cell) for cell in row]
        if shown.verdicts and (style := _VERDICT_STYLES.get(row[-1])):
            cells[-1] = f"[{style}]{cells[-1]}[/]"
        made.add_row(*cells)
    target.print(made)
