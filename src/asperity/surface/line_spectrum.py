r"""D and G from the lines :math:`f_0 \gamma^n` of a Weierstrass-Mandelbrot function.

Estimators for continuous spectra err by up to 0.3 in D on a spectrum of a few lines. Here the series of
lines is found, the amplitude of every line is fitted by least squares, and

.. math::
    \ln a_n = \tfrac12 \ln\ln\gamma + (D - 1) \ln G - (2 - D) \ln f_n

is solved for D and G. Without noise this is exact to rounding.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.fft
import scipy.linalg
from numpy.typing import NDArray
from scipy.special import ndtri, stdtrit

from asperity.surface.spectrum import raised_cosine, without_line

#: A band one gamma wide with fewer ordinates than this cannot show lines.
_FEWEST_ORDINATES = 128
_LINE_ORDINATES = 16
_CONCENTRATION = 0.9
_LONGEST = 16384
_MOST_PROFILES = 32
_SIGNIFICANCE = 5.0
#: From this number of profiles on, the spread between them is used if it is larger.
_FEWEST_TO_SPREAD = 5
#: Highest line that is fitted, as a share of the sampling limit.
_HIGHEST_LINE = 0.9999
#: Longest wave that is fitted, in inverse record lengths.
_LONGEST_WAVE = 0.05
_CONDITION = 1e-13
_ITERATIONS = 40
#: Largest scatter of ln a about the line that still counts as this function [-].
LARGEST_LINE_MISFIT = 0.15


@dataclass(frozen=True)
class LineFit:
    """D [-] and ln G [ln m] from the amplitudes of the lines, and their covariance, shape (2, 2).

    ``low`` and ``high`` are the lowest and highest line used [1/m]; ``lines``, the number of amplitudes used, over all
    profiles; ``misfit``, the scatter of ln a beyond the errors of the amplitudes [-]; ``explained``, the share of the
    variance of height differences that the lines explain [-].
    """

    fractal_dimension: float
    log_roughness: float
    covariance: NDArray[np.float64]
    low: float
    high: float
    lines: int
    misfit: float
    explained: float


def line_concentration(*, profile: NDArray[np.float64], frequency_ratio: float) -> float:
    """Median share of the strongest few ordinates in bands one ``frequency_ratio`` wide: near 1 for lines."""
    z = without_line(profile[None])[0] * raised_cosine(profile.size, 1.0)
    power = np.abs(scipy.fft.rfft(z)) ** 2
    shares = []
    top = power.size - 1
    while top * (1.0 - 1.0 / frequency_ratio) >= _FEWEST_ORDINATES:
        band = power[int(top / frequency_ratio) : top]
        total = float(band.sum())
        if total > 0.0:
            shares.append(float(np.partition(band, -_LINE_ORDINATES)[-_LINE_ORDINATES:].sum()) / total)
        top = int(top / frequency_ratio)
    return float(np.median(shares)) if shares else 0.0


def fit_lines(*, profiles: NDArray[np.float64], spacing: float, frequency_ratio: float) -> LineFit | None:
    """D and G fitted to the amplitudes of a comb of lines in each profile; None without such lines over a decade."""
    sample = profiles[:: max(1, profiles.shape[0] // _MOST_PROFILES), :_LONGEST]
    if line_concentration(profile=sample[0], frequency_ratio=frequency_ratio) < _CONCENTRATION:
        return None
    log_f, log_a, error, explained = [], [], [], []
    for profile in sample:
        amplitudes = _amplitudes(profile, spacing, frequency_ratio)
        if amplitudes is None:
            return None
        log_f.append(amplitudes[0])
        log_a.append(amplitudes[1])
        error.append(amplitudes[2])
        explained.append(amplitudes[3])
    every = np.concatenate(log_f)
    if every.size < 4 or every.max() - every.min() < np.log(9.99):
        return None
    result, covariance, misfit = _regression(log_f, log_a, error, frequency_ratio)
    if len(log_f) >= _FEWEST_TO_SPREAD:
        covariance = _wider(covariance, _spread_covariance(log_f, log_a, error, frequency_ratio))
    if not 1.0 < result[0] < 2.0 or misfit > LARGEST_LINE_MISFIT:
        return None
    return LineFit(
        fractal_dimension=float(result[0]),
        log_roughness=float(result[1]),
        covariance=covariance,
        low=float(np.exp(every.min())),
        high=float(np.exp(every.max())),
        lines=every.size,
        misfit=misfit,
        explained=float(np.mean(explained)),
    )


def _regression(
    log_f: list[NDArray[np.float64]],
    log_a: list[NDArray[np.float64]],
    error: list[NDArray[np.float64]],
    gamma: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64], float]:
    """(D, ln G), their covariance and the misfit, from a straight line of ln a against ln f.

    A variance is added to those of the amplitudes until chi-square is one per degree of freedom; it starts
    from their median, so that no single line decides.
    """
    x, y, s = np.concatenate(log_f), np.concatenate(log_a), np.concatenate(error)
    floor = float(np.median(s) ** 2)
    extra = 0.0
    for _ in range(40):
        w = 1.0 / (s**2 + floor + extra)
        reference = float(np.average(x, weights=w))
        design = np.stack([np.ones_like(x), x - reference], axis=1)
        covariance = np.linalg.inv(design.T @ (w[:, None] * design))
        level, slope = covariance @ (design.T @ (w * y))
        residual = y - level - slope * (x - reference)
        chi = float(np.sum(w * residual**2) / (x.size - 2))
        if chi <= 1.0 + np.sqrt(2.0 / (x.size - 2)):
            break
        extra = max(extra, floor, 1e-30) * chi
    D = 2.0 + float(slope)
    log_G = (float(level) - 0.5 * np.log(np.log(gamma)) + (2.0 - D) * reference) / (D - 1.0)
    jacobian = np.array([[0.0, 1.0], [1.0 / (D - 1.0), -(reference + log_G) / (D - 1.0)]])
    return np.array([D, log_G]), jacobian @ covariance @ jacobian.T, float(np.sqrt(extra))


def _spread_covariance(
    log_f: list[NDArray[np.float64]],
    log_a: list[NDArray[np.float64]],
    error: list[NDArray[np.float64]],
    gamma: float,
) -> NDArray[np.float64]:
    """Covariance of (D, ln G) by leaving out one profile at a time, widened for their small number."""
    k = len(log_f)
    left_out = []
    for i in range(k):
        f, a, s = (column[:i] + column[i + 1 :] for column in (log_f, log_a, error))
        left_out.append(_regression(f, a, s, gamma)[0])
    widening = float(stdtrit(k - 1, 0.975) / ndtri(0.975)) ** 2
    return np.asarray((k - 1) * np.cov(np.stack(left_out).T, bias=True) * widening)


def _wider(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    """Of two covariances of (D, ln G) the one with the larger variance of D."""
    return first if first[0, 0] >= second[0, 0] else second


def _amplitudes(
    profile: NDArray[np.float64], spacing: float, gamma: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], float] | None:
    """Ln f, ln a, standard error of ln a of the significant lines, and the share of variance they explain."""
    length = profile.size * spacing
    start = _comb_offset(profile, spacing, gamma)
    if start is None:
        return None
    scale = float(np.std(profile))
    z = (profile - profile.mean()) / scale
    best = _fit_comb(z, spacing, gamma, float(np.log(start)))
    used = (best.error < 1.0 / _SIGNIFICANCE) & (best.frequency * length > 2.0)
    first, stop = _run(used)
    if stop - first < 4:
        return None
    chosen = slice(first, stop)
    explained = 1.0 - best.rough_variance / float(np.mean(np.diff(z) ** 2))
    return (
        np.log(best.frequency[chosen]),
        np.log(best.amplitude[chosen] * scale),
        best.error[chosen],
        explained,
    )


@dataclass(frozen=True)
class _Comb:
    frequency: NDArray[np.float64]
    amplitude: NDArray[np.float64]
    error: NDArray[np.float64]
    variance: float
    rough_variance: float


def _fit_comb(z: NDArray[np.float64], spacing: float, gamma: float, log_start: float) -> _Comb:
    """Least squares for all amplitudes below the sampling limit and, by Gauss-Newton, the place of the comb.

    Lines longer than the record represent remaining form; lines above the sampling limit count as noise.
    """
    n = z.size
    length = n * spacing
    log_gamma = np.log(gamma)
    above = int(np.floor((np.log(_HIGHEST_LINE * 0.5 / spacing) - log_start) / log_gamma))
    below = int(np.floor((log_start - np.log(_LONGEST_WAVE / length)) / log_gamma))
    order = np.arange(-below, above + 1)
    m = order.size
    x = (np.arange(n) - 0.5 * (n - 1)) * spacing
    design = np.empty((n, 2 * m + 3))
    design[:, 0], design[:, 1] = 1.0, x / length
    A, B = np.zeros(m), np.zeros(m)
    kept: _Comb | None = None
    for iteration in range(_ITERATIONS):
        f = np.exp(log_start + order * log_gamma)
        wave = np.exp(2j * np.pi * f * x[:, None])
        design[:, 2 : 2 + m], design[:, 2 + m : -1] = wave.real, wave.imag
        resolved = f * length > 0.99
        design[:, -1] = (2.0 * np.pi * x[:, None] * (wave.real * (f * B) - wave.imag * (f * A)))[
            :, resolved
        ].sum(axis=1)
        size = float(np.linalg.norm(design[:, -1])) / np.sqrt(n)
        design[:, -1] /= size or 1.0
        gram = design.T @ design
        inverse = np.linalg.pinv(gram, rcond=_CONDITION, hermitian=True)
        solution = inverse @ (design.T @ z)
        solution += inverse @ (design.T @ (z - design @ solution))  # one refinement
        residual = z - design @ solution
        variance = float(residual @ residual) / (n - design.shape[1])
        A, B = solution[2 : 2 + m], solution[2 + m : -1]
        if kept is None or variance < kept.variance:
            amplitude = np.hypot(A, B)
            k = np.arange(m) + 2
            propagated = inverse[k, k] * A**2 + inverse[k + m, k + m] * B**2 + 2.0 * inverse[k, k + m] * A * B
            error = np.sqrt(variance * np.abs(propagated)) / np.maximum(amplitude, 1e-300) ** 2
            kept = _Comb(f, amplitude, error, variance, float(np.mean(np.diff(residual) ** 2)))
        step = float(solution[-1]) / size if size else 0.0
        limit = 0.3 / (f[-1] * length)
        log_start += float(np.clip(step, -limit, limit))
        if iteration > 1 and abs(step) < 1e-4 * limit:
            break
    assert kept is not None
    return kept


def _run(flags: NDArray[np.bool_]) -> tuple[int, int]:
    """Longest unbroken run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(np.int8), [0]])))
    if edges.size == 0:
        return 0, 0
    best = int(np.argmax(edges[1::2] - edges[::2]))
    return int(edges[2 * best]), int(edges[2 * best + 1])


