"""``asperity calibrate``: unknowns of a joint from measured curves."""

from __future__ import annotations

import click

from asperity.cli.options import json_option
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.argument("data", type=click.Path(), nargs=-1, required=True)
@click.option("-u", "--unknown", "unknowns", multiple=True, required=True, metavar="KEY[=LOWER:UPPER]",
              help="A number of FILE, for example play.angle, or offset, drift; repeat for several.")  # fmt: skip
@click.option("--level", default="assembly", show_default=True,
              type=click.Choice(["published", "series_with_bulk", "assembly"]),
              help="Stiffness that is fitted.")  # fmt: skip
@click.option("--history", default="virgin", show_default=True, type=click.Choice(["virgin", "cycled"]),
              help="Joint before the first row: never loaded, or cycled to the largest torque.")  # fmt: skip
@click.option("--model-error", default="5 %", show_default=True,
              help="Standard deviation of the joint's compliance by the model; 0 for the scatter alone.")  # fmt: skip
@click.option(
    "--starts", default=4, show_default=True, type=click.IntRange(1, 1000), help="Starts of the search."
)
@click.option("--seed", default=1, show_default=True, type=click.IntRange(0), help="Of starts and draws.")
@click.option("--out", type=click.Path(), help="Write the calibrated joint as a joint file.")
@click.option("--plot", type=click.Path(), help="Draw data, fit and residuals (.png, .svg, .pdf).")
@click.option("--posterior", "draws", type=click.IntRange(50, 100000), metavar="DRAWS",
              help="Also draw from the posterior, this number from each of four chains (extra 'bayes').")  # fmt: skip
@click.option("--plot-posterior", type=click.Path(), help="Draw the posterior (.png, .svg, .pdf).")
@json_option()
@run_by_name
def calibrate() -> None:
    """Fit numbers of the joint file FILE to the measured curve DATA, or to two curves together.

    DATA is a CSV file with a column torque and one of angle, stiffness, drift (angle lost per output turn), speed loss
    or speed ratio (input over output), if wanted time and repetition; units in the header, e.g. 'torque [N*m]',
    'angle [arcmin]', 'drift [arcmin/turn]', 'speed loss [%]'. Rows in the order of time: the hysteresis of a
    torque-angle curve follows the history. A curve of the joint at rest and a drift curve can be fitted together:
    give both files; 'offset of drift' is then the offset of the drift curve.

    A misfit beyond the curve's own scatter, and an unknown that ends at a bound, are said; a fit that leaves a quarter
    of the curve unexplained ends with exit code 3.
    """
