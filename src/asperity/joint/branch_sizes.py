"""Sizes of the branches of a joint that differ, as input."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class BranchSizes:
    """Deviations of the sizes of each branch from the nominal ones, and the bearings of the sun.

    Parameters
    ----------
    planet, right_roller, left_roller : ndarray
        Deviations of the radii, larger positive, one for each planet, shape (n,) [m].
    sun_support_stiffness : float
        Radial stiffness of the sun's bearings [N/m]: 0 for a floating sun, ``math.inf`` for one that is held.
    """

    planet: np.ndarray
    right_roller: np.ndarray
    left_roller: np.ndarray
    sun_support_stiffness: float
