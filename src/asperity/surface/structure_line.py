"""The customary straight line through the structure function, with the shift that its departures cause."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from asperity.errors import NoSolutionError
from asperity.surface import conventions
from asperity.surface.self_affine_band import NARROWEST_DECADES
from asperity.surface.spectral_likelihood import TAILS, SpectralFit
from asperity.surface.spectrum import without_line
from asperity.surface.structure_function import logarithmic_lags, structure_functions

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
