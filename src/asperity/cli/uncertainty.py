"""``asperity uncertainty``: intervals of the results from the tolerances of a joint file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click
import numpy as np

from asperity.cli.terminal import json_option, plot_option_of, prepare_computation, print_json, save_image
from asperity.writing import check_image

if TYPE_CHECKING:
    import xarray

    from asperity.joint_file.model import Case
    from asperity.joint_file.quantity_key import Distribution


@click.command()
@click.argument("file", type=click.Path())
@click.option("--samples", type=int, default=100_000, show_default=True, help="Monte-Carlo samples.")
@click.option(
    "--seed", type=click.IntRange(0), default=0, show_default=True, help="Seed of the random numbers."
)
@click.option(
    "--distribution",
    metavar="TEXT",
    help="For tolerances whose distribution the file does not state: 'uniform', 'triangular' or "
    "'normal K sigma' (the tolerance is K standard deviations).",
)
@click.option(
    "--results",
    multiple=True,
    metavar="NAMES",
    help="Results or groups of them, separated by commas, as for sweep.",
)
@click.option(
    "--branches",
    type=int,
    metavar="DRAWS",
    help="Draw the sizes of each planet and each other roller off the axis by themselves, so many times: torque of the "
    "first slip, load shares, force on the sun. Needs load.interference.",
)
@json_option("Print one JSON document in SI units.")
@plot_option_of(
    "uncertainty.png",
    "Draw the first result's histogram and Sobol indices, to uncertainty.png if no name is given.",
)
def uncertainty(
    file: str,
    samples: int,
    seed: int,
    distribution: str | None,
    results: tuple[str, ...],
    branches: int | None,
    as_json: bool,
    plot: str | None,
) -> None:
    """Intervals of the results of the joint in FILE, and the contribution of each tolerance.

    Tolerances are written in the file, with a distribution behind a comma: planet_radius = "13.5 mm +- 5 um, uniform",
    preload = "1000 N +- 50 N, normal 2 sigma". Where load.interference makes the preload, a radius is that of a
    finished part, which deviates while all others stay as they are.
    """
    from asperity.cli.terminal import about, read_case_of_branches
    from asperity.joint_file.quantity_key import parse_distribution

    case = read_case_of_branches(file)
    otherwise = None if distribution is None else parse_distribution(distribution)
    prepare_computation()
    from asperity.cli.terminal import progress_bar
    from asperity.study.tolerances.uncertainty import uncertainty as propagate

    check_image(plot, file)
    if branches is not None:
        with about(file):
            scattered = _unlike_branches(case, otherwise, branches, seed)
        _show_branches(scattered, branches, as_json)
        return
    names = [name.strip() for text in results for name in text.split(",") if name.strip()] or None
    with progress_bar("samples") as report, about(file):
        dataset = propagate(
            case, results=names, distribution=otherwise, samples=samples, seed=seed, report=report
        )
    if as_json:
        from asperity.study.tolerances.documents import uncertainty_document

        print_json(uncertainty_document(dataset))
    else:
        _show(dataset)
    if plot is not None:
        from asperity.study.tolerances.influence_plot import uncertainty_figure

        save_image(uncertainty_figure(dataset, result=dataset["result"].values[0]), plot)


def _unlike_branches(case: Case, otherwise: Distribution | None, draws: int, seed: int) -> dict[str, Any]:
    """Document of drives whose branches are drawn one by one."""
    from asperity.cli.terminal import progress_bar
    from asperity.study.tolerances.branch_scatter import branch_scatter

    with progress_bar("drives") as report:
        return branch_scatter(case, distribution=otherwise, draws=draws, seed=seed, report=report).document()


def _show_branches(scatter: dict[str, Any], draws: int, as_json: bool) -> None:
    if as_json:
        print_json(scatter)
        return
    from asperity.cli.terminal import console, show_table

    rows = []
    for name, words, unit, factor in (
        ("first_slip_Nm", "first branch slips, standing", "N·m", 1.0),
        ("all_slip_Nm", "all branches slip, standing", "N·m", 1.0),
        ("rolling_first_slip_Nm", "first branch slips, rolling", "N·m", 1.0),
        ("largest_share", "largest share of a branch, standing", "%", 100.0),
        ("largest_rolling_share", "largest share of a branch, rolling", "%", 100.0),
        ("sun_force_N", "force on the sun's bearings", "N", 1.0),
    ):
        values = ["-"] * 3 if scatter[name] is None else [f"{factor * value:.4g}" for value in scatter[name]]
        rows.append((words, unit, *values))
    title = f"{draws} drives with branches of their own sizes"
    show_table(console(), title, ("", "unit", "2.5 %", "median", "97.5 %"), rows)
    alone = scatter["share_without_a_balance"]
    click.echo(
        f"equal branches pass {scatter['equal_branches_Nm']:.4g} N·m; a branch is loose in "
        f"{100.0 * scatter['share_with_a_loose_branch']:.1f} % and slips under the torque of the file in "
        f"{100.0 * scatter['share_that_slips_under_the_torque']:.1f} % of the drives"
        + (f"; {100.0 * alone:.1f} % have no balance" if alone else "")
    )


def _show(dataset: xarray.Dataset) -> None:
    from asperity.cli.study_output import show_bounds, show_status
    from asperity.cli.terminal import console, table
    from asperity.results import display_unit
    from asperity.study.tolerances.documents import TOLERANCES_OF_PARTS, failures
    from asperity.units import from_si

    show_status(dataset)
    target, named = console(), []
    rows = table(
        target, "95 % of the results", "result", "unit", "nominal", "mean", "std. dev.", "2.5 %", "97.5 %"
    )
    for name in dataset["result"].values.tolist():
        one = dataset.sel(result=name)
        if one["categories"].item():
            named.append(f"{one['result_name'].item()}: {_shares(dataset, name)}")
            continue
        low, _, high = one["quantiles"].values
        numbers = (one["nominal"], one["mean"], one["standard_deviation"], low, high)
        unit = display_unit(name)
        cells = (_cell(from_si(float(number), unit)) for number in numbers)
        rows.add_row(name.replace("_", " "), unit.replace("*", "·"), *cells)
    if rows.rows:
        target.print(rows)
    show_bounds(
        dict(zip(dataset["result"].values.tolist(), dataset["result_name"].values.tolist(), strict=True))
    )
    for sentence in failures(
        dataset, {name: name.replace("_", " ") for name in dataset["result"].values.tolist()}
    ):
        click.echo(sentence)
    for line in named:
        click.echo(line)
    if bool(dataset["finished_part"].any()):
        click.echo(TOLERANCES_OF_PARTS)
    first = dataset.isel(result=0)
    if np.all(np.isnan(first["total_order"].values)):
        return
    name = str(first["result"].item()).replace("_", " ")
    title = f"Contributions to the variance of the {name} (Sobol indices, ± 95 %)"
    shares = table(target, title, "tolerance", "distribution", "first order", "total")
    for k in np.argsort(-np.nan_to_num(first["total_order"].values)):
        one = first.isel(input=int(k))
        shares.add_row(
            str(one["input"].item()),
            str(one["distribution"].item()),
            f"{float(one['first_order']):.3f} ± {float(one['first_order_half_width']):.3f}",
            f"{float(one['total_order']):.3f} ± {float(one['total_order_half_width']):.3f}",
        )
    target.print(shares)


def _cell(number: float) -> str:
    """A number; that of a drive that fails is infinitely bad."""
    from asperity.units import format_quantity

    if np.isnan(number):
        return "-"
    return format_quantity(number, "1", 5) if np.isfinite(number) else "fails"


def _shares(dataset: xarray.Dataset, name: str) -> str:
    """Words for the share of each category of a result that is not a quantity."""
    categories = str(dataset["categories"].sel(result=name).item()).split(" ")
    solved = dataset["samples"].sel(result=name).values[dataset["status"].values == 0]
    codes, counts = np.unique(solved.astype(int), return_counts=True)
    pairs = sorted(zip(counts.tolist(), codes.tolist(), strict=True), reverse=True)
    return ", ".join(f"{categories[code]} in {100.0 * count / solved.size:.2f} %" for count, code in pairs)
