"""What the command of :mod:`asperity.cli.serve` does."""

from __future__ import annotations

import json
import signal
import webbrowser
from pathlib import Path
from typing import TYPE_CHECKING

from asperity.cli.terminal import in_unicode, say
from asperity.drive.types import DEFAULT_TYPE
from asperity.joint_file.edited_text import joint_file_text, with_measurement
from asperity.joint_file.reader import read_case
from asperity.joint_file.template import template
from asperity.page.joint_request import MEASUREMENT_FILE, JointRequest, shown_name
from asperity.page.server import is_loopback, listening_socket, require_packages
from asperity.page.server import serve as serve_page

if TYPE_CHECKING:
    from asperity.page.joint_request import JointRequest


def serve(file: str | None, port: int, no_browser: bool, host: str) -> None:
    """What ``asperity serve`` does; its options stand in :mod:`asperity.cli.serve`."""
    require_packages()
    start = _start(file) if file else JointRequest(name="zou2025.toml", text=_example())
    listening = listening_socket(host, port)
    if not is_loopback(host):
        say(
            f"asperity: warning: the page listens at {host}: every computer that reaches this address can use it, "
            "without a password and unencrypted"
        )

    def ready(address: str) -> None:
        say(f"asperity: {address} (Ctrl+C stops it)")
        if not no_browser:
            webbrowser.open(address)

    def stopping(stopped: KeyboardInterrupt) -> None:
        say("asperity: stopped" if type(stopped) is KeyboardInterrupt else "asperity: terminated")

    if signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)  # the server ends by itself
    try:
        serve_page(start, listening=listening, host=host, ready=ready, stopping=stopping)
    except KeyboardInterrupt as stopped:
        if type(stopped) is not KeyboardInterrupt:  # the system asked, which has an exit code of its own
            raise
        stopping(stopped)


def _start(file: str) -> JointRequest:
    """A joint file with its measured surface; entries of a library file of the user's are replaced by their numbers."""
    case = read_case(file)
    name, text = shown_name(Path(file).name), joint_file_text(case, {}, comment="")
    if case.measured is None:
        return JointRequest(name, text)
    return JointRequest(
        name, with_measurement(text, MEASUREMENT_FILE), surfaces=(in_unicode(json.loads(case.measured.text)),)
    )


def _example() -> str:
    """The text of the joint that 'asperity init' writes."""
    return template(DEFAULT_TYPE)
