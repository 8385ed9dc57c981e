"""A joint file solved into the document that ``asperity joint --json`` prints, whatever the type of its drive."""

from __future__ import annotations

from typing import Any

from asperity.joint.document import joint_document
from asperity.joint.planar.document import planar_document
from asperity.joint.planar.solve import solve_planar
from asperity.joint.solve import solve
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case, unequal_branches
from asperity.joint_file.planar_assumptions import planar_assumptions
from asperity.joint_file.planar_build import planar_joint_from_case, unequal_sectors
from asperity.joint_file.planar_model import PlanarCase
from asperity.joint_file.si_tables import AnyCase, si_values


def solved_document(case: AnyCase) -> dict[str, Any]:
    """Solve a joint file.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.

    Returns
    -------
    dict
        As :func:`asperity.joint.document.joint_document` or :func:`asperity.joint.planar.document.planar_document`.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the torque capacity.
    NoSolutionError
        If no balance was found.
    """
    inputs = si_values(case)
    if isinstance(case, PlanarCase):
        drive = planar_joint_from_case(case)
        solution = solve_planar(drive)
        return planar_document(
            joint=drive,
            solution=solution,
            inputs=inputs,
            assumptions=planar_assumptions(case),
            branches=unequal_sectors(case, drive, solution),
        )
    joint = joint_from_case(case)
    return joint_document(
        joint=joint,
        solution=solve(joint),
        inputs=inputs,
        assumptions=assumptions(case),
        branches=unequal_branches(case, joint),
    )
