"""Structure functions of measured profiles by Fourier transform, with missing points allowed."""

from __future__ import annotations

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError

#: Up to this lag differences are formed directly: the transform loses digits where S is small.
DIRECT_LAGS = 16
_CHUNK_POINTS = 2_000_000


def logarithmic_lags(*, points: int, per_decade: int, longest_fraction: float) -> NDArray[np.int64]:
    """Distinct whole lags, evenly spread in their logarithm, from 1 to a fraction of the record."""
    longest = max(2, int(points * longest_fraction))
    count = max(2, int(np.ceil(np.log10(longest) * per_decade)) + 1)
    return np.unique(np.round(np.logspace(0.0, np.log10(longest), count)).astype(np.int64))


def structure_functions(*, profiles: NDArray[np.float64], lags: NDArray[np.int64]) -> NDArray[np.float64]:
    r"""Structure function of each profile.

    .. math::
        S_k = \frac{1}{N_k} \sum_i (z_{i+k} - z_i)^2

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m]; NaN marks missing points, whose pairs are left out.
    lags : array of int, shape (lags,)
        Lags in points, each from 1 to points - 1.

    Returns
    -------
    array, shape (profiles, lags)
        S [m^2]; NaN where no pair is left.

    Notes
    -----
    The sum of squared differences is two sums of squares less twice the autocorrelation, which costs one
    Fourier transform of twice the length; rows are worked through in blocks, so memory stays small.
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
