r"""Compliance of an annulus mode by mode, in addition to that of a disc or of a hole in an infinite plate.

Tractions :math:`\sigma_r = P\cos n\theta`, :math:`\tau = Q\sin n\theta` on a rim and the displacements that they cause
are taken in the channels :math:`P \pm Q`. In units of the loaded radius :math:`R`, with :math:`s = +1` for a loaded
outer and :math:`-1` for a loaded inner rim and :math:`m = s n`, the fields that decay away from the loaded rim
(:math:`r^m`, :math:`r^{m+2}` in Airy's function) have

.. math::
    R\,\sigma_\pm = 2G\,D^{(1)}_\pm u_\pm, \qquad D^{(1)} = \operatorname{diag}\left(\frac{m+1}\kappa,\; m-1\right)

at every radius, and those that decay away from the other rim
:math:`D^{(2)} = -\operatorname{diag}(m+1,\, (m-1)/\kappa)`. The condition at the other rim couples the second set to
the first, :math:`u^{(2)} = -E u^{(1)}` at the loaded rim with :math:`E \sim (R_i/R_o)^{2n}`, and the mode's compliance
is that of the disc, or of the hole, plus

.. math:: s\,\big(D^{(1)-1} D^{(2)} - 1\big)\, E\, \big(D^{(1)} - D^{(2)} E\big)^{-1}.
"""

from __future__ import annotations

from typing import NamedTuple

from asperity.engine.arrays import xp
from asperity.types import Array, Real


class Wall(NamedTuple):
    """An annulus in units of its loaded radius and of twice its shear modulus.

    Parameters
    ----------
    side : Real
        s: +1 for contacts on the outer, -1 on the inner rim [-].
    ratio : Real
        Radius of the other rim over that of the loaded rim [-].
    kolosov : Real
        Kolosov's constant [-].
    radial, tangential : tuple of Real
        Weights of traction and displacement in the condition at the other rim, :func:`support_weights` [-].
    """

    side: Real
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


class Channels(NamedTuple):
    """A 2x2 matrix on the channels plus and minus.

    Parameters
    ----------
    pp, pm, mp, mm : Real
        Entries ++, +-, -+ and -- [-].
    """

    pp: Real
    pm: Real
    mp: Real
    mm: Real


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
    echo: Channels
    motion: Channels
    passed: Channels
    answer: Channels


def channel_product(a: Channels, b: Channels) -> Channels:
    """Product :math:`AB` of two matrices on the channels.

    Parameters
    ----------
    a, b : Channels
        A and B [-].

    Returns
    -------
    Channels
        Their product [-].

    References
    ----------
    Elementary.
    """
    return Channels(
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
        The two weights [-]: (1, 0) for a free rim, (0, 1) for a fixed one.

    References
    ----------
    E. Winkler, Die Lehre von der Elasticität und Festigkeit, 1867.
    """
    stiffness = xp.asarray(support_stiffness)
    finite = xp.isfinite(stiffness)
    relative = xp.where(finite, stiffness, 1.0) * radius / (2.0 * shear_modulus)
    return xp.where(finite, 1.0 / (1.0 + relative), 0.0), xp.where(finite, relative / (1.0 + relative), 1.0)


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
    zero = xp.zeros_like(decay * ratio)
    passed = Channels(ratio * decay, zero, (m + 1.0) / kolosov * (inverse - ratio) * decay, inverse * decay)
    returned = Channels(ratio * decay, (m - 1.0) / kolosov * (inverse - ratio) * decay, zero, inverse * decay)

    def conditions(d: tuple[Real, Real], weights: tuple[Real, Real]) -> tuple[Real, Real]:
        traction, displacement = weights
        return (
            traction * d[0] * inverse - side * displacement,
            traction * d[1] * inverse - side * displacement,
        )

    (ar_p, ar_m), (at_p, at_m) = conditions(d1, wall.radial), conditions(d1, wall.tangential)
    (br_p, br_m), (bt_p, bt_m) = conditions(d2, wall.radial), conditions(d2, wall.tangential)
    scale = 1.0 / (br_p * bt_m + br_m * bt_p)
    reflection = Channels(
        (bt_m * ar_p + br_m * at_p) * scale,
        (bt_m * ar_m - br_m * at_m) * scale,
        (bt_p * ar_p - br_p * at_p) * scale,
        (bt_p * ar_m + br_p * at_m) * scale,
    )
    answer = channel_product(reflection, passed)
    echo = channel_product(returned, answer)
    # D1 - D2 E, inverted
    pp, pm = d1[0] - d2[0] * echo.pp, -d2[0] * echo.pm
    mp, mm = -d2[1] * echo.mp, d1[1] - d2[1] * echo.mm
    inverse_determinant = side / (pp * mm - pm * mp)
    motion = Channels(
        mm * inverse_determinant,
        -pm * inverse_determinant,
        -mp * inverse_determinant,
        pp * inverse_determinant,
    )
    return ModeField(d1, d2, echo, motion, passed, Channels(*(-entry for entry in answer)))


def added_compliance(*, mode: Real, decay: Real, wall: Wall) -> ModeCompliance:
    r"""Contribution of the other rim to the compliance of a mode n >= 2 of a disc or of a hole in an infinite plate.

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
    change = channel_product(field.echo, field.motion)
    plus = field.second[0] / field.first[0] - 1.0
    minus = field.second[1] / field.first[1] - 1.0
    return components(
        Channels(plus * change.pp, plus * change.pm, minus * change.mp, minus * change.mm), wall.side
    )


def components(channels: Channels, side: Real) -> ModeCompliance:
    r"""From the channels plus and minus to radial and tangential components.

    .. math:: H^{rr} = \textstyle\sum H_{\pm\pm}, \qquad H^{rt} = s\,(H_{++} - H_{--})

    Parameters
    ----------
    channels : Channels
        Compliance on the channels, symmetric [-].
    side : Real
        +1, or -1 where the channels belong to minus the mode number [-].

    Returns
    -------
    ModeCompliance
        Compliance [-].

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    straight, crossed = channels.pp + channels.mm, 0.5 * (channels.pm + channels.mp)
    return ModeCompliance(
        xp.asarray(straight + 2.0 * crossed),
        xp.asarray(straight - 2.0 * crossed),
        xp.asarray(side * (channels.pp - channels.mm)),
    )
