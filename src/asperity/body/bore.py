r"""Compliance and stress of a roller that a pin presses in its bore.

The pin presses with the pressure of :mod:`asperity.body.conforming_pin` around the direction of its force F,

.. math:: p = \frac{F}{\pi R_i L} \left[\tfrac12 w_0 + \cos\varphi + \sum_{n\ge2} w_n \cos n\varphi\right] .

Its displacement is the mean of that of the bore with the same weight. The modes n = 0 and n >= 2 are those of an
annulus loaded on its inner rim (:mod:`asperity.body.annulus_modes`). In the mode n = 1 the force balances those of the
contacts on the outer rim. A force in the opposite direction presses on the other side: the odd modes change their sign
with it, the even ones do not.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from asperity.body.annulus_modes import Channels, ModeField, Wall, added_compliance, mode_field
from asperity.body.conforming_pin import SHARED, conforming_pressure, pressure_shares
from asperity.body.rigid_modes import uniform_field
from asperity.body.rim_stress import mode_stress
from asperity.body.shapes import Annulus, kolosov_constant
from asperity.engine.arrays import xp
from asperity.materials import shear_modulus
from asperity.types import Array, Real

#: Modes whose fields are those of an annulus without a resultant force.
_MODES = SHARED[1:].astype(float)


class BoreModes(NamedTuple):
    """What a hollow roller does under each mode of the pressure of its pin.

    Parameters
    ----------
    along : Array
        Displacement of the contacts under a unit force of the pin by the first mode, first outward, then
        counter-clockwise, shape (2 contacts,) [m/N].
    rim : Array
        The same by the modes :data:`asperity.body.conforming_pin.SHARED`, for shares of 1, shape (2 contacts, modes)
        [m/N].
    shift : Array
        Displacement of the pin along its force by the first mode, the pin's own flattening included [m/N].
    scale : Array
        :math:`1/(E'L)` [m/N].
    wall : Array
        What the wall adds to the compliance of a large plate under the squares of the shares, over the scale, shape
        (modes,) [-].
    """

    along: Array
    rim: Array
    shift: Array
    scale: Array
    wall: Array


class _Translation(NamedTuple):
    """Airy's functions of the mode n = 1 under a force in the bore, balanced by P = -Q on the outer rim."""

    cubic: Array
    inverse: Array
    resultant: Array


def _pressed_inside(body: Annulus) -> Wall:
    """The annulus in units of its bore, its outer rim free."""
    kolosov = kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=body.plane_state)
    return Wall(-1.0, body.outer_radius / body.inner_radius, kolosov, (1.0, 0.0), (1.0, 0.0))


def _through(channels: Channels, first: Real, second: Real) -> tuple[Real, Real]:
    return channels.pp * first + channels.pm * second, channels.mp * first + channels.mm * second


def _field(wall: Wall) -> ModeField:
    """Modes n >= 2 under tractions on the bore."""
    return mode_field(mode=xp.asarray(_MODES), decay=xp.asarray(wall.ratio**-_MODES), wall=wall)


def _translation(wall: Wall) -> _Translation:
    r"""Coefficients under a traction :math:`\cos\varphi` on the bore, in units of its radius."""
    ratio, kolosov = xp.asarray(wall.ratio), wall.kolosov
    c = -0.5 / (kolosov + 1.0) * xp.ones_like(ratio)
    b = (0.25 + c * (1.0 - ratio**2)) / (ratio**4 - 1.0)
    return _Translation(b, b + c + 0.25, c)


