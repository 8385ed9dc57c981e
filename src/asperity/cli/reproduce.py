"""``asperity reproduce``: the paper's cases, figures and claims, recomputed."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.option(
    "--out",
    type=click.Path(file_okay=False),
    help="Folder for the 14 panels (PNG and CSV), the tables (CSV) and the verdicts (JSON). It is "
    "created if it does not exist.",
)
@json_option("Print one JSON document instead of text.")
@run_by_name
def reproduce() -> None:
    """Recompute the cases and figures of Zou et al. 2025 and check its claims.

    Each claim is compared with computed numbers, by criteria that are printed with the verdicts. The exit code is
    0 whether or not the claims are met.
    """
