"""``asperity sweep``: a joint file evaluated on a grid of any of its numbers."""

from __future__ import annotations

import click

from asperity.cli.options import plot_option_of
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--over",
    "axes",
    multiple=True,
    required=True,
    metavar="KEY=START:STOP:COUNT[:log]",
    help="An axis: any numeric key of the joint file, with units, e.g. 'load.output_torque=0 N*m:5 N*m:11'. "
    "Repeat for more axes.",
)
@click.option(
    "--results",
    multiple=True,
    default=("all",),
    show_default="all",
    metavar="NAMES",
    help="Results or groups of them, separated by commas: stiffness, assembly, series, published, forces, contacts, "
    "diagnostics, geometry, size, residuals, capacity, rolling, losses, life, wear, heat, accuracy, loads, bearings, "
    "seats, stresses, or all, which leaves out stresses, wear and accuracy, because they take longest. Only these are "
    "computed.",
)
@click.option(
    "--out",
    type=click.Path(),
    help="Where to write: a folder .zarr (any size, can be continued after an interruption) or a file .nc, "
    ".parquet or .csv.",
)
@click.option(
    "--units",
    multiple=True,
    metavar="UNITS",
    help="Units of what is printed and of the file, separated by commas, e.g. 'N*m/arcmin,um,MPa'; each for everything "
    "that it measures. By default a file is in SI units. A folder .zarr always is.",
)
@click.option("--overwrite", is_flag=True, help="Replace what an earlier run has written to --out.")
@plot_option_of("sweep.png", "Draw the sweep to an image, sweep.png if no name is given.")
@click.option("--plot-result", metavar="NAME", help="Which result to draw instead of the stiffness.")
@click.option(
    "--limit",
    "limits",
    multiple=True,
    metavar="NAME<=VALUE",
    help="A limit whose line the map of two axes shows, e.g. 'mass<=1.2 kg' or 'torque_safety>=1.5'. Repeat for more. "
    "By default the limits of the model for the results that are computed.",
)
@click.option(
    "--scheduler",
    metavar="tcp://HOST:PORT",
    help="Address of a running Dask scheduler; needs an --out of type .zarr.",
)
@click.option(
    "--workers",
    type=click.IntRange(0),
    help="Number of local processes for an --out of type .zarr; by default one for each core if the sweep is large, "
    "otherwise none.",
)
@run_by_name
def sweep() -> None:
    """Evaluate the joint in FILE on a grid of any of its numbers.

    Without --out a small sweep is printed. Points without a result (rollers that do not fit, a torque above the
    capacity) stay in the output; their status gives the reason.

    \b
    asperity sweep joint.toml --over "load.output_torque=0 N*m:5 N*m:11" --plot
    asperity sweep joint.toml --over "surface.fractal_roughness=1e-10 mm:1e-8 mm:50:log" \\
        --over "load.preload=500 N:2000 N:40" --results stiffness,slip_ratio --out sweep.nc
    """  # noqa: D301 (click's mark for lines that are not wrapped is the character itself)
