"""``asperity sensitivity``: the influence of every number of a joint file on the results."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click
import numpy as np

from asperity.cli.terminal import json_option, plot_option_of, prepare_computation, print_json, save_image
from asperity.writing import check_image

if TYPE_CHECKING:
    import xarray


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
    from asperity.study.tolerances.sensitivity import DEFAULT_RESULTS, differentiable_rows, ranking
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
        _show(ranking(dataset, result))
    if plot is not None:
        from asperity.study.tolerances.influence_plot import tornado_figure

        save_image(tornado_figure(dataset, result=result), plot)


def _show(ranked: xarray.Dataset) -> None:
    from asperity.cli.document_text import print_wrapped
    from asperity.cli.terminal import console, table
    from asperity.joint_file.si_tables import key_at
    from asperity.results import display_unit
    from asperity.study.tolerances.documents import ABOUT_FINISHED_PARTS
    from asperity.study.tolerances.sensitivity import FINISHED_PART, path_of_input
    from asperity.units import format_quantity, from_si

    unit = display_unit(str(ranked["result"].item()))
    shown_unit = "" if unit == "1" else unit.replace("*", "·")
    value = from_si(float(ranked["result_value"]), unit)
    target = console()
    title = f"{ranked['result_name'].item()}: {format_quantity(value, '1', 5)} {shown_unit}".rstrip()
    rows = table(
        target, title, "number of the file", "value", "elasticity", f"derivative [{shown_unit or '-'}]"
    )
    without_effect = []
    for path in ranked["input"].values.tolist():
        one = ranked.sel(input=path)
        if float(one["derivative"]) == 0.0:
            without_effect.append(path)
            continue
        key = key_at(path_of_input(path))
        per = "" if key.unit == "1" else f" per {key.unit}".replace("*", "·")
        elasticity = float(one["elasticity"])
        derivative = from_si(float(one["derivative"]), unit) / from_si(1.0, key.unit)
        rows.add_row(
            path,
            format_quantity(float(one["value"]), key.unit),
            "-" if np.isnan(elasticity) else f"{elasticity + 0.0:+.4f}",
            "-" if np.isnan(derivative) else f"{format_quantity(derivative + 0.0, '1', 5)}{per}",
        )
    target.print(rows)
    if any(name.endswith(FINISHED_PART) for name in ranked["input"].values.tolist()):
        print_wrapped(target, ABOUT_FINISHED_PARTS, indent=2)
    if without_effect:
        print_wrapped(target, f"no effect: {', '.join(without_effect)}", indent=2)
    if not np.isfinite(value):
        click.echo("the result is infinite: no torque makes a contact slip, and it has no derivatives")
