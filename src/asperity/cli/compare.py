"""``asperity compare``: two joint files side by side."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("one", type=click.Path())
@click.argument("other", type=click.Path())
@json_option("Print all differences as one JSON document in SI units.")
@click.option(
    "--all", "in_full", is_flag=True, help="Show every result that differs, not only the main ones."
)
@run_by_name
def compare() -> None:
    """What differs between the joints in ONE and OTHER: what the files say, and what comes out."""
