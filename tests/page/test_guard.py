"""What a request must satisfy: an application that counts its calls stands behind the guard."""

import asyncio
import json

import pytest

from asperity.errors import InputError
from asperity.page.guard import SECURITY_HEADERS, Guard, errors_by_key, parsed

HOST = "127.0.0.1:8642"


class Counting:
    def __init__(self):
        self.bodies = []

    async def __call__(self, scope, receive, send):
        self.bodies.append((await receive())["body"])
        await send({"type": "http.response.start", "status": 200, "headers": []})
        await send({"type": "http.response.body", "body": b"done"})


def answer(guard, *, method="GET", path="/", headers=(), parts=(b"",), pause=0.0):
    """Status, headers and body of one request, whose body arrives in parts."""
    sent, waiting = [], list(parts)

    async def receive():
        await asyncio.sleep(pause)
        body = waiting.pop(0)
        return {"type": "http.request", "body": body, "more_body": bool(waiting)}

    async def send(message):
        sent.append(message)

    scope = {
        "type": "http",
        "method": method,
        "path": path,
        "headers": [(name.encode(), value.encode()) for name, value in headers],
    }
    asyncio.run(guard(scope, receive, send))
    return sent[0]["status"], dict(sent[0]["headers"]), sent[1]["body"]


@pytest.fixture
def counting():
    return Counting()


@pytest.fixture
def guard(counting):
    return Guard(counting, hosts=[HOST, "localhost:8642"], largest_body=100, longest_body=0.2)


def test_own_host_is_answered_with_the_policy(guard, counting):
    status, headers, body = answer(guard, headers=[("host", HOST)])
    assert (status, body) == (200, b"done")
    policy = headers[b"content-security-policy"].decode()
    assert "default-src 'none'" in policy
    assert "script-src 'self'" in policy
    assert "unsafe" not in policy
    assert headers[b"x-content-type-options"] == b"nosniff"


@pytest.mark.parametrize(
    "headers",
    [
        [("host", "evil.example:8642")],  # DNS rebinding: the name of the attacker points at 127.0.0.1
        [("host", "127.0.0.1:9999")],
        [("host", "127.0.0.1")],
        [("host", HOST), ("host", "evil.example")],
        [],
    ],
)
def test_another_host_is_refused(guard, counting, headers):
    status, sent, body = answer(guard, headers=headers)
    assert status == 421
    assert "another host" in json.loads(body)["error"]
    assert set(SECURITY_HEADERS) <= {name.decode() for name in sent}
    assert counting.bodies == []


@pytest.mark.parametrize(
    "extra",
    [
        ("origin", "http://evil.example"),
        ("origin", "https://127.0.0.1:8642"),
        ("origin", "http://127.0.0.1:9999"),
        ("origin", "null"),
        ("sec-fetch-site", "cross-site"),
        ("sec-fetch-site", "same-site"),
    ],
)
def test_posts_of_other_sites_are_refused(guard, counting, extra):
    status, _, body = answer(guard, method="POST", path="/api/joint", headers=[("host", HOST), extra])
    assert status == 403
    assert "other web sites" in json.loads(body)["error"]
    assert counting.bodies == []


def test_other_sites_cannot_read_the_interface_but_may_link_to_the_page(guard):
    across = [("host", HOST), ("sec-fetch-site", "cross-site")]
    assert answer(guard, path="/api/description", headers=across)[0] == 403
    assert answer(guard, path="/", headers=across)[0] == 200


def test_own_posts_and_those_of_scripts_are_answered(guard, counting):
    own = [("host", HOST), ("origin", f"http://{HOST}"), ("sec-fetch-site", "same-origin")]
    assert answer(guard, method="POST", headers=own, parts=[b"ab", b"c"])[0] == 200
    assert answer(guard, method="POST", headers=[("host", "LOCALHOST:8642")], parts=[b"d"])[0] == 200
    assert counting.bodies == [b"abc", b"d"]


@pytest.mark.parametrize("method", ["OPTIONS", "PUT", "DELETE", "TRACE", "CONNECT"])
def test_other_methods_are_refused(guard, counting, method):
    assert answer(guard, method=method, headers=[("host", HOST)])[0] == 405
    assert counting.bodies == []


@pytest.mark.parametrize(
    ("stated", "parts"),
    [
        ("101", [b""]),
        ("9" * 30, [b""]),
        ("-1", [b""]),
        ("1e3", [b""]),
        ("3", [b"x" * 60, b"x" * 60]),  # chunks that say less than they bring
    ],
)
def test_large_bodies_are_refused(guard, counting, stated, parts):
    found = answer(guard, method="POST", headers=[("host", HOST), ("content-length", stated)], parts=parts)
    assert found[0] == 413
    assert counting.bodies == []


def test_the_largest_body_is_read(guard, counting):
    assert answer(guard, method="POST", headers=[("host", HOST)], parts=[b"x" * 100])[0] == 200


def test_an_address_may_take_a_larger_body(counting):
    guard = Guard(counting, hosts=[HOST], largest_body=100, larger_bodies={"/upload": 200})
    send = {"method": "POST", "headers": [("host", HOST)]}
    assert answer(guard, path="/upload", parts=[b"x" * 100, b"x" * 100], **send)[0] == 200
    assert answer(guard, path="/upload", parts=[b"x" * 100, b"x" * 101], **send)[0] == 413
    assert answer(guard, path="/other", parts=[b"x" * 101], **send)[0] == 413
    assert len(counting.bodies) == 1


def test_a_slow_body_is_refused(guard, counting):
    status, _, body = answer(guard, method="POST", headers=[("host", HOST)], parts=[b"x"] * 20, pause=0.05)
    assert status == 408
    assert "0.2 s" in json.loads(body)["error"]
    assert counting.bodies == []


def test_web_sockets_are_closed(guard):
    sent = []

    async def run():
        async def send(message):
            sent.append(message)

        await guard({"type": "websocket", "headers": []}, None, send)

    asyncio.run(run())
    assert sent == [{"type": "websocket.close", "code": 1008}]


def test_messages_are_found_by_key():
    message = "a.toml: 2 errors\n  load.preload: bad\n  bodies.sun, bodies.ring: there is no material 'x'"
    assert errors_by_key(message, source="a.toml") == {
        "load.preload": "bad",
        "bodies.sun": "there is no material 'x'",
        "bodies.ring": "there is no material 'x'",
    }
    assert errors_by_key("the output torque is too large: lower it", source="a.toml") == {}


def test_half_a_character_is_no_text():
    """No answer could repeat it: UTF-8 has no lone surrogates."""
    assert parsed(b'{"a": "\\ud83d\\ude00", "b": "\\\\ud800"}') == {"a": "\U0001f600", "b": "\\ud800"}
    for body in (b'{"name": "\\ud800"}', b'[["\\uDCFC"]]', b'{"\\udfff": 1}'):
        with pytest.raises(InputError, match="the body is not valid JSON: a lone surrogate"):
            parsed(body)