def bore_modes(*, body: Annulus, contact_angles: Array, push_angle: Real) -> BoreModes:
    r"""A hollow roller between the pin in its bore and the contacts on its outer rim, mode by mode.

    .. math:: u_p = F \left[C_1 + \frac{\hat C + \sum_n h_n w_n^2}{E'L}\right] + \sum_j f_j\,
        (a_j + \textstyle\sum_n w_n r_{jn}), \qquad
        u_j = \sum_k C_{jk} f_k + F\,(a_j + \textstyle\sum_n w_n r_{jn})

    with the force F > 0 of the pin and those of the contacts, f, on the body. Where F < 0, the odd modes change their
    signs with it.

    Parameters
    ----------
    body : Annulus
        The roller, its bore free otherwise.
    contact_angles : Array
        Polar angles of its contacts, shape (n,) [rad].
    push_angle : Real
        Polar angle of a positive force of the pin on the body [rad].

    Returns
    -------
    BoreModes
        a, r and C_1 [m/N], h [-]. The contacts are points: a half-width b changes their mode n by the share
        :math:`(nb/2R)^2`.

    Notes
    -----
    Pin and contacts together are in balance; the translation of the body is left out, as in
    :func:`~asperity.body.compliance.compliance_matrix`. The pin is a cylinder of the roller's material that fills the
    bore but for its clearance, its force spread evenly over its section: it flattens as a disc, in the first mode by
    :math:`(\kappa - 1) F/(8 \pi G L)`.

    References
    ----------
    Airy's functions by J. H. Michell, Proc. London Math. Soc. 31 (1899) 100, as in J. R. Barber, Elasticity, 2010,
    tables 8.1 and 9.1. Equations (E5) and (E7) of :doc:`/equations`.
    """
    wall, away = _pressed_inside(body), contact_angles - push_angle
    ratio, kolosov = wall.ratio, wall.kolosov
    field = _field(wall)
    first = _through(field.motion, 1.0, 1.0)
    passed, back = (_through(part, *first) for part in (field.passed, field.answer))
    plus, minus = passed[0] + back[0], passed[1] + back[1]
    outward, sideways = 0.5 * (plus + minus), 0.5 * wall.side * (plus - minus)
    even, odd = uniform_field(wall)
    swells = -(0.5 * (kolosov - 1.0) * even - odd)
    swells_outside = -(0.5 * (kolosov - 1.0) * even * ratio - odd / ratio)
    b, e, c = _translation(wall)
    # displacement of the bore minus that of the outer rim, both in their direction, under the unit traction
    translation = (kolosov - 2.0) * b + e - c - (-2.0 * b * ratio**2 + 2.0 * kolosov * c * xp.log(ratio))
    outer = kolosov * b * ratio**2 + e / ratio**2 - c
    added = added_compliance(mode=xp.asarray(_MODES), decay=xp.asarray(ratio**-_MODES), wall=wall)

    modulus = shear_modulus(youngs_modulus=body.youngs_modulus, poisson_ratio=body.poisson_ratio)
    unit = 1.0 / (2.0 * math.pi * modulus * body.length)  # a traction of F/(pi R L) times R/2G
    cosine, sine = xp.cos(away), xp.sin(away)
    turns = _MODES * away[:, None]
    uniform = xp.broadcast_to(0.5 * swells_outside, away.shape)
    normal = xp.concatenate([uniform[:, None], xp.cos(turns) * outward], axis=1)
    tangential = xp.concatenate([xp.zeros_like(away)[:, None], xp.sin(turns) * sideways], axis=1)
    walls = xp.concatenate([xp.asarray(swells - 1.0)[None], xp.asarray(added.radial)])
    return BoreModes(
        along=unit * outer * xp.concatenate([cosine, sine]),
        rim=unit * xp.concatenate([normal, tangential]),
        shift=unit * (translation + 0.25 * (kolosov - 1.0)),
        scale=xp.asarray((kolosov + 1.0) / (8.0 * modulus * body.length)),
        wall=2.0 / (math.pi * (kolosov + 1.0)) * walls,
    )


class PinStress(NamedTuple):
    """Stresses under a pin's force, tension positive [Pa].

    Parameters
    ----------
    bore_hoop, bore_radial : Array
        Of the bore.
    rim_hoop : Array
        Hoop stress of the outer rim.
    """

    bore_hoop: Array
    bore_radial: Array
    rim_hoop: Array


def pin_stress(*, body: Annulus, force: Array, arc: Array, away: Array) -> PinStress:
    r"""Stresses along both rims of a hollow roller under the force of the pin in its bore.

    .. math:: \sigma_\theta = \frac{F}{\pi R_i L}\left[\tfrac12 h_0 w_0 + h_1 \cos\varphi
        + \sum_{n\ge2} h_n w_n \cos n\varphi\right]

    Parameters
    ----------
    body : Annulus
        The roller.
    force : Array
        Size of the pin's force F [N].
    arc : Array
        Its arc of contact, u of :func:`asperity.body.conforming_pin.conforming_pressure` [-].
    away : Array
        Angles from its direction on the body, shape (points, ...) [rad].

    Returns
    -------
    PinStress
        In addition to :func:`~asperity.body.rim_range.rim_stresses` under the contact forces that it balances.

    References
    ----------
    As :func:`bore_modes`.
    """
    wall = _pressed_inside(body)
    ratio, shares = wall.ratio, pressure_shares(arc=arc)
    stress = mode_stress(wall, _field(wall), 1.0, 1.0)
    even, odd = uniform_field(wall)
    b, e, c = _translation(wall)
    inner, outer = (6.0 * b * r + 2.0 * e / r**3 - (wall.kolosov - 1.0) * c / r for r in (1.0, ratio))
    waves = xp.cos(away[..., None] * _MODES)
    uniform, first = 0.5 * shares[0], xp.cos(away)
    local = math.pi * conforming_pressure(angle=away, arc=arc)
    pressure = force / (math.pi * body.inner_radius * body.length)
    bore = (
        -(even - odd) * uniform
        + inner * first
        - (local - uniform - first)
        + waves @ (shares[1:] * stress.loaded_rim)
    )
    rim = -(even - odd / ratio**2) * uniform + outer * first + waves @ (shares[1:] * stress.other_rim)
    return PinStress(pressure * bore, -pressure * local, pressure * rim)
