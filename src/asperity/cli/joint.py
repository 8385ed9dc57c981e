"""``asperity joint``: from a joint file to its stiffness."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from asperity.cli.terminal import (
    about,
    json_option,
    plot_option,
    prepare_computation,
    print_json,
    refuse_lonely_measurement_of,
    save_image,
    show_blocks,
    surface_option,
)
from asperity.writing import check_image

if TYPE_CHECKING:
    from asperity.branches.size_errors import SizeErrorCurves
    from asperity.results.solved import SolvedJoint


@click.command()
@click.argument("file", type=click.Path())
@json_option()
@click.option("--all", "in_full", is_flag=True, help="Print everything that is assumed, in full.")
@surface_option
@plot_option("Draw the stiffness budget, the levels and the safety margins: PNG, SVG or PDF.")
def joint(
    file: str,
    as_json: bool,
    in_full: bool,
    surfaces: tuple[str, ...],
    measurement_of: str | None,
    plot_file: str | None,
) -> None:
    """Forces, contacts, torsional stiffness, torque capacity and warnings of the joint described in FILE.

    FILE is a TOML file; 'asperity init' writes one with comments. With --surface a measured surface takes the
    place of the file's, as surface.measurement in the file does: both bodies of a contact have it, unless it is that of
    the pair. It gives the rms of the heights that each contact feels, or
    with model.contact_law = "zou_2025" D and G. What is not certain about it, and the error of the contact law, come
    out as an interval of stiffness and drift. So does what Ra leaves open where the file states surfaces by their Ra.
    If the surface serves several contact laws, stiffness and drift by each of them stand side by side.
    """
    from asperity.joint_file.reader import read_case

    check_image(plot_file, file, *surfaces)
    refuse_lonely_measurement_of(surfaces, measurement_of)
    case = read_case(file, measured=not surfaces)
    prepare_computation()
    from asperity.joint_file.solved_document import solve_with_surface

    with about(file):
        if surfaces:
            from asperity.joint.measured_surface import measured_surface
            from asperity.joint_file.measured_surface import case_with_surface

            case = case_with_surface(case, measured_surface(surfaces, measurement_of))
        solved, document = solve_with_surface(case)
    if plot_file:
        from asperity.show.compliance_figure import joint_figure
        from asperity.show.style import plain_title

        errors = _size_errors(solved)
        save_image(joint_figure(solved, title=plain_title(file), size_errors=errors), plot_file)
    if as_json:
        print_json(document)
        return
    from asperity.views.joint import assumptions
    from asperity.views.screens import joint_screen
    from asperity.views.solved_view import SolvedView

    show_blocks(*joint_screen(SolvedView(solved, document), file), *assumptions(document, in_full=in_full))


def _size_errors(solved: SolvedJoint) -> SizeErrorCurves | None:
    """Branches of unlike sizes over the size of the first; None where the file has none."""
    if solved.branches is None:
        return None
    from asperity.branches.size_errors import size_error_curves

    return size_error_curves(solved.branches)
