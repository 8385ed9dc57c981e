"""``asperity crown``: which crown takes up a tilt of the rollers."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option("--tilt", required=True, metavar="ANGLE", help="Angle between the axes, e.g. '0.5 mrad'.")
@json_option()
@run_by_name
def crown() -> None:
    """The crown radius and the logarithmic profile of every contact in FILE for a misalignment.

    Of the profiles that leave both ends of a tilted contact free, the one with the lowest peak pressure, under its
    largest normal force; with half and twice the drop at the ends for comparison, and as FILE crowns it.
    """
