"""A joint that stands under torques of either sign: its stiffness on every level, as it is and without slip."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from asperity.joint.description import Joint
from asperity.standing.over_torque import standing_over_torque

#: Levels of the stiffness, from the simplest.
LEVELS = ("published", "series_with_bulk", "assembly")

#: Friction coefficient under which no contact slips at all: T/(mu N) is lost in the rounding of 1 − T/(mu N).
NO_SLIP_FRICTION = 1e30


class Standing(NamedTuple):
    """A joint at torques, as NumPy arrays. SI units.

    Parameters
    ----------
    solved : ndarray
        Whether the forces balance, shape (torques,).
    holds : ndarray
        Whether friction holds the torque, shape (torques,).
    slip_ratio : ndarray
        T/(mu N) of each contact, shape (contacts, torques) [-].
    levels, levels_without_slip : dict
        Name of a level → incremental stiffness at the output, shape (torques,) [N·m/rad]: as the joint is, and under
        the same normal forces with so much friction that no contact slips.
    """

    solved: np.ndarray
    holds: np.ndarray
    slip_ratio: np.ndarray
    levels: dict[str, np.ndarray]
    levels_without_slip: dict[str, np.ndarray]


def standing_at(joint: Joint, torques: np.ndarray) -> Standing:
    """What a wind-up needs to know of a joint with any type of drive."""
    found = standing_over_torque(joint, torques, no_slip_friction=NO_SLIP_FRICTION)
    own, without = ({name: np.asarray(getattr(found, name))[:, k] for name in LEVELS} for k in range(2))
    holds, ratio = np.asarray(found.solved), np.asarray(found.slip_ratio).T
    return Standing(np.asarray(found.balanced), holds, ratio, own, without)
