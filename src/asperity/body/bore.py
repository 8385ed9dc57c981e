r"""Compliance and stress of a roller that a fitting pin presses in its bore.

The pin presses on half of the bore, with a pressure that follows the cosine from the direction of its force,

.. math::
    p = \frac{2F}{\pi R_i L} \max(\cos\varphi, 0), \qquad \max(\cos\varphi, 0) = \frac1\pi + \tfrac12 \cos\varphi
    + \frac2\pi \sum_{k\ge1} \frac{(-1)^{k+1}}{4k^2 - 1} \cos 2k\varphi .

Its displacement is the mean of that of the bore with the same weight. The modes n = 0 and n = 2k are those of an
annulus loaded on its inner rim (:mod:`asperity.body.annulus_modes`). In the mode n = 1 the force balances those of the
contacts on the outer rim. A force in the opposite direction presses on the other half: the mode n = 1 changes its sign
with it, the others do not.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.annulus_modes import Channels, ModeField, Wall, mode_field
from asperity.body.rigid_modes import uniform_field
from asperity.body.rim_stress import mode_stress
from asperity.body.shapes import Annulus, kolosov_constant
from asperity.materials import shear_modulus
from asperity.types import Real

#: Even modes that are summed; what is left out of the compliance falls as the fourth power of their number.
_PAIRS = 40


class BoreCompliance(NamedTuple):
    """Displacements under a unit force of the pin on the body.

    Parameters
    ----------
    push_compliance : Array
        Of the pin along its force [m/N].
    along : Array
        Of the contacts, first outward, then counter-clockwise, shape (2 contacts,) [m/N]: the part that changes its
        sign with the force.
    around : Array
        Of the contacts: the part that does not, since a force in the opposite direction presses the other half of the
        bore outward too, likewise [m/N].
    """

    push_compliance: Array
    along: Array
    around: Array


class _Translation(NamedTuple):
    """Airy's functions of the mode n = 1 under a force in the bore, balanced by P = -Q on the outer rim."""

    cubic: Array
    inverse: Array
    resultant: Array


def _even_modes() -> tuple[np.ndarray, np.ndarray]:
    """Numbers of the even modes, and their share in max(cos, 0)."""
    k = np.arange(1, _PAIRS + 1)
    return 2.0 * k, 2.0 / math.pi * (-1.0) ** (k + 1) / (4.0 * k**2 - 1.0)


def _pressed_inside(body: Annulus) -> Wall:
    """The annulus in units of its bore, its outer rim free."""
    kolosov = kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=body.plane_state)
    return Wall(-1.0, body.outer_radius / body.inner_radius, kolosov, (1.0, 0.0), (1.0, 0.0))


def _through(channels: Channels, first: Real, second: Real) -> tuple[Real, Real]:
    return channels.pp * first + channels.pm * second, channels.mp * first + channels.mm * second


def _fields(wall: Wall) -> tuple[ModeField, tuple[Real, Real]]:
    """Even modes under a unit radial traction on the bore: the field, and the motion of its first set there."""
    mode, _ = _even_modes()
    field = mode_field(mode=jnp.asarray(mode), decay=jnp.asarray(wall.ratio**-mode), wall=wall)
    return field, _through(field.motion, 1.0, 1.0)


def _translation(wall: Wall) -> _Translation:
    r"""Coefficients under a traction :math:`\cos\varphi` on the bore, in units of its radius."""
    ratio, kolosov = jnp.asarray(wall.ratio), wall.kolosov
    c = -0.5 / (kolosov + 1.0) * jnp.ones_like(ratio)
    b = (0.25 + c * (1.0 - ratio**2)) / (ratio**4 - 1.0)
    return _Translation(b, b + c + 0.25, c)


