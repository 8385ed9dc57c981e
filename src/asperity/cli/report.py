"""``asperity report``: one document about a joint for a design review."""

from __future__ import annotations

import click

from asperity.cli.options import surface_option, title_options
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--out",
    default="report.html",
    show_default=True,
    type=click.Path(dir_okay=False),
    help="Write the report to this file: .html or .pdf.",
)
@surface_option
@click.option("--sensitivity", is_flag=True, help="Add how much every number of the file moves the results.")
@click.option(
    "--tolerances",
    is_flag=True,
    help="Add intervals of the results from the tolerances that the file states.",
)
@click.option(
    "--distribution",
    metavar="TEXT",
    help="For tolerances whose distribution the file does not state, as for 'asperity uncertainty'.",
)
@click.option(
    "--design",
    "design_file",
    type=click.Path(),
    metavar="DESIGN",
    help="Add the design of this joint that the design file DESIGN asks for: before and after, with its limits.",
)
@title_options
@run_by_name
def report() -> None:
    """Write one document about the joint described in FILE: inputs, drawing, results, margins and warnings.

    The report contains everything that a design review asks for, and the joint file itself, from which it can be
    made again. The same input gives the same report, byte for byte. HTML is one file without scripts; PDF needs the
    optional package typst.
    """
