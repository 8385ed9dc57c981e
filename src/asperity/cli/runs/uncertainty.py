"""What the command of :mod:`asperity.cli.uncertainty` does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.progress import progress_bar
from asperity.cli.study_output import show_bounds, show_status
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.joint_file.quantity_key import parse_distribution
from asperity.types import Document
from asperity.writing import check_image

if TYPE_CHECKING:
    from asperity.joint_file.model import Case
    from asperity.joint_file.quantity_key import Distribution


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
    """What ``asperity uncertainty`` does; its options stand in :mod:`asperity.cli.uncertainty`."""
    case = read_case_of_branches(file)
    otherwise = None if distribution is None else parse_distribution(distribution)
    # what imports JAX, once the file is read
    from asperity.study.tolerances.documents import uncertainty_document
    from asperity.study.tolerances.influence_plot import uncertainty_figure
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
        print_json(uncertainty_document(dataset))
    else:
        show_status(dataset)
        names = dataset["result"].values.tolist()
        show_blocks(*intervals(dataset), *variance_shares(dataset, names[:1]))
        show_bounds(dict(zip(names, dataset["result_name"].values.tolist(), strict=True)))
    if plot is not None:
        save_image(uncertainty_figure(dataset, result=dataset["result"].values[0]), plot)


def _unlike_branches(case: Case, otherwise: Distribution | None, draws: int, seed: int) -> Document:
    """Document of drives whose branches are drawn one by one."""
    from asperity.study.tolerances.branch_scatter import branch_scatter

    with progress_bar("drives") as report:
        return branch_scatter(case, distribution=otherwise, draws=draws, seed=seed, report=report).document()
