"""What the command of :mod:`asperity.cli.wear` does."""

from __future__ import annotations

from asperity.api.joint import DescribedJoint
from asperity.api.wear import wear as found_wear
from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.unit_table import Dimension
from asperity.writing import check_image


def wear(file: str, life: str | None, plot_file: str | None, as_json: bool) -> None:
    """What ``asperity wear`` does; its options stand in :mod:`asperity.cli.wear`."""
    check_image(plot_file, file)
    case = read_case_of_branches(file)
    if life is not None:
        read_option("life", life, Dimension.TIME)  # refuses what is no such quantity
    with about(file):
        found = found_wear(DescribedJoint(case, file), life=life)
        figure = found.plot() if plot_file else None
    if plot_file and figure is not None:
        save_image(figure, plot_file)
    if as_json:
        print_json(found.document)
        return
    show_blocks(*found.blocks())
