"""``asperity loads``: what pins, bearings, shafts and housing carry."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--mounting-gap",
    default="0 um",
    show_default=True,
    metavar="LENGTH",
    help="Radial gap between a ring and its rollers while it is slipped on.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the table to this CSV file.")
@json_option("Print one JSON document in SI units instead of a table.")
@run_by_name
def loads() -> None:
    """Forces and torques on pins, bearings, shafts and housing of the joint described in FILE, for their supplier.

    And the force, or the temperature, that mounts its rings, and their stress. One column each: without torque, under
    the working torque, and under every load [[duty]] of FILE. With [tilt] also what its tilted axes do to the contacts.
    """
