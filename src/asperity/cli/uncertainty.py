"""``asperity uncertainty``: intervals of the results from the tolerances of a joint file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import (
    json_option,
    plot_option_of,
    prepare_computation,
    print_json,
    save_image,
    show_blocks,
)
from asperity.writing import check_image

if TYPE_CHECKING:
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
    from asperity.cli.study_output import show_bounds, show_status
    from asperity.cli.terminal import progress_bar
    from asperity.study.tolerances.uncertainty import uncertainty as propagate
    from asperity.views.tolerances import intervals, unlike_branches, variance_shares

    check_image(plot, file)
    if branches is not None:
        with about(file):
            scattered = _unlike_branches(case, otherwise, branches, seed)
        if as_json:
            print_json(scattered)
        else:
            show_blocks(*unlike_branches(scattered, branches))
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
        show_status(dataset)
        names = dataset["result"].values.tolist()
        show_blocks(*intervals(dataset), *variance_shares(dataset, names[:1]))
        show_bounds(dict(zip(names, dataset["result_name"].values.tolist(), strict=True)))
    if plot is not None:
        from asperity.study.tolerances.influence_plot import uncertainty_figure

        save_image(uncertainty_figure(dataset, result=dataset["result"].values[0]), plot)


def _unlike_branches(case: Case, otherwise: Distribution | None, draws: int, seed: int) -> dict[str, Any]:
    """Document of drives whose branches are drawn one by one."""
    from asperity.cli.terminal import progress_bar
    from asperity.study.tolerances.branch_scatter import branch_scatter

    with progress_bar("drives") as report:
        return branch_scatter(case, distribution=otherwise, draws=draws, seed=seed, report=report).document()
