"""A joint file solved, with the document that ``asperity joint --json`` prints."""

from __future__ import annotations

from typing import Any, NamedTuple

from asperity.joint.solve import solve_joint
from asperity.joint_file.assumptions import assumptions
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.own_branches import branches_of
from asperity.joint_file.si_tables import AnyCase, si_values
from asperity.results.document import joint_document
from asperity.results.solved import SolvedJoint, solved_with_capacities


class SolvedCase(NamedTuple):
    """A joint file, solved by :func:`solved_case`, and all of it as plain data in SI units."""

    solved: SolvedJoint
    document: dict[str, Any]


def solve_case(case: AnyCase) -> SolvedCase:
    """Solve a joint file, and write down what comes out.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    SolvedCase
        The joint and its document.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity.
    NoSolutionError
        If no balance was found.
    """
    solved = solved_case(case)
    return SolvedCase(solved, document_of(case, solved))


def document_of(case: AnyCase, solved: SolvedJoint) -> dict[str, Any]:
    """The document of a joint file that is solved already."""
    return joint_document(solved, inputs=si_values(case), assumptions=assumptions(case))


def solved_case(case: AnyCase) -> SolvedJoint:
    """Solve a joint file.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    SolvedJoint
        The joint; with sections ``[[branch]]`` it and its results have every branch by itself.

    Raises
    ------
    InputError
        If the bodies do not fit, or the output torque exceeds the capacity.
    NoSolutionError
        If no balance was found.
    """
    branches = branches_of(case)
    joint = joint_from_case(case) if branches is None else branches.joint
    solved = solved_with_capacities(joint, solve_joint(joint), branches)
    if case.rolling is not None and case.rolling.required_life is not None:
        solved.required_life = case.rolling.required_life.value
    return solved
