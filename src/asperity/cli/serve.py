"""``asperity serve``: a local page in the browser."""

from __future__ import annotations

import click

from asperity.cli.run_by_name import run_by_name


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
@run_by_name
def serve() -> None:
    """Open the joint described in FILE as a page in the browser, or an example joint without FILE.

    The page shows the drive to scale with its forces, stiffness, drift, safety margins, warnings and curves. Every
    number has a slider and a field that takes any unit; all results follow at once. A joint file can be opened from the
    page and saved from it. The address of the page contains the joint, so that a link shows the same joint.

    The page runs on this computer, needs no network, and other computers cannot reach it. Ctrl+C stops it. Scripts can
    use the same JSON interface: /openapi.json describes it.
    """
