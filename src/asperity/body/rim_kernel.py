r"""The singular part of every rim in closed form: sums of :math:`e^{in\theta}/(n\pm1)`.

With :math:`z = e^{i\theta}` and :math:`L = -\ln(1-z)`,

.. math::
    \sum_{n\ge1} \frac{z^n}{n+1} = \bar z\,(L - z), \qquad \sum_{n\ge2} \frac{z^n}{n-1} = z L .

They give the displacements of a disc under loads on its rim, and of an infinite plate under loads on the rim of a
hole; the additional terms of an annulus converge like :math:`(R_i/R_o)^{2n}`.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.body.punch import mean_logarithm, mean_power
from asperity.engine.arrays import xp
from asperity.types import Array, Real

#: Terms of the power series in the half-width; with 12 the first omitted term is below 1e-16 up to a = 0.1 R.
_TERMS = 6


class RimSums(NamedTuple):
    """The four sums at one angle [-].

    Parameters
    ----------
    cosine_plus, sine_plus : Array
        Over n >= 1 of cos(n theta)/(n+1) and sin(n theta)/(n+1) [-].
    cosine_minus, sine_minus : Array
        Over n >= 2 of cos(n theta)/(n-1) and sin(n theta)/(n-1) [-].
    """

    cosine_plus: Array
    sine_plus: Array
    cosine_minus: Array
    sine_minus: Array


def separated_sums(*, angle: Real, second_moment: Real, fourth_moment: Real) -> RimSums:
    r"""Sums between two different contacts, weighted with both punch pressures.

    .. math::
        \overline{f(\theta + \xi)} = f + \tfrac12 \overline{\xi^2} f^{(2)} + \tfrac1{24}\overline{\xi^4} f^{(4)}, \qquad
        L = -\ln\left|2\sin\tfrac\theta2\right| + \tfrac i2 (\pi - \theta)

    Parameters
    ----------
    angle : Real
        Angle theta between the contacts, no multiple of a full turn [rad].
    second_moment, fourth_moment : Real
        Means of the second and fourth power of the distance of two points of the contacts,
        :func:`~asperity.body.punch.distance_moments` [-]; 0 for point loads.

    Returns
    -------
    RimSums
        Real and imaginary parts of the two sums.

    Notes
    -----
    With :math:`g = z/(1-z) = -\tfrac12 + it`, :math:`t = \tfrac12\cot\tfrac\theta2`, the derivatives are
    :math:`(zL)^{(2)} = -z(L + 3g + g^2)`, :math:`(zL)^{(4)} = z(L + 15g + 25g^2 + 20g^3 + 6g^4)`,
    :math:`(\bar zL)^{(2)} = -\bar z(L - g + g^2)`, :math:`(\bar zL)^{(4)} = \bar z(L - g + g^2 + 4g^3 + 6g^4)`.
    The sixth derivative is neglected, about (a/d)^6/10 of a sum of order 1 for half-widths a at the distance d.

    References
    ----------
    I. S. Gradshteyn and I. M. Ryzhik, Table of Integrals, Series, and Products, 1.441.
    """
    derivatives = separated_derivatives(angle)
    half, quarter = 0.5 * second_moment, fourth_moment / 24.0
    return RimSums(*(part[0] + half * part[1] + quarter * part[2] for part in derivatives))


def separated_derivatives(angle: Real) -> RimSums:
    r"""The sums for point loads, and their second and fourth derivatives by the angle.

    .. math:: f, \quad f^{(2)}, \quad f^{(4)}

    Parameters
    ----------
    angle : Real
        Angle theta between the contacts, no multiple of a full turn [rad].

    Returns
    -------
    RimSums
        Each of shape (3, ...).

    References
    ----------
    The notes of :func:`separated_sums`.
    """
    turn = xp.mod(xp.asarray(angle), 2.0 * math.pi)
    sin_half, cos_half = xp.sin(0.5 * turn), xp.cos(0.5 * turn)
    cos, sin = 1.0 - 2.0 * sin_half**2, 2.0 * sin_half * cos_half
    t = 0.5 * cos_half / sin_half
    t2 = t * t
    alternating, plus_shift, minus_shift, once = (
        np.array(numbers).reshape((3,) + (1,) * turn.ndim)
        for numbers in ((1.0, -1.0, 1.0), (0.0, -0.75, 0.625), (0.0, 1.25, -3.375), (1.0, 0.0, 0.0))
    )
    zero = xp.zeros_like(t2)
    even = xp.stack([zero, t2, 6.0 * t2 * t2 - 4.0 * t2]) - xp.log(2.0 * sin_half) * alternating
    odd = xp.stack([zero, 2.0 * t, 2.0 * t * (4.0 * t2 - 1.0)])
    imaginary = 0.5 * (math.pi - turn) * alternating
    plus, plus_i, minus, minus_i = even + plus_shift, imaginary + odd, even + minus_shift, imaginary - odd
    return RimSums(
        cosine_plus=cos * plus + sin * plus_i - once,
        sine_plus=cos * plus_i - sin * plus,
        cosine_minus=cos * minus - sin * minus_i,
        sine_minus=cos * minus_i + sin * minus,
    )


def _self_series() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Coefficients of even and odd powers of 2 alpha; see :func:`self_sums`."""
    sign = np.array([(-1.0) ** j for j in range(_TERMS)])
    even = np.array([mean_power(2 * j) ** 2 for j in range(_TERMS + 1)])
    odd = np.array([mean_power(2 * j + 1) ** 2 for j in range(_TERMS)])
    log = np.array([2.0 * mean_power(2 * j) * mean_logarithm(2 * j) for j in range(_TERMS)])
    cosine = sign / np.array([float(math.factorial(2 * j)) for j in range(_TERMS)])
    sine = sign / np.array([float(math.factorial(2 * j + 1)) for j in range(_TERMS)])
    # -ln(2 sin(x/2)/x) = sum |B_2k| x^2k / (2k (2k)!), Bernoulli numbers
    bernoulli = [1 / 6, 1 / 30, 1 / 42, 1 / 30, 5 / 66]
    chord = np.array([0.0] + [b / (2 * k * math.factorial(2 * k)) for k, b in enumerate(bernoulli, 1)])
    product = np.convolve(cosine, chord)[:_TERMS]
    logarithm = -cosine * even[:_TERMS]  # times ln(2 alpha)
    regular = -cosine * log + product * even[:_TERMS]
    kink = 0.5 * math.pi * sine * odd  # of sin(x) pi/2, odd powers
    bend = -0.5 * sine * even[1:]  # of -sin(x) x/2, even powers from 2
    return logarithm, regular, kink, bend


