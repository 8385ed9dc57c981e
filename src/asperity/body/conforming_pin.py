r"""An elastic pin that touches its bore over an arc: pressure, arc and compliance, pin and plate of one material.

With the half-angle :math:`\epsilon` of the arc, :math:`u = \sin^2(\epsilon/2)` and :math:`x = \cos\epsilon = 1 - 2u`,
a force F over the length L presses with

.. math::
    p = \frac{F}{RL}\left[\frac{\sqrt2}{\pi} \cos\frac\varphi2 \sqrt{\cos\varphi - x} + \frac{(1-u)^2}{\pi u}
    \operatorname{artanh}\sqrt{\frac{\cos\varphi - x}{1 + \cos\varphi}}\,\right], \qquad |\varphi| < \epsilon .

In a large plate the arc is that at which the bore, wider than the pin by the radial clearance c, just fits the pressed
pin. Everywhere it is the one that stores the least energy, for a given force, among the pressures of this family.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from asperity.engine.arrays import xp
from asperity.types import Array

#: Highest mode of the pressure that the wall of a roller answers in its own way; below the first that is left out the
#: answer falls with the power 2n of the ratio of bore and roller.
MODES = 80
#: Modes whose shares :func:`pressure_shares` gives: the first one, a force, is known.
SHARED = np.array([0, *range(2, MODES + 1)])
#: The arc below which a logarithm is summed as a series, and terms of that.
_SMALL, _TERMS = 0.05, 14


def conforming_pressure(*, angle: Array, arc: Array) -> Array:
    r"""Pressure of an elastic pin on its bore, over its force per length and radius.

    .. math:: w = \frac{pRL}{F}, \qquad \int w \cos\varphi \, d\varphi = 1

    Parameters
    ----------
    angle : Array
        From the direction of the force, phi [rad].
    arc : Array
        :math:`\sin^2(\epsilon/2)` of the half-angle of the contact, above 0 and below 1 [-].

    Returns
    -------
    Array
        w [-]; 0 beyond the arc.

    References
    ----------
    A. Persson, On the Stress Distribution of Cylindrical Elastic Bodies in Contact, Chalmers University, Göteborg 1964;
    M. Ciavarella and P. Decuzzi, Int. J. Solids Struct. 38 (2001) 4507, for one material. Equation (E7) of
    :doc:`/equations`.
    """
    half = xp.sin(0.5 * angle) ** 2
    touches = half < arc
    inside = xp.where(touches, half, 0.0)
    depth = arc - inside  # half of cos(phi) - x
    log = xp.arctanh(xp.sqrt(depth / (1.0 - inside)))
    pressure = 2.0 * xp.sqrt((1.0 - inside) * depth) + (1.0 - arc) ** 2 / arc * log
    return xp.where(touches, pressure / math.pi, 0.0)


def clearance_share(*, arc: Array) -> Array:
    r"""How far a unit of radial clearance lets a pin on, beyond what its force alone presses.

    .. math::
        \int w\,(1 - \cos\varphi)\,d\varphi = u^2 + u\,(1-u)^2\,\ell, \qquad \ell = \frac{-\ln(1-u) - u}{u^2}

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    Array
        Share [-]: u/2 of a small arc.

    References
    ----------
    Integral of :func:`conforming_pressure`; equation (E7) of :doc:`/equations`.
    """
    return arc**2 + arc * (1.0 - arc) ** 2 * _log_rest(arc)[0]


def conforming_compliance(*, arc: Array) -> Array:
    r"""Compliance of a pin in the bore of a large plate under all modes of its pressure but the first.

    .. math::
        \hat C = E' L C = \frac{w_0^2}{\pi} - \frac2\pi\left[\ln u + \tfrac12 (1-u)(1 + 3u - 2u^2) + (1-u)^4\,\ell
        \right] = \frac{w_0^2}\pi + \frac4\pi \sum_{n\ge2} \frac{n\,w_n^2}{n^2 - 1}

    with the shares :math:`w_n` of :func:`pressure_shares` and :math:`\ell` of :func:`clearance_share`.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    Array
        Displacement of the pin against the plate, weighted with the pressure, over F/(E'L), with
        :math:`E' = E/(1-\nu^2)` in plane strain and E in plane stress [-].

    References
    ----------
    Sum of the modes n/(n^2 - 1) of disc and hole; equation (E7) of :doc:`/equations`.
    """
    uniform = 1.0 + clearance_share(arc=arc)
    left = 1.0 - arc
    bracket = xp.log(arc) + 0.5 * left * (1.0 + 3.0 * arc - 2.0 * arc**2) + left**4 * _log_rest(arc)[0]
    return (uniform**2 - 2.0 * bracket) / math.pi


def fitting_load(*, arc: Array) -> Array:
    r"""Clearance over the load that makes an arc of contact in a large plate, times the arc.

    .. math:: \frac{c E' L}{F}\,u = \frac{2\,(1 - 2u) + (1-u)^2 \ln(1-u)}{\pi}

    0 at a half-angle of 84.83°, at which a pin without clearance touches under any force; 2/π of small arcs is Hertz's.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    Array
        Clearance c times E'L over the force, times u [-]; negative where no clearance leaves so wide an arc.

    References
    ----------
    As :func:`conforming_pressure`. The derivative of :func:`conforming_compliance` is
    :math:`-2 \frac{cE'L}{F}` times that of :func:`clearance_share`: the arc stores the least energy.
    """
    left = 1.0 - arc
    return (2.0 * (1.0 - 2.0 * arc) + left**2 * xp.log1p(-arc)) / math.pi


def pressure_shares(*, arc: Array) -> Array:
    r"""Shares of the modes in the pressure of a pin.

    .. math::
        w_n = \int w \cos n\varphi\, d\varphi = \tfrac12 (P_{n+1} + P_n + P_{n-1} + P_{n-2}) - x (P_n + P_{n-1})
        + \frac{(1+x)^2}{4n^2} \sum_{m<n} (2m+1) P_m

    with Legendre's polynomials of :math:`x = 1 - 2u`; :math:`w_0 = 1 + \int w (1 - \cos\varphi)`, :math:`w_1 = 1`.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure`, shape (...) [-].

    Returns
    -------
    Array
        Shares of the modes :data:`SHARED`, shape (..., modes) [-].

    References
    ----------
    Mehler's and Dirichlet's integrals of Legendre's polynomials; equation (E7) of :doc:`/equations`.
    """
    uniform = 1.0 + clearance_share(arc=arc)
    waves = xp.cos(half_angle(arc)[..., None] * np.arange(MODES + 2.0))
    return xp.concatenate([uniform[..., None], waves @ share_series(power=1).T], axis=-1)


def half_angle(arc: Array) -> Array:
    r"""Half-angle of a contact over an arc, :math:`\epsilon = 2 \arcsin\sqrt u`.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    Array
        Half-angle [rad].
    """
    return 2.0 * xp.arcsin(xp.sqrt(arc))


@functools.cache
def share_series(*, power: int) -> np.ndarray:
    r"""Powers of the shares of the modes 2, 3, ... as series, :math:`w_n^p = \sum_k s_{nk} \cos k\epsilon`.

    Parameters
    ----------
    power : int
        p, above 0 [-].

    Returns
    -------
    ndarray
        s, shape (modes, cosines) [-]: Legendre's polynomials of a cosine are sums of cosines.

    References
    ----------
    :func:`pressure_shares`; equation (E7) of :doc:`/equations`.
    """
    count, legendre = power * (MODES + 1) + 1, np.polynomial.legendre
    angles = (np.arange(count) + 0.5) * math.pi / count
    x, n = np.cos(angles), SHARED[1:]
    values = legendre.legvander(x, MODES + 1).T
    before = np.cumsum((2.0 * np.arange(MODES + 2) + 1.0)[:, None] * values, axis=0)[n - 1]
    shares = 0.5 * (values[n + 1] + values[n] + values[n - 1] + values[n - 2])
    shares = shares - x * (values[n] + values[n - 1]) + (1.0 + x) ** 2 / (4.0 * n[:, None] ** 2) * before
    found = 2.0 / count * shares**power @ np.cos(np.arange(count)[:, None] * angles).T
    return found * np.where(np.arange(count) == 0, 0.5, 1.0)


def clearance_slopes(arc: Array) -> tuple[Array, Array, Array]:
    """First three derivatives by u of :func:`clearance_share`.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    tuple of Array
        First, second and third derivative [-].
    """
    rest, slope, curvature = _log_rest(arc)
    left = 1.0 - arc**2
    return (
        1.0 + arc - left * rest,
        1.0 + 2.0 * arc * rest - left * slope,
        2.0 * rest + 4.0 * arc * slope - left * curvature,
    )


def fitting_slopes(arc: Array) -> tuple[Array, Array]:
    """First two derivatives by u of :func:`fitting_load`.

    Parameters
    ----------
    arc : Array
        u, as of :func:`conforming_pressure` [-].

    Returns
    -------
    tuple of Array
        First and second derivative [-].
    """
    log = -xp.log1p(-arc)
    return (arc - 5.0 + 2.0 * (1.0 - arc) * log) / math.pi, (3.0 - 2.0 * log) / math.pi


def _log_rest(arc: Array) -> tuple[Array, Array, Array]:
    """The part of -ln(1 - u) beyond u, over the square of u, and its first two derivatives by u [-]."""
    small = arc < _SMALL
    near, far = xp.where(small, arc, 0.0), xp.where(small, 0.5, arc)
    k = np.arange(float(_TERMS))
    powers = near[..., None] ** k
    series = [
        xp.sum(powers * weight, axis=-1)
        for weight in (1.0 / (k + 2.0), (k + 1.0) / (k + 3.0), (k + 2.0) * (k + 1.0) / (k + 4.0))
    ]
    rest = (-xp.log1p(-far) - far) / far**2
    slope = 1.0 / (far * (1.0 - far)) - 2.0 * rest / far
    curvature = (2.0 * far - 1.0) / (far * (1.0 - far)) ** 2 + 2.0 * (rest / far - slope) / far
    return tuple(xp.where(small, *pair) for pair in zip(series, (rest, slope, curvature), strict=True))  # type: ignore[return-value]
