"""What the command of :mod:`asperity.cli.crown` does."""

from __future__ import annotations

from asperity.cli.options import read_option
from asperity.cli.terminal import about, print_json, show_blocks
from asperity.joint_file.reader import read_case
from asperity.joint_file.solved_document import solved_case
from asperity.results.crown_document import crown_document
from asperity.unit_table import Dimension
from asperity.views.crown import crown as crown_blocks


def crown(file: str, tilt: str, as_json: bool) -> None:
    """What ``asperity crown`` does; its options stand in :mod:`asperity.cli.crown`."""
    angle = read_option("tilt", tilt, Dimension.ANGLE)
    case = read_case(file)
    with about(file):
        document = crown_document(solved_case(case), angle)
    if as_json:
        print_json(document)
    else:
        show_blocks(*crown_blocks(document))