_LOGARITHM, _REGULAR, _KINK, _BEND = _self_series()


def _polynomial(coefficients: np.ndarray, variable: Array) -> Array:
    total = xp.zeros_like(variable)
    for coefficient in reversed(coefficients.tolist()):
        total = total * variable + coefficient
    return total


def self_sums(punch_angle: Real) -> tuple[Array, Array]:
    r"""Sums at the contact itself, weighted with :math:`J_0(n\alpha)^2`; those of sines are zero.

    .. math::
        \overline{\cos\xi\,\ln\frac1{2\sin(\xi/2)}} \pm \overline{\sin\xi\,\frac{\pi-\xi}2}, \qquad
        \overline{\xi^k} = (2\alpha)^k \mu_k^2, \quad
        \overline{\xi^k \ln\xi} = (2\alpha)^k \left[\mu_k^2 \ln 2\alpha + 2\mu_k\lambda_k\right]

    Parameters
    ----------
    punch_angle : Real
        Half-width over radius, alpha [rad].

    Returns
    -------
    cosine_plus, cosine_minus : Array
        The sums of :class:`RimSums` [-]; their leading term is ln(2/alpha) [-].

    Notes
    -----
    Power series to (2 alpha)^11: relative error below 1e-14 up to alpha = 0.1.

    References
    ----------
    Moments of :func:`~asperity.body.punch.mean_power`.
    """
    width = 2.0 * xp.asarray(punch_angle)
    square = width**2
    logarithm = _polynomial(_LOGARITHM, square) * xp.log(width) + _polynomial(_REGULAR, square)
    straight = width * _polynomial(_KINK, square) + square * _polynomial(_BEND, square)
    return logarithm + straight - 1.0, logarithm - straight
