"""One worker for all computations: requests wait in a short queue, and a full queue refuses."""

from __future__ import annotations

import asyncio
import threading
from collections import OrderedDict
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor, wait
from typing import Any, TypeVar

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
            raise BusyError(f"no answer within {self._longest:g} s; try again in a moment") from None

    def close(self, *, longest: float = 0.0) -> None:
        """Drop what waits, and finish what runs, for which it waits no longer than ``longest`` [s]."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        with self._lock:
            left = list(self._left)
        wait(left, timeout=longest)


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
