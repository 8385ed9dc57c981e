"""``asperity tolerances``: which deviations of the sizes of a joint file are allowed."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option("--keep", "keep", multiple=True, required=True, metavar="RESULT>=VALUE",
              help="A limit, for example 'torque_capacity>=12 N*m', 'drive_life>=5000 h', 'stiffness>=8e5 N*m/rad' or "
              "'hertz_pressure<=1500 MPa'; repeat for several. Of form errors: "
              "'transmission_error<=20 arcsec', 'transmission_error_rms<=5 arcsec', "
              "'turn_slip_ratio<=0.9'.")  # fmt: skip
@click.option(
    "--share", default="99.9 %", show_default=True, help="Share of the drives that keep all limits."
)
@click.option("--sharing", type=click.Choice(["equal", "grade", "cost", "stated"]),
              help="The same deviation of all radii, the same grade, or the least cost, of 1/t each; of form "
              "errors also in the proportions that FILE states.  [default: grade, of form errors stated]")  # fmt: skip
@click.option("--distribution", default="uniform", show_default=True, metavar="TEXT",
              help="Of the sizes within their deviations, as for 'asperity uncertainty'.")  # fmt: skip
@click.option("--samples", default=10_000, show_default=True, type=click.IntRange(100, 1_000_000),
              help="Drives of each try.")  # fmt: skip
@click.option("--seed", default=0, show_default=True, type=click.IntRange(0), help="Of the random numbers.")
@json_option("Print one JSON document in SI units.")
@run_by_name
def tolerances() -> None:
    """The deviations of the sizes in FILE with which nearly all drives keep stated limits, as grades of ISO 286-1.

    The preload must be made by load.interference. Tolerances that FILE states are not used: its other numbers are
    exact. All parts of one size deviate alike; 'asperity uncertainty --branches' draws them one by one.

    With limits of form errors: runout and roundness of the parts that FILE states in [[form]], to first order.
    """
