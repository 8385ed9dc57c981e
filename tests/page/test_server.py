"""Where the server listens, and under which names it answers."""

import contextlib
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.request

import pytest

from asperity.errors import InputError, MissingExtraError
from asperity.page import server as module
from asperity.page.server import host_names, is_loopback, listening_socket, require_packages

uvicorn = pytest.importorskip("uvicorn")

HALF = b"GET / HTTP/1.1\r\nHost: x\r\nX-Slow: "


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("127.0.0.1", True),
        ("127.1.2.3", True),
        ("::1", True),
        ("localhost", True),
        ("0.0.0.0", False),
        ("::", False),
        ("192.168.1.2", False),
        ("localhost.example.com", False),
    ],
)
def test_loopback(host, expected):
    assert is_loopback(host) is expected


def test_the_socket_is_on_the_loopback_address():
    with listening_socket("127.0.0.1", 0) as found:
        assert found.getsockname()[0] == "127.0.0.1"


def test_a_port_in_use_is_said():
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        port = other.getsockname()[1]
        with pytest.raises(InputError, match=f"port {port}.*choose another port"):
            listening_socket("127.0.0.1", port)


def test_an_unknown_address_is_said():
    with pytest.raises(InputError, match="unknown"):
        listening_socket("no such host", 0)


@pytest.mark.parametrize("host", ["0.0.0.0", "::", ""])
def test_all_addresses_at_once_are_refused(host):
    with pytest.raises(InputError, match=r"all addresses|unknown"):
        listening_socket(host, 0)


def test_names_of_the_host():
    assert host_names("127.0.0.1", 8642) == ("127.0.0.1:8642", "localhost:8642", "[::1]:8642")
    assert "192.168.1.2:80" in host_names("192.168.1.2", 80)
    assert "192.168.1.2" in host_names("192.168.1.2", 80)


def test_missing_packages_are_said_with_the_command(monkeypatch):
    monkeypatch.setitem(sys.modules, "starlette", None)
    with pytest.raises(MissingExtraError, match=r"starlette.*\[page\]"):
        require_packages()


#: A server whose every answer takes a minute, with a handler of SIGINT: a process that a script starts in the
#: background ignores it.
SLOW = """
import signal, sys, time
signal.signal(signal.SIGINT, signal.{handler})
from asperity.page import application
application.joint_answer = lambda request: print("computing", file=sys.stderr, flush=True) or time.sleep(60)
from asperity.cli import main
main()
"""


@pytest.mark.slow
@pytest.mark.parametrize("handler", ["default_int_handler", "SIG_IGN"])
def test_an_interruption_during_a_computation_says_that_it_stopped_and_no_more(joint_text, handler):
    command = [sys.executable, "-c", SLOW.format(handler=handler), "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as server:
        said = server.stderr.readline() + server.stderr.readline()  # it computes its first joint as it starts
        assert "computing" in said
        address = re.search(r"http://\S+", said).group()
        body = json.dumps({"toml": joint_text}).encode()
        request = urllib.request.Request(f"{address}api/joint", body, {"content-type": "application/json"})

        def ask():
            with pytest.raises(OSError, match=r"."):
                urllib.request.urlopen(request, timeout=30)

        asking = threading.Thread(target=ask)
        asking.start()
        time.sleep(1.0)
        server.send_signal(signal.SIGINT)
        assert server.stderr.read().split() == ["asperity:", "stopped"]
        asking.join()
    assert server.returncode == 0


#: A server that is about to compile something for an hour, for whatever reason, and whose computations are done.
COMPILING = """
import sys, time
from asperity import compilation
from asperity.page import application
def answer(request):
    compilation._compilers().submit(time.sleep, 3600.0)
    print("computed", file=sys.stderr, flush=True)
    return {}
application.joint_answer = answer
from asperity.cli import main
main()
"""


def test_a_server_that_has_nothing_to_compute_does_not_wait_for_what_is_compiled():
    command = [sys.executable, "-c", COMPILING, "serve", "--port", "0", "--no-browser"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as server:
        assert "computed" in server.stderr.readline() + server.stderr.readline()
        server.send_signal(signal.SIGINT)
        assert server.stderr.read().split() == ["asperity:", "stopped"]
        server.wait(timeout=100)
    assert server.returncode == 0


@pytest.mark.slow
def test_the_folder_of_a_job_is_gone_when_the_server_has_ended(tmp_path, joint_text):
    command = [sys.executable, "-c", COMPILING, "serve", "--port", "0", "--no-browser"]
    environment = {**os.environ, "TMPDIR": str(tmp_path)}
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True, env=environment) as server:
        address = re.search(r"http://\S+", server.stderr.readline() + server.stderr.readline()).group()
        body = json.dumps({"toml": joint_text, "job": {"kind": "sensitivity"}}).encode()
        kind = {"content-type": "application/json"}
        urllib.request.urlopen(urllib.request.Request(f"{address}api/jobs", body, kind), timeout=60).close()
        while not list(tmp_path.glob("asperity-page-*/*")):
            time.sleep(0.01)
        server.send_signal(signal.SIGINT)
        server.wait(timeout=100)
    assert list(tmp_path.glob("asperity-page-*")) == []


async def _application(scope, receive, send):
    await _answered(scope, receive, send)


async def _answered(scope, receive, send):
    if scope["type"] != "http":
        return
    size = 20_000_000 if scope["path"] == "/large" else 2
    head = [(b"content-length", str(size).encode())]
    await send({"type": "http.response.start", "status": 200, "headers": head})
    await send({"type": "http.response.body", "body": b"o" * size})


@pytest.fixture
def port(monkeypatch):
    monkeypatch.setattr(module, "LONGEST_HEADER", 1.0)
    monkeypatch.setattr(module, "LONGEST_READING", 1.0)
    config = uvicorn.Config(
        _application,
        http=module.impatient_protocol(),
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


def test_a_burst_that_is_accepted_before_it_is_read_is_answered(port, monkeypatch):
    """The requests are there before the first one is accepted, as the loop stands still meanwhile."""
    stands, goes_on, answered = threading.Event(), threading.Event(), _answered

    async def standing(scope, receive, send):
        if scope["path"] == "/stand":
            stands.set()
            goes_on.wait(10.0)
        await answered(scope, receive, send)

    monkeypatch.setattr(sys.modules[__name__], "_answered", standing)
    first = _connected(port, b"GET /stand HTTP/1.1\r\nHost: x\r\n\r\n")
    assert stands.wait(10.0)
    burst = [_connected(port, b"GET / HTTP/1.1\r\nHost: x\r\n\r\n") for _ in range(60)]
    goes_on.set()
    for each in (first, *burst):
        assert each.recv(1000).startswith(b"HTTP/1.1 200")
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


@pytest.mark.slow
def test_half_a_request_after_an_answer_is_not_waited_for(port):
    client = _connected(port, b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
    assert client.recv(1000).startswith(b"HTTP/1.1 200")
    client.sendall(HALF)
    assert 1.0 < _seconds_until_closed(client) < 6.0
    client.close()


@pytest.mark.slow
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
