"""Power spectral densities of measured profiles, and their averages in narrow bins of frequency."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.fft
from numpy.typing import NDArray

from asperity.errors import InputError

_CHUNK_POINTS = 4_000_000
#: Lags over which neighbouring ordinates are compared, and the fewest ordinates of a bin that takes part.
_CORRELATED_LAGS = 10
_FEWEST_ORDINATES = 16
_RANGE = 8
_FEWEST_IN_RANGE = 128


@dataclass(frozen=True)
class BinnedSpectrum:
    """Averages of the raw spectrum over narrow bins of frequency and blocks of profiles; arrays of shape (bins,).

    ``frequency`` is the geometric mean of the Fourier frequencies in each bin [1/m], ``spread`` the variance of their
    logarithm, ``ordinates`` their number; ``density``, one-sided, averaged over the bin and all profiles [m^3].
    ``independent`` is the number of independent ordinates behind the average: ordinates times profiles, less for a
    taper, for roughness that changes along a profile or from profile to profile, and for neighbouring rows of a map,
    which resemble each other.

    ``points`` of a profile lie at the distance ``spacing`` [m]. ``rows_of_a_map``: the profiles are
    neighbouring rows of one map.
    """

    frequency: NDArray[np.float64]
    spread: NDArray[np.float64]
    ordinates: NDArray[np.int64]
    independent: NDArray[np.float64]
    density: NDArray[np.float64]
    profiles: int
    points: int
    spacing: float
    rows_of_a_map: bool

    @property
    def nyquist(self) -> float:
        """Sampling limit [1/m]."""
        return 0.5 / self.spacing


def power_spectral_densities(
    *, profiles: NDArray[np.float64], spacing: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    r"""Frequencies [1/m] and one-sided power spectral density [m^3] of each profile, straight line removed.

    With Hann's window w

    .. math::
        P(f_j) = \frac{2 \Delta}{\sum_i w_i^2} \left| \sum_i w_i z_i e^{-2\pi i f_j x_i} \right|^2

    The ordinate at the sampling limit of an even number of points is one-sided as well.
    """
    _check(profiles, spacing)
    points = profiles.shape[1]
    w = raised_cosine(points, 1.0)
    levelled = without_line(profiles)
    spectrum = scipy.fft.rfft(levelled * w, axis=1)[:, 1:]
    density = (2.0 * spacing / np.sum(w**2)) * (spectrum.real**2 + spectrum.imag**2)
    if points % 2 == 0:
        density[:, -1] *= 0.5
    return scipy.fft.rfftfreq(points, spacing)[1:], density


def binned_spectrum(
    *,
    profiles: NDArray[np.float64],
    spacing: float,
    differenced: bool,
    bins_per_decade: int,
    rows_of_a_map: bool,
) -> BinnedSpectrum:
    r"""Average of the spectra of profiles, shape (profiles, points) [m], in narrow logarithmic bins.

    The heights have no missing points. At low frequencies every ordinate is a bin of its own. ``differenced``:
    differences of neighbouring heights with a light taper, which resolves low frequencies of steep spectra best,
    instead of straight line removed and Hann window. ``rows_of_a_map``: the profiles are neighbouring rows of one map,
    whose resemblance is measured: with I the ordinates of the two-dimensional transform that fall into a bin, :math:`2
    (\sum I)^2 / \sum I^2` of them are independent.
    """
    _check(profiles, spacing)
    rows, points = profiles.shape
    used = points - 1 if differenced else points
    taper = raised_cosine(used, 0.1 if differenced else 1.0)
    frequency = scipy.fft.rfftfreq(used, spacing)
    last = used // 2 if used % 2 == 0 else frequency.size  # leave out the real ordinate at the sampling limit
    edges = bin_edges(last, bins_per_decade)
    counts = np.diff(edges)
    transfer = 4.0 * np.sin(np.pi * frequency[1:last] * spacing) ** 2 if differenced else np.ones(last - 1)
    norm = 2.0 * spacing / np.sum(taper**2)

    total = np.zeros(last - 1)
    kept = np.empty((rows, last - 1), dtype=np.complex64) if rows_of_a_map and rows > 1 else None
    scale = float(np.std(profiles[0])) or 1.0
    powers = np.empty((rows, counts.size))
    step = max(1, _CHUNK_POINTS // points)
    for start in range(0, rows, step):
        block = profiles[start : start + step]
        if differenced:
            values = np.diff(block, axis=1)
            values -= values.mean(axis=1, keepdims=True)
        else:
            values = without_line(block)
        values *= taper
        spectrum = scipy.fft.rfft(values, axis=1, workers=2)[:, 1:last]
        power = spectrum.real**2 + spectrum.imag**2
        total += power.sum(axis=0)
        powers[start : start + step] = np.add.reduceat(power / transfer, edges[:-1] - 1, axis=1)
        if kept is not None:
            kept[start : start + step] = spectrum / (scale * np.sqrt(transfer))
    density = np.add.reduceat(total / transfer, edges[:-1] - 1) * norm / (counts * rows)
    loss = used * np.sum(taper**4) / np.sum(taper**2) ** 2
    log = np.log(frequency[1:last])
    mean = np.add.reduceat(log, edges[:-1] - 1) / counts
    spread = np.add.reduceat((log - np.repeat(mean, counts)) ** 2, edges[:-1] - 1) / counts
    loss = np.maximum(loss, _correlation(total / transfer, edges, log, mean)) * _inequality(powers, counts)
    independent = counts * rows if kept is None else _independent_ordinates(kept, edges)
    return BinnedSpectrum(
        frequency=np.exp(mean),
        spread=spread,
        ordinates=counts,
        independent=np.asarray(independent, dtype=np.float64) / loss,
        density=density,
        profiles=rows,
        points=points,
        spacing=spacing,
        rows_of_a_map=rows_of_a_map,
    )


def _correlation(
    power: NDArray[np.float64],
    edges: NDArray[np.int64],
    log_frequency: NDArray[np.float64],
    log_centre: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Factor per bin by which ordinates that vary together enlarge the variance of the bin's average.

    A taper, and roughness that changes along the profile, spread every wave over several ordinates: one plus
    twice the sum of the correlations at the next lags, of ordinates divided by their local mean. Each range
    of a factor of eight in frequency has its own; below the lowest with enough ordinates its value is kept.
    """
    counts = np.diff(edges)
    factor = np.ones(counts.size)
    first = int(np.searchsorted(counts, _FEWEST_ORDINATES))
    means = np.add.reduceat(power, edges[:-1] - 1)[first:] / counts[first:]
    if counts.size - first < 3 or not (means > 0.0).all():
        return factor
    start = int(edges[first]) - 1
    x = power[start:] / np.exp(np.interp(log_frequency[start:], log_centre[first:], np.log(means)))
    top, value = power.size, 1.0
    while top > start:
        bottom = max(top // _RANGE, start)
        if top - bottom >= _FEWEST_IN_RANGE:
            part = x[bottom - start : top - start] - x[bottom - start : top - start].mean()
            variance = float(part @ part)
            pairs = sum(float(part[lag:] @ part[:-lag]) for lag in range(1, _CORRELATED_LAGS + 1))
            value = 1.0 + 2.0 * pairs / variance if variance > 0.0 else 1.0
        factor[edges[:-1] - 1 < top] = value
        top = bottom
    return factor


def _inequality(powers: NDArray[np.float64], counts: NDArray[np.int64]) -> float:
    """Factor by which unequal profiles enlarge the variance of their average: 1 where all are alike."""
    mean = powers.mean(axis=0)
    share = np.where(mean > 0.0, powers / np.where(mean > 0.0, mean, 1.0), 1.0) @ counts
    return float(np.mean(share**2) / np.mean(share) ** 2)


def _independent_ordinates(spectra: NDArray[np.complex64], edges: NDArray[np.int64]) -> NDArray[np.float64]:
    """Independent ordinates per bin from the transform of the row spectra across the rows; at least one."""
    across = scipy.fft.fft(spectra, axis=0, workers=2, overwrite_x=True)
    power = (across.real**2 + across.imag**2).astype(np.float64)
    first = np.add.reduceat(power.sum(axis=0), edges[:-1] - 1)
    second = np.add.reduceat(np.einsum("ij,ij->j", power, power), edges[:-1] - 1)
    return np.maximum(2.0 * first**2 / second, 1.0)


def bin_edges(last: int, per_decade: int) -> NDArray[np.int64]:
    """First ordinate of each bin, and the end: ordinates 1 .. last - 1 without gaps."""
    ratio = 10.0 ** (1.0 / per_decade)
    edges = [1]
    while edges[-1] < last:
        edges.append(min(last, max(edges[-1] + 1, round(edges[-1] * ratio))))
    return np.asarray(edges, dtype=np.int64)


def without_line(profiles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Each profile less its least-squares straight line."""
    points = profiles.shape[1]
    u = np.arange(points) - 0.5 * (points - 1)
    levelled = profiles - profiles.mean(axis=1, keepdims=True)
    levelled -= ((levelled @ u) / (u @ u))[:, None] * u
    return levelled


def raised_cosine(points: int, share: float) -> NDArray[np.float64]:
    """Periodic window that rises and falls as a cosine over a share of its points: 1 is Hann's."""
    edge = np.minimum(np.arange(points), points - np.arange(points)) / (share * points)
    return np.where(edge < 0.5, 0.5 - 0.5 * np.cos(2.0 * np.pi * edge), 1.0)


def _check(profiles: NDArray[np.float64], spacing: float) -> None:
    if profiles.ndim != 2 or profiles.shape[1] < 16:
        raise InputError(
            f"profiles must have shape (profiles, points) with 16 points or more, not {profiles.shape}"
        )
    if not spacing > 0.0:
        raise InputError(f"the spacing is {spacing} m; it must be positive")
    if not np.isfinite(profiles).all():
        raise InputError("profiles for a spectrum must have no missing points")
