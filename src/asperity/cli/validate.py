"""``asperity validate``: evidence that this installation computes correctly."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@json_option("Print one JSON document instead of a table.")
@click.option(
    "--out",
    type=click.Path(),
    metavar="FILE",
    help="Also write the evidence to a file: .pdf or .html, to read and print, or .json.",
)
@run_by_name
def validate() -> None:
    """Recompute published and independent results with this installation, and compare.

    The references are tables by quadrature, decks of CONTACT, closed forms, independent solvers and the paper's
    figures. For each check: what was found and expected, how far they differ, the tolerance, and the source. The exit
    code is 1 if any check fails.
    """
