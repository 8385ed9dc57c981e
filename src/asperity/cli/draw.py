"""``asperity draw``: the drive of a joint file to scale."""

from __future__ import annotations

import click

from asperity.cli.options import title_options
from asperity.cli.run_by_name import run_by_name


@click.command()
@click.argument("file", type=click.Path())
@click.option(
    "--out",
    required=True,
    type=click.Path(dir_okay=False),
    help="Write the drawing to this file: .svg, .pdf, .png or .dxf.",
)
@click.option(
    "--forces",
    is_flag=True,
    help="Draw the forces of one branch too, each with its letter, under the torque of the file.",
)
@click.option(
    "--parts",
    is_flag=True,
    help="A sheet for each kind of roller and ring too: further pages of a PDF file, otherwise files beside it.",
)
@title_options
@run_by_name
def draw() -> None:
    """Draw the drive described in FILE to scale: view, section along the axis, parts, tolerances and title block.

    The sheet is the smallest, from A4 on, that the drawing fills, at the largest standard scale; print it in full size.
    What no sheet can show is refused with the scale that it would need. The housing is drawn where the file has one. A
    wall of the ring that is thicker than half the inner radius is broken off, and the drawing says so. The bore of a
    ring is the one to be made, smaller by the interference that makes the preload, which is stated; in a housing of the
    file it is that of the ring in its seat, and its own sheet has the one before it is pressed in. Diameters have the
    tolerances of the file, twice those of the radii, and the coarsest grade of ISO 286-1 within them. What the file
    does not state is a dash, or is said not to be stated; an Ra or Rz that it states is a surface symbol on the sheets
    of the parts. With --forces there is a section only where the sheet need not be larger for it. A DXF file contains
    the true sizes in mm, with DIMENSION entities; it needs the optional package ezdxf.
    """
