"""``asperity roll``: creep, drift, losses and life of a joint that turns."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@plot_option("Draw creep curves, efficiency, drift and life: PNG, SVG or PDF.")
@json_option()
@click.option("--all", "in_full", is_flag=True, help="Print everything that is assumed, in full.")
@run_by_name
def roll() -> None:
    """Drift, losses, axial thrust and life of the joint described in FILE when it turns.

    Rollers that pass torque creep: the output falls behind with every turn, however stiff the joint is. The sections
    [rolling], [lubrication] and [[duty]] of FILE are optional; what they leave out is listed under 'Assumptions'.
    The JSON document is that of 'asperity joint'.
    With [[branch]] the last table says what each branch carries.
    """
