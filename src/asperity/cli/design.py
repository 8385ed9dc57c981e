"""``asperity design``: the best joint within limits, or a Pareto front of several objectives."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option("--out", type=click.Path(), help="Write the designed joint as a joint file (a front: as .csv).")
@click.option(
    "--plot",
    type=click.Path(),
    help="Draw the objective along each variable, or the front (.png, .svg, .pdf).",
)
@click.option(
    "--map",
    "map_file",
    type=click.Path(),
    help="Draw where two variables meet all limits, with the line of each limit (.png, .svg, .pdf).",
)
@click.option(
    "--map-over",
    nargs=2,
    metavar="VARIABLE VARIABLE",
    help="The two variables of the map; by default the first two.",
)
@json_option()
@click.option(
    "--population",
    default=100,
    show_default=True,
    type=click.IntRange(8, 5000),
    help="Designs of a generation (front).",
)
@click.option(
    "--generations",
    default=150,
    show_default=True,
    type=click.IntRange(1, 10000),
    help="Generations (front).",
)
@run_by_name
def design() -> None:
    """Choose the free variables of a joint as specified in the design file FILE.

    FILE is a TOML file that names a joint file, free variables with bounds, one objective (or two or three for a
    Pareto front), limits, and the torques and tolerances for which they must hold. Where no design meets all limits,
    the command says which of them conflict and by how much, and ends with exit code 3.
    """
