"""What the command of :mod:`asperity.cli.sweep` does."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.progress import progress_bar
from asperity.cli.study_output import show_points, show_status
from asperity.cli.terminal import about, save_image, say, say_written
from asperity.errors import InputError
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.results import Result, chosen_results
from asperity.study.datasets import SWEEP_TABLES, asked_units, check_table_path, in_units, write_table
from asperity.study.parameters import parse_axis
from asperity.study.sweep.sweep_map import parse_limit
from asperity.writing import check_apart, check_file, check_image, if_abandoned


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
    """What ``asperity sweep`` does; its options stand in :mod:`asperity.cli.sweep`."""
    case = read_case_of_branches(file)
    # what imports JAX, once the file is read
    from asperity.study.sweep.sweep import sweep as evaluate_sweep
    from asperity.study.sweep.sweep_plot import sweep_figure

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
    _check_output(out, file, overwrite=overwrite)
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
    with _kept(out if streamed else None), progress_bar("points") as report, about(file, out):
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
    if out is not None and not streamed:
        write_table(in_units(dataset, shown_units), out)
    if plot is not None:
        save_image(sweep_figure(dataset, result=plot_result, limits=drawn), plot)
    show_status(dataset)
    if out is None:
        show_points(dataset, shown_units)
    else:
        say_written(out)


@contextmanager
def _kept(store: str | None) -> Iterator[None]:
    """Where the sweep is interrupted, say that the finished blocks of its folder are kept."""

    def kept() -> None:
        if store is not None:
            say(f"the finished blocks are kept in {store}; the same command continues from there")

    try:
        with if_abandoned(kept):
            yield
    except KeyboardInterrupt:
        kept()
        raise


def _check_output(out: str | None, file: str, *, overwrite: bool) -> None:
    """Refuse an output that cannot be written, or that is not an earlier one of a sweep."""
    if out is None:
        return
    suffix = Path(out).suffix
    if suffix == ".zarr":
        from asperity.study.sweep.store import check_store

        check_store(out, file)
        return
    check_table_path(out, overwrite=overwrite)
    check_file(out, file, kind=SWEEP_TABLES[suffix])


def _listed(texts: tuple[str, ...]) -> list[str]:
    """Words between commas, of an option that may be repeated."""
    return [word.strip() for text in texts for word in text.split(",") if word.strip()]


def _check_plot_result(
    name: str, asked: list[str], table: Mapping[str, Result], *, drawn: bool, option: str = "--plot-result"
) -> None:
    """Refuse a result that cannot be drawn before anything is computed."""
    if not drawn:
        raise InputError(f"{option} needs --plot, the picture to draw '{name}' in")
    chosen_results([name], table=table)  # raises if there is no such result
    computed = chosen_results(asked, table=table)
    if name not in computed:
        raise InputError(
            f"{option} '{name}' is not among the results that are computed, {', '.join(computed)}; ask for it "
            "by --results"
        )
