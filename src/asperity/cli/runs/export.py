"""What the command of :mod:`asperity.cli.export` does."""

from __future__ import annotations

from pathlib import Path

from asperity.cli.joint_input import read_case_of_branches
from asperity.cli.options import read_option
from asperity.cli.terminal import about, about_torque, say_written, show_blocks
from asperity.export.content import export_content, heading
from asperity.export.targets import check_target, exported, write_exported
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.section_build import inertias_from_case
from asperity.standing.windup import StiffnessLevel
from asperity.unit_table import Dimension
from asperity.views.blocks import Paragraph


def export(file: str, to: str, out: str, torque: str | None, level: StiffnessLevel) -> None:
    """What ``asperity export`` does; its options stand in :mod:`asperity.cli.export`."""
    check_target(to, out, file)
    case = read_case_of_branches(file)
    asked = None if torque is None else read_option("torque", torque, Dimension.TORQUE)
    with about(file), about_torque(torque):
        content = export_content(
            with_own_branches(case),
            inertias=None if case.dynamics is None else inertias_from_case(case),
            source=Path(file).name,
            largest_torque=asked,
            level=level,
        )
    made = exported(content, to=to, suffix=Path(out).suffix)
    write_exported(made, out)
    sentences = (*heading(content, what=f"{out}: {to}"), *made.notes)
    show_blocks(*map(Paragraph, sentences))
    say_written(out)
