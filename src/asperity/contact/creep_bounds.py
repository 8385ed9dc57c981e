"""The law of creep on the width of one contact: what elastic bodies leave of the stress of an even slip."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.types import Array

_NODES, _GAUSS = np.polynomial.legendre.leggauss(16)
_ANGLES = 0.25 * math.pi * (1.0 + _NODES)
#: Pressure over its peak at the places x = a sin(phi) on half of the width, and weights of both halves over a.
SHAPE, WEIGHTS = np.cos(_ANGLES), 0.5 * math.pi * _GAUSS * np.cos(_ANGLES)


def _along_places(values: np.ndarray, of: Array) -> np.ndarray:
    """Numbers of the places before the axes of an array."""
    return values.reshape(-1, *(1 for _ in xp.shape(of)))


def elliptic_stress(peak: Array) -> Array:
    r"""A stress in proportion to Hertz's pressure at the places, :math:`\tau_{max}\sqrt{1 - x^2/a^2}`.

    Parameters
    ----------
    peak : Array
        In the middle of the contact, shape (contacts, ...) [Pa].

    Returns
    -------
    Array
        At the places of :data:`SHAPE`, shape (16, contacts, ...) [Pa].

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 4.2.
    """
    return xp.asarray(_along_places(SHAPE, peak) * peak)


def width_mean(stress: Array) -> Array:
    r"""Mean over the width of a stress that is symmetric across the contact, :math:`\int \tau\,dx/2a`.

    Parameters
    ----------
    stress : Array
        At the places of :data:`SHAPE` on half of the width, shape (16, contacts, ...) [Pa].

    Returns
    -------
    Array
        Mean, shape (contacts, ...) [Pa].

    References
    ----------
    Gauss's quadrature over phi with x = a sin phi; equation (F4) of :doc:`/equations`.
    """
    return 0.5 * (_along_places(WEIGHTS, stress[0]) * stress).sum(axis=0)


class BoundedStress(NamedTuple):
    """Mean shear stress of a contact of elastic bodies [Pa], and its creepage over that at which all slips [-]."""

    mean: Array
    slid: Array


def bounded_stress(*, stress: Array, mean: Array, bodies: Array, exponent: Array) -> BoundedStress:
    r"""Mean shear stress of a rolling contact of elastic bodies, between the two bounds of the law of creep.

    .. math::
        \bar\tau_{up} = \bar\tau_0\,u(2 - u), \quad u = \min\left(\frac{\pi b}{4\bar\tau_0}, 1\right), \qquad
        \bar\tau_{low} = \frac1{2a}\int b \arctan\frac{\tau}{b}\,dx, \qquad
        \bar\tau = (1 - v)\,\bar\tau_{up} + v\,\bar\tau_{low}, \quad v = \frac{4 n}{1 + 3 n}

    Parameters
    ----------
    stress, mean : Array
        Stress tau of rigid bodies at the places, shape (16, contacts, ...), and its mean, shape (contacts, ...) [Pa].
    bodies : Array
        :math:`b = E^* z/2` of the creepage z that the bodies feel [Pa].
    exponent : Array
        n, slope of the logarithm of the mean over that of the slip, taken within 0 and 1 [-].

    Returns
    -------
    BoundedStress
        Shape (contacts, ...).

    References
    ----------
    F. W. Carter, Proc. R. Soc. A 112 (1926) 151; equation (F5) of :doc:`/equations`.
    """
    slid = 0.25 * math.pi * bodies / mean
    used = xp.minimum(slid, 1.0)
    upper = mean * used * (2.0 - used)
    lower = width_mean(bodies * xp.arctan(stress / bodies))
    within = xp.clip(exponent, 0.0, 1.0)
    return BoundedStress(upper + 4.0 * within / (1.0 + 3.0 * within) * (lower - upper), slid)
