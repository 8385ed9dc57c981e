"""``asperity film``: the oil in the contacts of a joint over speed, at one or more temperatures."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--temperature",
    "temperatures",
    help="Temperatures of the oil, at most six, such as '20,40,80 degC'; fits and preload stay those of the file.  "
    "[default: that of the file]",
)
@click.option(
    "--from",
    "start",
    help="Lowest speed of the input, such as '1 rpm'.  [default: a thousandth of the speed of the file]",
)
@click.option(
    "--to", "stop", help="Highest speed of the input likewise.  [default: twice the speed of the file]"
)
@click.option(
    "--points",
    type=int,
    default=25,
    show_default=True,
    help="Speeds, evenly over their logarithm; that of the file comes in addition.",
)
@plot_option("Draw traction capacity and share of the asperities over speed: PNG, SVG or PDF.")
@json_option()
@run_by_name
def film() -> None:
    """Oil in the contacts of the joint described in FILE over speed (Stribeck curves).

    For every contact: central and minimum film, film ratio λ, share of the load that the asperities carry, largest
    traction coefficient, and creepage under the torque of FILE; for the joint: drift and efficiency. FILE needs an oil
    whose traction is known, [lubrication] fluid: 'asperity materials' lists them.
    """
