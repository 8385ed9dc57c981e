"""``asperity roll``: creep, drift, losses and life of a joint that turns."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import about, json_option, plot_option, prepare_computation, print_json, save_image
from asperity.writing import check_image

if TYPE_CHECKING:
    from asperity.results.solved import SolvedJoint

_WIDTH = 10.0  # of the picture [in]


@click.command()
@click.argument("file", type=click.Path())
@plot_option("Draw creep curves, efficiency, drift and life: PNG, SVG or PDF.")
@json_option()
@click.option("--all", "in_full", is_flag=True, help="Print everything that is assumed, in full.")
def roll(file: str, plot_file: str | None, as_json: bool, in_full: bool) -> None:
    """Drift, losses, axial thrust and life of the joint described in FILE when it turns.

    Rollers that pass torque creep: the output falls behind with every turn, however stiff the joint is. The sections
    [rolling], [lubrication] and [[duty]] of FILE are optional; what they leave out is listed under 'Assumed'. The JSON
    document is that of 'asperity joint'.
    With [[branch]] the last table says what each branch carries.
    """
    from asperity.joint_file.reader import read_case

    check_image(plot_file)
    case = read_case(file)
    prepare_computation()
    from asperity.joint.solve import refuse_no_rolling
    from asperity.joint_file.solved_document import solve_case

    with about(file):
        solved, document = solve_case(case)  # refuses a torque beyond the capacity
        refuse_no_rolling(solved.joint, solved.solution)
    if plot_file:
        _draw(solved, document, file, plot_file)
    if as_json:
        print_json(document)
        return
    from asperity.cli.roll_table import show_rolling
    from asperity.cli.terminal import console

    show_rolling(console(), document, source=file, in_full=in_full)


def _capacity(document: dict[str, Any]) -> float:
    """Torque capacity in rolling [N·m]; infinite where friction does not limit it."""
    capacity = document["rolling"]["torque_capacity_Nm"]
    return math.inf if capacity is None else float(capacity)


def _draw(solved: SolvedJoint, document: dict[str, Any], file: str, plot_file: str) -> None:
    from asperity.rolling.curves import rolling_curves
    from asperity.show.rolling_figure import rolling_figure
    from asperity.show.style import plain_title

    joint, result = solved.joint, solved.result
    capacity = math.copysign(_capacity(document), float(joint.output_torque))
    curves = rolling_curves(joint=joint, result=result, laws=solved.solution.laws, torque_capacity=capacity)
    title = f"{plain_title(file)} in rolling"
    save_image(rolling_figure(curves, result.rolling, joint=joint, title=title, width=_WIDTH), plot_file)