def bore_compliance(*, body: Annulus, contact_angles: Array, push_angle: Real) -> BoreCompliance:
    r"""Compliance of a hollow roller between the pin in its bore and the contacts on its outer rim.

    .. math:: u_p = c\,F + \sum_j (a_j \pm r_j) f_j, \qquad u_j = \sum_k C_{jk} f_k + a_j F + r_j |F|

    with the force F of the pin and those of the contacts, f, on the body, and the sign of F.

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
    BoreCompliance
        c, a and r [m/N]. The contacts are points: a half-width b changes their mode n by the share :math:`(nb/2R)^2`.

    Notes
    -----
    Pin and contacts together are in balance; the translation of the body is left out, as in
    :func:`~asperity.body.compliance.compliance_matrix`. The stiffness of the pin is not counted.

    References
    ----------
    Airy's functions by J. H. Michell, Proc. London Math. Soc. 31 (1899) 100, as in J. R. Barber, Elasticity, 2010,
    tables 8.1 and 9.1; the cosine pressure of a fitting pin as in S. P. Timoshenko and J. N. Goodier, Theory of
    Elasticity, 1970, section 45. Equation (E5) of :doc:`/equations`.
    """
    wall, away = _pressed_inside(body), contact_angles - push_angle
    ratio, kolosov = wall.ratio, wall.kolosov
    mode, share = _even_modes()
    field, first = _fields(wall)
    echo, passed, back = (_through(part, *first) for part in (field.echo, field.passed, field.answer))
    at_bore = 0.5 * (first[0] - echo[0] + first[1] - echo[1])
    plus, minus = passed[0] + back[0], passed[1] + back[1]
    outward, sideways = 0.5 * (plus + minus), 0.5 * wall.side * (plus - minus)
    even, odd = uniform_field(wall)
    swells = -(0.5 * (kolosov - 1.0) * even - odd)
    swells_outside = -(0.5 * (kolosov - 1.0) * even * ratio - odd / ratio)
    b, e, c = _translation(wall)
    log = jnp.log(ratio)
    # displacement of the bore minus that of the outer rim, both in their direction, under the unit traction
    translation = ((kolosov - 2.0) * b + e - c) - (-2.0 * b * ratio**2 + 2.0 * kolosov * c * log)
    outer = kolosov * b * ratio**2 + e / ratio**2 - c

    modulus = shear_modulus(youngs_modulus=body.youngs_modulus, poisson_ratio=body.poisson_ratio)
    scale = 2.0 / (math.pi * 2.0 * modulus * body.length)  # a pressure of 2F/(pi R L) times R/2G
    compliance = 2.0 * swells / math.pi**2 + 0.25 * translation + jnp.sum(share**2 * at_bore)
    turns = mode * away[:, None]
    return BoreCompliance(
        push_compliance=scale * 2.0 * compliance,
        along=0.5 * scale * outer * jnp.concatenate([jnp.cos(away), jnp.sin(away)]),
        around=scale
        * jnp.concatenate(
            [
                swells_outside / math.pi + jnp.cos(turns) @ (share * outward),
                jnp.sin(turns) @ (share * sideways),
            ]
        ),
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


def pin_stress(*, body: Annulus, force: Array, away: Array) -> PinStress:
    r"""Stresses along both rims of a hollow roller under the force of a fitting pin in its bore.

    .. math:: \sigma_\theta = \frac{2F}{\pi R_i L}\left[\frac{h_0}\pi + \tfrac12 h_1 \cos\varphi
        + \frac2\pi \sum_{k\ge1} \frac{(-1)^{k+1}}{4k^2-1} h_{2k} \cos 2k\varphi\right]

    Parameters
    ----------
    body : Annulus
        The roller.
    force : Array
        Size of the pin's force F [N].
    away : Array
        Angles from its direction on the body, shape (points, ...) [rad].

    Returns
    -------
    PinStress
        In addition to :func:`~asperity.body.rim_range.rim_stresses` under the contact forces that it balances.

    References
    ----------
    As :func:`bore_compliance`.
    """
    wall = _pressed_inside(body)
    ratio = wall.ratio
    mode, share = _even_modes()
    field, _ = _fields(wall)
    stress = mode_stress(wall, field, 1.0, 1.0)
    even, odd = uniform_field(wall)
    b, e, c = _translation(wall)
    inner, outer = (6.0 * b * r + 2.0 * e / r**3 - (wall.kolosov - 1.0) * c / r for r in (1.0, ratio))
    waves = jnp.cos(away[..., None] * mode)
    first, pressed = 0.5 * jnp.cos(away), jnp.maximum(jnp.cos(away), 0.0)
    pressure = 2.0 * force / (math.pi * body.inner_radius * body.length)
    bore = (
        -(even - odd) / math.pi
        + inner * first
        - (pressed - 1.0 / math.pi - first)
        + waves @ (share * stress.loaded_rim)
    )
    rim = -(even - odd / ratio**2) / math.pi + outer * first + waves @ (share * stress.other_rim)
    return PinStress(pressure * bore, -pressure * pressed, pressure * rim)
