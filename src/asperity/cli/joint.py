"""``asperity joint``: from a joint file to its stiffness."""

from __future__ import annotations

import click

from asperity.cli.options import json_option, plot_option, surface_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@json_option()
@click.option(
    "--all",
    "in_full",
    is_flag=True,
    help="Print the shares of the compliance, the springs of the contacts and the drive, too, and all that is assumed.",
)
@surface_option
@plot_option("Draw the stiffness budget, the levels and the safety margins: PNG, SVG or PDF.")
@run_by_name
def joint() -> None:
    """Forces, contacts, torsional stiffness, torque capacity and warnings of the joint described in FILE.

    FILE is a TOML file; 'asperity init' writes one with comments. With --surface a measured surface takes the
    place of the file's, as surface.measurement in the file does: both bodies of a contact have it, unless it is that of
    the pair. It gives the rms of the heights that each contact feels, or
    with model.contact_law = "zou_2025" D and G. What is not certain about it, and the error of the contact law, come
    out as an interval of stiffness and drift. So does what Ra leaves open where the file states surfaces by their Ra.
    If the surface serves several contact laws, stiffness and drift by each of them stand side by side.
    """
