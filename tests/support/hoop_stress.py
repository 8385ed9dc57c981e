"""Hoop stress of an annulus by the sum over its modes of all forces at once: the other route to equation (E4)."""

import math

import jax.numpy as jnp
from jax import Array

from asperity.body.annulus_modes import Wall, mode_field
from asperity.body.compliance import loaded_radius, wall_of
from asperity.body.rigid_modes import translation_field, uniform_field
from asperity.body.rim_stress import HoopStress, mode_stress
from asperity.body.shapes import Annulus


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
    r"""Hoop stress at both rims, shape (m,) [Pa], under point forces on the loaded rim.

    .. math::
        \sigma_\theta = \frac{1}{\pi R L} \sum_j \left[ F^r_j \left(\tfrac12 h^r_0 + \sum_{n\ge1} h^r_n
        \cos n(\theta - \varphi_j)\right) - F^t_j \sum_{n\ge1} h^t_n \sin n(\theta - \varphi_j) \right]

    Contacts at polar angles of shape (n,) [rad], forces on the body outward and counter-clockwise [N], points at
    angles of shape (m,) [rad]; valid on the loaded rim a few half-widths away from the contacts, on the other
    rim everywhere. Unbalanced forces are treated as in :func:`asperity.body.compliance.compliance_matrix`.
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
