"""What the command of :mod:`asperity.cli.window` does."""

from __future__ import annotations

from asperity.api.joint import DescribedJoint
from asperity.api.window import JointWindow
from asperity.api.window import window as found_window
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.progress import progress_bar
from asperity.cli.terminal import about, print_json, save_image, say_written, show_blocks
from asperity.joint_file.si_tables import key_at, si_values
from asperity.joint_file.window import Over, window_key
from asperity.made_files import table_where
from asperity.results.window_document import window_columns
from asperity.writing import check_apart, check_file, check_image, write_columns

#: Columns of a window: its axis, its preload where that is not the axis, and its capacity come before all limits.
WINDOW_LIMITS = table_where(
    "the limits of a window",
    lambda columns: "preload_N" in columns[:2] and "torque_capacity_Nm" in columns[1:3],
)


def window(
    file: str,
    over: Over | None,
    start: str | None,
    stop: str | None,
    points: int,
    csv_file: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """What ``asperity window`` does; its options stand in :mod:`asperity.cli.window`."""
    check_apart(csv=csv_file, plot=plot_file)
    check_file(csv_file, file, kind=WINDOW_LIMITS)
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    with about(file):
        dimension = key_at(window_key(si_values(case), over)).dimension
    for option, end in (("from", start), ("to", stop)):
        if end is not None:
            read_option(option, end, dimension)  # refuses what is no such quantity
    with about(file), progress_bar("looking for limits", compiles=False) as report:
        found: JointWindow = found_window(
            DescribedJoint(case, file), over=over, start=start, stop=stop, points=points, report=report
        )
    if csv_file:
        write_columns(window_columns(found.window), csv_file, kind=WINDOW_LIMITS)
        say_written(csv_file)
    if plot_file:
        save_image(found.plot(), plot_file)
    if as_json:
        print_json(found.document)
        return
    show_blocks(*found.blocks())
