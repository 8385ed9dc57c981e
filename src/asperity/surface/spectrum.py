"""Power spectral densities of measured profiles, and their averages in narrow bins of frequency."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.fft
import scipy.signal
from numpy.typing import NDArray

from asperity.errors import InputError

_CHUNK_POINTS = 4_000_000


@dataclass(frozen=True)
class BinnedSpectrum:
    """Averages of the raw spectrum over narrow bins of frequency and blocks of profiles.

    Attributes
    ----------
    frequency : array, shape (bins,)
        Geometric centre of each bin [1/m].
    ordinates : array, shape (bins,)
        Number of Fourier frequencies in the bin.
    density : array, shape (blocks, bins)
        Mean one-sided power spectral density [m^3] of each block of profiles.
    profiles : array, shape (blocks,)
        Number of profiles in each block.
    points, spacing : int, float
        Points of a profile and their distance [m].
    differenced : bool
        True: density of the differences of neighbouring heights, divided by the transfer function of the
        difference, so that it reads as a density of heights.
    degrees_lost : float
        Factor (at least 1) by which the taper widens the variance of bin averages.
    """

    frequency: NDArray[np.float64]
    ordinates: NDArray[np.int64]
    density: NDArray[np.float64]
    profiles: NDArray[np.int64]
    points: int
    spacing: float
    differenced: bool
    degrees_lost: float

    @property
    def mean(self) -> NDArray[np.float64]:
        """Density averaged over all profiles [m^3], shape (bins,)."""
        return np.asarray(np.average(self.density, axis=0, weights=self.profiles))

    @property
    def nyquist(self) -> float:
        """Sampling limit [1/m]."""
        return 0.5 / self.spacing


def power_spectral_densities(
    *, profiles: NDArray[np.float64], spacing: float, window: str | tuple[str, float]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    r"""One-sided power spectral density of each profile, straight line removed, windowed.

    .. math::
        P(f_j) = \frac{2 \Delta}{\sum_i w_i^2} \left| \sum_i w_i z_i e^{-2\pi i f_j x_i} \right|^2

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m], no missing points.
    spacing : float
        Distance of the points [m].
    window : str or tuple
        A window of ``scipy.signal.get_window``, such as ``"hann"``.

    Returns
    -------
    frequency : array, shape (frequencies,)
        f [1/m], from 1/length to the sampling limit.
    density : array, shape (profiles, frequencies)
        P [m^3]. The ordinate at the sampling limit of an even number of points is one-sided as well.
    """
    _check(profiles, spacing)
    points = profiles.shape[1]
    w = scipy.signal.get_window(window, points)
    levelled = _without_line(profiles)
    spectrum = scipy.fft.rfft(levelled * w, axis=1)[:, 1:]
    density = (2.0 * spacing / np.sum(w**2)) * (spectrum.real**2 + spectrum.imag**2)
    if points % 2 == 0:
        density[:, -1] *= 0.5
    return scipy.fft.rfftfreq(points, spacing)[1:], density


def binned_spectrum(
    *, profiles: NDArray[np.float64], spacing: float, differenced: bool, bins_per_decade: int, blocks: int
) -> BinnedSpectrum:
    """Average of the spectra of many profiles in narrow logarithmic bins.

    Parameters
    ----------
    profiles : array, shape (profiles, points)
        Heights [m], no missing points.
    spacing : float
        Distance of the points [m].
    differenced : bool
        False: straight line removed and Hann window. True: differences of neighbouring heights with a light
        taper, which resolves low frequencies of steep spectra best.
    bins_per_decade : int
        Bins per decade; at low frequencies every ordinate is a bin of its own.
    blocks : int
        Profiles are averaged in at most so many blocks of neighbours, for later error estimates.

    Returns
    -------
    BinnedSpectrum
    """
    _check(profiles, spacing)
    rows, points = profiles.shape
    used = points - 1 if differenced else points
    taper = scipy.signal.get_window(("tukey", 0.1) if differenced else "hann", used)
    norm = 2.0 * spacing / np.sum(taper**2)
    frequency = scipy.fft.rfftfreq(used, spacing)
    last = used // 2 if used % 2 == 0 else frequency.size  # leave out the real ordinate at the sampling limit
    edges = _bin_edges(last, bins_per_decade)
    transfer = 4.0 * np.sin(np.pi * frequency[1:last] * spacing) ** 2 if differenced else None
    limits = np.unique(np.linspace(0, rows, min(blocks, rows) + 1).astype(int))
    density = np.zeros((limits.size - 1, edges.size - 1))
    for b, (low, high) in enumerate(zip(limits[:-1], limits[1:], strict=True)):
        step = max(1, _CHUNK_POINTS // points)
        for start in range(int(low), int(high), step):
            block = profiles[start : min(start + step, int(high))]
            if differenced:
                values = np.diff(block, axis=1)
                values -= values.mean(axis=1, keepdims=True)
            else:
                values = _without_line(block)
            values *= taper
            spectrum = scipy.fft.rfft(values, axis=1)[:, 1:last]
            power = np.einsum("ij,ij->j", spectrum.real, spectrum.real)
            power += np.einsum("ij,ij->j", spectrum.imag, spectrum.imag)
            if transfer is not None:
                power /= transfer
            density[b] += np.add.reduceat(power, edges[:-1] - 1)
    counts = np.diff(edges)
    profiles_in = np.diff(limits)
    density *= norm / (counts * profiles_in[:, None])
    centre = np.sqrt(frequency[edges[:-1]] * frequency[edges[1:] - 1])
    return BinnedSpectrum(
        frequency=centre,
        ordinates=counts,
        density=density,
        profiles=profiles_in,
        points=points,
        spacing=spacing,
        differenced=differenced,
        degrees_lost=float(used * np.sum(taper**4) / np.sum(taper**2) ** 2),
    )


def _bin_edges(last: int, per_decade: int) -> NDArray[np.int64]:
    """First ordinate of each bin, and the end: ordinates 1 .. last - 1 without gaps."""
    ratio = 10.0 ** (1.0 / per_decade)
    edges = [1]
    while edges[-1] < last:
        edges.append(min(last, max(edges[-1] + 1, round(edges[-1] * ratio))))
    return np.asarray(edges, dtype=np.int64)


def _without_line(profiles: NDArray[np.float64]) -> NDArray[np.float64]:
    """Each profile less its least-squares straight line."""
    points = profiles.shape[1]
    u = np.arange(points) - 0.5 * (points - 1)
    levelled = profiles - profiles.mean(axis=1, keepdims=True)
    levelled -= ((levelled @ u) / (u @ u))[:, None] * u
    return levelled


def _check(profiles: NDArray[np.float64], spacing: float) -> None:
    if profiles.ndim != 2 or profiles.shape[1] < 16:
        raise InputError(f"profiles must have shape (profiles, points) with 16 points or more, not {profiles.shape}")
    if not spacing > 0.0:
        raise InputError(f"the spacing is {spacing} m; it must be positive")
    if not np.isfinite(profiles).all():
        raise InputError("profiles for a spectrum must have no missing points")
