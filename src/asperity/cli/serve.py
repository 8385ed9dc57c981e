"""``asperity serve``: a local page in the browser."""

from __future__ import annotations

import json
import signal
from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import in_unicode, prepare_computation, say

if TYPE_CHECKING:
    from asperity.page.joint_request import JointRequest


@click.command()
@click.argument("file", type=click.Path(), required=False)
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=8642,
    show_default=True,
    help="Port of the page; 0 for a free one.",
)
@click.option("--no-browser", is_flag=True, help="Print the address only; do not open the browser.")
@click.option(
    "--host",
    default="127.0.0.1",
    show_default=True,
    help="Address to listen at. Any other than the loopback address lets other computers use the page.",
)
def serve(file: str | None, port: int, no_browser: bool, host: str) -> None:
    """Open the joint described in FILE as a page in the browser, or an example joint without FILE.

    The page shows the drive to scale with its forces, stiffness, drift, safety margins, warnings and curves. Every
    number has a slider and a field that takes any unit; all results follow at once. A joint file can be opened from the
    page and saved from it. The address of the page contains the joint, so that a link shows the same joint.

    The page runs on this computer, needs no network, and other computers cannot reach it. Ctrl+C stops it. Scripts can
    use the same JSON interface: /openapi.json describes it.
    """
    from asperity.page.joint_request import JointRequest
    from asperity.page.server import is_loopback, listening_socket, require_packages
    from asperity.page.server import serve as serve_page

    require_packages()
    start = _start(file) if file else JointRequest(name="zou2025.toml", text=_example())
    listening = listening_socket(host, port)
    prepare_computation()
    if not is_loopback(host):
        say(
            f"asperity: warning: the page listens at {host}: every computer that reaches this address can use it, "
            "without a password and unencrypted"
        )

    def ready(address: str) -> None:
        say(f"asperity: {address} (Ctrl+C stops it)")
        if not no_browser:
            import webbrowser

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
    from asperity.joint_file.edited_text import joint_file_text, with_measurement
    from asperity.joint_file.reader import read_case
    from asperity.page.joint_request import MEASUREMENT_FILE, JointRequest, shown_name

    case = read_case(file)
    name, text = shown_name(Path(file).name), joint_file_text(case, {}, comment="")
    if case.measured is None:
        return JointRequest(name, text)
    return JointRequest(
        name, with_measurement(text, MEASUREMENT_FILE), surfaces=(in_unicode(json.loads(case.measured.text)),)
    )


def _example() -> str:
    """The text of the joint that 'asperity init' writes."""
    from importlib.resources import files

    return files("asperity.joint_file").joinpath("zou2025.toml").read_text(encoding="utf-8")
