r"""Integrals over a stage of wear, from functions that are known at Gauss points of it.

A stage takes the length :math:`\Delta` off the interference, of which :math:`\Delta (1 - y^2)` is lost at y: rates with
the slope of a root, where a contact begins to slide at y = 0, have none over y.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial import legendre

from asperity.engine.arrays import xp
from asperity.types import Array, Number

_POINTS = 24
_NODES, _WEIGHTS = legendre.leggauss(_POINTS)
#: Gauss points of y, from 0 to 1.
PLACES = 0.5 * (1.0 + _NODES)


def _of_series() -> np.ndarray:
    """Values at the points → coefficients of the Legendre series of their integral, shape (points + 1, points)."""
    series = (legendre.legvander(_NODES, _POINTS - 1) * _WEIGHTS[:, None]).T
    series = series * (np.arange(_POINTS) + 0.5)[:, None]
    return 0.5 * np.stack([legendre.legint(column) for column in series.T], axis=1)


_OF_SERIES = _of_series()


def integral_from(y: Number, values: Number) -> Array:
    """Integrals from y to 1 of functions by their values at :data:`PLACES`, shape (points, ...).

    ``y`` of shape (...); results have its axes, then those of the functions. The polynomial through the values is
    integrated, to the whole of Gauss's rule from y = 0.
    """
    weights = xp.tensordot(_polynomials(xp.ones_like(y)) - _polynomials(y), _OF_SERIES, axes=((0,), (0,)))
    result: Array = xp.tensordot(weights, values, axes=1)
    return result


def _polynomials(y: Number) -> Array:
    """Legendre polynomials of 2y − 1, their degrees first."""
    x = 2.0 * y - 1.0
    terms = [xp.ones_like(x), x]
    for degree in range(1, _POINTS):
        terms.append(((2 * degree + 1) * x * terms[degree] - degree * terms[degree - 1]) / (degree + 1))
    return xp.stack(terms)
