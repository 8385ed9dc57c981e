"""Structure functions of measured profiles, with missing points allowed, and the step of rounded heights."""

from __future__ import annotations

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError

#: Up to this lag differences are formed directly: the transform loses digits where S is small.
DIRECT_LAGS = 16
_CHUNK_POINTS = 2_000_000
_SAMPLE = 2000
_AGREEMENT = 0.8
_PLATEAUS = 0.5
_FEWEST_MOVES = 20
_LEAST_SHARE = 0.02


def logarithmic_lags(*, points: int, per_decade: int, longest_fraction: float) -> NDArray[np.int64]:
    """Distinct whole lags, evenly spread in their logarithm, from 1 to a fraction of the record."""
    longest = max(2, int(points * longest_fraction))
    count = max(2, int(np.ceil(np.log10(longest) * per_decade)) + 1)
    return np.unique(np.round(np.logspace(0.0, np.log10(longest), count)).astype(np.int64))


def structure_functions(*, profiles: NDArray[np.float64], lags: NDArray[np.int64]) -> NDArray[np.float64]:
    r"""Structure function of each profile, shape (profiles, lags) [m^2]; NaN where no pair is left.

    .. math::
        S_k = \frac{1}{N_k} \sum_i (z_{i+k} - z_i)^2

    Of heights [m], shape (profiles, points), where NaN marks missing points, whose pairs are left out; lags in points,
    each from 1 to points - 1. The sum of squared differences is two sums of squares less twice the autocorrelation,
    which costs one Fourier transform of twice the length; rows are worked through in blocks, so memory stays small.
    """
    if profiles.ndim != 2:
        raise InputError(f"profiles must have shape (profiles, points), not {profiles.shape}")
    rows, points = profiles.shape
    if lags.size == 0 or lags.min() < 1 or lags.max() >= points:
        raise InputError(f"lags must lie between 1 and {points - 1} points")
    result = np.empty((rows, lags.size))
    step = max(1, _CHUNK_POINTS // points)
    for start in range(0, rows, step):
        block = profiles[start : start + step]
        absent = np.isnan(block)
        if absent.any():
            result[start : start + step] = _with_gaps(block, ~absent, lags)
        else:
            result[start : start + step] = _complete(block, lags)
    return result


def _complete(block: NDArray[np.float64], lags: NDArray[np.int64]) -> NDArray[np.float64]:
    points = block.shape[1]
    out = np.empty((block.shape[0], lags.size))
    short = lags <= DIRECT_LAGS
    for j in np.flatnonzero(short):
        lag = int(lags[j])
        difference = block[:, lag:] - block[:, :-lag]
        out[:, j] = np.einsum("ij,ij->i", difference, difference) / (points - lag)
    if not short.all():
        k = lags[~short]
        z = block - block.mean(axis=1, keepdims=True)
        size = scipy.fft.next_fast_len(points + int(k.max()), real=True)
        spectrum = scipy.fft.rfft(z, n=size, axis=1)
        power = spectrum.real**2 + spectrum.imag**2
        correlation = scipy.fft.irfft(power, n=size, axis=1)[:, k]
        np.multiply(z, z, out=z)
        total = np.cumsum(z, axis=1)
        # sum over the first and over the last N - k squares
        ends = total[:, points - k - 1] + total[:, -1:] - total[:, k - 1]
        out[:, ~short] = (ends - 2.0 * correlation) / (points - k)
    return out


def _with_gaps(
    block: NDArray[np.float64], present: NDArray[np.bool_], lags: NDArray[np.int64]
) -> NDArray[np.float64]:
    points = block.shape[1]
    m = present.astype(np.float64)
    count = np.maximum(m.sum(axis=1, keepdims=True), 1.0)
    z = np.where(present, block, 0.0)
    z = np.where(present, z - z.sum(axis=1, keepdims=True) / count, 0.0)
    size = scipy.fft.next_fast_len(points + int(lags.max()), real=True)
    M, Z, Q = (scipy.fft.rfft(a, n=size, axis=1) for a in (m, z, z * z))
    cross = Q * M.conj() + M * Q.conj() - 2.0 * (Z * Z.conj())
    pairs = scipy.fft.irfft(M * M.conj(), n=size, axis=1)[:, lags]
    squares = scipy.fft.irfft(cross, n=size, axis=1)[:, lags]
    return np.where(pairs > 0.5, squares / np.maximum(np.round(pairs), 1.0), np.nan)


def height_step(*, profiles: NDArray[np.float64]) -> float | None:
    r"""Step to which heights as the instrument gave them are rounded [m], or None if there is none.

    The differences d of neighbouring heights are multiples of the step q if :math:`\langle \cos(2\pi d/q) \rangle` is
    near 1, over all and over those above q/2. A tilt is removed with the median difference. It is the step that
    explains the differences best, if at least one in fifty differences is a whole step other than zero. No missing
    points; shape (profiles, points).
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
