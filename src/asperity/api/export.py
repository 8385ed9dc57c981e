"""A joint for other programs, from a script."""

from __future__ import annotations

from pathlib import Path

from asperity.api.joint import DescribedJoint, require_joint
from asperity.api.named_quantity import NamedQuantity, si_number
from asperity.api.shown import Shown
from asperity.export.content import export_content, heading
from asperity.export.targets import check_target, exported, write_exported
from asperity.joint_file.own_branches import with_own_branches
from asperity.joint_file.section_build import inertias_from_case
from asperity.results import LEVELS, known_result
from asperity.standing.windup import StiffnessLevel
from asperity.unit_table import Dimension
from asperity.views.blocks import Block, Paragraph


def export_joint(
    joint: DescribedJoint,
    *,
    to: str,
    out: str | Path,
    torque: str | NamedQuantity | None = None,
    level: StiffnessLevel = "assembly",
) -> ExportedFile:
    """Write a joint for another program: stiffness, hysteresis, play and drift.

    Parameters
    ----------
    joint : DescribedJoint
        From :func:`asperity.load`.
    to : str
        The program, as ``asperity export --help`` names it, such as ``"table"``.
    out : str or Path
        The file; an earlier export is replaced.
    torque : str or NamedQuantity, optional
        Largest output torque with its unit, such as ``"5 N*m"``; by default the output torque of the file.
    level : {"assembly", "series_with_bulk", "published"}, optional
        Which stiffness makes the wind-up.

    Returns
    -------
    ExportedFile
        What was written.

    Raises
    ------
    InputError
        If there is no such program, it cannot carry the joint, the torque is out of range, or the file cannot be
        written.
    NoSolutionError
        If the force balance does not close.
    """
    require_joint(joint)
    known_result(level, among=LEVELS, what="level of the stiffness")
    check_target(to, out, joint.source)
    largest = None if torque is None else si_number(torque, Dimension.TORQUE, name="torque")
    case = joint.case
    content = export_content(
        with_own_branches(case),
        inertias=None if case.dynamics is None else inertias_from_case(case),
        source=Path(joint.source).name,
        largest_torque=largest,
        level=level,
    )
    made = exported(content, to=to, suffix=Path(out).suffix)
    write_exported(made, out)
    return ExportedFile(Path(out), (*heading(content, what=f"{out}: {to}"), *made.notes))


class ExportedFile(Shown):
    """A file for another program.

    Parameters
    ----------
    path : Path
        The file.
    sentences : tuple of str
        What it contains, and what its user should know.
    """

    def __init__(self, path: Path, sentences: tuple[str, ...]) -> None:
        self.path, self.sentences = path, sentences

    def blocks(self) -> list[Block]:
        """What it contains, and what its user should know."""
        return [Paragraph(sentence) for sentence in self.sentences]
