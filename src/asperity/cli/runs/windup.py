"""What the command of :mod:`asperity.cli.windup` does."""

from __future__ import annotations

from asperity.api.joint import DescribedJoint
from asperity.api.windup import windup as wound_up
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.terminal import about, about_torque, print_json, save_image, say_written, show_blocks
from asperity.errors import InputError
from asperity.made_files import table_with
from asperity.results.windup_document import rolling_columns, windup_columns
from asperity.standing.windup import StiffnessLevel
from asperity.unit_table import Dimension
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


def windup(
    file: str,
    torque: str | None,
    level: StiffnessLevel,
    stages: tuple[float, float],
    creep_share: float,
    csv_file: str | None,
    rolling_file: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """What ``asperity windup`` does; its options stand in :mod:`asperity.cli.windup`."""
    check_apart(csv=csv_file, rolling_csv=rolling_file, plot=plot_file)
    check_file(csv_file, file, kind=WINDUP_CURVES)
    check_file(rolling_file, file, kind=ROLLING_CURVES)
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    if torque is not None:
        read_option("torque", torque, Dimension.TORQUE)  # refuses what is no torque
    first, second = stages
    if not 0.0 < first < second < 1.0:
        raise InputError(f"--stages {first:g} {second:g}: allowed are two shares with 0 < first < second < 1")
    if not 0.0 < creep_share < float("inf"):
        raise InputError(f"--creep-share {creep_share:g}: allowed is a number above 0, e.g. 0.05")
    with about(file), about_torque(torque):
        wound = wound_up(
            DescribedJoint(case, file),
            torque=torque,
            level=level,
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
