"""Connections whose other end takes its time: without a limit, a few dozen of them would be all that the server takes.

uvicorn limits how long a connection stays open after an answer. Here are the limits of one that has never asked, asks a
letter at a time, or does not read its answer. :class:`asperity.page.guard.Guard` limits the body.
"""

from __future__ import annotations

import asyncio
from typing import Any

#: Time in which the header of a request must arrive, from the connection or from the last answer on [s].
LONGEST_HEADER = 10.0
#: Time in which the other end must read more of an answer [s].
LONGEST_READING = 30.0
#: Connections that may wait for a header at the same time: half of those that are served.
MOST_SILENT = 32


def impatient_protocol() -> type[asyncio.Protocol]:
    """The HTTP protocol of uvicorn with limits of time."""
    from uvicorn.protocols.http.auto import AutoHTTPProtocol

    class Impatient(AutoHTTPProtocol):  # type: ignore[misc, valid-type]
        _header: asyncio.TimerHandle | None = None
        _reading: asyncio.TimerHandle | None = None

        def connection_made(self, transport: Any) -> None:
            super().connection_made(transport)
            self._look(LONGEST_HEADER)
            silent = [each for each in self.connections if each._header is not None]
            if len(silent) > MOST_SILENT:
                min(silent, key=lambda each: each._header.when())._leave()

        def data_received(self, data: bytes) -> None:
            super().data_received(data)
            self._look(LONGEST_HEADER)

        def on_response_complete(self) -> None:
            super().on_response_complete()
            # a browser that has read one page may wait longer before it asks for the next
            self._look(max(LONGEST_HEADER, self.timeout_keep_alive))

        def connection_lost(self, exc: Exception | None) -> None:
            self._leave()
            super().connection_lost(exc)

        def pause_writing(self) -> None:
            super().pause_writing()
            self._reading = self.loop.call_later(LONGEST_READING, self._leave)

        def resume_writing(self) -> None:
            super().resume_writing()
            if self._reading is not None:
                self._reading.cancel()
                self._reading = None

        def _leave(self) -> None:
            for timer in (self._header, self._reading):
                if timer is not None:
                    timer.cancel()
            self._header = self._reading = None
            self.transport.abort()

        def _look(self, longest: float) -> None:
            """Wait for a header no longer than this, where no request is being answered."""
            if self.cycle is not None and not self.cycle.response_complete:
                if self._header is not None:
                    self._header.cancel()
                    self._header = None
            elif self._header is None and not self.transport.is_closing():
                self._header = self.loop.call_later(longest, self._leave)

    return Impatient
