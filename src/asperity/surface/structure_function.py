"""Structure functions of measured profiles, the step of rounded heights, and the usual straight line through them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError, NoSolutionError
from asperity.surface import conventions
from asperity.surface.self_affine_band import NARROWEST_DECADES
from asperity.surface.spectral_likelihood import TAILS, SpectralFit
from asperity.surface.spectrum import without_line

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

    The rounding errors of two points are independent once heights change by about a step between them; below the first
    lag with S = step^2 the profile is a staircase. A wave is resolved if it is at least four such lags long. Infinite
    where neighbours already differ by a step.
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


_SEGMENTS = 12
_LAGS_PER_DECADE = 12
#: Longest lag used, as a share of a piece of the record.
LONGEST_LAG = 0.25
_GRID = 4000
_TREND_POINTS = 240


@dataclass(frozen=True)
class StructureLine:
    """D and ln G of the straight line, their covariance, and the wavelengths that its lags stand for [m]."""

    fractal_dimension: float
    log_roughness: float
    covariance: NDArray[np.float64]
    shortest_wavelength: float
    longest_wavelength: float


def structure_line(*, profiles: NDArray[np.float64], spacing: float, fit: SpectralFit) -> StructureLine:
    r"""Straight line of ln S on ln lag, weights 1/lag, within the usable band of a spectral fit.

    Notes
    -----
    The covariance is that of the jackknife over blocks of the record, plus the square of the systematic
    shift: the straight line through the structure function of the fitted spectrum, with its roll-off, noise,
    sampling limit (power above it folded or absent, whichever matters more) and the subtracted line, gives
    another D and ln G than the power law of that spectrum.
    """
    levelled = without_line(profiles)
    pieces = levelled
    if profiles.shape[0] < _SEGMENTS:
        cut = max(1, _SEGMENTS // profiles.shape[0])
        length = profiles.shape[1] // cut
        pieces = levelled[:, : cut * length].reshape(-1, length)
    lags = logarithmic_lags(points=pieces.shape[1], per_decade=_LAGS_PER_DECADE, longest_fraction=LONGEST_LAG)
    tau = lags.astype(np.float64) * spacing
    low, high = fit.usable_band
    used = (tau >= 0.5 / high * (1 - 1e-9)) & (tau <= 0.5 / low * (1 + 1e-9))
    if used.sum() < 4 or np.log10(tau[used][-1] / tau[used][0]) < NARROWEST_DECADES - 1e-9:
        raise NoSolutionError(
            "less than one decade of lags lies in the self-affine band: no straight line through the "
            "structure function"
        )
    lags, tau = lags[used], tau[used]
    S = structure_functions(profiles=pieces, lags=lags)
    blocks = np.array_split(np.arange(pieces.shape[0]), min(_SEGMENTS, pieces.shape[0]))
    sums = np.stack([S[b].sum(axis=0) for b in blocks])
    counts = np.array([b.size for b in blocks], dtype=np.float64)
    line = _line(tau, sums.sum(axis=0) / counts.sum())
    left_out = [
        _line(tau, (sums.sum(axis=0) - s) / (counts.sum() - c)) for s, c in zip(sums, counts, strict=True)
    ]
    covariance = (len(blocks) - 1) * np.cov(np.stack(left_out).T, bias=True)
    D = fit.fractal_dimension
    power = conventions.structure_function(
        lag=tau, fractal_dimension=D, fractal_roughness=math.exp(_log_roughness(fit))
    )
    trend = trend_share(tau / (profiles.shape[1] * spacing), 2.0 - D)
    shifts = []
    for tail in TAILS[:2]:  # what lies above the sampling limit matters here more than to the spectrum
        ratio = 1.0 - trend + structure_departure(replace(fit, tail=tail), tau) / power
        if not (ratio > 0.0).all():
            raise NoSolutionError("roll-off and noise dominate the structure function: no straight line")
        shifts.append(_line(tau, power * ratio) - np.array([D, _log_roughness(fit)]))
    shift = max(shifts, key=lambda shift: abs(float(shift[0])))
    return StructureLine(
        fractal_dimension=float(line[0]),
        log_roughness=float(line[1]),
        covariance=covariance + np.outer(shift, shift),
        shortest_wavelength=2.0 * float(tau[0]),
        longest_wavelength=2.0 * float(tau[-1]),
    )


def _log_roughness(fit: SpectralFit) -> float:
    D, log_f = fit.fractal_dimension, math.log(fit.reference_frequency)
    return (fit.log_level + math.log(2.0) + (5.0 - 2.0 * D) * log_f) / (2.0 * (D - 1.0))


def _line(tau: NDArray[np.float64], S: NDArray[np.float64]) -> NDArray[np.float64]:
    """(D, ln G) of the straight line through ln S."""
    if not (S > 0.0).all():
        raise NoSolutionError("the structure function vanishes at a lag: no fractal profile")
    slope, level = np.polyfit(np.log(tau / tau[0]), np.log(S), 1, w=np.sqrt(tau[0] / tau))
    D = 2.0 - 0.5 * float(slope)
    if not 1.0 < D < 2.0:
        raise NoSolutionError(f"the structure function gives D = {D:.3f}, outside 1 .. 2: no fractal profile")
    G = conventions.roughness_from_structure_function(
        level=math.exp(level), lag=float(tau[0]), fractal_dimension=D
    )
    if not G > 0.0:
        raise NoSolutionError(
            f"the structure function gives D = {D:.4f} and no positive G: no fractal profile"
        )
    return np.array([D, math.log(G)])


def structure_departure(fit: SpectralFit, tau: NDArray[np.float64]) -> NDArray[np.float64]:
    r"""What roll-off, white part and sampling limit add to the structure function [m^2].

    .. math::
        \Delta S(\tau) = \int_0^\infty 2 [1 - \cos 2\pi f\tau] \, \Delta P(f) \, df

    Heights that follow an unlimited power law keep its structure function at every lag when they are sampled:
    folding adds nothing.
    """
    nyquist = 0.5 * fit.sampling_frequency
    edges = np.geomspace(1e-4 * fit.low, 100.0 * nyquist, _GRID + 1)
    f, width = np.sqrt(edges[1:] * edges[:-1]), np.diff(edges)
    density = fit.density(f)
    law = density * np.where((f >= fit.low) | (fit.roll_off > 0.0), fit.bend(f), 1.0)
    sampled = f <= nyquist
    kept = law if fit.tail == "folded" else np.where(sampled, law, 0.0)
    change = kept + np.where(sampled, fit.floor, 0.0) - density
    wave = np.sinc(tau[:, None] * width) * np.cos(2.0 * np.pi * tau[:, None] * f)
    return np.asarray((2.0 * (1.0 - wave)) @ (change * width))


def trend_share(share: NDArray[np.float64], hurst: float) -> NDArray[np.float64]:
    r"""Part of :math:`S(\tau)` that goes with the least-squares line, for lags as shares of the record.

    Of self-affine heights the slope of the line and the differences are correlated; the covariances follow
    from :math:`\langle z_i z_j \rangle = -\tfrac12 S_{|i-j|}` for weights that sum to zero.
    """
    n = _TREND_POINTS
    x = (np.arange(n) + 0.5) / n
    kernel = -0.5 * np.abs(x[:, None] - x) ** (2.0 * hurst)
    w = (x - x.mean()) / np.sum((x - x.mean()) ** 2)
    with_slope = kernel @ w
    variance = float(w @ with_slope)
    # mean difference at the lag k: mean of the last n - k points less that of the first n - k
    k = np.clip(share * n, 1e-9, n - 1.0)
    total = np.concatenate([[0.0], np.cumsum(with_slope)])
    first = np.interp(n - k, np.arange(n + 1), total)
    cross = (total[-1] - np.interp(k, np.arange(n + 1), total) - first) / (n - k)
    return np.asarray((2.0 * share * cross - share**2 * variance) / share ** (2.0 * hurst))
