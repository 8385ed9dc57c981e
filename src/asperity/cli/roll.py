"""``asperity roll``: creep, drift, losses and life of a joint that turns."""

from __future__ import annotations

import click

from asperity.cli.terminal import (
    about,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    save_image,
    show_blocks,
)
from asperity.writing import check_image


@click.command()
@click.argument("file", type=click.Path())
@plot_option("Draw creep curves, efficiency, drift and life: PNG, SVG or PDF.")
@json_option()
@click.option("--all", "in_full", is_flag=True, help="Print everything that is assumed, in full.")
def roll(file: str, plot_file: str | None, as_json: bool, in_full: bool) -> None:
    """Drift, losses, axial thrust and life of the joint described in FILE when it turns.

    Rollers that pass torque creep: the output falls behind with every turn, however stiff the joint is. The sections
    [rolling], [lubrication] and [[duty]] of FILE are optional; what they leave out is listed under 'Assumptions'.
    The JSON document is that of 'asperity joint'.
    With [[branch]] the last table says what each branch carries.
    """
    from asperity.joint_file.reader import read_case

    check_image(plot_file, file)
    case = read_case(file)
    prepare_computation()
    from asperity.api.joint import DescribedJoint
    from asperity.api.rolling import roll as rolled

    with about(file):
        rolling = rolled(DescribedJoint(case, file))  # refuses a torque beyond the capacity
    if plot_file:
        save_image(rolling.plot(), plot_file)
    if as_json:
        print_json(rolling.document)
        return
    from asperity.views.joint import assumptions

    show_blocks(*rolling.blocks(), *assumptions(rolling.document, in_full=in_full))
