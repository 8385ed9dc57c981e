"""``asperity dynamics``: natural frequencies and frequency response of a joint between motor and load."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@plot_option("Draw the frequency response, and the natural frequencies over torque: PNG, SVG or PDF.")
@click.option(
    "--csv",
    "csv_file",
    type=click.Path(dir_okay=False),
    help="Write the frequency response to this CSV file.",
)
@json_option()
@run_by_name
def dynamics() -> None:
    """Natural frequencies and frequency response of the joint described in FILE, with motor and load.

    The section [dynamics] of FILE gives the inertias of motor and load. The joint is linear about its output torque.
    While it turns, creep acts as a damper in series with its spring.
    """
