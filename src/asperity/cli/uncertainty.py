"""``asperity uncertainty``: intervals of the results from the tolerances of a joint file."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option_of
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option("--samples", type=int, default=100_000, show_default=True, help="Monte-Carlo samples.")
@click.option(
    "--seed", type=click.IntRange(0), default=0, show_default=True, help="Seed of the random numbers."
)
@click.option(
    "--distribution",
    metavar="TEXT",
    help="For tolerances whose distribution the file does not state: 'uniform', 'triangular' or "
    "'normal K sigma' (the tolerance is K standard deviations).",
)
@click.option(
    "--results",
    multiple=True,
    metavar="NAMES",
    help="Results or groups of them, separated by commas, as for sweep.",
)
@click.option(
    "--branches",
    type=int,
    metavar="DRAWS",
    help="Draw the sizes of each planet and each other roller off the axis by themselves, so many times: torque of the "
    "first slip, load shares, force on the sun. Needs load.interference.",
)
@json_option("Print one JSON document in SI units.")
@plot_option_of(
    "uncertainty.png",
    "Draw the first result's histogram and Sobol indices, to uncertainty.png if no name is given.",
)
@run_by_name
def uncertainty() -> None:
    """Intervals of the results of the joint in FILE, and the contribution of each tolerance.

    Tolerances are written in the file, with a distribution behind a comma: planet_radius = "13.5 mm +- 5 um, uniform",
    preload = "1000 N +- 50 N, normal 2 sigma". Where load.interference makes the preload, a radius is that of a
    finished part, which deviates while all others stay as they are.
    """
