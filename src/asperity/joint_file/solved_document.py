"""A joint file solved, with the document that ``asperity joint --json`` prints, whatever the type of its drive."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple, TypeVar

from asperity.joint.branch_results import UnequalBranches
from asperity.joint.description import Joint
from asperity.joint.document import joint_document
from asperity.joint.equal_branches import solve_equal_branches, without_state
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.document import planar_document
from asperity.joint.planar.solve import PlanarSolution, solve_planar
from asperity.joint.planar.solved import SolvedPlanarJoint, solved_planar_joint
from asperity.joint.results import SolvedJoint
from asperity.joint.solve import Solution, solve
from asperity.joint.solved import SolvedPapersJoint
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case, unequal_branches
from asperity.joint_file.model import Case
from asperity.joint_file.planar_assumptions import planar_assumptions
from asperity.joint_file.planar_build import planar_joint_from_case, unequal_sectors
from asperity.joint_file.planar_model import PlanarCase
from asperity.joint_file.si_tables import AnyCase, si_values

_Described = TypeVar("_Described", Joint, PlanarJoint)
_Solution = TypeVar("_Solution", Solution, PlanarSolution)


class SolvedCase(NamedTuple):
    """A joint file, solved.

    Parameters
    ----------
    solved : SolvedJoint
        As :func:`solved_case` finds it.
    document : dict
        All of it as plain data in SI units: :func:`asperity.joint.document.joint_document` or
        :func:`asperity.joint.planar.document.planar_document`.
    """

    solved: SolvedJoint
    document: dict[str, Any]


def solve_case(case: AnyCase) -> SolvedCase:
    """Solve a joint file, and write down what comes out.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.

    Returns
    -------
    SolvedCase
        The joint and its document.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity, of its own branches where they count.
    NoSolutionError
        If no balance was found.
    """
    solved = solved_case(case)
    return SolvedCase(solved, document_of(case, solved))


def document_of(case: AnyCase, solved: SolvedJoint) -> dict[str, Any]:
    """The document of a joint file that is solved already.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.
    solved : SolvedJoint
        As :func:`solved_case` found it.

    Returns
    -------
    dict
        As of :class:`SolvedCase`.
    """
    if isinstance(case, PlanarCase):
        assert isinstance(solved, SolvedPlanarJoint)
        return planar_document(solved, inputs=si_values(case), assumptions=planar_assumptions(case))
    assert isinstance(solved, SolvedPapersJoint)
    return joint_document(solved, inputs=si_values(case), assumptions=assumptions(case))


def solved_case(case: AnyCase) -> SolvedJoint:
    """Solve a joint file, with equal branches and with its own.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.

    Returns
    -------
    SolvedJoint
        What the joint does with equal branches, and what its sections ``[[branch]]`` do. Under a torque that only these
        carry, the results are what all of them do together, and nan for all else.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity, of its own branches where they count.
    NoSolutionError
        If no balance was found.
    """
    solved = _planar(case) if isinstance(case, PlanarCase) else _papers(case)
    if case.rolling is not None and case.rolling.required_life is not None:
        solved.required_life = case.rolling.required_life.value
    return solved


def _papers(case: Case) -> SolvedPapersJoint:
    joint = joint_from_case(case)
    if case.branch is None:
        return SolvedPapersJoint(joint, solve(joint))
    return SolvedPapersJoint(joint, *_with_own(joint, solve, lambda _: unequal_branches(case, joint)))


def _planar(case: PlanarCase) -> SolvedPlanarJoint:
    joint = planar_joint_from_case(case)
    if case.branch is None:
        return solved_planar_joint(joint, solve_planar(joint))
    both = _with_own(joint, solve_planar, lambda equal: unequal_sectors(case, joint, equal))
    return solved_planar_joint(joint, *both)


def _with_own(
    joint: _Described,
    solver: Callable[[_Described], _Solution],
    own_branches: Callable[[_Solution], UnequalBranches | None],
) -> tuple[_Solution, UnequalBranches | None]:
    """What a joint does with equal branches, and with its own."""
    solution, carries = solve_equal_branches(joint, solver)
    found = own_branches(solution)
    if carries or found is None:
        return solution, found
    return without_state(solution, float(joint.output_torque), found), found
