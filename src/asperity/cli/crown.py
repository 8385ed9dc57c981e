"""``asperity crown``: which crown takes up a tilt of the rollers."""

from __future__ import annotations

import click

from asperity.cli.terminal import (
    about,
    json_option,
    prepare_computation,
    print_json,
    read_option,
    show_blocks,
)


@click.command()
@click.argument("file", type=click.Path())
@click.option("--tilt", required=True, metavar="ANGLE", help="Angle between the axes, e.g. '0.5 mrad'.")
@json_option()
def crown(file: str, tilt: str, as_json: bool) -> None:
    """The crown radius and the logarithmic profile of every contact in FILE for a misalignment.

    Of the profiles that leave both ends of a tilted contact free, the one with the lowest peak pressure, under its
    largest normal force; with half and twice the drop at the ends for comparison, and as FILE crowns it.
    """
    from asperity.joint_file.reader import read_case
    from asperity.unit_table import Dimension

    angle = read_option("tilt", tilt, Dimension.ANGLE)
    case = read_case(file)
    prepare_computation()
    from asperity.joint_file.solved_document import solved_case
    from asperity.results.crown_document import crown_document

    with about(file):
        document = crown_document(solved_case(case), angle)
    if as_json:
        print_json(document)
    else:
        from asperity.views.crown import crown as crown_blocks

        show_blocks(*crown_blocks(document))
