"""``asperity materials``: the library of materials, finishes and oils with their sources."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("name", required=False)
@click.option("--file", type=click.Path(), help="Your own library file; its materials are added.")
@click.option("--finishes-file", type=click.Path(), help="Your own library file; its finishes are added.")
@json_option("Print one JSON document; finishes and oils in SI units.")
@run_by_name
def materials() -> None:
    """List the library of materials, finishes and oils, or the entry NAME with its source.

    A joint file refers to a material by its name: [bodies] sun = "52100", or [materials.sun] library = "52100"
    to change some of its values. A finish limits the roughness of a design: { finish = "ground" }.
    An oil makes the friction: [lubrication] fluid = "M100".
    """
