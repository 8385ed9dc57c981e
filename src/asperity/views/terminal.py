"""Blocks as a terminal shows them, by rich."""

from __future__ import annotations

import functools
import io
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
_SHORT_WORDS = 24  # letters of a column of words that wraps

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

    First the heads give way, line by line; what still does not fit stands in further tables.
    """
    if _needed(shown) <= width:
        yield shown
        return
    narrow = replace(shown, head=tuple(map(_wrapped, shown.head, _columns(shown))))
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


def _wrapped(head: str, cells: tuple[str, ...]) -> str:
    """The head of a column in lines no longer than its cells, as far as its words allow."""
    longest = max(map(len, (*head.split(), *cells)))
    return "\n".join(part for line in head.split("\n") for part in textwrap.wrap(line, longest) or [""])


def _needed(shown: Table) -> int:
    """Letters that a table needs in a line; columns of words need no more than some."""
    widths = []
    for place, (head, cells) in enumerate(zip(shown.head, _columns(shown), strict=True)):
        lines = max(map(len, (*head.split("\n"), *cells)), default=0)
        widths.append(min(lines, _SHORT_WORDS) if place in shown.words else lines)
    return sum(widths) + _GAP * len(widths)


def _show_table(target: Console, shown: Table, *, head: bool = True) -> None:
    """Print a table: numbers at the right, words at the left and wrapped, its title in bold."""
    from rich import box
    from rich.markup import escape
    from rich.table import Table as RichTable

    lines = box.SIMPLE_HEAD if head and target.encoding.lower().startswith("utf") else None
    made = RichTable(
        title=escape(shown.title) if shown.title else None,
        title_justify="left",
        title_style="bold",
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
