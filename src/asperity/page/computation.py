"""One worker for all computations: requests wait in a short queue, and a full queue refuses.

Another worker compiles the programs of the answers again, so that the answers after it come sooner.
"""

from __future__ import annotations

import asyncio
import contextlib
import os
import sys
import threading
import weakref
from collections import OrderedDict
from collections.abc import Callable, Iterable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from typing import Any, TypeVar

from asperity.compilation import Program
from asperity.errors import AsperityError

Computed = TypeVar("Computed")

#: Computations that may wait or run at the same time.
MOST_WAITING = 8
#: Answers that are kept for downloads.
MOST_KEPT = 32


class BusyError(AsperityError):
    """Too many computations wait, or one takes too long."""


class Computations:
    """A single thread that runs one computation after the other, or a few that run them side by side.

    ``longest`` is the time that a request waits for its answer [s].
    """

    def __init__(self, *, longest: float, threads: int = 1) -> None:
        self._longest = longest
        self._pool = ThreadPoolExecutor(threads, thread_name_prefix="asperity-computation")
        self._left: set[Future[Any]] = set()
        self._lock = threading.Lock()

    def submit(self, function: Callable[..., Computed], *arguments: Any) -> Future[Computed]:
        """Result of a computation put at the end of the queue; :class:`BusyError` if the queue is full."""
        with self._lock:
            if len(self._left) >= MOST_WAITING:
                raise BusyError(f"{MOST_WAITING} computations are waiting already; try again in a moment")
            future = self._pool.submit(function, *arguments)
            self._left.add(future)
        future.add_done_callback(self._done)
        return future

    def _done(self, future: Future[Any]) -> None:
        with self._lock:
            self._left.discard(future)

    async def run(self, function: Callable[..., Computed], *arguments: Any) -> Computed:
        """What a computation returns, of a function and its arguments, once its turn has come.

        :class:`BusyError` if the queue is full, or the answer does not come in time; what has not begun is dropped.
        """
        future = self.submit(function, *arguments)
        try:
            return await asyncio.wait_for(asyncio.wrap_future(future), self._longest)
        except TimeoutError:
            raise BusyError(
                f"no answer within {self._longest:g} s; a first start compiles the programs, try again"
            ) from None

    def close(self, *, longest: float = 0.0) -> None:
        """Drop what waits, and finish what runs, for which it waits no longer than ``longest`` [s]."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        with self._lock:
            left = list(self._left)
        wait(left, timeout=longest)


class FasterPrograms:
    """A thread that compiles programs again, to run faster, one after the other."""

    def __init__(self) -> None:
        self._pool = ThreadPoolExecutor(1, thread_name_prefix="asperity-faster", initializer=_yield_to_others)
        self._known: weakref.WeakSet[Program] = weakref.WeakSet()
        self._left: set[Future[None]] = set()

    @property
    def idle(self) -> bool:
        """Whether no program is compiled, and none waits."""
        return all(compilation.done() for compilation in self._left)

    def add(self, programs: Iterable[Program]) -> None:
        """Compile programs that were called for an answer again, those of them for which this was not asked before."""
        new = [program for program in programs if program not in self._known]
        self._known.update(new)
        self._left = {compilation for compilation in self._left if not compilation.done()}
        with contextlib.suppress(RuntimeError):  # closed since: an answer of the last moment
            self._left.update(self._pool.submit(_compile_again, weakref.ref(program)) for program in new)

    def close(self) -> None:
        """Drop what waits, and finish what runs."""
        self._pool.shutdown(wait=False, cancel_futures=True)


def _compile_again(waiting: weakref.ref[Program]) -> None:
    if (program := waiting()) is not None:  # not forgotten meanwhile, to free its memory
        program.compile_again()


def _yield_to_others() -> None:
    """On Linux, where a thread has a priority of its own, answers go first."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, threading.get_native_id(), 10)


class KeptAnswers:
    """The latest answers by their identity, for downloads."""

    def __init__(self) -> None:
        self._kept: OrderedDict[str, Any] = OrderedDict()

    def keep(self, identity: str, answer: Any) -> None:
        """Remember an answer and forget the oldest ones."""
        self._kept[identity] = answer
        self._kept.move_to_end(identity)
        while len(self._kept) > MOST_KEPT:
            self._kept.popitem(last=False)

    def get(self, identity: str) -> Any:
        """An answer; None if it was never given, or has been forgotten."""
        return self._kept.get(identity)
