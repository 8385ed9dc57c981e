"""Unequal branches over the size of one planet."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from asperity.branches.branches import AssembledBranches, SectorDeviations, assembled_branches
from asperity.branches.results import BranchState, UnequalBranches, unequal_branches
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.solve import DirectedLimits, states_and_limits

_WIDEST = 0.4  # of the interference
_POINTS = 17


@dataclass(frozen=True)
class SizeErrorCurves:
    """Unequal branches over a further deviation of the first. SI units; shape (m,), shares (m, n).

    All but the deviation is nan where a joint with such sizes is refused, one with a loose sector for example.

    Parameters
    ----------
    deviation : ndarray
        Added to the radius of the first planet, or to that track of the first sector which the file names first [m].
    standing_share, rolling_share : ndarray
        Shares of the branches in the torque [-]; nan where all slip.
    first_slip, all_slip : ndarray
        Torques of the standing joint at which the weakest branch and all of them slip [N·m].
    central_force : ndarray
        Force of the rollers on the input under the torque at rest [N].
    noun, track : str
        What a branch is called, and whose radius it is.
    """

    deviation: np.ndarray
    standing_share: np.ndarray
    rolling_share: np.ndarray
    first_slip: np.ndarray
    all_slip: np.ndarray
    central_force: np.ndarray
    noun: str
    track: str


class LoadedBranches(NamedTuple):
    """Unequal branches under the torque of their joint, and the torques that they pass in its direction."""

    branches: UnequalBranches
    limits: DirectedLimits


def loaded_branches(joint: Joint, sizes: SectorDeviations) -> LoadedBranches:
    """Unequal branches of one joint of equal sectors, without the results of their contacts; equation (I4).

    Raises as :func:`asperity.branches.branches.assembled_branches`.
    """
    assembled = assembled_branches(joint, sizes)
    states, limits = states_and_limits(assembled.joint)
    return LoadedBranches(unequal_branches(assembled, states), limits)


def size_error_curves(branches: AssembledBranches) -> SizeErrorCurves:
    """What a wrong size of one planet does."""
    joint, sizes = branches.equal, branches.sizes
    widest = _WIDEST * branches.equal_interference
    deviation = np.linspace(-widest, widest, _POINTS)
    loaded = [_loaded(joint, sizes.with_first(deviated)) for deviated in deviation]
    nothing = np.full(branches.sectors, np.nan)

    def shares(of: Callable[[UnequalBranches], BranchState | None]) -> np.ndarray:
        states = [None if point is None else of(point.branches) for point in loaded]
        return np.array([nothing if state is None else state.share for state in states])

    def numbers(of: Callable[[LoadedBranches], float]) -> np.ndarray:
        return np.array([np.nan if point is None else of(point) for point in loaded])

    return SizeErrorCurves(
        deviation=deviation,
        standing_share=shares(lambda branches: branches.standing),
        rolling_share=shares(lambda branches: branches.rolling),
        first_slip=numbers(lambda point: float(point.limits.first_slip.output_torque)),
        all_slip=numbers(lambda point: float(point.limits.standing.output_torque)),
        central_force=numbers(
            lambda point: (
                math.nan
                if point.branches.standing is None
                else math.hypot(*point.branches.standing.central_force)
            )
        ),
        noun=branches.noun,
        track=next(iter(sizes.deviations)).replace("_", " "),
    )


def _loaded(joint: Joint, sizes: SectorDeviations) -> LoadedBranches | None:
    """Branches of given sizes; None where they are refused."""
    try:
        return loaded_branches(joint, sizes)
    except (InputError, NoSolutionError):
        return None
