"""``asperity sensitivity``: the influence of every number of a joint file on the results."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option_of
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--result",
    default="assembly_stiffness_output",
    show_default=True,
    metavar="NAME",
    help="The result to rank by, e.g. torque_capacity, slip_ratio_sp (of one contact) or self_locking_ratio.",
)
@json_option("Print all results as one JSON document in SI units.")
@plot_option_of("sensitivity.png", "Draw a tornado plot, to sensitivity.png if no name is given.")
@run_by_name
def sensitivity() -> None:
    """Exact derivatives and elasticities of the joint in FILE with respect to every number in it.

    An elasticity of 2 says that one per cent more of the number makes about two per cent more of the result. A radius
    is that of another drive, as for sweep: the bore of a ring that follows from the rollers follows it. Where
    load.interference makes the preload, "(finished part)" is the row of a part that deviates while all others stay as
    they are, as for uncertainty and tolerances.
    """
