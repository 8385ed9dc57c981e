r"""Ra of a surface with given D and G, the G of a surface with given Ra and D, and Ra where Rz is known.

A roughness instrument takes Ra behind the Gaussian filter of cut-off :math:`\lambda_c`, which leaves
:math:`1 - 2^{-(f\lambda_c)^2}` of the amplitude at the frequency f. With the spectrum of
:mod:`asperity.surface.conventions` the mean square of the heights that pass is

.. math::
    R_q^2 = \int_0^\infty \tfrac12 G^{2(D-1)} f^{-1-2H} \left(1 - 2^{-(f\lambda_c)^2}\right)^2 df
          = \tfrac12 G^{2(D-1)} \lambda_c^{2H}\, I(H), \qquad
    I(H) = \frac{\Gamma(1-H)\,(\ln 2)^H\,(2 - 2^H)}{2H}, \qquad H = 2 - D

Ra fixes this one combination of D and G: one of the two has to come from elsewhere.

Rz is the mean, over the five sampling lengths of an evaluation length, of the highest peak minus the deepest valley in
each. The more independent heights a sampling length holds, the farther its extremes lie apart: for normally
distributed heights with the spectrum of :mod:`asperity.surface.conventions` the ratio of Rz to Ra depends on D, and on
how far the two filters of the instrument, at :math:`\lambda_c` and :math:`\lambda_s`, lie apart.

The ratio and the scatter are fits to simulated profiles: normally distributed Fourier coefficients of variance
proportional to

.. math::
    f^{-1-2H} \left(1 - 2^{-(f\lambda_c)^2}\right)^2 2^{-2(f\lambda_s)^2}, \qquad H = 2 - D

at a spacing of :math:`\lambda_s/6.4`, 5400 to 18000 evaluation lengths at each of eleven D from 1.01 to 1.99. The fits
lie within 0.1 % of the simulated ratio, which has a standard error up to 0.16 %, and within 0.0015 of the simulated
relative scatter, 0.05 to 0.12.

References
----------
Rz: ISO 4287:1997, 4.1.3, and ISO 4288:1996; pairs of cut-offs: ISO 3274:1996, table 1; filters: ISO 16610-21.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.engine.arrays import entry_of, special, xp
from asperity.errors import InputError
from asperity.units import format_quantity

#: Root mean square over Ra of normally distributed heights.
RMS_OVER_RA = math.sqrt(math.pi / 2.0)

#: Largest Ra [m] → cut-off [m] of the profile filter; above the last Ra the cut-off is the last one.
STANDARD_CUT_OFFS = ((0.02e-6, 0.08e-3), (0.1e-6, 0.25e-3), (2e-6, 0.8e-3), (10e-6, 2.5e-3), (math.inf, 8e-3))

#: Cut-offs in one evaluation length.
CUT_OFFS_EVALUATED = 5

_NORMAL_95 = 1.959963984540054


def standard_cut_off(*, roughness_average: Any) -> Any:
    r"""Cut-off :math:`\lambda_c` [m] of the profile filter with which a given Ra [m] is measured.

    Up to 0.02, 0.1, 2 and 10 µm: 0.08, 0.25, 0.8 and 2.5 mm, above 8 mm; the evaluation length is five cut-offs.

    References
    ----------
    ISO 4288:1996, table 1 (profiles that are not periodic); ISO 21920-3:2021, table 2.

    Examples
    --------
    >>> standard_cut_off(roughness_average=0.2e-6)
    0.0008
    """
    if isinstance(roughness_average, float):
        return next(cut_off for largest, cut_off in STANDARD_CUT_OFFS if roughness_average <= largest)
    largest, cut_offs = (np.array(column) for column in zip(*STANDARD_CUT_OFFS, strict=True))
    return entry_of(cut_offs, xp.searchsorted(largest, roughness_average))


def passed_variance(*, fractal_dimension: Any) -> Any:
    r"""The integral :math:`I(H) = \int_0^\infty u^{-1-2H} (1 - 2^{-u^2})^2 du` [-] in closed form.

    .. math::
        I(H) = \frac{\Gamma(1-H)\,(\ln 2)^H\,(2 - 2^H)}{2H}, \qquad H = 2 - D

    Of an array the derivatives are exact.
    """
    h = 2.0 - fractal_dimension
    return _gamma(1.0 - h) * math.log(2.0) ** h * (2.0 - 2.0**h) / (2.0 * h)


def _gamma(x: Any) -> Any:
    return math.gamma(x) if isinstance(x, float) else special.gamma(x)


def roughness_average(*, fractal_dimension: Any, fractal_roughness: Any, cut_off: Any) -> Any:
    r"""Ra of a surface with given D and G.

    .. math::
        R_a = \sqrt{2/\pi}\, R_q, \qquad R_q^2 = \tfrac12 G^{2(D-1)} \lambda_c^{2H}\, I(H)

    Of D [-], 1 < D < 2, and G [m], behind the cut-off lambda_c [m] of the profile filter: Ra [m], its mean over a long
    profile.

    Normally distributed heights, and a power law from a few cut-offs down to wavelengths far below it. The filter
    lambda_s of instruments, a three-hundredth of the cut-off, takes 0.4 % of Ra at D = 1.5 and 7 % at D = 1.8.

    References
    ----------
    Gaussian profile filter: ISO 16610-21; spectrum: :mod:`asperity.surface.conventions`.

    Examples
    --------
    >>> ra = roughness_average(fractal_dimension=1.4, fractal_roughness=1e-11, cut_off=0.8e-3)
    >>> f"{ra * 1e6:.2f} um"
    '0.26 um'
    """
    d = fractal_dimension
    square = 0.5 * fractal_roughness ** (2.0 * (d - 1.0)) * cut_off ** (4.0 - 2.0 * d)
    return (square * passed_variance(fractal_dimension=d)) ** 0.5 / RMS_OVER_RA


def fractal_roughness_from_average(*, roughness_average: Any, cut_off: Any, fractal_dimension: Any) -> Any:
    r"""Fractal roughness G [m] of a surface with given Ra [m] and D [-]; the inverse of :func:`roughness_average`.

    .. math::
        G = \left[\frac{\pi R_a^2}{\lambda_c^{2H}\, I(H)}\right]^{1/(2(D-1))}

    ``cut_off`` is that of the profile filter, lambda_c [m].

    Examples
    --------
    >>> g = fractal_roughness_from_average(roughness_average=0.2e-6, cut_off=0.8e-3, fractal_dimension=1.5)
    >>> f"{g * 1e3:.2e} mm"
    '1.82e-07 mm'
    """
    d = fractal_dimension
    passed = cut_off ** (4.0 - 2.0 * d) * passed_variance(fractal_dimension=d)
    return (math.pi * roughness_average**2 / passed) ** (0.5 / (d - 1.0))


def pair_average(*, first: Any, second: Any) -> Any:
    r"""Ra of the equivalent surface of two bodies, :math:`\sqrt{R_{a1}^2 + R_{a2}^2}` [m]: their mean squares add."""
    return (first**2 + second**2) ** 0.5


def scatter_of_average(*, fractal_dimension: float, cut_offs: float) -> float:
    r"""Relative standard deviation [-] of an Ra that is measured over n cut-offs (5 by the standards).

    .. math::
        \frac{s(R_a)}{R_a} = \frac{1}{2\,I(H)} \left[\frac1n \int_0^\infty u^{-2-4H} (1 - 2^{-u^2})^4 du\right]^{1/2}

    Of the mean square of a normal process over a length of many correlation lengths, halved for its root. Ra itself
    scatters nearly as Rq does.

    References
    ----------
    J. S. Bendat and A. G. Piersol, Random Data, the error of mean square estimates.
    """
    h = 2.0 - fractal_dimension
    logs = np.linspace(math.log(1e-3), math.log(1e4), 4001)  # the integrand falls as a power on both sides
    u = np.exp(logs)
    passed = -np.expm1(-math.log(2.0) * u**2)
    fourth = np.trapezoid(passed**4 * u ** (-1.0 - 4.0 * h), logs)
    return float(
        0.5 * math.sqrt(fourth / cut_offs) / passed_variance(fractal_dimension=float(fractal_dimension))
    )


@dataclass(frozen=True)
class CorrespondingAverage:
    """The Ra [m] that an instrument shows on surfaces with given D and G, behind the cut-off [m] of the profile filter.

    ``pair``: of the equivalent surface of both bodies; ``per_body``: of each of two like bodies, of which 95 % of
    measurements over one evaluation length lie between ``low`` and ``high``.
    """

    cut_off: float
    pair: float
    per_body: float
    low: float
    high: float


def corresponding_average(
    *, fractal_dimension: float, fractal_roughness: float, cut_off: float | None
) -> CorrespondingAverage:
    """Ra of two like bodies whose equivalent surface has given D and G, and its scatter over one evaluation length.

    Without a cut-off [m] that of ISO 4288 is taken, the shortest at which Ra does not exceed its class.
    """
    for largest, tried in STANDARD_CUT_OFFS if cut_off is None else ((math.inf, cut_off),):
        pair = roughness_average(
            fractal_dimension=float(fractal_dimension),
            fractal_roughness=float(fractal_roughness),
            cut_off=tried,
        )
        per_body = pair / math.sqrt(2.0)
        if per_body <= largest:
            break
    spread = _NORMAL_95 * scatter_of_average(fractal_dimension=fractal_dimension, cut_offs=CUT_OFFS_EVALUATED)
    return CorrespondingAverage(
        tried, pair, per_body, per_body * max(1.0 - spread, 0.0), per_body * (1.0 + spread)
    )


#: Largest Rz [m] → cut-off [m] of the profile filter; above the last Rz the cut-off is the last one.
DEPTH_CUT_OFFS = ((0.1e-6, 0.08e-3), (0.5e-6, 0.25e-3), (10e-6, 0.8e-3), (50e-6, 2.5e-3), (math.inf, 8e-3))

# ratio of the cut-offs -> coefficients of (D - 1.5)^n in Rz/Ra, and in the relative standard deviation of Rz
_FITS = {
    32: ((5.2001, 1.8570, -0.0566, -0.3366, -0.2344), (0.0904, -0.0553, 0.0175)),
    100: ((5.5614, 2.7487, 0.5898, -0.8619, -1.2345), (0.0828, -0.0675, 0.0157)),
    320: ((5.7940, 3.6100, 1.7432, -1.2113, -3.0217), (0.0789, -0.0770, 0.0110)),
}
# long-wave cut-off [m] -> ratio to the short-wave one: 2.5, 2.5, 2.5, 8 and 25 um; 2.5 mm / 8 um is 312
_RATIOS = {0.08e-3: 32, 0.25e-3: 100, 0.8e-3: 320, 2.5e-3: 320, 8e-3: 320}


def depth_cut_off(*, mean_roughness_depth: float) -> float:
    r"""Cut-off :math:`\lambda_c` [m] of the profile filter with which a given Rz [m] is measured.

    Up to 0.1, 0.5, 10 and 50 µm: 0.08, 0.25, 0.8 and 2.5 mm, above 8 mm. ISO 4288:1996, table 2 (profiles that are not
    periodic).

    >>> depth_cut_off(mean_roughness_depth=1.6e-6)
    0.0008
    """
    return next(cut_off for largest, cut_off in DEPTH_CUT_OFFS if mean_roughness_depth <= largest)


def depth_over_average(*, fractal_dimension: float, cut_off: float) -> float:
    """Ratio Rz/Ra [-] of the means of normally distributed heights, both behind the same filters.

    Real processes differ: one scratch raises Rz and leaves Ra, a plateau lowers both unequally.
    The Ra of :func:`asperity.surface.roughness_average.roughness_average` is taken without the short-wave filter, which
    takes 0.4 % of it at D = 1.5 and 7 % at D = 1.8 for cut-offs from 0.8 mm, 4 % and 19 % for 0.08 mm.

    Examples
    --------
    >>> f"{depth_over_average(fractal_dimension=1.3, cut_off=0.8e-3):.2f}"
    '5.15'
    """
    return _fitted(0, fractal_dimension, cut_off)


def scatter_of_depth(*, fractal_dimension: float, cut_off: float) -> float:
    """Relative standard deviation [-] of Rz over five sampling lengths from one evaluation length to the next."""
    return _fitted(1, fractal_dimension, cut_off)


def average_from_depth(
    *,
    mean_roughness_depth: float,
    tolerance: float,
    fractal_dimension: float,
    dimension_tolerance: float,
    cut_off: float,
) -> tuple[float, float]:
    """Ra [m] of normally distributed heights with a given Rz [m], and how far it may be from there to both sides [m].

    The distance holds Ra for every D of the range and every Rz of the tolerance; with the tolerance 0 Rz is that of one
    evaluation length, within two standard deviations of the mean.
    """
    average = mean_roughness_depth / depth_over_average(fractal_dimension=fractal_dimension, cut_off=cut_off)
    half = 0.0
    for sign in (-1.0, 1.0):  # ratio and scatter rise or fall with D all the way
        d = fractal_dimension + sign * dimension_tolerance
        scatter = 2.0 * scatter_of_depth(fractal_dimension=d, cut_off=cut_off)
        spread = tolerance / mean_roughness_depth if tolerance > 0.0 else scatter
        end = mean_roughness_depth / depth_over_average(fractal_dimension=d, cut_off=cut_off)
        half = max(half, end * (1.0 + spread) - average, average - end * (1.0 - spread))
    return average, half


def _fitted(which: int, fractal_dimension: float, cut_off: float) -> float:
    ratio = next(
        (ratio for known, ratio in _RATIOS.items() if math.isclose(known, cut_off, rel_tol=1e-9)), None
    )
    if ratio is None:
        known = ", ".join(format_quantity(tabulated, "mm") for tabulated in _RATIOS)
        raise InputError(
            f"Rz/Ra is known for the cut-offs of ISO 3274, {known}, got {format_quantity(cut_off, 'mm')}"
        )
    x = fractal_dimension - 1.5
    return sum(c * x**power for power, c in enumerate(_FITS[ratio][which]))
