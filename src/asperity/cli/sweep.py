"""``asperity sweep``: a joint file evaluated on a grid of any of its numbers."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import plot_option_of, prepare_computation, save_image, say, say_written
from asperity.errors import InputError
from asperity.writing import check_apart, check_file, check_image, if_abandoned

if TYPE_CHECKING:
    from collections.abc import Mapping

    from asperity.results import Result


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
    "diagnostics, geometry, size, residuals, capacity, rolling, losses, life, loads, bearings, seats, stresses, or all "
    "but the stresses. Only these are computed.",
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
def sweep(
    file: str,
    axes: tuple[str, ...],
    results: tuple[str, ...],
    out: str | None,
    units: tuple[str, ...],
    overwrite: bool,
    plot: str | None,
    plot_result: str | None,
    limits: tuple[str, ...],
    scheduler: str | None,
    workers: int | None,
) -> None:
    """Evaluate the joint in FILE on a grid of any of its numbers.

    Without --out a small sweep is printed. Points without a result (rollers that do not fit, a torque above the
    capacity) stay in the output; their status gives the reason.

    \b
    asperity sweep joint.toml --over "load.output_torque=0 N*m:5 N*m:11" --plot
    asperity sweep joint.toml --over "surface.fractal_roughness=1e-10 mm:1e-8 mm:50:log" \\
        --over "load.preload=500 N:2000 N:40" --results stiffness,slip_ratio --out sweep.nc
    """  # noqa: D301 (click's mark for lines that are not wrapped is the character itself)
    from asperity.cli.terminal import read_case_of_branches

    case = read_case_of_branches(file)
    prepare_computation()
    from asperity.cli.study_output import show_points, show_status
    from asperity.cli.terminal import about, progress_bar
    from asperity.joint_file.any_joint import results_of
    from asperity.joint_file.si_tables import si_values
    from asperity.results import chosen_results
    from asperity.study.datasets import SWEEP_TABLES, asked_units, check_table_path, in_units, write_table
    from asperity.study.parameters import parse_axis
    from asperity.study.sweep.store import check_store
    from asperity.study.sweep.sweep import sweep as evaluate_sweep
    from asperity.study.sweep.sweep_map import parse_limit

    kind, table = case.type, results_of(si_values(case))
    grid = [parse_axis(axis, kind=kind) for axis in axes]
    names = _listed(results)
    computed = [table[name] for name in chosen_results(names, table=table)]
    streamed = out is not None and Path(out).suffix == ".zarr"
    if units and streamed:
        raise InputError("--units: a folder .zarr is in SI units; write .nc, .parquet or .csv for others")
    try:
        shown_units = asked_units(_listed(units), axes=grid, results=computed)
    except InputError as error:
        raise InputError(f"--units: {error}") from None
    check_apart(out=out, plot=plot)
    if out is not None and streamed:
        check_store(out, file)
    elif out is not None:
        check_table_path(out, overwrite=overwrite)
        check_file(out, file, kind=SWEEP_TABLES[Path(out).suffix])
    check_image(plot, file)
    if plot_result is not None:
        _check_plot_result(plot_result, names, table, drawn=plot is not None)
    drawn = [parse_limit(text) for text in limits]
    for limit in drawn:
        _check_plot_result(limit.name, names, table, drawn=plot is not None, option="--limit")
    if drawn and len(grid) != 2:
        raise InputError("--limit draws lines in the map of two axes; curves have none")
    if (scheduler is not None or workers) and not streamed:
        raise InputError(
            "--scheduler and --workers need an --out of type .zarr, to which the processes write"
        )

    def kept() -> None:
        if streamed:
            say(f"the finished blocks are kept in {out}; the same command continues from there")

    try:
        with progress_bar("points") as report, about(file, out), if_abandoned(kept):
            dataset = evaluate_sweep(
                case,
                grid,
                results=names,
                store=out if streamed else None,
                overwrite=overwrite,
                scheduler=scheduler,
                workers=workers,
                report=report,
                notice=say,
            )
    except KeyboardInterrupt:
        kept()
        raise
    if out is not None and not streamed:
        write_table(in_units(dataset, shown_units), out)
    if plot is not None:
        from asperity.study.sweep.sweep_plot import sweep_figure

        save_image(sweep_figure(dataset, result=plot_result, limits=drawn), plot)
    show_status(dataset)
    if out is None:
        show_points(dataset, shown_units)
    else:
        say_written(out)


def _listed(texts: tuple[str, ...]) -> list[str]:
    """Words between commas, of an option that may be repeated."""
    return [word.strip() for text in texts for word in text.split(",") if word.strip()]


def _check_plot_result(
    name: str, asked: list[str], table: Mapping[str, Result], *, drawn: bool, option: str = "--plot-result"
) -> None:
    """Refuse a result that cannot be drawn before anything is computed."""
    from asperity.results import chosen_results

    if not drawn:
        raise InputError(f"{option} needs --plot, the picture to draw '{name}' in")
    chosen_results([name], table=table)  # raises if there is no such result
    computed = chosen_results(asked, table=table)
    if name not in computed:
        raise InputError(
            f"{option} '{name}' is not among the results that are computed, {', '.join(computed)}; ask for it "
            "by --results"
        )
