"""What every request must satisfy before it reaches the page: host, origin, method, size and time of the body.

Answers to requests that are wrong, with the message of the command line and the keys that it is about.

A page on the loopback address can be reached from any web site that the user visits, in two ways. The site posts to
``http://127.0.0.1:PORT`` directly: refused by the ``Origin`` and ``Sec-Fetch-Site`` headers. Or it points its own name
at 127.0.0.1 (DNS rebinding), so that the browser takes both for the same site: refused by the ``Host`` header.
"""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Awaitable, Callable, Iterable, Mapping, MutableMapping
from typing import Any

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse

from asperity.errors import AsperityError, InputError, NoSolutionError
from asperity.page.computation import BusyError

Scope = MutableMapping[str, Any]
Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]

#: Largest body of a request [byte].
LARGEST_BODY = 1_000_000
#: Time in which a body must arrive [s].
LONGEST_BODY = 10.0

METHODS = ("GET", "HEAD", "POST")

#: Headers of every answer. Scripts and styles come from this server alone, nothing is inline, nothing leaves.
SECURITY_HEADERS = {
    "content-security-policy": (
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    ),
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-store",
}


class RefusedError(Exception):
    """A request that is not answered: HTTP status, and why, in one sentence."""

    def __init__(self, status: int, message: str) -> None:
        super().__init__(message)
        self.status = status


