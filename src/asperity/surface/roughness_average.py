r"""Ra of a surface with given D and G, and the G of a surface with given Ra and D.

A roughness instrument takes Ra behind the Gaussian filter of cut-off :math:`\lambda_c`, which leaves
:math:`1 - 2^{-(f\lambda_c)^2}` of the amplitude at the frequency f. With the spectrum of
:mod:`asperity.surface.conventions` the mean square of the heights that pass is

.. math::
    R_q^2 = \int_0^\infty \tfrac12 G^{2(D-1)} f^{-1-2H} \left(1 - 2^{-(f\lambda_c)^2}\right)^2 df
          = \tfrac12 G^{2(D-1)} \lambda_c^{2H}\, I(H), \qquad
    I(H) = \frac{\Gamma(1-H)\,(\ln 2)^H\,(2 - 2^H)}{2H}, \qquad H = 2 - D

Ra fixes this one combination of D and G: one of the two has to come from elsewhere.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

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
    import jax.numpy as jnp

    largest, cut_offs = (jnp.asarray(column) for column in zip(*STANDARD_CUT_OFFS, strict=True))
    return cut_offs[jnp.searchsorted(largest, roughness_average)]


def passed_variance(*, fractal_dimension: Any) -> Any:
    r"""The integral :math:`I(H) = \int_0^\infty u^{-1-2H} (1 - 2^{-u^2})^2 du` [-] in closed form.

    .. math::
        I(H) = \frac{\Gamma(1-H)\,(\ln 2)^H\,(2 - 2^H)}{2H}, \qquad H = 2 - D

    A float needs no JAX; of an array the derivatives are exact.
    """
    h = 2.0 - fractal_dimension
    return _gamma(1.0 - h) * math.log(2.0) ** h * (2.0 - 2.0**h) / (2.0 * h)


def _gamma(x: Any) -> Any:
    if isinstance(x, float):
        return math.gamma(x)
    from jax.scipy.special import gamma

    return gamma(x)


def roughness_average(*, fractal_dimension: Any, fractal_roughness: Any, cut_off: Any) -> Any:
    r"""Ra of a surface with given D and G.

    .. math::
        R_a = \sqrt{2/\pi}\, R_q, \qquad R_q^2 = \tfrac12 G^{2(D-1)} \lambda_c^{2H}\, I(H)

    Parameters
    ----------
    fractal_dimension : float or Array
        D [-], 1 < D < 2.
    fractal_roughness : float or Array
        G [m].
    cut_off : float or Array
        Cut-off lambda_c of the profile filter [m].

    Returns
    -------
    float or Array
        Ra [m], its mean over a long profile.

    Notes
    -----
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
    r"""Fractal roughness G of a surface with given Ra and D; the inverse of :func:`roughness_average`.

    .. math::
        G = \left[\frac{\pi R_a^2}{\lambda_c^{2H}\, I(H)}\right]^{1/(2(D-1))}

    Parameters
    ----------
    roughness_average : float or Array
        Ra [m].
    cut_off : float or Array
        Cut-off lambda_c of the profile filter [m].
    fractal_dimension : float or Array
        D [-], 1 < D < 2.

    Returns
    -------
    float or Array
        G [m].

    Examples
    --------
    >>> g = fractal_roughness_from_average(roughness_average=0.2e-6, cut_off=0.8e-3, fractal_dimension=1.5)
    >>> f"{g * 1e3:.2e} mm"
    '1.82e-07 mm'
    """
    d = fractal_dimension
    ratio = (
        math.pi * roughness_average**2 / (cut_off ** (4.0 - 2.0 * d) * passed_variance(fractal_dimension=d))
    )
    return ratio ** (0.5 / (d - 1.0))


def pair_average(*, first: Any, second: Any) -> Any:
    r"""Ra of the equivalent surface of two bodies, :math:`\sqrt{R_{a1}^2 + R_{a2}^2}` [m]: their mean squares add."""
    return (first**2 + second**2) ** 0.5


def scatter_of_average(*, fractal_dimension: float, cut_offs: float) -> float:
    r"""Relative standard deviation [-] of an Ra that is measured over n cut-offs (5 by the standards).

    .. math::
        \frac{s(R_a)}{R_a} = \frac{1}{2\,I(H)} \left[\frac1n \int_0^\infty u^{-2-4H} (1 - 2^{-u^2})^4 du\right]^{1/2}

    Notes
    -----
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
