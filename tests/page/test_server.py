"""Where the server listens, and under which names it answers."""

import json
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
from asperity.page.server import host_names, is_loopback, listening_socket, require_packages


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
