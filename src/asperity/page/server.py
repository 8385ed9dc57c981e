"""The server of the page: one process on the loopback address."""

from __future__ import annotations

import ipaddress
import logging
import os
import socket
import sys
from collections.abc import Callable

from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.page.joint_request import JointRequest

#: Requests that are served at the same time; more are refused.
MOST_CONNECTIONS = 64


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
    if ipaddress.ip_address(
        str(address[0]).partition("%")[0]
    ).is_unspecified:  # every request must name its host
        raise InputError(
            f"{host} stands for all addresses of this computer; give the one that other computers use, e.g. 192.168.1.5"
        )
    found = socket.socket(family, kind, protocol)
    found.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        found.bind(address)
    except OSError as error:
        found.close()
        raise InputError(
            f"cannot listen at {host}, port {port}: {error.strerror or error}; choose another port, or 0 for a "
            "free one",
            options=("port",),
        ) from None
    return found


def host_names(host: str, port: int) -> tuple[str, ...]:
    """Values of the ``Host`` header under which the page may be asked for."""
    names = dict.fromkeys(["127.0.0.1", "localhost", "[::1]", f"[{host}]" if ":" in host else host])
    found = [f"{name}:{port}" for name in names]
    return tuple(found + list(names) if port == 80 else found)


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
    from asperity.page.computation import Computations, FasterPrograms
    from asperity.page.slow_clients import impatient_protocol

    port = listening.getsockname()[1]
    computations, charts = Computations(longest=LONGEST_ANSWER), Computations(longest=LONGEST_ANSWER)
    faster = FasterPrograms()
    app = application(
        start, hosts=host_names(host, port), computations=computations, charts=charts, faster=faster
    )
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
    if computations.idle and charts.idle and faster.idle:
        raise stopped
    # a computation cannot be interrupted, and the interpreter would wait for it
    stopping(stopped)
    sys.stderr.flush()
    os._exit(0 if type(stopped) is KeyboardInterrupt else 143)