class Guard:
    """ASGI application around another one.

    Only ``hosts``, values of the ``Host`` header with their port, are answered. A body has at most ``largest_body``
    bytes, or those of its address in ``larger_bodies``, and must arrive within ``longest_body`` seconds.
    """

    def __init__(
        self,
        app: App,
        *,
        hosts: Iterable[str],
        largest_body: int = LARGEST_BODY,
        larger_bodies: Mapping[str, int] | None = None,
        longest_body: float = LONGEST_BODY,
    ) -> None:
        self._app = app
        self._hosts = frozenset(host.lower() for host in hosts)
        self._largest, self._longest = largest_body, longest_body
        self._larger = dict(larger_bodies or {})

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer one request, or refuse it."""
        if scope["type"] == "lifespan":
            await self._app(scope, receive, send)
            return
        if scope["type"] != "http":  # no web sockets here
            await send({"type": "websocket.close", "code": 1008})
            return

        async def guarded_send(message: Message) -> None:
            if message["type"] == "http.response.start":
                extra = [(name.encode(), value.encode()) for name, value in SECURITY_HEADERS.items()]
                message = {**message, "headers": [*message.get("headers", []), *extra]}
            await send(message)

        try:
            headers = _headers(scope)
            self._check(scope, headers)
            body = await self._body(headers, receive, self._larger.get(scope["path"], self._largest))
        except RefusedError as refused:
            await _refuse(guarded_send, refused)
            return
        await self._app(scope, _replayed(body, receive), guarded_send)

    def _check(self, scope: Scope, headers: dict[str, list[str]]) -> None:
        hosts = headers.get("host", [])
        if len(hosts) != 1 or hosts[0].lower() not in self._hosts:
            raise RefusedError(
                421, f"this page is at {', '.join(sorted(self._hosts))}; the request names another host"
            )
        if scope["method"] not in METHODS:
            raise RefusedError(405, f"the method {scope['method']} is not allowed; use {', '.join(METHODS)}")
        foreign = any(
            not origin.lower().startswith("http://")
            or origin.lower().removeprefix("http://") not in self._hosts
            for origin in headers.get("origin", [])
        )
        calls = scope["method"] == "POST" or scope["path"].startswith("/api/")
        across = any(site not in ("same-origin", "none") for site in headers.get("sec-fetch-site", []))
        if foreign or (calls and across):
            raise RefusedError(403, "requests from other web sites are refused")

    async def _body(self, headers: dict[str, list[str]], receive: Receive, largest: int) -> bytes:
        """All of the body, which must be small and arrive in time."""
        too_large = RefusedError(413, f"the request is too large; at most {largest} bytes are read here")
        stated = headers.get("content-length", ["0"])[0]
        if not stated.isdigit() or len(stated) > 18 or int(stated) > largest:
            raise too_large
        parts: list[bytes] = []
        size = 0
        try:
            async with asyncio.timeout(self._longest):
                while True:
                    message = await receive()
                    if message["type"] != "http.request":
                        raise RefusedError(400, "the request ended before its body was complete")
                    parts.append(message.get("body", b""))
                    size += len(parts[-1])
                    if size > largest:
                        raise too_large
                    if not message.get("more_body", False):
                        return b"".join(parts)
        except TimeoutError:
            raise RefusedError(
                408, f"the body of the request did not arrive within {self._longest:g} s"
            ) from None


def _headers(scope: Scope) -> dict[str, list[str]]:
    headers: dict[str, list[str]] = {}
    for name, value in scope["headers"]:
        headers.setdefault(name.decode("latin-1").lower(), []).append(value.decode("latin-1"))
    return headers


def _replayed(body: bytes, receive: Receive) -> Receive:
    """The body once more, for the application."""
    waiting = [body]

    async def replay() -> Message:
        if waiting:
            return {"type": "http.request", "body": waiting.pop(), "more_body": False}
        return await receive()

    return replay


async def _refuse(send: Send, refused: RefusedError) -> None:
    body = json.dumps({"error": str(refused), "kind": "refused", "keys": {}}).encode()
    headers = [(b"content-type", b"application/json"), (b"content-length", str(len(body)).encode())]
    if refused.status in (408, 413):
        headers.append((b"connection", b"close"))
    await send({"type": "http.response.start", "status": refused.status, "headers": headers})
    await send({"type": "http.response.body", "body": body})


_KEY = r"[A-Za-z0-9_-]+(?:\.[A-Za-z0-9_-]+)+"
_KEYED = re.compile(rf"^({_KEY}(?:, {_KEY})*): (.+)$", re.DOTALL)


def require_type(request: Request, *allowed: str) -> None:
    """Refuse, by an ``HTTPException``, the types that a form of another site can send without asking first."""
    stated = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if stated not in allowed:
        raise HTTPException(415, f"the Content-Type must be {' or '.join(allowed)}")


def parsed(body: bytes) -> Any:
    """What the JSON document of a body says; an ``InputError`` if it is not JSON of Unicode texts."""
    try:
        document = json.loads(body, parse_constant=_no_constant)
        if b"\\ud" in body.lower():  # by such an escape, a text may hold half of a character
            json.dumps(document, ensure_ascii=False).encode()
    except UnicodeEncodeError:
        raise InputError(
            "the body is not valid JSON: a lone surrogate, half of a character, is no text"
        ) from None
    except (ValueError, RecursionError) as error:
        raise InputError(f"the body is not valid JSON: {error}") from None
    return document


def _no_constant(name: str) -> None:
    raise ValueError(f"{name} is not a number of JSON")


def errors_by_key(message: str, *, source: str) -> dict[str, str]:
    """The errors of a message by the key of the joint file that they are about."""
    messages = {}
    for line in message.removeprefix(f"{source}: ").split("\n  "):
        keyed = _KEYED.match(line)
        if keyed:
            messages.update(dict.fromkeys(keyed.group(1).split(", "), keyed.group(2)))
    return messages


def problem(error: AsperityError, *, source: str) -> JSONResponse:
    """The answer to a request that cannot be fulfilled: message, kind, and keys of the joint file called ``source``."""
    if isinstance(error, BusyError):
        return refusal(503, str(error), "busy")
    kind = "no_solution" if isinstance(error, NoSolutionError) else "input"
    return refusal(422, str(error), kind, errors_by_key(str(error), source=source))


def refusal(status: int, message: str, kind: str, keys: dict[str, str] | None = None) -> JSONResponse:
    """An answer that says what is wrong."""
    return JSONResponse({"error": message, "kind": kind, "keys": keys or {}}, status_code=status)
