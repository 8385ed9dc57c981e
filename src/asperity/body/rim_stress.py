r"""Hoop stress of an annulus of any wall thickness at both rims, away from the contacts.

The stress at a rim follows from the same fields as the displacement (:mod:`asperity.body.annulus_modes`), since on
every circle :math:`\sigma_r + \sigma_\theta` is twice the stress :math:`\sigma_+` of the set that decays from the
loaded rim plus twice :math:`\sigma_-` of the other. On the loaded rim a radial point load causes no singular hoop
stress near it, a tangential one :math:`2F/(\pi L d)` at the distance d; these parts are summed in closed form.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
from jax import Array

from asperity.body.annulus_modes import ModeField, Wall, mode_field
from asperity.body.compliance import loaded_radius, wall_of
from asperity.body.rigid_modes import translation_field, uniform_field
from asperity.body.shapes import Annulus
from asperity.types import Real


class HoopStress(NamedTuple):
    """Hoop stress at the two rims.

    Parameters
    ----------
    loaded_rim, other_rim : Array
        Tension positive [Pa].
    """

    loaded_rim: Array
    other_rim: Array


def mode_stress(wall: Wall, field: ModeField, plus: Real, minus: Real) -> HoopStress:
    """Hoop stress of modes n >= 2 beyond the closed part, for tractions in the channels of the field.

    Parameters
    ----------
    wall : Wall
        The annulus.
    field : ModeField
        Its fields, of :func:`asperity.body.annulus_modes.mode_field`.
    plus, minus : Real
        Tractions on the loaded rim in the two channels [-].

    Returns
    -------
    HoopStress
        At both rims; at the loaded one without the traction itself, which the disc or the hole has.

    References
    ----------
    Equation (E4) of :doc:`/equations`.
    """
    (d1_p, d1_m), (d2_p, d2_m) = field.first, field.second
    x_p = field.motion.pp * plus + field.motion.pm * minus
    x_m = field.motion.mp * plus + field.motion.mm * minus
    echo_p = field.echo.pp * x_p + field.echo.pm * x_m
    echo_m = field.echo.mp * x_p + field.echo.mm * x_m
    # d1 x+ = side t+ + d2 (E x)+, of which the first term is the closed part
    loaded = 2.0 * (d2_p * echo_p - d2_m * echo_m)
    far_p = d1_p * (field.passed.pp * x_p + field.passed.pm * x_m)
    far_m = d1_m * (field.passed.mp * x_p + field.passed.mm * x_m)
    back_p = d2_p * (field.answer.pp * x_p + field.answer.pm * x_m)
    back_m = d2_m * (field.answer.mp * x_p + field.answer.mm * x_m)
    other = (2.0 * (far_p + back_m) - 0.5 * (far_p + far_m + back_p + back_m)) / wall.ratio
    return HoopStress(jnp.asarray(loaded), jnp.asarray(other))


def _translation_stress(wall: Wall, plus: float, minus: float) -> HoopStress:
    """Hoop stress of the mode n = 1."""
    b, e, c, _ = translation_field(wall=wall, plus=plus, minus=minus)
    return HoopStress(
        *(6.0 * b * r + 2.0 * e / r**3 - (wall.kolosov - 1.0) * c / r for r in (1.0, wall.ratio))
    )


def hoop_stress(
    *,
    body: Annulus,
    contact_angles: Array,
    radial_forces: Array,
    tangential_forces: Array,
    angle: Array,
    mode_count: int,
) -> HoopStress:
    r"""Hoop stress at both rims under point forces on the loaded rim.

    .. math::
        \sigma_\theta = \frac{1}{\pi R L} \sum_j \left[ F^r_j \left(\tfrac12 h^r_0 + \sum_{n\ge1} h^r_n
        \cos n(\theta - \varphi_j)\right) - F^t_j \sum_{n\ge1} h^t_n \sin n(\theta - \varphi_j) \right]

    Parameters
    ----------
    body : Annulus
        The body.
    contact_angles : Array
        Polar angles of all n contacts, shape (n,) [rad].
    radial_forces, tangential_forces : Array
        Forces on the body, outward and counter-clockwise, shape (n,) [N].
    angle : Array
        Polar angles of the points, shape (m,) [rad].
    mode_count : int
        Modes to sum, n^2 (R_i/R_o)^n of the last one is what the far rim misses [-].

    Returns
    -------
    HoopStress
        At both rims, shape (m,) [Pa].

    Notes
    -----
    Valid on the loaded rim a few half-widths away from the contacts, on the other rim everywhere. One body; use
    ``jax.vmap`` for many. Unbalanced forces are treated as in
    :func:`~asperity.body.compliance.compliance_matrix`.

    References
    ----------
    Equation (E4) of :doc:`/equations`.
    """
    wall, side = wall_of(body), 1.0 if body.loaded_rim == "outer" else -1.0
    modes = jnp.arange(2, mode_count + 2, dtype=float)
    field = mode_field(mode=modes, decay=(wall.ratio**side) ** modes, wall=wall)
    radial = mode_stress(wall, field, 1.0, 1.0)
    shear = mode_stress(wall, field, side, -side)
    radial_1 = _translation_stress(wall, 1.0, 1.0)
    shear_1 = _translation_stress(wall, 1.0, -1.0)
    even, odd = uniform_field(wall)

    away = angle[:, None] - contact_angles[None]
    cosine = jnp.cos(modes * away[..., None])
    sine = jnp.sin(modes * away[..., None])
    # sums of cos and sin from n = 2, near a point load
    cosines = -0.5 - jnp.cos(away)
    half = 0.5 * away
    at_contact = jnp.abs(jnp.sin(half)) < 1e-12
    cotangent = jnp.where(at_contact, 0.0, jnp.cos(half) / jnp.where(at_contact, 1.0, jnp.sin(half)))
    sines = 0.5 * cotangent - jnp.sin(away)
    loaded_r = (
        0.5 * side * (even - odd)
        + radial_1.loaded_rim * jnp.cos(away)
        + side * cosines
        + cosine @ radial.loaded_rim
    )
    loaded_t = shear_1.loaded_rim * jnp.sin(away) + 2.0 * sines + sine @ shear.loaded_rim
    other_r = (
        0.5 * side * (even - odd / wall.ratio**2)
        + radial_1.other_rim * jnp.cos(away)
        + cosine @ radial.other_rim
    )
    other_t = shear_1.other_rim * jnp.sin(away) + sine @ shear.other_rim
    scale = 1.0 / (math.pi * loaded_radius(body) * body.length)
    return HoopStress(
        scale * (loaded_r @ radial_forces - loaded_t @ tangential_forces),
        scale * (other_r @ radial_forces - other_t @ tangential_forces),
    )
