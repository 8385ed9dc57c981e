"""What the command of :mod:`asperity.cli.joint` does."""

from __future__ import annotations

from asperity.branches.size_errors import size_error_curves
from asperity.cli.joint_input import refuse_lonely_measurement_of
from asperity.cli.terminal import about, print_json, save_image, show_blocks
from asperity.joint_file.reader import read_case
from asperity.joint_file.solved_document import solve_with_surface
from asperity.joint_file.stated_parts import made_interference
from asperity.show.compliance_figure import joint_figure
from asperity.show.style import plain_title
from asperity.views.joint import assumptions
from asperity.views.screens import joint_screen
from asperity.views.solved_view import SolvedView
from asperity.writing import check_image


def joint(
    file: str,
    as_json: bool,
    in_full: bool,
    surfaces: tuple[str, ...],
    measurement_of: str | None,
    plot_file: str | None,
) -> None:
    """What ``asperity joint`` does; its options stand in :mod:`asperity.cli.joint`."""
    check_image(plot_file, file, *surfaces)
    refuse_lonely_measurement_of(surfaces, measurement_of)
    case = read_case(file, measured=not surfaces)
    with about(file):
        if surfaces:
            from asperity.joint.measured_surface import measured_surface  # which imports SciPy
            from asperity.joint_file.measured_surface import case_with_surface

            case = case_with_surface(case, measured_surface(surfaces, measurement_of))
        solved, document = solve_with_surface(case)
    if plot_file:
        errors = None if solved.branches is None else size_error_curves(solved.branches)
        save_image(joint_figure(solved, title=plain_title(file), size_errors=errors), plot_file)
    if as_json:
        print_json(document)
        return
    view = SolvedView(solved, document, made_interference(case, solved.result).size)
    brief = "" if in_full else "in full, with shares, springs and the drive, with --all"
    show_blocks(*joint_screen(view, file, in_full=in_full), *assumptions(document, brief=brief))
