"""The form of a profile along a roller: the circle of least squares, and Lundberg's logarithmic profile."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy.optimize
from numpy.typing import NDArray

from asperity.surface.topography import Topography

#: Fewest points of a form.
FEWEST_POINTS = 16
# points to which a profile is averaged for the search
_SEARCHED = 512
# of the middle, and of the logarithm of the excess length, both over half of the profile
_BOUNDS = ((-0.5, 0.5), (-9.0, 4.0))


@dataclass(frozen=True)
class Crown:
    """The circle of least squares along a profile, as the parabola :math:`z = z_0 + bx - x^2/2R`.

    ``radius``: R [m], negative where the profile is hollow, infinite where it is straight; ``drop``: B^2/8R [m] at the
    ends of the length B, negative where hollow; ``misfit``: rms of the heights about the parabola [m];
    ``middle_radius``: radius of the circle of the middle half alone [m], the same of a circular crown.
    """

    radius: float
    drop: float
    misfit: float
    middle_radius: float

    @property
    def stands_out(self) -> bool:
        """Whether the profile is this crown: misfit up to a tenth of the drop, the middle's radius within 20 %."""
        bends_alike = abs(self.radius / self.middle_radius - 1.0) <= 0.2
        return bends_alike and self.misfit <= 0.1 * abs(self.drop)


def crown(*, topography: Topography) -> Crown | None:
    """The crown of a profile without missing points, slopes taken as small; None of fewer than sixteen points."""
    z = topography.heights
    if z.size < FEWEST_POINTS:
        return None
    quarter = z.size // 4
    middle_radius, _, _ = _circle(z[quarter : z.size - quarter], topography.spacing)
    return Crown(*_circle(z, topography.spacing), middle_radius)


def _circle(z: NDArray[np.float64], spacing: float) -> tuple[float, float, float]:
    """Radius, drop at the ends and misfit [m] of the parabola of least squares."""
    x = np.linspace(-1.0, 1.0, z.size)
    fit = np.polynomial.Polynomial.fit(x, z, 2, domain=[-1.0, 1.0])
    drop, half_length = -float(fit.coef[2]), 0.5 * (z.size - 1) * spacing
    return 0.5 * half_length**2 / drop if drop else math.inf, drop, float(np.std(z - fit(x)))


@dataclass(frozen=True)
class LogarithmicProfile:
    r"""The logarithmic profile of least squares, :math:`z = z_0 + bx - A \ln\{1 / [1 - (2(x - x_c)/L)^2]\}`.

    ``coefficient`` and ``length``: A and L [m]; by the standard A is 0.00035 times the roller's diameter. ``misfit``:
    rms of the heights about it [m].

    References
    ----------
    G. Lundberg, Forsch. Ing.-Wes. 10 (1939) 201; ISO/TS 16281:2008, roller profile for lengths up to 2.5 diameters.
    """

    coefficient: float
    length: float
    misfit: float

    def stands_out(self, circle: Crown) -> bool:
        """Whether the profile is this one: misfit up to a tenth of the circle's drop, and to 0.8 of its misfit."""
        return self.misfit <= min(0.1 * circle.drop, 0.8 * circle.misfit)


def logarithmic_profile(*, topography: Topography) -> LogarithmicProfile | None:
    """The logarithmic profile of a profile without missing points.

    None of fewer than sixteen points, and of one that no such form that is high in the middle fits.
    """
    z = topography.heights
    if z.size < FEWEST_POINTS:
        return None
    block = max(1, z.size // _SEARCHED)
    means = z[: z.size // block * block].reshape(-1, block).mean(axis=1)
    ends = 1.0 - (z.size % block) / z.size
    x = np.linspace(-1.0, 1.0, z.size)
    coarse = np.linspace(-1.0, 2.0 * ends - 1.0, 2 * means.size + 1)[1::2]

    def misfit(shape: NDArray[np.float64]) -> float:
        return float(np.std(means - _logarithmic(coarse, means, *shape)[0]))

    starts = [(0.0, math.log(excess)) for excess in (0.3, 0.03, 0.003)]
    searches = [
        scipy.optimize.minimize(misfit, start, method="Nelder-Mead", bounds=_BOUNDS) for start in starts
    ]
    best = min(searches, key=lambda search: search.fun)
    fit, coefficient, length = _logarithmic(x, z, *best.x)
    if not coefficient > 0.0:
        return None
    half_length = 0.5 * (z.size - 1) * topography.spacing
    return LogarithmicProfile(coefficient, length * half_length, float(np.std(z - fit)))


def _logarithmic(
    x: NDArray[np.float64], z: NDArray[np.float64], centre: float, log_excess: float
) -> tuple[NDArray[np.float64], float, float]:
    """Heights of least squares on positions from -1 to 1, coefficient and length in half lengths of the profile."""
    length = 2.0 * (1.0 + abs(centre) + math.exp(log_excess))
    fall = np.log1p(-((2.0 * (x - centre) / length) ** 2))
    design = np.stack([np.ones_like(x), x, fall], axis=1)
    solution = np.linalg.lstsq(design, z, rcond=None)[0]
    return design @ solution, float(solution[2]), length