def _comb_offset(profile: NDArray[np.float64], spacing: float, gamma: float) -> float | None:
    """One frequency of the comb [1/m], to a fraction of the resolution at its highest line."""
    n = profile.size
    padded = 8 * n
    z = without_line(profile[None])[0] * raised_cosine(n, 1.0)
    power = np.abs(scipy.fft.rfft(z, n=padded)) ** 2
    total = np.concatenate([[0.0], np.cumsum(power)])
    lowest, highest = 4.0 * 8, 0.98 * 0.5 * padded
    terms = int(np.floor(np.log(highest / lowest) / np.log(gamma)))
    if terms < 3:
        return None
    steps = int(np.ceil(np.log(gamma) * highest / 2.0))
    start = lowest * np.exp(np.log(gamma) * np.arange(steps) / steps)
    score = np.zeros(steps)
    for k in range(terms):
        place = start * gamma**k
        low = (place / np.sqrt(gamma)).astype(np.int64)
        high = np.minimum((place * np.sqrt(gamma)).astype(np.int64) + 1, power.size)
        share = power[np.round(place).astype(np.int64)] / np.maximum(total[high] - total[low], 1e-300)
        score += np.log(share + 1e-4)  # logarithms: a band without a line does not outweigh the lines
    best = int(np.argmax(score))
    return float(start[best] / (padded * spacing))
