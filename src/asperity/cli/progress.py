"""Progress of long runs: a bar on standard error, on a terminal only."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from asperity.cli.terminal import rich_console


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], Any]]:
    """A bar that shows how much of the work is done.

    Parameters
    ----------
    what : str
        What is counted.

    Yields
    ------
    callable
        Takes the number done and the total.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=rich_console(stderr=True), transient=True) as progress:
        task = progress.add_task(f"compiling, then {what}", total=None)

        def report(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total, description=what if done else None)

        yield report
