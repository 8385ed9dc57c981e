"""Clients that say nothing, say it slowly, or do not listen: a server with short limits sends them away."""

import contextlib
import http.client
import socket
import threading
import time

import pytest

from asperity.page import slow_clients

uvicorn = pytest.importorskip("uvicorn")

HALF = b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: "


async def _application(scope, receive, send):
    if scope["type"] != "http":
        return
    size = 20_000_000 if scope["path"] == "/large" else 2
    head = [(b"content-length", str(size).encode())]
    await send({"type": "http.response.start", "status": 200, "headers": head})
    await send({"type": "http.response.body", "body": b"o" * size})


@pytest.fixture
def port(monkeypatch):
    monkeypatch.setattr(slow_clients, "LONGEST_HEADER", 1.0)
    monkeypatch.setattr(slow_clients, "LONGEST_READING", 1.0)
    config = uvicorn.Config(
        _application,
        http=slow_clients.impatient_protocol(),
        lifespan="off",
        log_config=None,
        limit_concurrency=64,
        timeout_keep_alive=2,
    )
    server = uvicorn.Server(config)
    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        yield listening.getsockname()[1]
        server.should_exit = True
        thread.join()


def _connected(port, said=b""):
    found = socket.create_connection(("127.0.0.1", port), timeout=10.0)
    found.sendall(said)
    return found


def _status(port, path="/"):
    asking = http.client.HTTPConnection("127.0.0.1", port, timeout=10.0)
    asking.request("GET", path)
    status = asking.getresponse().status
    asking.close()
    return status


def _seconds_until_closed(connection):
    start = time.perf_counter()
    with contextlib.suppress(ConnectionResetError):
        while connection.recv(65536):
            pass
    return time.perf_counter() - start


@pytest.mark.parametrize("said", [b"", b"G", HALF])
def test_the_page_answers_beside_a_hundred_clients_that_have_not_finished_asking(port, said):
    clients = [_connected(port, said) for _ in range(100)]
    assert _status(port) == 200
    assert 0.5 < _seconds_until_closed(clients[-1]) < 5.0
    assert _status(port) == 200
    for each in clients:
        each.close()


def test_a_letter_at_a_time_gains_no_time(port):
    client = _connected(port, HALF)
    start = time.perf_counter()
    with contextlib.suppress(OSError):
        while time.perf_counter() - start < 8.0:
            client.sendall(b"x")
            time.sleep(0.1)
    assert time.perf_counter() - start < 5.0
    client.close()


def test_half_a_request_after_an_answer_is_not_waited_for(port):
    client = _connected(port, b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
    assert client.recv(1000).startswith(b"HTTP/1.1 200")
    client.sendall(HALF)
    assert 1.0 < _seconds_until_closed(client) < 6.0
    client.close()


def test_whoever_does_not_read_the_answer_is_left(port):
    client = _connected(port, b"GET /large HTTP/1.1\r\nHost: x\r\n\r\n")
    time.sleep(3.0)
    received = 0
    with contextlib.suppress(ConnectionResetError):
        while part := client.recv(65536):
            received += len(part)
    assert 0 < received < 20_000_000
    client.close()


def test_whoever_reads_gets_all_and_may_ask_again(port):
    asking = http.client.HTTPConnection("127.0.0.1", port, timeout=10.0)
    for path in ("/large", "/", "/"):
        asking.request("GET", path)
        assert len(asking.getresponse().read()) in (2, 20_000_000)
        time.sleep(0.2)
    asking.close()
