"""What the command of :mod:`asperity.cli.accuracy` does."""

from __future__ import annotations

from asperity.api.accuracy import accuracy as found_accuracy
from asperity.api.joint import DescribedJoint
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.unit_table import Dimension
from asperity.writing import check_image


def accuracy(
    file: str,
    reverse: bool,
    allowed: str | None,
    uncertainty: str | None,
    plot_file: str | None,
    as_json: bool,
) -> None:
    """What ``asperity accuracy`` does; its options stand in :mod:`asperity.cli.accuracy`."""
    check_image(plot_file, file)
    for option, text, dimension in (
        ("allowed", allowed, Dimension.ANGLE),
        ("uncertainty", uncertainty, Dimension.DIMENSIONLESS),
    ):
        if text is not None:
            read_option(option, text, dimension)  # refuses what is no such quantity
    case = read_case_of_branches(file)
    with about(file):
        found = found_accuracy(
            DescribedJoint(case, file), reverse=reverse, allowed=allowed, uncertainty=uncertainty
        )
    if plot_file:
        save_image(found.plot(), plot_file)
    if as_json:
        print_json(found.document)
        return
    show_blocks(*found.blocks())
