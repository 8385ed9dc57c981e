"""A joint file solved, with the document that ``asperity joint --json`` prints, whatever the type of its drive."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Generic, NamedTuple, TypeVar

from asperity.joint.branch_results import UnequalBranches
from asperity.joint.description import Joint
from asperity.joint.document import joint_document
from asperity.joint.equal_branches import solve_equal_branches, without_state
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.document import planar_document
from asperity.joint.planar.solve import PlanarSolution, solve_planar
from asperity.joint.solve import Solution, solve
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case, unequal_branches
from asperity.joint_file.model import Case
from asperity.joint_file.planar_assumptions import planar_assumptions
from asperity.joint_file.planar_build import planar_joint_from_case, unequal_sectors
from asperity.joint_file.planar_model import PlanarCase
from asperity.joint_file.si_tables import AnyCase, si_values

_Described = TypeVar("_Described", Joint, PlanarJoint)
_Solved = TypeVar("_Solved", Solution, PlanarSolution)


class SolvedCase(NamedTuple, Generic[_Described, _Solved]):
    """A joint file, solved.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        The joint that it describes.
    solution : Solution or PlanarSolution
        What the joint does with equal branches. Under a torque that only its own branches carry, what all of these do
        together, and nan for all else.
    branches : UnequalBranches or None
        What its sections ``[[branch]]`` do; None where there are none.
    document : dict
        All of it as plain data in SI units.
    """

    joint: _Described
    solution: _Solved
    branches: UnequalBranches | None
    document: dict[str, Any]


def solve_case(case: Case) -> SolvedCase[Joint, Solution]:
    """Solve a joint file with the paper's drive.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    SolvedCase
        With the document of :func:`asperity.joint.document.joint_document`.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity, of its own branches where they count.
    NoSolutionError
        If no balance was found.
    """
    joint, solution, found = papers_branches(case)
    document = joint_document(
        joint=joint,
        solution=solution,
        inputs=si_values(case),
        assumptions=assumptions(case),
        branches=found,
    )
    return SolvedCase(joint, solution, found, document)


def solve_planar_case(case: PlanarCase) -> SolvedCase[PlanarJoint, PlanarSolution]:
    """Solve a joint file with another drive.

    Parameters
    ----------
    case : PlanarCase
        The joint file.

    Returns
    -------
    SolvedCase
        With the document of :func:`asperity.joint.planar.document.planar_document`.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity, of its own branches where they count.
    NoSolutionError
        If no balance was found.
    """
    joint, solution, found = planar_branches(case)
    document = planar_document(
        joint=joint,
        solution=solution,
        inputs=si_values(case),
        assumptions=planar_assumptions(case),
        branches=found,
    )
    return SolvedCase(joint, solution, found, document)


def solved_document(case: AnyCase) -> dict[str, Any]:
    """Solve a joint file with any drive.

    Parameters
    ----------
    case : Case or PlanarCase
        The joint file.

    Returns
    -------
    dict
        The document of :func:`solve_case` or :func:`solve_planar_case`.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity, of its own branches where they count.
    NoSolutionError
        If no balance was found.
    """
    return solve_planar_case(case).document if isinstance(case, PlanarCase) else solve_case(case).document


def papers_branches(case: Case) -> tuple[Joint, Solution, UnequalBranches | None]:
    """Solve a joint file with the paper's drive, with equal branches and with its own.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    joint : Joint
        The joint that it describes.
    solution : Solution
        With equal branches; as of :class:`SolvedCase` under a torque that only its own branches carry.
    found : UnequalBranches or None
        With its own; None where it states none.

    Raises
    ------
    InputError
        If the bodies do not fit, or its branches do not carry the output torque.
    NoSolutionError
        If no balance was found.
    """
    joint = joint_from_case(case)
    return _solved(case, joint, solve, lambda _: unequal_branches(case, joint))


def planar_branches(case: PlanarCase) -> tuple[PlanarJoint, PlanarSolution, UnequalBranches | None]:
    """Solve a joint file with another drive, as :func:`papers_branches`.

    Parameters
    ----------
    case : PlanarCase
        The joint file.

    Returns
    -------
    PlanarJoint, PlanarSolution, UnequalBranches or None
        As of :func:`papers_branches`.

    Raises
    ------
    InputError, NoSolutionError
        As :func:`papers_branches`.
    """
    joint = planar_joint_from_case(case)
    return _solved(case, joint, solve_planar, lambda found: unequal_sectors(case, joint, found))


def _solved(
    case: AnyCase,
    joint: _Described,
    solver: Callable[[_Described], _Solved],
    own_branches: Callable[[_Solved], UnequalBranches | None],
) -> tuple[_Described, _Solved, UnequalBranches | None]:
    """A joint with equal branches, and with its own where its file states them."""
    if case.branch is None:
        return joint, solver(joint), None
    solution, carries = solve_equal_branches(joint, solver)
    found = own_branches(solution)
    if carries or found is None:
        return joint, solution, found
    return joint, without_state(solution, float(joint.output_torque), found), found
