"""Unequal branches over the size of one planet."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from asperity.joint.branch_results import BranchState
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.branches import BranchedJoint


@dataclass(frozen=True)
class SizeErrorCurves:
    """Unequal branches over a further deviation of the first planet. SI units; shape (m,), shares (m, n).

    Parameters
    ----------
    deviation : ndarray
        Added to the radius of the first planet [m].
    standing_share, rolling_share : ndarray
        Shares of the branches in the torque [-]; nan where all slip.
    first_slip, all_slip : ndarray
        Torques of the standing joint at which the weakest branch and all of them slip [N·m].
    sun_force : ndarray
        Force of the planets on the sun under the torque at rest [N].
    """

    deviation: np.ndarray
    standing_share: np.ndarray
    rolling_share: np.ndarray
    first_slip: np.ndarray
    all_slip: np.ndarray
    sun_force: np.ndarray


def size_error_curves(drive: BranchedJoint, sizes: BranchSizes, deviation: np.ndarray) -> SizeErrorCurves:
    """What a wrong size of one planet does.

    Parameters
    ----------
    drive : BranchedJoint
        The joint.
    sizes : BranchSizes
        Sizes of its branches.
    deviation : ndarray
        Added to the radius of the first planet, shape (m,) [m].

    Returns
    -------
    SizeErrorCurves
        At each deviation.
    """
    found = [drive.branches(sizes.with_first(each), slip=False) for each in deviation]
    nothing = np.full(drive.count, np.nan)

    def shares(states: list[BranchState | None]) -> np.ndarray:
        return np.array([nothing if state is None else state.share for state in states])

    return SizeErrorCurves(
        deviation=deviation,
        standing_share=shares([each.standing for each in found]),
        rolling_share=shares([each.rolling for each in found]),
        first_slip=np.array([each.capacity.first_slip for each in found]),
        all_slip=np.array([each.capacity.all_slip for each in found]),
        sun_force=np.array(
            [np.nan if each.standing is None else np.hypot(*each.standing.sun_force) for each in found]
        ),
    )
