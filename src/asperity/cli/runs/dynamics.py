"""What the command of :mod:`asperity.cli.dynamics` does."""

from __future__ import annotations

from asperity.api.joint import DescribedJoint
from asperity.api.structure import dynamics as dynamics_of
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.terminal import about, print_json, save_image, say_written, show_blocks
from asperity.made_files import table_with
from asperity.writing import check_apart, check_file, check_image, write_columns

RESPONSE = table_with(
    "a frequency response",
    "frequency_Hz",
    *(
        f"{state}_{side}_{part}"
        for state in ("standing", "turning")
        for side in ("motor", "load")
        for part in ("rad_per_Nm", "phase_deg")
    ),
)


def dynamics(file: str, plot_file: str | None, csv_file: str | None, as_json: bool) -> None:
    """What ``asperity dynamics`` does; its options stand in :mod:`asperity.cli.dynamics`."""
    check_apart(plot=plot_file, csv=csv_file)
    check_image(plot_file, file)
    check_file(csv_file, file, kind=RESPONSE)
    case = read_case_of_branches(file)
    with about(file):
        solved = dynamics_of(DescribedJoint(case, file))
    if csv_file:
        write_columns(solved.response(), csv_file, kind=RESPONSE)
        say_written(csv_file)
    if plot_file:
        save_image(solved.plot(), plot_file)
    if as_json:
        print_json(solved.document)
        return
    show_blocks(*solved.blocks())
