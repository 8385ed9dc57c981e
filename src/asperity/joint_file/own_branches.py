"""The joint of a file with the sizes of its own branches, for whatever takes a joint."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from asperity.joint_file.build import (
    branched_joint,
    deviations_of,
    joint_from_case,
)
from asperity.joint_file.si_tables import AnyCase, si_values

if TYPE_CHECKING:
    from asperity.joint.description import Joint


def with_own_branches(case: AnyCase) -> Joint:
    """The joint of a file with its own branches, where they differ.

    Parameters
    ----------
    case : Case
        The joint file.

    Returns
    -------
    Joint
        With sections ``[[branch]]``: every branch by itself, contacts and rollers with its number behind their names.
        Otherwise the joint with equal branches.

    Raises
    ------
    InputError
        If the bodies do not fit, or the branches cannot be compared.
    NoSolutionError
        If no balance without torque was found.

    References
    ----------
    Equation (I4) of :doc:`/equations`.
    """
    if case.branch is None:
        return joint_from_case(case)
    from asperity.joint.solve import solve_joint

    joint = joint_from_case(case)
    free = dataclasses.replace(joint, output_torque=0.0)  # which equal branches carry, whatever its own do
    branched = branched_joint(case, free, solve_joint(free))
    assert branched is not None
    unfolded = branched.unfolded(deviations_of(si_values(case)))
    return dataclasses.replace(unfolded, output_torque=joint.output_torque)
