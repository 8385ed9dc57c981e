r"""The modes n = 0 and n = 1 of an annulus: uniform pressure, twist, and translation."""

from __future__ import annotations

from typing import NamedTuple

from asperity.body.annulus_modes import Channels, ModeCompliance, Wall, components
from asperity.engine.arrays import xp
from asperity.types import Array, Real


def uniform_field(wall: Wall) -> tuple[Real, Real]:
    r"""Lamé's field under a uniform pressure, :math:`\sigma_r = A + C/r^2`, :math:`\sigma_\theta = A - C/r^2`.

    Parameters
    ----------
    wall : Wall
        The annulus; r in units of its loaded radius.

    Returns
    -------
    even, odd : Real
        A and C for a unit radial stress on the loaded rim, A + C = 1 [-].

    References
    ----------
    G. Lamé, 1852; S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 1970, section 28.
    """
    traction, held = wall.radial
    pull = traction - wall.side * held * 0.5 * (wall.kolosov - 1.0) * wall.ratio
    push = traction / wall.ratio**2 + wall.side * held / wall.ratio
    return push / (push - pull), -pull / (push - pull)


def uniform_compliance(wall: Wall) -> tuple[Array, Array]:
    r"""Compliance of the mode n = 0: uniform pressure, and uniform shear, which rotates the rims.

    .. math:: \frac{2G u_r}{R} = \frac{\kappa - 1}2 A - C, \qquad \frac{2G u_\theta}{R} = \omega - \tau

    Parameters
    ----------
    wall : Wall
        The annulus.

    Returns
    -------
    radial, tangential : Array
        In units of R/4G [-]. The torque on a ring is reacted evenly along its outer rim, whatever supports it; that on
        a roller is balanced, and its tangential compliance without torsional support 0.

    References
    ----------
    S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 1970, sections 28 and 43.
    """
    side, ratio = wall.side, wall.ratio
    even, odd = uniform_field(wall)
    traction, held = wall.tangential
    turns = held > 0.0
    supported = side * traction / (xp.where(turns, held, 1.0) * ratio**3)
    turn = xp.where(turns, supported, 0.0) + 1.0 / ratio**2
    radial = side * (0.5 * (wall.kolosov - 1.0) * even - odd)
    return xp.asarray(2.0 * radial), 2.0 * xp.where(turns | (side < 0.0), side * (turn - 1.0), 0.0)


class TranslationField(NamedTuple):
    """Coefficients of the fields of the mode n = 1.

    Parameters
    ----------
    cubic, inverse : Array
        Of Airy's functions r^3 and 1/r [-].
    resultant : Array
        Of Michell's function with a resultant force [-].
    translation : Array
        Twice the rigid translation [-].
    """

    cubic: Array
    inverse: Array
    resultant: Array
    translation: Array


def translation_field(*, wall: Wall, plus: Real, minus: Real) -> TranslationField:
    r"""Fields of the mode n = 1 under the tractions P + Q and P - Q on the loaded rim.

    Parameters
    ----------
    wall : Wall
        The annulus.
    plus, minus : Real
        P + Q and P - Q; only the second has a resultant force [-].

    Returns
    -------
    TranslationField
        Coefficients. For an unsupported body the resultant and the translation are excluded (balanced loads).

    References
    ----------
    J. R. Barber, Elasticity, 2010, tables 8.1 and 9.1; equation (E2) of :doc:`/equations`.
    """
    side, ratio, kolosov = wall.side, wall.ratio, wall.kolosov
    (free_r, held_r), (free_t, held_t) = wall.radial, wall.tangential
    supported = (held_r + held_t) > 0.0
    c = xp.where(supported, side * minus / (2.0 * (kolosov + 1.0)), 0.0)
    e = c - 0.25 * side * plus  # coefficient of 1/r is b + e, with b that of r^3
    # at the other rim, constant part and part with b: sums and differences of stresses and displacements
    stress, stress_0 = 4.0 * (ratio - ratio**-3), 4.0 * (c / ratio - e * ratio**-3)
    motion, motion_0 = 2.0 * (kolosov * ratio**2 + ratio**-2), 2.0 * (e * ratio**-2 - c)
    difference, difference_0 = -4.0 * ratio**2, 4.0 * kolosov * xp.log(ratio) * c
    shear = 2.0 * (kolosov + 1.0) * c / ratio
    factor = (free_r * held_t + free_t * held_r) * stress - 2.0 * side * held_r * held_t * motion
    constant = (
        held_t * free_r * (stress_0 + shear)
        + held_r * free_t * (stress_0 - shear)
        - 2.0 * side * held_r * held_t * motion_0
    )
    b = -xp.where(supported, constant, stress_0) / xp.where(supported, factor, stress)
    held = xp.where(supported, held_r + held_t, 1.0)
    turned = (
        (free_r - free_t) * (stress * b + stress_0)
        + (free_r + free_t) * shear
        - side * (held_r - held_t) * (motion * b + motion_0)
    ) / (side * held)
    shift = xp.where(supported, turned - difference * b - difference_0, 4.0 * b)
    return TranslationField(b, b + e, c, shift)


def translation_compliance(wall: Wall) -> ModeCompliance:
    r"""Compliance of the mode n = 1, minus the part contained in the closed sums of the rim.

    .. math:: 2G\,u_+ = 2(\kappa b + e - c), \qquad 2G\,u_- = g - 4b

    Parameters
    ----------
    wall : Wall
        The annulus.

    Returns
    -------
    ModeCompliance
        Addition to :math:`\kappa/2` for a disc, 1/2 for a hole, in the channel P + Q, in units of R/4G [-].

    References
    ----------
    :func:`translation_field`; equation (E2) of :doc:`/equations`.
    """
    channels = []
    for plus, minus in ((1.0, 0.0), (0.0, 1.0)):
        b, e, c, shift = translation_field(wall=wall, plus=plus, minus=minus)
        channels.append((2.0 * (wall.kolosov * b + e - c), shift - 4.0 * b))
    (pp, mp), (pm, mm) = channels
    alone = 0.5 * xp.where(wall.side > 0.0, wall.kolosov, 1.0)
    return components(Channels(pp - alone, pm, mp, mm), 1.0)
