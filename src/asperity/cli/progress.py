"""Progress of long runs: a bar on standard error, on a terminal only."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[int, int], Any]]:
    """A bar that is told how far the work is.

    Parameters
    ----------
    what : str
        What is counted.

    Yields
    ------
    callable
        To be called with the number done and the number in all.
    """
    if not sys.stderr.isatty():
        yield lambda done, total: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=Console(stderr=True), transient=True) as progress:
        task = progress.add_task(f"compiling, then {what}", total=None)

        def report(done: int, total: int) -> None:
            progress.update(task, completed=done, total=total, description=what if done else None)

        yield report
