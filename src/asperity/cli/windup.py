"""``asperity windup``: torque–angle curve, hysteresis loop and catalogue stiffness; the angle behind once it turns."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name
from asperity.standing import STAGE_SHARES

LEVELS = ("assembly", "series_with_bulk", "published")


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--torque",
    help="Largest output torque of the curve, with its unit, e.g. '10 N*m'; default: the file's output torque. "
    "The curve covers both directions, so the sign does not matter.",
)
@click.option(
    "--level",
    type=click.Choice(LEVELS),
    default="assembly",
    show_default=True,
    help="Level of the stiffness that is integrated.",
)
@click.option(
    "--stages",
    type=(float, float),
    default=STAGE_SHARES,
    show_default="one and two thirds",
    help="Torques at which K1 ends and K3 begins, as shares of the largest torque.",
)
@click.option(
    "--creep-share",
    type=float,
    default=0.05,
    show_default=True,
    help="For an input that turns: creep over wind-up up to which the static curve is said to hold.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the curves to this CSV file.")
@click.option(
    "--rolling-csv",
    "rolling_file",
    type=click.Path(dir_okay=False),
    help="Write the angle behind over the angle turned, and the drift of swings, to this CSV file.",
)
@plot_option("Draw the curves: PNG, SVG or PDF.")
@json_option("Print one JSON document in SI units instead of a table.")
@run_by_name
def windup() -> None:
    """Wind-up of the joint described in FILE: torque–angle curve, hysteresis, lost motion, K1/K2/K3, capacity.

    The output turns against the locked input, play included. The loop runs between plus and minus the largest torque.
    It is an estimate, because the normal forces change with the torque.

    Stiffness holds for an input that stands. Once it turns under torque, the contacts creep and the output drifts:
    the second table says from which angle on, and by how much. 'asperity roll' has more on the drift.
    """
