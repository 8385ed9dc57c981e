r"""Compliance of an annulus mode by mode, as what it adds to a disc or to a hole in an infinite plate.

Tractions :math:`\sigma_r = P\cos n\theta`, :math:`\tau = Q\sin n\theta` on a rim and the displacements they cause are
taken in the channels :math:`P \pm Q`. In units of the loaded radius :math:`R`, with :math:`s = +1` for a loaded outer and
:math:`-1` for a loaded inner rim and :math:`m = s n`, the fields that decay away from the loaded rim
(:math:`r^m`, :math:`r^{m+2}` in Airy's function) have

.. math:: R\,\sigma_\pm = 2G\,D^{(1)}_\pm u_\pm, \qquad D^{(1)} = \operatorname{diag}\left(\frac{m+1}\kappa,\; m-1\right)

at every radius, and those that decay away from the other rim :math:`D^{(2)} = -\operatorname{diag}(m+1,\, (m-1)/\kappa)`.
The condition at the other rim ties the second set to the first, :math:`u^{(2)} = -E u^{(1)}` at the loaded rim with
:math:`E \sim (R_i/R_o)^{2n}`, and the mode's compliance is that of the disc, or of the hole, plus

.. math:: s\,\big(D^{(1)-1} D^{(2)} - 1\big)\, E\, \big(D^{(1)} - D^{(2)} E\big)^{-1}.
"""

from __future__ import annotations

from typing import NamedTuple

import jax.numpy as jnp
from jax import Array

from asperity.types import Real


class Wall(NamedTuple):
    """An annulus in units of its loaded radius and of twice its shear modulus.

    Parameters
    ----------
    side : float
        s: +1 for contacts on the outer, -1 on the inner rim [-].
    ratio : Real
        Radius of the other rim over that of the loaded rim [-].
    kolosov : Real
        Kolosov's constant [-].
    radial, tangential : tuple of Real
        Weights of traction and displacement in the condition at the other rim, :func:`support_weights` [-].
    """

    side: float
    ratio: Real
    kolosov: Real
    radial: tuple[Real, Real]
    tangential: tuple[Real, Real]


class ModeCompliance(NamedTuple):
    """Displacements of a mode under unit tractions of that mode, in units of R/4G.

    Parameters
    ----------
    radial, tangential : Array
        Along the traction [-].
    coupling : Array
        Radial under tangential, and tangential under radial [-].
    """

    radial: Array
    tangential: Array
    coupling: Array


class _Pair(NamedTuple):
    """A 2x2 matrix on the channels plus and minus."""

    pp: Array
    pm: Array
    mp: Array
    mm: Array


class ModeField(NamedTuple):
    """A mode under unit tractions on the loaded rim; matrices on the channels (+, -) as (++, +-, -+, --) [-].

    Parameters
    ----------
    first : tuple of Real
        D1: traction over displacement of the set that decays from the loaded rim [-].
    second : tuple of Real
        D2: the same of the set that decays from the other rim [-].
    echo : tuple of Array
        E: displacement of the second set over that of the first, sign reversed, at the loaded rim [-].
    motion : tuple of Array
        Displacement of the first set at the loaded rim per traction [-].
    passed : tuple of Array
        Displacement of the first set at the other rim over that at the loaded rim [-].
    answer : tuple of Array
        Displacement of the second set at the other rim over that of the first at the loaded rim [-].
    """

    first: tuple[Real, Real]
    second: tuple[Real, Real]
    echo: _Pair
    motion: _Pair
    passed: _Pair
    answer: _Pair


def _product(a: _Pair, b: _Pair) -> _Pair:
    return _Pair(
        a.pp * b.pp + a.pm * b.mp,
        a.pp * b.pm + a.pm * b.mm,
        a.mp * b.pp + a.mm * b.mp,
        a.mp * b.pm + a.mm * b.mm,
    )


