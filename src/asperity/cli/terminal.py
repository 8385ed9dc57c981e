"""Where commands print: plain text when piped, at most 100 columns, legible in terminals without Unicode."""

from __future__ import annotations

import codecs
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from rich.console import Console
    from rich.table import Table

WIDEST = 100

_IN_ASCII = {
    "·": "*",
    "²": "^2",
    "³": "^3",
    "µ": "u",
    "°": " deg",
    "–": "-",
    "→": "->",
    "±": "+-",
    "≥": ">=",
    "…": "...",
}


def _spell_out(error: UnicodeError) -> tuple[str, int]:
    if not isinstance(error, UnicodeEncodeError):
        raise error
    unknown = error.object[error.start : error.end]
    return "".join(_IN_ASCII.get(letter, "?") for letter in unknown), error.end


def prepare_output() -> None:
    """Let standard output and error spell out what their encoding cannot write, instead of failing."""
    codecs.register_error("asperity_spell_out", _spell_out)
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="asperity_spell_out")


def console() -> Console:
    """A console on standard output.

    Returns
    -------
    Console
        With colours on a terminal only, and no wider than :data:`WIDEST`.
    """
    from rich.console import Console

    prepare_output()
    made = Console(highlight=False, soft_wrap=False)
    made.width = min(made.width, WIDEST) if made.is_terminal else WIDEST
    return made


def table(target: Console, title: str, *columns: str) -> Table:
    """An empty table in the style of all commands: first column text, the others numbers.

    Parameters
    ----------
    target : Console
        Where it will be shown.
    title : str
        Its title.
    *columns : str
        Headers, with units.

    Returns
    -------
    Table
        To be filled.
    """
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    lines = box.SIMPLE_HEAD if target.encoding.lower().startswith("utf") else None
    made = Table(title=escape(title), title_justify="left", title_style="bold", box=lines, pad_edge=False)
    for index, column in enumerate(columns):
        made.add_column(escape(column), justify="right" if index else "left", no_wrap=index > 0)
    return made


def say_written(path: str | Path) -> None:
    """Say on standard error that a file has been written.

    Parameters
    ----------
    path : str or Path
        Its name.
    """
    click.echo(f"wrote {path}", err=True)


@contextmanager
def rows_progress(unit: str) -> Iterator[Callable[[int], None]]:
    """A count on standard error while something of unknown length is done; nothing if that is no terminal.

    Parameters
    ----------
    unit : str
        What is counted.

    Yields
    ------
    callable
        To be called with the number done so far.
    """
    from rich.console import Console

    target = Console(stderr=True)
    if not target.is_terminal:
        yield lambda done: None
        return
    with target.status(f"0 {unit}") as status:
        yield lambda done: status.update(f"{done} {unit}")
