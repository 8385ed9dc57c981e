"""Places of the rollers of a drive at which all contacts just touch."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from asperity.drive.layout.drive import Drive, gaps, incidence
from asperity.engine.arrays import uses_jax, xp
from asperity.engine.control import fori_loop, traced_once

_STEPS = 30
_LONGEST_STEP = 0.2  # over the smallest radius
_SHORTEST_STEP = 1e-14  # likewise; below it only rounding moves the centres


def closed(drive: Drive) -> Drive:
    r"""Move the centres of a drive as little as possible until all contacts just touch.

    .. math:: A u = g

    Parameters
    ----------
    drive : Drive
        The drive, its centres near their places.

    Returns
    -------
    Drive
        The drive with closed gaps; where the radii do not allow that, gaps remain.

    Notes
    -----
    Newton's method with the smallest displacements u that close the gaps g at each step, or come closest to it.

    References
    ----------
    Equation (M1) of :doc:`/equations`.
    """
    if uses_jax(drive):
        return _traced_closed(drive)
    centres = drive.centres
    with np.errstate(all="ignore"):  # of a layout that cannot exist they are nan, as with JAX
        for _ in range(_STEPS):
            move = _move(drive, centres)
            centres = centres + move
            if np.max(np.abs(move)) <= _SHORTEST_STEP * _least_radius(drive):
                break
    return dataclasses.replace(drive, centres=centres, motion=None)


@traced_once
def _traced_closed(drive: Drive) -> Drive:
    centres = fori_loop(0, _STEPS, lambda _, centres: centres + _move(drive, centres), drive.centres)
    return dataclasses.replace(drive, centres=centres, motion=None)


def _least_radius(drive: Drive) -> Any:
    return xp.minimum(xp.min(drive.first_radius), xp.min(drive.second_radius))


def _move(drive: Drive, centres: Any) -> Any:
    """How far all centres move in one step."""
    placed = dataclasses.replace(drive, centres=centres, motion=None)
    approach, clearance = incidence(placed).approach, gaps(placed)
    if not uses_jax(approach) and not (np.all(np.isfinite(approach)) and np.all(np.isfinite(clearance))):
        return np.full_like(centres, np.nan)
    moved, *_ = xp.linalg.lstsq(approach, clearance, rcond=None)
    longest = _LONGEST_STEP * _least_radius(drive)
    moved = moved * xp.minimum(1.0, longest / xp.maximum(xp.max(xp.abs(moved)), 1e-300))
    return np.eye(len(drive.bodies))[:, list(drive.floating)] @ moved.reshape(-1, 2)
