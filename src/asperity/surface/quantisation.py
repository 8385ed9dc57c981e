"""Detection of heights that an instrument has rounded to whole steps, and the noise that this adds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from asperity.surface.structure_function import logarithmic_lags, structure_functions

_SAMPLE = 2000
_AGREEMENT = 0.8
_PLATEAUS = 0.5
_FEWEST_MOVES = 20
_LEAST_SHARE = 0.02


def height_step(*, profiles: NDArray[np.float64]) -> float | None:
    r"""Step to which heights are rounded [m], or None if there is none.

    The differences d of neighbouring heights are multiples of the step q if
    :math:`\langle \cos(2\pi d/q) \rangle` is near 1, over all and over those above q/2. A
    tilt is removed with the median difference.

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m] as the instrument gave them, no missing points.

    Returns
    -------
    float or None
        The step that explains the differences best, if at least one in fifty differences is a whole step
        other than zero.
    """
    flat = np.diff(profiles, axis=1).ravel()
    d = flat[:: max(1, flat.size // _SAMPLE)]
    d = d - np.median(d)
    size = np.abs(d)
    largest = float(np.quantile(size, 0.995)) * 1.05
    if np.mean(size <= 1e-6 * size.max()) > _PLATEAUS:  # a staircase: steps are rare, and most of them single
        every = np.abs(flat - np.median(flat))
        rises = every[every > 1e-6 * every.max()]
        return float(np.median(rises)) if rises.size else None
    if largest == 0.0:
        return None
    steps = np.geomspace(largest, largest / 300.0, 800)
    best: tuple[float, float] | None = None
    for step in steps:
        moved = d[size > 0.5 * step]
        if moved.size < _FEWEST_MOVES or moved.size < _LEAST_SHARE * d.size:
            continue
        agreement = min(float(np.mean(np.cos(2.0 * np.pi / step * part))) for part in (moved, d))
        if agreement > _AGREEMENT and (best is None or agreement > best[0]):
            best = (agreement, float(step))
        elif best is not None and step < 0.9 * best[1]:
            break
    return None if best is None else best[1]


def resolved_frequency(*, profiles: NDArray[np.float64], step: float, spacing: float) -> float:
    """Highest frequency at which rounded heights still follow the surface [1/m].

    The rounding errors of two points are independent once heights change by about a step between them; below
    the first lag with S = step^2 the profile is a staircase. A wave is resolved if it is at least four such
    lags long.
    Infinite where neighbours already differ by a step.
    """
    lags = logarithmic_lags(points=profiles.shape[1], per_decade=10, longest_fraction=0.5)
    S = structure_functions(profiles=profiles, lags=lags).mean(axis=0)
    coarse = np.flatnonzero(step**2 <= S)
    if coarse.size and coarse[0] == 0:
        return float("inf")
    lag = int(lags[coarse[0]]) if coarse.size else profiles.shape[1]
    return 1.0 / (4.0 * lag * spacing)


def quantisation_noise_density(*, step: float, spacing: float) -> float:
    r"""One-sided density of the white noise of rounding, :math:`2\Delta q^2/12` [m^3]."""
    return 2.0 * spacing * step**2 / 12.0
