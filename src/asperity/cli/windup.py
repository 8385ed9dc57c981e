"""``asperity windup``: torque–angle curve, hysteresis loop and catalogue stiffness; the angle behind once it turns."""

from __future__ import annotations

import click

from asperity.cli.terminal import (
    about,
    about_torque,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    read_option,
    save_image,
    say_written,
    show_blocks,
)
from asperity.made_files import table_with
from asperity.standing import STAGE_SHARES
from asperity.writing import check_apart, check_file, check_image, write_columns

WINDUP_CURVES = table_with(
    "the curves of a wind-up",
    "torque_Nm",
    "loading_angle_rad",
    "incremental_stiffness_Nm_per_rad",
    "unloading_angle_rad",
    "reloading_angle_rad",
)
ROLLING_CURVES = table_with(
    "the curve beyond a wind-up",
    "input_angle_rad",
    "output_angle_rad",
    "angle_behind_rad",
    "drift_per_swing_rad",
)
LEVELS = ("assembly", "series_with_bulk", "published")


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--torque",
    help="Largest output torque of the curve, with its unit, e.g. '10 N*m'; default: the file's output torque. "
    "The curve covers both directions, so the sign does not matter.",
)
@click.option(
    "--level",
    type=click.Choice(LEVELS),
    default="assembly",
    show_default=True,
    help="Level of the stiffness that is integrated.",
)
@click.option(
    "--stages",
    type=(float, float),
    default=STAGE_SHARES,
    show_default="one and two thirds",
    help="Torques at which K1 ends and K3 begins, as shares of the largest torque.",
)
@click.option(
    "--creep-share",
    type=float,
    default=0.05,
    show_default=True,
    help="For an input that turns: creep over wind-up up to which the static curve is said to hold.",
)
@click.option("--csv", "csv_file", type=click.Path(dir_okay=False), help="Write the curves to this CSV file.")
@click.option(
    "--rolling-csv",
    "rolling_file",
    type=click.Path(dir_okay=False),
    help="Write the angle behind over the angle turned, and the drift of swings, to this CSV file.",
)
@plot_option("Draw the curves: PNG, SVG or PDF.")
@json_option("Print one JSON document in SI units instead of a table.")
def windup(
    file: str,
    torque: str | None,
    level: str,
    stages: tuple[float, float],
    creep_share: float,
    csv_file: str | None,
    rolling_file: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """Wind-up of the joint described in FILE: torque–angle curve, hysteresis, lost motion, K1/K2/K3, capacity.

    The output turns against the locked input, play included. The loop runs between plus and minus the largest torque.
    It is an estimate, because the normal forces change with the torque.

    Stiffness holds for an input that stands. Once it turns under torque, the contacts creep and the output drifts:
    the second table says from which angle on, and by how much. 'asperity roll' has more on the drift.
    """
    from asperity.cli.terminal import read_case_of_branches
    from asperity.errors import InputError

    check_apart(csv=csv_file, rolling_csv=rolling_file, plot=plot_file)
    check_file(csv_file, file, kind=WINDUP_CURVES)
    check_file(rolling_file, file, kind=ROLLING_CURVES)
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    if torque is not None:
        from asperity.unit_table import Dimension

        read_option("torque", torque, Dimension.TORQUE)  # refuses what is no torque
    first, second = stages
    if not 0.0 < first < second < 1.0:
        raise InputError(f"--stages {first:g} {second:g}: allowed are two shares with 0 < first < second < 1")
    if not 0.0 < creep_share < float("inf"):
        raise InputError(f"--creep-share {creep_share:g}: allowed is a number above 0, e.g. 0.05")
    prepare_computation()
    from asperity.api.joint import DescribedJoint
    from asperity.api.windup import windup as wound_up
    from asperity.results.windup_document import rolling_columns, windup_columns

    with about(file), about_torque(torque):
        wound = wound_up(
            DescribedJoint(case, file),
            torque=torque,
            level=level,  # type: ignore[arg-type]
            stages=stages,
            creep_share=creep_share,
        )
    if csv_file:
        write_columns(windup_columns(wound.curve), csv_file, kind=WINDUP_CURVES)
        say_written(csv_file)
    if rolling_file:
        if wound.onset is None:
            raise InputError(f"--rolling-csv: {wound.document['rolling']['unknown_because'][0]}")
        write_columns(rolling_columns(wound.onset), rolling_file, kind=ROLLING_CURVES)
        say_written(rolling_file)
    if plot_file:
        save_image(wound.plot(), plot_file)
    if as_json:
        print_json(wound.document)
        return
    show_blocks(*wound.blocks())
