"""How much of the work of a command is done, on a terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from asperity.cli.terminal import rich_console
from asperity.writing import if_abandoned


@contextmanager
def rows_progress(unit: str) -> Iterator[Callable[[int], None]]:
    """A counter on standard error for work of unknown length; nothing is shown if that is not a terminal."""
    target = rich_console(stderr=True)
    if not target.is_terminal:
        yield lambda done: None
        return
    with target.status(f"0 {unit}") as status, if_abandoned(status.stop):
        yield lambda done: status.update(f"{done} {unit}")


@contextmanager
def progress_bar(what: str, *, compiles: bool = True) -> Iterator[Callable[[int, int], None]]:
    """A bar that shows how much of the work is done; yields what takes the number done and the total.

    ``compiles``: whether a program is compiled before.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    shown = Progress(*columns, console=rich_console(stderr=True), transient=True)
    with shown as progress, if_abandoned(progress.stop):
        task = progress.add_task(f"compiling, then {what}" if compiles else what, total=None)

        def report(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total, description=what if done else None)

        yield report
