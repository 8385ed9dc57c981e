"""The server of the page: one process on the loopback address, impatient with slow clients."""

from __future__ import annotations

import asyncio
import ipaddress
import itertools
import logging
import os
import selectors
import socket
import sys
from collections.abc import Callable
from typing import Any

from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.page.joint_request import JointRequest

#: Requests that are served at the same time; more are refused.
MOST_CONNECTIONS = 64
#: Time in which the header of a request must arrive, from the connection or from the last answer on [s].
LONGEST_HEADER = 10.0
#: Time in which the other end must read more of an answer [s].
LONGEST_READING = 30.0
#: Connections that may wait for a header at the same time: half of those that are served.
MOST_SILENT = 32


def require_packages() -> None:
    """Raise unless the packages of the page are installed."""
    for name in ("starlette", "uvicorn"):
        optional_module(name, extra="page", needs="the page needs")


def is_loopback(host: str) -> bool:
    """Whether an address can be reached from this computer alone."""
    if host == "localhost":
        return True
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False


def listening_socket(host: str, port: int) -> socket.socket:
    """A socket that listens at an address."""
    try:
        family, kind, protocol, _, address = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)[0]
    except OSError as error:
        raise InputError(f"the address {host} is unknown: {error.strerror or error}") from None
    # every request must name its host
    if ipaddress.ip_address(str(address[0]).partition("%")[0]).is_unspecified:
        raise InputError(
            f"{host} stands for all addresses of this computer; give the one that other computers use, e.g. 192.168.1.5"
        )
    listener = socket.socket(family, kind, protocol)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind(address)
    except OSError as error:
        listener.close()
        raise InputError(
            f"cannot listen at {host}, port {port}: {error.strerror or error}; choose another port, or 0 for a "
            "free one",
            options=("port",),
        ) from None
    return listener


def host_names(host: str, port: int) -> tuple[str, ...]:
    """Values of the ``Host`` header under which the page may be asked for."""
    names = dict.fromkeys(["127.0.0.1", "localhost", "[::1]", f"[{host}]" if ":" in host else host])
    hosts = [f"{name}:{port}" for name in names]
    return tuple(hosts + list(names) if port == 80 else hosts)


def serve(
    start: JointRequest,
    *,
    listening: socket.socket,
    host: str,
    ready: Callable[[str], None],
    stopping: Callable[[KeyboardInterrupt], None],
) -> None:
    """Serve the page until it is interrupted."""
    import uvicorn

    from asperity.page.application import LONGEST_ANSWER, application
    from asperity.page.computation import Computations

    port = listening.getsockname()[1]
    computations, charts = Computations(longest=LONGEST_ANSWER), Computations(longest=LONGEST_ANSWER)
    app = application(start, hosts=host_names(host, port), computations=computations, charts=charts)
    shown = f"[{host}]" if ":" in host else host

    class Announced(uvicorn.Server):
        async def startup(self, sockets: list[socket.socket] | None = None) -> None:
            await super().startup(sockets)
            ready(f"http://{shown}:{port}/")

    config = uvicorn.Config(
        app,
        http=impatient_protocol(),
        log_level="warning",
        access_log=False,
        ws="none",
        server_header=False,
        limit_concurrency=MOST_CONNECTIONS,
        timeout_keep_alive=30,
        timeout_graceful_shutdown=2,
    )
    server = Announced(config)
    # what still runs when it is interrupted is cut off, and that is no error
    logging.getLogger("uvicorn.error").addFilter(lambda record: not server.should_exit)
    stopped = KeyboardInterrupt()
    try:  # ends without an exception where a script has started it in the background, which ignores SIGINT
        server.run(sockets=[listening])
    except KeyboardInterrupt as interruption:
        stopped = interruption
    # a computation cannot be interrupted, nor can XLA, and the interpreter would wait for both
    stopping(stopped)
    sys.stderr.flush()
    os._exit(0 if type(stopped) is KeyboardInterrupt else 143)


def impatient_protocol() -> type[asyncio.Protocol]:
    """The HTTP protocol of uvicorn with limits of time."""
    from uvicorn.protocols.http.auto import AutoHTTPProtocol

    class Impatient(AutoHTTPProtocol):  # type: ignore[misc, valid-type]
        _header: asyncio.TimerHandle | None = None
        _reading: asyncio.TimerHandle | None = None

        def connection_made(self, transport: Any) -> None:
            super().connection_made(transport)
            self._look(LONGEST_HEADER)
            self._make_room()

        def data_received(self, data: bytes) -> None:
            if self.config.limit_concurrency is not None:
                # others that have not asked yet, or are being left, take nobody's place
                left = sum(each is not self and each.transport.is_closing() for each in self.connections)
                others = [each for each in self._silent() if each is not self]
                self.limit_concurrency = self.config.limit_concurrency + len(others) + left
            super().data_received(data)
            self._look(LONGEST_HEADER)
            if self._header is not None:  # it has not asked to the end
                self._make_room()

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

        def _silent(self) -> list[Any]:
            return [connection for connection in self.connections if connection._header is not None]

        def _make_room(self) -> None:
            """Leave those whose time is up first, of the connections that have nothing to be read."""
            silent = sorted(self._silent(), key=lambda connection: connection._header.when())
            idle = (connection for connection in silent if not connection._has_asked())
            for connection in list(itertools.islice(idle, max(len(silent) - MOST_SILENT, 0))):
                connection._leave()

        def _has_asked(self) -> bool:
            """Whether something waits to be read: the requests of a burst are accepted before they are."""
            try:
                with selectors.DefaultSelector() as look:
                    look.register(self.transport.get_extra_info("socket"), selectors.EVENT_READ)
                    return bool(look.select(0.0))
            except (OSError, ValueError):  # it is closed
                return False

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
