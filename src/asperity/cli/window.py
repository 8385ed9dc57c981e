"""``asperity window``: the torques that a joint may pass over temperature or preload, and what limits them."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--over",
    type=click.Choice(("temperature", "preload")),
    help="Axis of the window: the working temperature, or the preload or interference that the file states.  [default: "
    "temperature where the preload or a seat in a housing depends on it, else preload]",
)
@click.option(
    "--from",
    "start",
    help="Start of the axis with its unit, such as '-20 degC', '400 N' or '20 um'.  [default: below the temperatures "
    "of the file, or a quarter of its preload]",
)
@click.option(
    "--to",
    "stop",
    help="End of the axis likewise.  [default: above the temperatures of the file, or twice its preload, up to eight "
    "times where slip governs no longer there]",
)
@click.option(
    "--points",
    type=int,
    default=25,
    show_default=True,
    help="Places on the axis; those at which another limit governs come in addition.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the limits to this CSV file.")
@plot_option("Draw the window: PNG, SVG or PDF.")
@json_option()
@run_by_name
def window() -> None:
    """Torques that the joint described in FILE may pass over temperature or preload, and what limits them where.

    One picture for a decision: below, the joint passes the torque; above, a contact slips, something yields, the life
    is too short, or the ring turns in its housing. The torque of the file and the loads of its [[duty]] are judged in
    it. Where the preload has tolerances ('30 um +- 3 um', radii of rollers), the least and the greatest capacity of
    parts within them are a band.
    """
