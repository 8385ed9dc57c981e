"""Height parameters of profiles (P, ISO 21920) and maps (S, ISO 25178), and the texture of maps.

The R parameters of a profile, behind filters, are in :mod:`asperity.surface.roughness`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import scipy.fft
import scipy.ndimage
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.topography import Topography

#: Peaks and valleys below this share of the total height do not delimit a profile element (ISO 21920-2).
HEIGHT_DISCRIMINATION = 0.1
#: Value of the autocorrelation at which Sal and Str are read (ISO 25178-2).
CORRELATION_READ = 0.2
# points along each side of a map of block means in which the autocorrelation is taken first, and the fewest of Sal
_COARSE, _FEWEST_IN_SAL = 1024, 10


@dataclass(frozen=True)
class HeightParameters:
    """Height parameters about the mean, of a profile without filters (P) or of a map (S).

    ``arithmetic_mean``: Pa or Sa [m]; ``root_mean_square``: Pq or Sq [m]; ``skewness`` and ``kurtosis``: Psk, Pku or
    Ssk, Sku [-]; ``total_height``: Pt or Sz [m], highest peak to lowest valley; ``mean_element_width``: PSm [m] of a
    profile, None for a map and where there is no full element; ``developed_area_ratio``: Sdr [-] of a map, of the
    triangles between its points, None for a profile and with missing points; ``correlation_length`` and
    ``aspect_ratio``: Sal [m] and Str [-] of a map, None for a profile, with missing points, and where the
    autocorrelation does not fall to 0.2 within half of the map, in any direction or in all of them; ``points``
    evaluated, and ``missing_points`` without a height, left out.
    """

    arithmetic_mean: float
    root_mean_square: float
    skewness: float
    kurtosis: float
    total_height: float
    mean_element_width: float | None
    developed_area_ratio: float | None
    correlation_length: float | None
    aspect_ratio: float | None
    points: int
    missing_points: int


def height_parameters(*, topography: Topography) -> HeightParameters:
    r"""Height parameters of the whole profile or map about its mean; nothing is levelled or filtered here.

    .. math::
        Pa = \langle |z| \rangle, \quad Pq = \langle z^2 \rangle^{1/2}, \quad
        Psk = \langle z^3 \rangle / Pq^3, \quad Pku = \langle z^4 \rangle / Pq^4

    Missing points are left out and counted. An ``InputError`` if no point has a height.

    References
    ----------
    ISO 21920-2:2021; ISO 25178-2:2021.

    Examples
    --------
    >>> surface = Topography(np.array([1.0, -1.0, 1.0, -1.0]), 1.0)
    >>> height_parameters(topography=surface).root_mean_square
    1.0
    """
    missing = np.isnan(topography.heights)
    known = topography.heights[~missing] if missing.any() else topography.heights.ravel()
    if known.size == 0:
        raise InputError(f"{topography.source} holds no heights")
    z = known - known.mean()
    squares = z * z
    square = float(np.mean(squares))
    rms = float(np.sqrt(square))
    flat = rms == 0.0
    complete_map = topography.is_map and topography.missing_points == 0
    length, aspect = _texture(topography) if complete_map and not flat else (None, None)
    return HeightParameters(
        arithmetic_mean=float(np.mean(np.abs(z))),
        root_mean_square=rms,
        skewness=float("nan") if flat else float(squares @ z / z.size / rms**3),
        kurtosis=float("nan") if flat else float(squares @ squares / z.size / square**2),
        total_height=float(np.ptp(z)),
        mean_element_width=(
            None
            if topography.is_map or topography.missing_points
            else element_width(
                heights=topography.heights - topography.heights.mean(), spacing=topography.spacing
            )
        ),
        developed_area_ratio=_developed_area_ratio(topography) if complete_map else None,
        correlation_length=length,
        aspect_ratio=aspect,
        points=int(known.size),
        missing_points=topography.missing_points,
    )


def element_width(*, heights: NDArray[np.float64], spacing: float) -> float | None:
    """Mean width [m] of a peak with the adjacent valley of heights about the mean line, small ones ignored; or None."""
    crossings = _upward_crossings(heights, HEIGHT_DISCRIMINATION * float(np.ptp(heights)))
    if crossings.size < 2:
        return None
    return float((crossings[-1] - crossings[0]) / (crossings.size - 1)) * spacing


def _developed_area_ratio(topography: Topography) -> float:
    """Sdr [-]: the area of the two triangles of each cell beyond that of the plane, over the latter."""
    z, total = topography.heights, 0.0
    assert topography.spacing_across is not None
    for start in range(0, z.shape[0] - 1, 16):  # so few that they stay in the processor's cache
        rows = z[start : start + 17]
        along = (np.diff(rows, axis=1) / topography.spacing) ** 2 + 1.0
        across = (np.diff(rows, axis=0) / topography.spacing_across) ** 2
        total += float(np.sqrt(along[:-1] + across[:, :-1]).sum() + np.sqrt(along[1:] + across[:, 1:]).sum())
    return total / (2.0 * (z.shape[0] - 1) * (z.shape[1] - 1)) - 1.0


def _texture(topography: Topography) -> tuple[float | None, float | None]:
    """Sal [m] and Str [-], of block means where these resolve Sal and otherwise of finer ones."""
    assert topography.spacing_across is not None
    spacings = np.array([topography.spacing_across, topography.spacing])
    blocks = max(1, max(topography.heights.shape) // _COARSE)
    while True:
        rows, columns = (n // blocks for n in topography.heights.shape)
        z = topography.heights[: rows * blocks, : columns * blocks]
        z = z.reshape(rows, blocks, columns, blocks).mean(axis=(1, 3)) if blocks > 1 else z
        nearest, farthest = _lobe_distances(_autocorrelation(z - z.mean()), blocks * spacings)
        resolved = nearest is None or nearest >= _FEWEST_IN_SAL * blocks * float(spacings.max())
        if blocks == 1 or (resolved and min(rows, columns) > 2 * _FEWEST_IN_SAL):
            aspect = None if nearest is None or farthest is None else nearest / farthest
            return nearest, aspect
        blocks //= 2


def _autocorrelation(z: NDArray[np.float64]) -> NDArray[np.float64]:
    """Autocorrelation [-] of a map for lags up to half of its sides, by the mean of the pairs; 1 in the middle."""
    half = [n // 2 for n in z.shape]
    padded = [scipy.fft.next_fast_len(n + h + 1, real=True) for n, h in zip(z.shape, half, strict=True)]
    transform = scipy.fft.rfft2(z, s=padded, workers=-1)
    products = scipy.fft.irfft2(np.abs(transform) ** 2, s=padded, workers=-1)
    lags = [np.arange(-h, h + 1) for h in half]
    pairs = np.multiply.outer(*(n - np.abs(lag) for n, lag in zip(z.shape, lags, strict=True)))
    means = products[np.ix_(*lags)] / pairs
    return np.asarray(means / means[half[0], half[1]])


def _lobe_distances(
    correlation: NDArray[np.float64], spacings: NDArray[np.float64]
) -> tuple[float | None, float | None]:
    """Nearest and farthest distance [m] of the edge of the lobe round the middle, at the value that is read.

    The first is None if the lobe fills the lags, the second if it reaches their end.
    """
    middle = np.array(correlation.shape) // 2
    labels = scipy.ndimage.label(correlation > CORRELATION_READ)[0]
    lobe = labels == labels[tuple(middle)]
    edges = []
    for axis in (0, 1):
        inside, value = np.moveaxis(lobe, axis, 0), np.moveaxis(correlation, axis, 0)
        for step in (1, -1):
            inner, outer = (slice(None, -1), slice(1, None))[::step]
            places = np.argwhere(inside[inner] & ~inside[outer])
            a, b = (value[part][tuple(places.T)] for part in (inner, outer))
            points = places.astype(np.float64)
            share = (a - CORRELATION_READ) / (a - b)
            points[:, 0] += share if step > 0 else 1.0 - share
            edges.append(points[:, ::-1] if axis else points)
    distances = np.hypot(*((np.concatenate(edges) - middle) * spacings).T)
    if distances.size == 0:
        return None, None
    ends = lobe[[0, -1]].any() or lobe[:, [0, -1]].any()
    return float(distances.min()), None if ends else float(distances.max())


def _upward_crossings(z: NDArray[np.float64], threshold: float) -> NDArray[np.float64]:
    """Places, in points, of upward crossings of the mean between a counted valley and a counted peak."""
    counted = np.flatnonzero(np.abs(z) > threshold)
    if counted.size == 0:
        return np.empty(0)
    sign = np.sign(z[counted])
    turns = np.flatnonzero((sign[:-1] < 0) & (sign[1:] > 0))
    places = []
    for t in turns:
        first, last = int(counted[t]), int(counted[t + 1])
        rise = first + int(np.flatnonzero(z[first : last + 1] > 0.0)[0])
        below, above = z[rise - 1], z[rise]
        places.append(rise - 1 + below / (below - above))
    return np.asarray(places)
