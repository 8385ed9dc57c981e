"""``asperity compare``: two joint files side by side."""

from __future__ import annotations

import click

from asperity.cli.terminal import json_option, prepare_computation, print_json, show_blocks


@click.command()
@click.argument("one", type=click.Path())
@click.argument("other", type=click.Path())
@json_option("Print all differences as one JSON document in SI units.")
@click.option(
    "--all", "in_full", is_flag=True, help="Show every result that differs, not only the main ones."
)
def compare(one: str, other: str, as_json: bool, in_full: bool) -> None:
    """What differs between the joints in ONE and OTHER: what the files say, and what comes out."""
    prepare_computation()
    from asperity.api.comparison import compare as compared

    comparison = compared(one, other)
    if as_json:
        print_json(comparison.document())
        return
    show_blocks(*comparison.blocks(in_full=in_full))
