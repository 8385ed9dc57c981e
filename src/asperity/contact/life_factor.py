"""Factor of rolling-contact fatigue life for the oil film and its cleanliness, a_ISO of ISO 281."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Hertz pressure of a line contact at which bearing steel of usual quality just does not tire [Pa]: ISO 281, B.3.1.
FATIGUE_LIMIT_PRESSURE = 1.5e9
#: Exponent of the film ratio in the viscosity ratio.
FILM_RATIO_EXPONENT = 1.3
#: Viscosity ratios between which the factor is known; above the upper one it is that of the upper one [-].
LEAST_VISCOSITY_RATIO, MOST_VISCOSITY_RATIO = 0.1, 4.0
#: Film ratio of that lower one [-].
LEAST_FILM_RATIO = LEAST_VISCOSITY_RATIO ** (1.0 / FILM_RATIO_EXPONENT)
#: Largest factor [-].
LARGEST_LIFE_FACTOR = 50.0

#: Coefficient and exponent of the viscosity ratio below 0.4, below 1 and above, of radial roller bearings.
_PIECES = ((1.3993, 0.054381), (1.2348, 0.19087), (1.2348, 0.071739))


def viscosity_ratio(*, film_ratio: Real) -> Real:
    r"""Viscosity of an oil over that which its contact needs, from its film.

    .. math:: \kappa = \lambda^{1.3}

    Parameters
    ----------
    film_ratio : Real
        Smallest film thickness over roughness lambda, positive [-].

    Returns
    -------
    Real
        Viscosity ratio kappa [-].

    Notes
    -----
    Approximate. A second route: :math:`h \propto \eta_0^{0.70}\alpha^{0.54}` (B11) with
    :math:`\alpha \propto \eta_0^{0.1348}` of mineral oils makes :math:`\lambda \propto \kappa^{0.773}`, an exponent of
    1.29. ISO takes the smallest film, by the same equation.

    References
    ----------
    ISO 281:2007, 9.3.3.3.2, and ISO/TR 1281-2:2008, as cited by public programs; equation (F6) of :doc:`/equations`.
    """
    return film_ratio**FILM_RATIO_EXPONENT  # (F6)


def fatigue_load_ratio(*, peak_pressure: Real) -> Real:
    r"""Fatigue load limit over the load of a line contact.

    .. math:: \frac{C_u}{P} = \left(\frac{1.5\,\mathrm{GPa}}{p_0}\right)^2

    Parameters
    ----------
    peak_pressure : Real
        Peak pressure p_0 of Hertz [Pa].

    Returns
    -------
    Real
        Ratio C_u/P [-]; infinite where the pressure is not positive.

    Notes
    -----
    ISO 281 defines C_u by the load under which the most loaded contact has 1.5 GPa; the load of a line contact goes
    with the square of its pressure.

    References
    ----------
    ISO 281:2007, annex B; equation (F6) of :doc:`/equations`.
    """
    pressed = xp.asarray(peak_pressure) > 0.0
    ratio = (FATIGUE_LIMIT_PRESSURE / xp.where(pressed, peak_pressure, 1.0)) ** 2  # (F6)
    return xp.where(pressed, ratio, xp.inf)


def life_modification_factor(*, viscosity_ratio: Real, cleanliness: Real, fatigue_load_ratio: Real) -> Array:
    r"""Life with a film of an oil of some cleanliness over rating life, of a line contact.

    .. math::
        a_{ISO} = 0.1\left[1 - b(\kappa)\left(\frac{e_C C_u}{P}\right)^{0.4}\right]^{-9.185} \le 50, \qquad
        b = 1.5859 - \begin{cases}
            1.3993\,\kappa^{-0.054381} & 0.1 \le \kappa < 0.4 \\
            1.2348\,\kappa^{-0.19087} & 0.4 \le \kappa < 1 \\
            1.2348\,\kappa^{-0.071739} & 1 \le \kappa \le 4
        \end{cases}

    Parameters
    ----------
    viscosity_ratio : Real
        Viscosity ratio kappa [-]; above 4 it counts as 4.
    cleanliness : Real
        Contamination factor e_C of the oil, 0 to 1 for the cleanest [-].
    fatigue_load_ratio : Real
        Fatigue load limit over load C_u/P, positive [-].

    Returns
    -------
    Array
        Factor a_ISO [-]; nan for kappa below 0.1, where the standard has none.

    Notes
    -----
    The curve of radial roller bearings. One public program prints 0.019087 in place of 0.19087; b is continuous at
    kappa 0.4 only with the latter. Extreme-pressure additives, for which the standard allows kappa 1 in some cases, are
    not counted.

    References
    ----------
    ISO 281:2007, equations 34 to 36; equation (F6) of :doc:`/equations`.
    """
    kappa = xp.asarray(viscosity_ratio, dtype=float)
    known = kappa >= LEAST_VISCOSITY_RATIO
    inside = xp.where(known, xp.minimum(kappa, MOST_VISCOSITY_RATIO), MOST_VISCOSITY_RATIO)
    thin, mixed, thick = (coefficient * inside**-exponent for coefficient, exponent in _PIECES)
    lost = xp.where(inside < 0.4, thin, xp.where(inside < 1.0, mixed, thick))
    # the largest factor is reached at a bracket above 0, and beyond it the power is not looked at
    ratio = cleanliness * xp.asarray(fatigue_load_ratio, dtype=float)
    limited = xp.isfinite(ratio)
    bracket = 1.0 - (1.5859 - lost) * xp.where(limited, ratio, 1.0) ** 0.4
    least = (0.1 / LARGEST_LIFE_FACTOR) ** (1.0 / 9.185)
    below = limited & (bracket > least)
    factor = 0.1 * xp.where(below, bracket, 1.0) ** -9.185  # (F6)
    return xp.where(known, xp.where(below, factor, LARGEST_LIFE_FACTOR), xp.nan)
