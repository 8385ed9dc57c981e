"""``asperity draw``: the drive of a joint file to scale."""

from __future__ import annotations

import click

from asperity.cli.terminal import about, check_title, prepare_computation, say, say_written, title_options


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--out",
    required=True,
    type=click.Path(dir_okay=False),
    help="Write the drawing to this file: .svg, .pdf, .png or .dxf.",
)
@click.option(
    "--forces", is_flag=True, help="Draw the forces of one branch too, under the torque of the file."
)
@click.option(
    "--parts",
    is_flag=True,
    help="A sheet for each kind of roller and ring too: further pages of a PDF file, otherwise files beside it.",
)
@title_options
def draw(file: str, out: str, forces: bool, parts: bool, **stated: str) -> None:
    """Draw the drive described in FILE to scale: view, section along the axis, parts, tolerances and title block.

    The sheet is A3, that of a part A4; the scale is the largest standard one that fits; print it in full size. A wall
    of the ring that is thicker than half the inner radius is broken off, and the drawing says so. The bore of a ring
    is the one to be made, smaller by the interference that makes the preload, which is stated; in a housing of the
    file it is that of the ring in its seat, and its own sheet has the one before it is pressed in. Diameters have the
    tolerances of the file, twice those of the radii, and the coarsest grade of ISO 286-1 within them. What the file
    does not state is a dash, or is said not to be stated. With --forces there is no section. A DXF file contains the
    true sizes in mm, with DIMENSION entities; it needs the optional package ezdxf.
    """
    from asperity.api.documents import check_drawing
    from asperity.cli.terminal import read_case_of_branches
    from asperity.joint_file.reader import read_case

    check_drawing(out, file)
    check_title(stated)
    case = read_case_of_branches(file) if forces else read_case(file)
    prepare_computation()
    from asperity.api.documents import draw as drawn
    from asperity.api.joint import DescribedJoint

    def warn(sentence: str) -> None:
        say(f"asperity: warning: {sentence}")

    with about(file):
        files = drawn(DescribedJoint(case, file), out, forces=forces, parts=parts, title=stated, notice=warn)
    for path in files:
        say_written(str(path))