def support_weights(*, support_stiffness: Real, radius: Real, shear_modulus: Real) -> tuple[Array, Array]:
    r"""Weights of traction and displacement at a supported rim, :math:`1/(1+k)` and :math:`k/(1+k)`.

    .. math:: \frac{1}{1+k}\,\sigma \pm \frac{k}{1+k}\,\frac{2G}{R}\,u = 0, \qquad k = \frac{k'' R}{2G}

    Parameters
    ----------
    support_stiffness : Real
        Stiffness of the support per area k'', 0 to infinity [N/m^3].
    radius : Real
        Radius of the loaded rim R [m].
    shear_modulus : Real
        Shear modulus G [Pa].

    Returns
    -------
    traction, displacement : Array
        The two weights [-]: (1, 0) for a free rim, (0, 1) for a held one.

    References
    ----------
    E. Winkler, Die Lehre von der Elasticität und Festigkeit, 1867.
    """
    stiffness = jnp.asarray(support_stiffness)
    finite = jnp.isfinite(stiffness)
    relative = jnp.where(finite, stiffness, 1.0) * radius / (2.0 * shear_modulus)
    return jnp.where(finite, 1.0 / (1.0 + relative), 0.0), jnp.where(finite, relative / (1.0 + relative), 1.0)


def mode_field(*, mode: Real, decay: Real, wall: Wall) -> ModeField:
    r"""Fields of a mode n >= 2 under unit tractions on the loaded rim.

    Parameters
    ----------
    mode : Real
        Mode number n >= 2 [-].
    decay : Real
        :math:`(R_i/R_o)^n` [-].
    wall : Wall
        The annulus.

    Returns
    -------
    ModeField
        Both sets of fields.

    References
    ----------
    Airy's functions by J. H. Michell, Proc. London Math. Soc. 31 (1899) 100; their stresses and displacements as in
    J. R. Barber, Elasticity, 2010, tables 8.1 and 9.1. Matrices: equation (E2) of :doc:`/equations`.
    """
    side, ratio, kolosov = wall.side, wall.ratio, wall.kolosov
    m = side * mode
    inverse = 1.0 / ratio
    d1 = ((m + 1.0) / kolosov, m - 1.0)
    d2 = (-(m + 1.0), -(m - 1.0) / kolosov)
    zero = jnp.zeros_like(decay * ratio)
    passed = _Pair(ratio * decay, zero, (m + 1.0) / kolosov * (inverse - ratio) * decay, inverse * decay)
    returned = _Pair(ratio * decay, (m - 1.0) / kolosov * (inverse - ratio) * decay, zero, inverse * decay)

    def conditions(d: tuple[Real, Real], weights: tuple[Real, Real]) -> tuple[Real, Real]:
        traction, displacement = weights
        return (
            traction * d[0] * inverse - side * displacement,
            traction * d[1] * inverse - side * displacement,
        )

    (ar_p, ar_m), (at_p, at_m) = conditions(d1, wall.radial), conditions(d1, wall.tangential)
    (br_p, br_m), (bt_p, bt_m) = conditions(d2, wall.radial), conditions(d2, wall.tangential)
    scale = 1.0 / (br_p * bt_m + br_m * bt_p)
    reflection = _Pair(
        (bt_m * ar_p + br_m * at_p) * scale,
        (bt_m * ar_m - br_m * at_m) * scale,
        (bt_p * ar_p - br_p * at_p) * scale,
        (bt_p * ar_m + br_p * at_m) * scale,
    )
    answer = _product(reflection, passed)
    echo = _product(returned, answer)
    # D1 - D2 E, inverted
    pp, pm = d1[0] - d2[0] * echo.pp, -d2[0] * echo.pm
    mp, mm = -d2[1] * echo.mp, d1[1] - d2[1] * echo.mm
    inverse_determinant = side / (pp * mm - pm * mp)
    motion = _Pair(
        mm * inverse_determinant,
        -pm * inverse_determinant,
        -mp * inverse_determinant,
        pp * inverse_determinant,
    )
    return ModeField(d1, d2, echo, motion, passed, _Pair(*(-entry for entry in answer)))


