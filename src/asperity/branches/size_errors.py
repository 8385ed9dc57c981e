"""Unequal branches over the size of one planet."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.branches.branches import BranchedJoint
from asperity.branches.results import BranchState, UnequalBranches
from asperity.branches.sizes import SectorDeviations
from asperity.errors import InputError, NoSolutionError


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
    sun_force : ndarray
        Force of the planets on the sun under the torque at rest [N].
    noun, track : str, optional
        What a branch is called, and whose radius it is.
    """

    deviation: np.ndarray
    standing_share: np.ndarray
    rolling_share: np.ndarray
    first_slip: np.ndarray
    all_slip: np.ndarray
    sun_force: np.ndarray
    noun: str = "planet"
    track: str = "planet"


def size_error_curves(
    drive: BranchedJoint, sizes: SectorDeviations, deviation: np.ndarray
) -> SizeErrorCurves:
    """What a wrong size of one planet does."""
    found = [_solved(drive, sizes.with_first(each)) for each in deviation]
    nothing = np.full(drive.count, np.nan)

    def shares(states: list[BranchState | None]) -> np.ndarray:
        return np.array([nothing if state is None else state.share for state in states])

    def numbers(of: Callable[[UnequalBranches], float]) -> np.ndarray:
        return np.array([np.nan if each is None else of(each) for each in found])

    known = next((each for each in found if each is not None), None)
    return SizeErrorCurves(
        deviation=deviation,
        standing_share=shares([None if each is None else each.standing for each in found]),
        rolling_share=shares([None if each is None else each.rolling for each in found]),
        first_slip=numbers(lambda each: each.capacity.first_slip),
        all_slip=numbers(lambda each: each.capacity.all_slip),
        sun_force=numbers(
            lambda each: np.nan if each.standing is None else float(np.hypot(*each.standing.sun_force))
        ),
        noun="planet" if known is None else known.noun,
        track=next(iter(sizes.deviations)).replace("_", " "),
    )


def _solved(drive: Any, sizes: SectorDeviations) -> UnequalBranches | None:
    """What branches of given sizes do; None where they are refused."""
    try:
        found: UnequalBranches = drive.branches(sizes)
    except (InputError, NoSolutionError):
        return None
    return found
