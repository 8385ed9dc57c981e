r"""Influence coefficients: the displacement at one point due to a uniform traction on one pixel.

The integrals over a pixel are differences of corner values of

.. math::
    \int\!\!\int \frac{x^2}{r^3} = y\,\operatorname{asinh}\frac{x}{|y|}, \quad
    \int\!\!\int \frac{y^2}{r^3} = x\,\operatorname{asinh}\frac{y}{|x|}, \quad
    \int\!\!\int \frac{xy}{r^3} = -r, \qquad r^2 = x^2 + y^2
"""

from __future__ import annotations

import math
from collections.abc import Callable

import jax.numpy as jnp
from jax import Array

from asperity.bem.elastic_pair import ElasticPair


def _over_pixel(
    primitive: Callable[[Array, Array], Array], x: Array, y: Array, dx: Array, dy: Array
) -> Array:
    right, left, top, bottom = x + dx / 2.0, x - dx / 2.0, y + dy / 2.0, y - dy / 2.0
    return primitive(right, top) - primitive(right, bottom) - primitive(left, top) + primitive(left, bottom)


def patch_integrals(x: Array, y: Array, *, pixel_size: Array) -> tuple[Array, Array, Array]:
    r"""Integrals [m] of :math:`x^2/r^3`, :math:`y^2/r^3`, :math:`xy/r^3` over the pixel centred at (x, y).

    No corner may have x = 0 or y = 0: x and y are multiples of the pixel size.
    """
    dx, dy = pixel_size[0], pixel_size[1]
    xx = _over_pixel(lambda a, b: b * jnp.arcsinh(a / jnp.abs(b)), x, y, dx, dy)
    yy = _over_pixel(lambda a, b: a * jnp.arcsinh(b / jnp.abs(a)), x, y, dx, dy)
    xy = _over_pixel(lambda a, b: -jnp.hypot(a, b), x, y, dx, dy)
    return xx, yy, xy


def normal_patch(pair: ElasticPair, xx: Array, yy: Array) -> Array:
    r"""Normal displacement per pressure [m/Pa], :math:`\frac{1}{\pi E} \int\!\!\int \frac1r`.

    References
    ----------
    A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377; K. L. Johnson, Contact Mechanics, 1985, equation
    (3.25).
    """
    return (xx + yy) / (math.pi * pair.contact_modulus)


def shear_patch(pair: ElasticPair, xx: Array, yy: Array, xy: Array) -> tuple[Array, Array, Array]:
    r"""Tangential displacements per shear traction on a pixel [m/Pa] (Cerruti), components xx, yy, xy.

    .. math::
        u_{xx} = \frac{1}{2\pi}\int\!\!\int\left[\frac{x^2}{G r^3} + \frac{2 y^2}{E r^3}\right], \quad
        u_{xy} = \frac{1}{2\pi}\left(\frac1G - \frac2E\right)\int\!\!\int\frac{xy}{r^3}

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (3.75), summed over both bodies.
    """
    in_plane, antiplane = 2.0 / pair.contact_modulus, 1.0 / pair.antiplane_modulus
    scale = 1.0 / (2.0 * math.pi)
    return (
        scale * (antiplane * xx + in_plane * yy),
        scale * (antiplane * yy + in_plane * xx),
        scale * (antiplane - in_plane) * xy,
    )


def strip_integral(x: Array, *, pixel_size: Array, reference_distance: Array) -> Array:
    r"""Integral of :math:`\frac1\pi\ln(d/|x - s|)` over the pixel centred at s = 0.

    Parameters
    ----------
    x : array
        Distances between pixel centres [m].
    pixel_size : array, scalar
        Width of the pixel [m].
    reference_distance : array, scalar
        Distance d at which the displacement is taken as zero [m].

    Returns
    -------
    array
        The integral [m]; times 2/E it is the displacement along the normal or across the strip, times 1/G the
        displacement along the strip, per traction.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, section 2.3 (an infinite strip has no displacement at infinity to
    refer to, so a distance has to be chosen).
    """

    def primitive(s: Array) -> Array:
        return s * (1.0 - jnp.log(jnp.abs(s) / reference_distance))

    return (primitive(x + pixel_size / 2.0) - primitive(x - pixel_size / 2.0)) / math.pi


def coupling_integral(x: Array, *, pixel_size: Array) -> Array:
    r"""Integral [m] of :math:`-\tfrac12\operatorname{sgn}(x - s)` over the pixel centred at s = 0.

    Times :math:`2\beta/E` it is the displacement across the strip per pressure, and with the opposite sign the normal
    displacement per traction across the strip.

    References
    ----------
    K. L. Johnson, Contact Mechanics, 1985, equations (2.25), taken over both bodies.
    """

    def primitive(s: Array) -> Array:
        return -0.5 * jnp.abs(s)

    return primitive(x + pixel_size / 2.0) - primitive(x - pixel_size / 2.0)
