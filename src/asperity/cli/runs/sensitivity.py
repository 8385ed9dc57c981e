"""What the command of :mod:`asperity.cli.sensitivity` does."""

from __future__ import annotations

from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import si_values
from asperity.results import known_result
from asperity.writing import check_image


def sensitivity(file: str, result: str, as_json: bool, plot: str | None) -> None:
    """What ``asperity sensitivity`` does; its options stand in :mod:`asperity.cli.sensitivity`."""
    case = read_case_of_branches(file)
    # what imports JAX, once the file is read
    from asperity.study.tolerances.documents import sensitivity_document
    from asperity.study.tolerances.influence_plot import tornado_figure
    from asperity.study.tolerances.sensitivity import DEFAULT_RESULTS, differentiable_rows
    from asperity.study.tolerances.sensitivity import sensitivity as differentiate
    from asperity.views.tolerances import elasticities

    table = results_of(si_values(case))
    rows = differentiable_rows(table)
    asked = rows[known_result(result, among=tuple(rows))]
    check_image(plot, file)
    others = [name for name in DEFAULT_RESULTS if name in table] if as_json or plot is not None else []
    names = tuple(dict.fromkeys((*others, asked)))
    with about(file):
        dataset = differentiate(case, names)
    if as_json:
        print_json(sensitivity_document(dataset))
    else:
        show_blocks(*elasticities(dataset, (result,)))
    if plot is not None:
        save_image(tornado_figure(dataset, result=result), plot)
