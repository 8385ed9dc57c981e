"""``asperity draw``: the drive of a joint file to scale."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import about, prepare_computation, say, say_written
from asperity.errors import InputError
from asperity.writing import IMAGE_SUFFIXES, check_file, write_image, write_text

if TYPE_CHECKING:
    from asperity.joint.evaluation import JointResult
    from asperity.joint_file.model import Case
    from asperity.joint_file.si_tables import AnyCase
    from asperity.show.sheet import Sheet


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
def draw(file: str, out: str, forces: bool) -> None:
    """Draw the drive described in FILE to scale: rollers, ring, axes and pins, with diameters and clearances in mm.

    The scale is the largest standard one that fits the sheet (A4, with --forces A3); print it in full size. A wall of
    the ring that is thicker than half the inner radius is broken off, and the drawing says so. The bore of a ring is
    the one to be made, smaller by the interference that makes the preload, which is stated. A DXF file contains the
    true sizes in mm; it needs the optional package ezdxf.
    """
    from asperity.cli.terminal import read_case_of_branches
    from asperity.joint_file.reader import read_case

    suffix = Path(out).suffix.lower()
    if suffix not in (*IMAGE_SUFFIXES, ".dxf"):
        raise InputError(f"{out}: the name of a drawing must end in .svg, .pdf, .png or .dxf")
    check_file(out, file)
    if suffix == ".dxf":
        from asperity.show.sheet_dxf import require_ezdxf

        require_ezdxf()
    case = read_case_of_branches(file) if forces else read_case(file)
    prepare_computation()
    with about(file):
        sheet = _sheet(case, file, forces)
    if suffix == ".dxf":
        from asperity.show.sheet_dxf import sheet_dxf

        write_text(sheet_dxf(sheet), out)
    else:
        from asperity.show.sheet_figure import sheet_figure

        write_image(sheet_figure(sheet), out)
    say_written(out)


def _sheet(case: Case, file: str, forces: bool) -> Sheet:
    from asperity.drive.layout.existence import refuse_impossible
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.own_branches import with_own_branches
    from asperity.show.drive_sheet import drive_sheet

    joint = joint_from_case(case)
    refuse_impossible(joint.drive)
    loaded = result = None
    if forces:
        from asperity.joint.solve import solve_joint

        loaded = with_own_branches(case)
        result = solve_joint(loaded).result
    made = _interference(case, result, file)
    return drive_sheet(joint, name=file, result=result, loaded=loaded, interference=made)


def _interference(case: AnyCase, result: JointResult | None, file: str) -> float | None:
    """The interference with which the ring is made; without it there is a drawing all the same, with a warning."""
    from asperity.joint_file.made_interference import made_interference

    made = made_interference(case, result)
    if made.size is None:
        say(
            f"asperity: warning: {file}: the interference of the preload is not known, and the ring's bore without it: "
            f"{made.unknown_because}"
        )
    return made.size
