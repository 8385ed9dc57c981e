"""``asperity wear``: how the tracks of a joint wear, and how long it then carries its load."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--life",
    help="Life that the joint is to reach, such as '10000 h'.  [default: rolling.required_life of the file]",
)
@plot_option("Draw preload, torque capacity and drift over time, with both ends: PNG, SVG or PDF.")
@json_option()
@run_by_name
def wear() -> None:
    """Wear of the joint described in FILE, under its torque or its duty, by Archard's law.

    Depths of all tracks, interference, preload, torque capacity and drift over time; when the first contact slides, and
    when nothing is left; and the wear coefficient that a life allows. FILE states load.interference, or a cam, and its
    wear coefficient in [wear]; without one times are products with it.
    """
