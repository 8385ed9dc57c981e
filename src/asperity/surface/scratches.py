r"""Scratches and spikes in heights that are otherwise normally distributed, as D and G need them.

The heights are filtered to their curvature at scales s, a factor of :math:`\sqrt 2` apart (the second derivative of a
Gaussian, of peak wavelength :math:`\sqrt 2 \pi s`), and divided by a robust standard
deviation, which may change along the profile as that of the shortest scale does. Of a stationary
Gaussian process of autocorrelation :math:`\rho`, the skewness of N such values has the variance

.. math:: \frac{6}{N} \sum_k \rho_k^3

(Lomnicki, Int. Stat. Rev. 29 (1961) 37). Valleys make it positive, spikes negative, by few that are deep or many that
are shallow; single ones also stand out of the normal distribution by their height. The heights of measured maps are
never quite normally distributed, and a map has enough of them to show it: there they count only if they bend the
spectrum, by more power than the robust deviation tells at some waves of the band than at others.
"""

from __future__ import annotations

import math

import numpy as np
import scipy.fft
import scipy.ndimage
from numpy.typing import NDArray
from scipy.special import ndtri

#: Largest skewness at any scale that sampling explains, in standard deviations (1 in 60 profiles).
LARGEST_SKEWNESS = 3.3
#: Chance with which one of all curvatures of normally distributed heights may be larger than those that are accepted.
CHANCE = 0.001
#: Largest change of the logarithm of the power over its robust estimate along the band of a map (0.04 in D a decade).
LARGEST_BEND = 0.2
#: Rows of a map that are looked at.
_ROWS = 32
# points for each point of the largest scale; of a block of the local deviation; blocks; reach in scales
_POINTS_OF_PROFILE, _POINTS_OF_MAP, _BLOCK, _BLOCKS, _REACH = 96, 32, 128, 16, 5


def scratches(
    *,
    profiles: NDArray[np.float64],
    spacing: float,
    shortest_wavelength: float,
    longest_wavelength: float,
    rows_of_a_map: bool,
) -> str:
    """What stands out of normally distributed heights between two wavelengths [m], in words; empty if nothing does.

    Heights [m] of shape (profiles, points) without missing points, ``spacing`` apart [m]; ``rows_of_a_map``: they are
    rows of one map, which resemble each other.
    """
    if rows_of_a_map:
        profiles = profiles[:: max(1, profiles.shape[0] // _ROWS)]
    points = profiles.shape[1]
    peak_wavelength = math.sqrt(2.0) * math.pi * spacing
    first = max(1, math.ceil(2.0 * math.log2(shortest_wavelength / peak_wavelength)))
    largest = min(
        points / (_POINTS_OF_MAP if rows_of_a_map else _POINTS_OF_PROFILE),
        longest_wavelength / peak_wavelength,
    )
    if largest < 1.0:
        return ""
    scales = [2.0 ** (0.5 * i) for i in range(first, math.floor(2.0 * math.log2(largest)) + 1)]
    # less the chord, because the transform takes the ends for neighbours
    chord = np.linspace(profiles[:, 0], profiles[:, -1], points, axis=1)
    spectrum = scipy.fft.rfft(profiles - chord, axis=1)
    f = scipy.fft.rfftfreq(points)
    limit = -float(ndtri(0.5 * CHANCE / max(1.0, sum(profiles.size / scale for scale in scales))))
    local, said, excess = np.ones_like(profiles), "", []
    for scale in scales:
        curvature = scipy.fft.irfft(
            -(f**2) * np.exp(-2.0 * (np.pi * scale * f) ** 2) * spectrum, n=points, axis=1
        )
        if scale == scales[0]:
            local = _local_deviation(curvature, max(1, min(_BLOCKS, int(points / (_BLOCK * scale)))))
        if not (local > 0.0).all():
            return ""
        reach = math.ceil(_REACH * scale)
        values = (curvature / local)[:, reach : points - reach]
        deviation = 1.4826 * np.median(np.abs(values), axis=1, keepdims=True)
        if not (deviation > 0.0).all():
            continue
        values /= deviation
        skewness = _skewness(values, rows_of_a_map)
        extreme = float(values.flat[np.argmax(np.abs(values))])
        where = f"around {1e6 * scale * peak_wavelength:.3g} um of wavelength"
        excess.append(math.log(float(np.mean(values**2))))
        if not said and abs(extreme) > limit:
            said = (
                f"{_name(extreme)}: {where} the profile bends by {abs(extreme):.1f} standard deviations at one place; "
                f"{limit:.1f} are the most of normally distributed heights"
            )
        elif not said and abs(skewness) > LARGEST_SKEWNESS:
            said = (
                f"{_name(skewness)}: {where} the skewness of its curvature is {abs(skewness):.1f} times its sampling "
                f"scatter; {LARGEST_SKEWNESS:g} times is the most of normally distributed heights"
            )
    if rows_of_a_map and said and max(excess) - min(excess) <= LARGEST_BEND:
        return ""
    return said


def _name(sign: float) -> str:
    return "scratches or other sharp valleys" if sign > 0.0 else "spikes or other sharp peaks"


def _local_deviation(curvature: NDArray[np.float64], blocks: int) -> NDArray[np.float64]:
    """Robust deviation of blocks along each profile and their neighbours, the largest: roughness may change."""
    edges = np.linspace(0, curvature.shape[1], blocks + 1).round().astype(int)
    pieces = np.split(np.abs(curvature), edges[1:-1], axis=1)
    deviation = np.stack([np.median(piece, axis=1) for piece in pieces], axis=1)
    largest = scipy.ndimage.maximum_filter1d(deviation, 3, axis=1, mode="nearest")
    return np.repeat(largest, np.diff(edges), axis=1)


def _skewness(values: NDArray[np.float64], rows_of_a_map: bool) -> float:
    """Skewness over its standard deviation for normally distributed values of this autocorrelation."""
    v = values - values.mean()
    axes = (0, 1) if rows_of_a_map else (1,)
    padded = [scipy.fft.next_fast_len(2 * v.shape[axis], real=True) for axis in axes]
    power = np.abs(scipy.fft.rfftn(v, s=padded, axes=axes)) ** 2
    products = scipy.fft.irfftn(power, s=padded, axes=axes)
    if rows_of_a_map:  # every row lag has as many products as there are pairs of rows
        pairs = np.maximum(v.shape[0] - np.abs(np.fft.fftfreq(padded[0], 1.0 / padded[0])), 1.0) / v.shape[0]
        products = products / pairs[:, None] ** (2.0 / 3.0)
    else:
        products = products.sum(axis=0)
    correlation = products / products.flat[0]
    third = float(np.mean(v**3)) / float(np.mean(v**2)) ** 1.5
    return third / math.sqrt(6.0 * float(np.sum(correlation**3)) / v.size)
