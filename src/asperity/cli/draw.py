"""``asperity draw``: the drive of a joint file to scale."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import about, prepare_computation, say, say_written, title_of, title_options
from asperity.errors import InputError
from asperity.writing import IMAGE_SUFFIXES, check_file, write_image, write_pages, write_text

if TYPE_CHECKING:
    from asperity.joint.evaluation import JointResult
    from asperity.joint_file.model import Case
    from asperity.joint_file.si_tables import AnyCase
    from asperity.show.sheet import Sheet
    from asperity.show.title_block import Title


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
    is the one to be made, smaller by the interference that makes the preload, which is stated. Diameters have the
    tolerances of the file, twice those of the radii, and the coarsest grade of ISO 286-1 within them. What the file
    does not state is a dash, or is said not to be stated. With --forces there is no section. A DXF file contains the
    true sizes in mm, with DIMENSION entities; it needs the optional package ezdxf.
    """
    from asperity.cli.terminal import read_case_of_branches
    from asperity.joint_file.reader import read_case

    suffix = Path(out).suffix.lower()
    if suffix not in (*IMAGE_SUFFIXES, ".dxf"):
        raise InputError(f"{out}: the name of a drawing must end in .svg, .pdf, .png or .dxf")
    title = title_of(stated)
    check_file(out, file)
    if suffix == ".dxf":
        from asperity.show.sheet_dxf import require_ezdxf

        require_ezdxf()
    case = read_case_of_branches(file) if forces else read_case(file)
    prepare_computation()
    with about(file):
        sheets = _sheets(case, file, forces, parts, title)
    if suffix == ".pdf" and parts:
        from asperity.show.sheet_figure import sheet_figure

        write_pages([sheet_figure(sheet) for sheet in sheets.values()], out)
        say_written(out)
        return
    files = {Path(out).with_stem(Path(out).stem + name): sheet for name, sheet in sheets.items()}
    for path in files:
        check_file(path, file)
    for path, sheet in files.items():
        _write(sheet, path)
        say_written(str(path))


def _write(sheet: Sheet, path: Path) -> None:
    if path.suffix.lower() == ".dxf":
        from asperity.show.sheet_dxf import sheet_dxf

        write_text(sheet_dxf(sheet), path)
    else:
        from asperity.show.sheet_figure import sheet_figure

        write_image(sheet_figure(sheet), path)


def _sheets(case: Case, file: str, forces: bool, parts: bool, title: Title) -> dict[str, Sheet]:
    """End of the name of each file → its sheet: the assembly, then the parts."""
    from asperity.drive.layout.existence import refuse_impossible
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.own_branches import with_own_branches
    from asperity.joint_file.stated_parts import stated_parts
    from asperity.show.drive_sheet import drive_sheet
    from asperity.show.part_sheets import part_sheets

    joint = joint_from_case(case)
    refuse_impossible(joint.drive)
    loaded = result = None
    if forces:
        from asperity.joint.solve import solve_joint

        loaded = with_own_branches(case)
        result = solve_joint(loaded).result
    made, stated = _interference(case, result, file), stated_parts(case, joint)
    name = Path(file).name
    of_parts = part_sheets(joint, name=name, stated=stated, title=title, interference=made) if parts else {}
    title = title._replace(sheet=f"1 of {len(of_parts) + 1}")
    drawing = drive_sheet(
        joint,
        name=name,
        result=result,
        loaded=loaded,
        interference=made,
        stated=stated,
        title=title,
        section=True,
    )
    return {"": drawing} | {f"_{part}": sheet for part, sheet in of_parts.items()}


def _interference(case: AnyCase, result: JointResult | None, file: str) -> float | None:
    """The interference with which the ring is made; without it there is a drawing all the same, with a warning."""
    from asperity.joint_file.stated_parts import made_interference

    made = made_interference(case, result)
    if made.size is None:
        say(
            f"asperity: warning: {file}: the interference of the preload is not known, and the ring's bore without it: "
            f"{made.unknown_because}"
        )
    return made.size
