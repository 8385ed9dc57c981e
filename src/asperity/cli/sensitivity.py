"""``asperity sensitivity``: the influence of every number of a joint file on the results."""

from __future__ import annotations

from typing import TYPE_CHECKING

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
    pass


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--result",
    default="assembly_stiffness_output",
    show_default=True,
    metavar="NAME",
    help="The result to rank by, e.g. torque_capacity, slip_ratio_sp (of one contact) or self_locking_ratio.",
)
@json_option("Print all results as one JSON document in SI units.")
@plot_option_of("sensitivity.png", "Draw a tornado plot, to sensitivity.png if no name is given.")
def sensitivity(file: str, result: str, as_json: bool, plot: str | None) -> None:
    """Exact derivatives and elasticities of the joint in FILE with respect to every number in it.

    An elasticity of 2 says that one per cent more of the number makes about two per cent more of the result. A radius
    is that of another drive, as for sweep: the bore of a ring that follows from the rollers follows it. Where
    load.interference makes the preload, "(finished part)" is the row of a part that deviates while all others stay as
    they are, as for uncertainty and tolerances.
    """
    from asperity.cli.terminal import about, read_case_of_branches

    case = read_case_of_branches(file)
    prepare_computation()
    from asperity.joint_file.any_joint import results_of
    from asperity.joint_file.si_tables import si_values
    from asperity.results import known_result
    from asperity.study.tolerances.sensitivity import DEFAULT_RESULTS, differentiable_rows
    from asperity.study.tolerances.sensitivity import sensitivity as differentiate

    table = results_of(si_values(case))
    rows = differentiable_rows(table)
    asked = rows[known_result(result, among=tuple(rows))]
    check_image(plot, file)
    others = [name for name in DEFAULT_RESULTS if name in table] if as_json or plot is not None else []
    names = tuple(dict.fromkeys((*others, asked)))
    with about(file):
        dataset = differentiate(case, names)
    if as_json:
        from asperity.study.tolerances.documents import sensitivity_document

        print_json(sensitivity_document(dataset))
    else:
        from asperity.views.tolerances import elasticities

        show_blocks(*elasticities(dataset, (result,)))
    if plot is not None:
        from asperity.study.tolerances.influence_plot import tornado_figure

        save_image(tornado_figure(dataset, result=result), plot)
