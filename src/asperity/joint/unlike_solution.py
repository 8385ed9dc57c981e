"""A joint with the paper's drive under one torque, its branches unlike: what they do together, and their capacity."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.branch_limits import no_rolling_together, refuse_beyond, slipping_in_rolling
from asperity.joint.branch_results import UnequalBranches
from asperity.joint.equal_branches import solve_equal_branches, without_state
from asperity.joint.evaluation import JointResult
from asperity.joint.rolling_document import absent_in_rolling
from asperity.joint.solve import solve
from asperity.joint.unlike_joint import UnlikeJoint


class UnlikeSolution(NamedTuple):
    """What unlike branches do together.

    Parameters
    ----------
    result : JointResult
        Torques, drift and powers of all branches; nan for what only a single contact has, as of
        :func:`asperity.joint.equal_branches.without_state`.
    branches : UnequalBranches
        The branches.
    """

    result: JointResult
    branches: UnequalBranches

    @property
    def capacity_document(self) -> dict[str, Any]:
        """Torque capacity, standing, as :func:`asperity.joint.capacity.capacity_document` says it."""
        found = self.branches.capacity
        contact = f"{found.contact_name}_{found.branch + 1}" if found.contact is not None else None
        return {
            "output_torque_Nm": found.all_slip,
            "limit": "gross_slip",
            "limiting_contact": contact,
            "meaning": "all branches slip",
            "is_lower_bound": False,
            "first_slip": {"output_torque_Nm": found.first_slip, "contact": contact},
        }

    def unknown_because(self, joint: UnlikeJoint) -> list[str]:
        """Why results of the rolling are absent, one sentence each."""
        refused = no_rolling_together(self.branches) or slipping_in_rolling(self.branches)
        return [refused] if refused else absent_in_rolling(joint.joint, self.result)

    @property
    def rolling_contacts(self) -> tuple[str, ...]:
        """Names of the contacts of the branches that are pressed in rolling, branch by branch."""
        rolling = self.branches.rolling
        pressed = () if rolling is None else np.flatnonzero(rolling.preload > 0.0)
        return tuple(f"{name}_{branch + 1}" for branch in pressed for name in CONTACT_NAMES)


def solve_unlike(joint: UnlikeJoint) -> UnlikeSolution:
    """Solve a joint with its own branches.

    Parameters
    ----------
    joint : UnlikeJoint
        One joint.

    Returns
    -------
    UnlikeSolution
        Under its torque and at its speed.

    Raises
    ------
    InputError
        If the bodies do not fit, or its branches do not carry the torque.
    NoSolutionError
        If no balance was found.
    """
    solution, _ = solve_equal_branches(joint.joint, solve)
    found, torque = joint.branches(), float(joint.output_torque)
    refuse_beyond(found, torque)
    return UnlikeSolution(without_state(solution, torque, found).result, found)
