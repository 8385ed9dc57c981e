"""What the command of :mod:`asperity.cli.roll` does."""

from __future__ import annotations

from asperity.api.joint import DescribedJoint
from asperity.api.rolling import roll as rolled
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.joint_file.reader import read_case
from asperity.views.joint import assumptions
from asperity.writing import check_image


def roll(file: str, plot_file: str | None, as_json: bool, in_full: bool) -> None:
    """What ``asperity roll`` does; its options stand in :mod:`asperity.cli.roll`."""
    check_image(plot_file, file)
    case = read_case(file)
    with about(file):
        rolling = rolled(DescribedJoint(case, file))  # refuses a torque beyond the capacity
    if plot_file:
        save_image(rolling.plot(), plot_file)
    if as_json:
        print_json(rolling.document)
        return
    show_blocks(
        *rolling.blocks(), *assumptions(rolling.document, brief="" if in_full else "in full with --all")
    )
