"""A joint file solved into its document, whatever the type of its drive."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from asperity.joint.planar.description import PlanarJoint
    from asperity.joint.planar.solve import PlanarSolution
    from asperity.joint_file.planar_model import PlanarCase

Document = dict[str, Any]


def solved_planar(case: PlanarCase) -> tuple[PlanarJoint, PlanarSolution, Document]:
    """Solve a joint file with a planar drive.

    Parameters
    ----------
    case : PlanarCase
        The joint file.

    Returns
    -------
    PlanarJoint, PlanarSolution, dict
        The joint, its solution, and its document.
    """
    from asperity.joint.planar.document import planar_document
    from asperity.joint.planar.solve import solve_planar
    from asperity.joint_file.planar_assumptions import planar_assumptions
    from asperity.joint_file.planar_build import planar_joint_from_case
    from asperity.joint_file.si_tables import si_values

    joint = planar_joint_from_case(case)
    solution = solve_planar(joint)
    document = planar_document(
        joint=joint, solution=solution, inputs=si_values(case), assumptions=planar_assumptions(case)
    )
    return joint, solution, document
