"""``asperity accuracy``: transmission error, forces and input torque over a turn of a joint with form errors."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--reverse",
    is_flag=True,
    help="The other direction of rotation under the same torque too, and by how much both differ at the same position.",
)
@click.option(
    "--allowed",
    help="Error of the position that is allowed, such as '5 arcmin': after how many turns the joint has to find its "
    "reference again.",
)
@click.option(
    "--uncertainty",
    help="Uncertainty of the drift by which a controller corrects the position, such as '20 %'.  [default: nothing "
    "corrects it]",
)
@plot_option(
    "Draw the orders, and one turn of the output as a curve and as a polar picture: PNG, SVG or PDF."
)
@json_option()
@run_by_name
def accuracy() -> None:
    """Transmission error over a turn of the joint described in FILE, from runout and roundness of its parts.

    For every harmonic of every section [[form]]: order, transmission error, change of the input torque and of the force
    of the contact that it changes most; for the joint and each contact: worst and root mean square over phases that are
    not known, and whether a contact may slip.
    """