def added_compliance(*, mode: Real, decay: Real, wall: Wall) -> ModeCompliance:
    r"""What the other rim adds to the compliance of a mode n >= 2 of a disc, or of a hole in an infinite plate.

    .. math:: s\,\big(D^{(1)-1} D^{(2)} - 1\big)\, E\, \big(D^{(1)} - D^{(2)} E\big)^{-1}

    Parameters
    ----------
    mode : Real
        Mode number n >= 2 [-].
    decay : Real
        :math:`(R_i/R_o)^n` [-].
    wall : Wall
        The annulus.

    Returns
    -------
    ModeCompliance
        Addition [-], of the order of the square of the decay.

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    field = mode_field(mode=mode, decay=decay, wall=wall)
    change = _product(field.echo, field.motion)
    plus = field.second[0] / field.first[0] - 1.0
    minus = field.second[1] / field.first[1] - 1.0
    return _compliance(
        _Pair(plus * change.pp, plus * change.pm, minus * change.mp, minus * change.mm), wall.side
    )


def _compliance(channels: _Pair, side: float) -> ModeCompliance:
    straight, crossed = channels.pp + channels.mm, 0.5 * (channels.pm + channels.mp)
    return ModeCompliance(
        straight + 2.0 * crossed, straight - 2.0 * crossed, side * (channels.pp - channels.mm)
    )


def uniform_field(wall: Wall) -> tuple[Array, Array]:
    r"""Lamé's field under a uniform pressure, :math:`\sigma_r = A + C/r^2`, :math:`\sigma_\theta = A - C/r^2`.

    Parameters
    ----------
    wall : Wall
        The annulus; r in units of its loaded radius.

    Returns
    -------
    even, odd : Array
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
    r"""Compliance of the mode n = 0: uniform pressure, and uniform shear, which turns the rims.

    .. math:: \frac{2G u_r}{R} = \frac{\kappa - 1}2 A - C, \qquad \frac{2G u_\theta}{R} = \omega - \tau

    Parameters
    ----------
    wall : Wall
        The annulus.

    Returns
    -------
    radial, tangential : Array
        In units of R/4G [-]; the tangential one is 0 where nothing holds the ring against turning (loads balance).

    References
    ----------
    S. P. Timoshenko and J. N. Goodier, Theory of Elasticity, 1970, sections 28 and 43.
    """
    side, ratio = wall.side, wall.ratio
    even, odd = uniform_field(wall)
    traction, held = wall.tangential
    turns = held > 0.0
    turn = side * traction / (jnp.where(turns, held, 1.0) * ratio**3) + 1.0 / ratio**2
    radial = side * (0.5 * (wall.kolosov - 1.0) * even - odd)
    return 2.0 * radial, 2.0 * jnp.where(turns, side * (turn - 1.0), 0.0)


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
        Coefficients. Where nothing holds the body the resultant is left out and so is the translation: loads balance.

    References
    ----------
    J. R. Barber, Elasticity, 2010, tables 8.1 and 9.1; equation (E2) of :doc:`/equations`.
    """
    side, ratio, kolosov = wall.side, wall.ratio, wall.kolosov
    (free_r, held_r), (free_t, held_t) = wall.radial, wall.tangential
    supported = (held_r + held_t) > 0.0
    c = jnp.where(supported, side * minus / (2.0 * (kolosov + 1.0)), 0.0)
    e = c - 0.25 * side * plus  # coefficient of 1/r is b + e, with b that of r^3
    # at the other rim, constant part and part with b: sums and differences of stresses and displacements
    stress, stress_0 = 4.0 * (ratio - ratio**-3), 4.0 * (c / ratio - e * ratio**-3)
    motion, motion_0 = 2.0 * (kolosov * ratio**2 + ratio**-2), 2.0 * (e * ratio**-2 - c)
    difference, difference_0 = -4.0 * ratio**2, 4.0 * kolosov * jnp.log(ratio) * c
    shear = 2.0 * (kolosov + 1.0) * c / ratio
    factor = (free_r * held_t + free_t * held_r) * stress - 2.0 * side * held_r * held_t * motion
    constant = (
        held_t * free_r * (stress_0 + shear)
        + held_r * free_t * (stress_0 - shear)
        - 2.0 * side * held_r * held_t * motion_0
    )
    b = -jnp.where(supported, constant, stress_0) / jnp.where(supported, factor, stress)
    held = jnp.where(supported, held_r + held_t, 1.0)
    turned = (
        (free_r - free_t) * (stress * b + stress_0)
        + (free_r + free_t) * shear
        - side * (held_r - held_t) * (motion * b + motion_0)
    ) / (side * held)
    shift = jnp.where(supported, turned - difference * b - difference_0, 4.0 * b)
    return TranslationField(b, b + e, c, shift)


def translation_compliance(wall: Wall) -> ModeCompliance:
    r"""Compliance of the mode n = 1, less what the closed sums of the rim already hold of it.

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
    alone = 0.5 * wall.kolosov if wall.side > 0.0 else 0.5
    return _compliance(_Pair(pp - alone, pm, mp, mm), 1.0)
