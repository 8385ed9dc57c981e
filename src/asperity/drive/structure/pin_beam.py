"""The pin of a roller as a beam: bending moment and stress, and how far it gives way."""

from __future__ import annotations

import math
from typing import Literal

from asperity.engine.arrays import xp
from asperity.engine.module import Module, static
from asperity.types import Array, Real

#: How the carrier holds a pin.
PinSupport = Literal["both_ends", "one_end"]


class PinBeam(Module):
    """The carrier pin of a roller as a beam.

    Parameters
    ----------
    free_length : Real
        Length between its two supports, or from its support to its end [m]; the roller is in the middle of it.
    support : {"both_ends", "one_end"}
        How the carrier holds it.
    diameter : Real
        Its diameter [m]; 0 where it is not known.
    """

    free_length: Real
    support: PinSupport = static()
    diameter: Real


def pin_bending_moment(*, force: Real, free_length: Real, roller_length: Real, support: PinSupport) -> Real:
    r"""Largest bending moment of a carrier pin with the roller in the middle of its free length.

    .. math:: M = \frac{F (2l - b)}{8} \;\text{(held at both ends)}, \qquad M = \frac{F l}{2} \;\text{(at one end)}

    Parameters
    ----------
    force : Real
        Force F of the roller, spread evenly over its length [N].
    free_length : Real
        Length l of the pin between its two supports, or from its support to its end [m].
    roller_length : Real
        Length b of the roller, at most l [m].
    support : {"both_ends", "one_end"}
        How the carrier holds the pin.

    Returns
    -------
    Real
        Bending moment [N·m].

    Notes
    -----
    Ends that may turn: cheeks of the carrier that hold the ends stiffly reduce the moment in the middle.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    if support == "one_end":
        return 0.5 * force * free_length
    return 0.125 * force * (2.0 * free_length - roller_length)


def pin_bending_stress(*, moment: Real, diameter: Real) -> Array:
    r"""Bending stress of a solid round pin, :math:`\sigma = 32 M/(\pi d^3)`.

    Parameters
    ----------
    moment : Real
        Bending moment M [N·m].
    diameter : Real
        Diameter d [m].

    Returns
    -------
    Array
        Stress at its surface [Pa]; nan for a pin without diameter.

    References
    ----------
    Statics of a beam; (L1) of :doc:`/equations`.
    """
    solid = diameter > 0.0
    return xp.where(solid, 32.0 * moment / (math.pi * xp.where(solid, diameter, 1.0) ** 3), xp.nan)


def pin_beam_compliance(
    *,
    free_length: Real,
    roller_length: Real,
    diameter: Real,
    youngs_modulus: Real,
    poisson_ratio: Real,
    support: PinSupport,
) -> Real:
    r"""Mean deflection of a carrier pin below its roller over the roller's force: bending and shear.

    .. math::
        c = \frac1{EI}\left[\frac{(l-b)^3}{48} + \frac{(l-b)^2 b}{16} + \frac{(l-b)\,b^2}{24} + \frac{b^3}{120}
        \right] + \frac1{kGA}\left[\frac l4 - \frac b6\right] \;\text{(held at both ends)}

    .. math::
        c = \frac1{EI}\left[\frac{l^3}{24} + \frac{b^3}{120}\right] + \frac1{kGA}\left[\frac l2 - \frac b6\right]
        \;\text{(at one end)}, \qquad k = \frac{6\,(1 + \nu)}{7 + 6\nu}

    Parameters
    ----------
    free_length : Real
        Length l of the pin between its two supports, or from its support to its end [m].
    roller_length : Real
        Length b of the roller in its middle, at most l [m].
    diameter : Real
        Diameter of the solid round pin [m].
    youngs_modulus : Real
        Young's modulus E of the pin [Pa].
    poisson_ratio : Real
        Poisson's ratio [-].
    support : {"both_ends", "one_end"}
        How the carrier holds the pin.

    Returns
    -------
    Real
        Compliance [m/N].

    Notes
    -----
    The roller spreads its force evenly over its length and follows the mean deflection there. The supports are rigid;
    two of them may turn, the only one does not. How far a pin held at one end tilts its roller is not counted.

    References
    ----------
    S. P. Timoshenko, Phil. Mag. 41 (1921) 744, the energy of bending moment and shear force; k of a solid round section
    by G. R. Cowper, J. Appl. Mech. 33 (1966) 335. Equation (L4) of :doc:`/equations`.
    """
    length, width = free_length, roller_length
    area = 0.25 * math.pi * xp.asarray(diameter) ** 2
    bending = youngs_modulus * area * diameter**2 / 16.0
    shear_factor = 6.0 * (1.0 + poisson_ratio) / (7.0 + 6.0 * poisson_ratio)
    shear = shear_factor * area * youngs_modulus / (2.0 * (1.0 + poisson_ratio))
    if support == "one_end":
        return (length**3 / 24.0 + width**3 / 120.0) / bending + (length / 2.0 - width / 6.0) / shear
    free = length - width
    bent = free**3 / 48.0 + free**2 * width / 16.0 + free * width**2 / 24.0 + width**3 / 120.0
    return bent / bending + (length / 4.0 - width / 6.0) / shear
