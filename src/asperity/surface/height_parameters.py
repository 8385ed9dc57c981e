"""Height parameters of profiles (ISO 21920) and maps (ISO 25178)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.topography import Topography

#: Peaks and valleys below this share of the total height do not delimit a profile element (ISO 21920-2).
HEIGHT_DISCRIMINATION = 0.1


@dataclass(frozen=True)
class HeightParameters:
    """Height parameters about the mean, of a profile (R) or of a map (S).

    Attributes
    ----------
    arithmetic_mean : float
        Ra or Sa [m].
    root_mean_square : float
        Rq or Sq [m].
    skewness, kurtosis : float
        Rsk, Rku or Ssk, Sku [-].
    total_height : float
        Rt or Sz [m], highest peak to lowest valley.
    mean_element_width : float or None
        RSm [m] of a profile; None for a map and where there is no full element.
    points, missing_points : int
        Points evaluated and points without a height, left out.
    """

    arithmetic_mean: float
    root_mean_square: float
    skewness: float
    kurtosis: float
    total_height: float
    mean_element_width: float | None
    points: int
    missing_points: int


def height_parameters(*, topography: Topography) -> HeightParameters:
    r"""Height parameters of the whole profile or map about its mean; nothing is levelled or filtered here.

    .. math::
        Ra = \langle |z| \rangle, \quad Rq = \langle z^2 \rangle^{1/2}, \quad
        Rsk = \langle z^3 \rangle / Rq^3, \quad Rku = \langle z^4 \rangle / Rq^4

    Parameters
    ----------
    topography : Topography
        Profile or map; missing points are left out and counted.

    Returns
    -------
    HeightParameters

    Raises
    ------
    InputError
        If no point has a height.

    References
    ----------
    ISO 21920-2:2021; ISO 25178-2:2021.

    Examples
    --------
    >>> surface = Topography(np.array([1.0, -1.0, 1.0, -1.0]), 1.0)
    >>> height_parameters(topography=surface).root_mean_square
    1.0
    """
    known = topography.heights[~np.isnan(topography.heights)]
    if known.size == 0:
        raise InputError(f"{topography.source} holds no heights")
    z = known - known.mean()
    square = float(np.mean(z * z))
    rms = float(np.sqrt(square))
    flat = rms == 0.0
    return HeightParameters(
        arithmetic_mean=float(np.mean(np.abs(z))),
        root_mean_square=rms,
        skewness=float("nan") if flat else float(np.mean(z**3) / rms**3),
        kurtosis=float("nan") if flat else float(np.mean(z**4) / square**2),
        total_height=float(np.ptp(z)),
        mean_element_width=None if topography.is_map else _element_width(topography),
        points=int(known.size),
        missing_points=topography.missing_points,
    )


def _element_width(topography: Topography) -> float | None:
    """RSm: mean width of a peak with the adjacent valley, small ones ignored."""
    z = topography.heights
    if np.isnan(z).any():
        return None
    z = z - z.mean()
    crossings = _upward_crossings(z, HEIGHT_DISCRIMINATION * float(np.ptp(z)))
    if crossings.size < 2:
        return None
    return float((crossings[-1] - crossings[0]) / (crossings.size - 1)) * topography.spacing


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
