"""Detecting heights that an instrument has rounded to whole steps, and the noise that this adds."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

_SAMPLE = 2000
_COHERENCE = 0.8


def height_step(*, profiles: NDArray[np.float64]) -> float | None:
    r"""Step to which heights are rounded [m], or None if there is none.

    The differences d of neighbouring heights are multiples of the step q if
    :math:`|\langle e^{2\pi i d/q} \rangle|` is near 1. A tilt taken off afterwards only turns the phase.

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m] as the instrument gave them, no missing points.

    Returns
    -------
    float or None
        The largest step that explains the differences, if at least a fifth of the differences are whole steps
        other than zero; smaller steps disturb nobody.
    """
    flat = np.diff(profiles, axis=1).ravel()
    d = flat[:: max(1, flat.size // _SAMPLE)]
    d = d - np.median(d)
    size = np.abs(d)
    largest = float(np.quantile(size, 0.995)) * 1.05
    if largest == 0.0:
        return None
    steps = np.geomspace(largest, largest / 300.0, 800)
    coherence = np.abs(np.mean(np.exp(2j * np.pi * d / steps[:, None]), axis=1))
    moved = np.mean(size > 0.5 * steps[:, None], axis=1)
    good = np.flatnonzero((coherence > _COHERENCE) & (moved >= 0.2))
    if good.size == 0:
        return None
    near = good[good <= good[0] + 8]
    return float(steps[near[np.argmax(coherence[near])]])


def quantisation_noise_density(*, step: float, spacing: float) -> float:
    r"""One-sided density of the white noise of rounding, :math:`2\Delta q^2/12` [m^3]."""
    return 2.0 * spacing * step**2 / 12.0
