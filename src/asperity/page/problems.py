"""Answers to requests that are wrong, with the message of the command line and the keys that it is about."""

from __future__ import annotations

import json
import re
from typing import Any

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse

from asperity.errors import AsperityError, InputError, NoSolutionError
from asperity.page.computation import BusyError

_KEY = r"[A-Za-z0-9_-]+(?:\.[A-Za-z0-9_-]+)+"
_KEYED = re.compile(rf"^({_KEY}(?:, {_KEY})*): (.+)$", re.DOTALL)


def require_type(request: Request, *allowed: str) -> None:
    """Refuse, by an ``HTTPException``, the types that a form of another site can send without asking first."""
    stated = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if stated not in allowed:
        raise HTTPException(415, f"the Content-Type must be {' or '.join(allowed)}")


def parsed(body: bytes) -> Any:
    """What the JSON document of a body says; an ``InputError`` if it is not JSON."""
    try:
        return json.loads(body, parse_constant=_no_constant)
    except (ValueError, RecursionError) as error:
        raise InputError(f"the body is not valid JSON: {error}") from None


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
    """The answer to a request that cannot be fulfilled.

    Parameters
    ----------
    error : AsperityError
        Why.
    source : str
        Name of the file at the beginning of its message.

    Returns
    -------
    JSONResponse
        Message, kind, and keys of the joint file.
    """
    if isinstance(error, BusyError):
        return refusal(503, str(error), "busy")
    kind = "no_solution" if isinstance(error, NoSolutionError) else "input"
    return refusal(422, str(error), kind, errors_by_key(str(error), source=source))


def refusal(status: int, message: str, kind: str, keys: dict[str, str] | None = None) -> JSONResponse:
    """An answer that says what is wrong."""
    return JSONResponse({"error": message, "kind": kind, "keys": keys or {}}, status_code=status)
