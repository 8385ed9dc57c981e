r"""Pressure of an increment of load, that of a flat punch, and weighted means of functions of position.

An increment of normal load at a Hertz contact of half-width :math:`a` is distributed as under a flat punch,
:math:`1/(\pi\sqrt{a^2 - x^2})`; so is an increment of shear over the stick zone. On a rim of radius :math:`R` its
Fourier coefficients are :math:`J_0(n a/R)`. The distance of two random points under one punch is
:math:`2a\,|\sin p\,\sin q|` with :math:`p` and :math:`q` uniform, which gives every moment in closed form.
"""

from __future__ import annotations

import math

from numpy.polynomial.chebyshev import cheb2poly

from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Largest argument of :func:`punch_factor`.
LARGEST_PUNCH_ARGUMENT = 8.0


def _bessel_at_4(order: int) -> float:
    """Bessel function J_k(4) by the trapezoidal rule on its integral, which is exact to rounding."""
    steps = 64
    angles = [2.0 * math.pi * step / steps for step in range(steps)]
    return math.fsum(math.cos(4.0 * math.sin(angle) - order * angle) for angle in angles) / steps


#: Coefficients of J0 on [0, 8] by powers of x^2/32 - 1, from Neumann's addition theorem with both radii 4.
_POWERS = cheb2poly([(1.0 if k == 0 else 2.0) * (-1.0) ** k * _bessel_at_4(k) ** 2 for k in range(16)])


def punch_factor(argument: Real) -> Array:
    r"""Fourier coefficient of a punch pressure on a rim, :math:`J_0(x)` with :math:`x = n a/R`.

    .. math:: J_0(8\cos\tfrac u2) = J_0(4)^2 + 2\sum_{k\ge1} (-1)^k J_k(4)^2 \cos ku

    Parameters
    ----------
    argument : Real
        Mode number times half-width over radius, 0 to 8 [-].

    Returns
    -------
    Array
        Coefficient [-]; accurate to 1e-15 up to 8, not valid beyond.

    References
    ----------
    G. N. Watson, A Treatise on the Theory of Bessel Functions, 1944, section 11.2 (Neumann's addition theorem).
    """
    t = xp.asarray(argument) ** 2 / (0.5 * LARGEST_PUNCH_ARGUMENT**2) - 1.0
    total = xp.zeros_like(t)
    for coefficient in reversed(_POWERS.tolist()):
        total = total * t + coefficient
    return total


def mean_power(exponent: int) -> float:
    r"""Mean of :math:`\sin^k p` over a quarter turn.

    .. math:: \mu_k = \frac{\Gamma((k+1)/2)}{\sqrt\pi\;\Gamma(k/2+1)}

    Parameters
    ----------
    exponent : int
        k >= 0 [-].

    Returns
    -------
    float
        Mean [-]; the mean of the k-th power of the distance of two points under one punch is (2a)^k times its square.

    References
    ----------
    Euler's beta integral.
    """
    return math.gamma(0.5 * (exponent + 1)) / (math.sqrt(math.pi) * math.gamma(0.5 * exponent + 1.0))


def mean_logarithm(exponent: int) -> float:
    r"""Mean of :math:`\sin^k p\,\ln\sin p` over a quarter turn, for even k: the derivative of :func:`mean_power`.

    .. math:: \lambda_k = \mu_k\left[-\ln 2 + \sum_{j=1}^{k/2}\left(\frac1{2j-1} - \frac1{2j}\right)\right]

    Parameters
    ----------
    exponent : int
        k >= 0, even [-].

    Returns
    -------
    float
        Mean [-].

    References
    ----------
    Digamma function at whole and half numbers.
    """
    harmonic = sum(1.0 / (2 * j - 1) - 1.0 / (2 * j) for j in range(1, exponent // 2 + 1))
    return mean_power(exponent) * (harmonic - math.log(2.0))


def distance_moments(half_width_1: Real, half_width_2: Real) -> tuple[Array, Array]:
    r"""Mean square and mean fourth power of the distance between points of two contacts, minus that of their centres.

    .. math::
        \overline{\xi^2} = \tfrac12(a^2 + b^2), \qquad
        \overline{\xi^4} = \tfrac38(a^4 + b^4) + \tfrac32 a^2 b^2

    Parameters
    ----------
    half_width_1, half_width_2 : Real
        Half-widths a and b of two different contacts, over the radius [-].

    Returns
    -------
    second, fourth : Array
        Moments [-].

    References
    ----------
    Moments of the arcsine distribution, a^2/2 and 3a^4/8.
    """
    square_1, square_2 = xp.asarray(half_width_1) ** 2, xp.asarray(half_width_2) ** 2
    fourth = 0.375 * (square_1**2 + square_2**2) + 1.5 * square_1 * square_2
    return 0.5 * (square_1 + square_2), fourth
