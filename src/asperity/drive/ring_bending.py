"""Bending of an unsupported ring under its loading rollers by thin-ring theory, as an estimate."""

from __future__ import annotations

import math
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np

from asperity.drive.geometry import DriveGeometry, Triangle
from asperity.types import Real

_HARMONICS = 200


class ThinRingCompliance(NamedTuple):
    """Radial displacement of a free ring at a loading roller, over the normal force there.

    Parameters
    ----------
    alike : Real
        With equal forces under all loading rollers, as from the preload [m/N].
    opposed : Real
        With opposite forces under the two rollers of each planet, as from a change of torque [m/N].
    """

    alike: Real
    opposed: Real


def thin_ring_compliance(
    *,
    geometry: DriveGeometry,
    sides: Triangle,
    wall_thickness: Real,
    length: Real,
    youngs_modulus: Real,
) -> ThinRingCompliance:
    r"""Compliance of a free ring under its loading rollers, by bending and stretching.

    .. math::
        \frac{u_{alike}}N = \frac{2m}{\pi} \frac{R^3}{EI} \sum_{n = m, 2m, \dots} \frac{\cos^2 n\alpha}{(n^2-1)^2}
        + \frac{m}{\pi} \frac{R}{EA}, \qquad
        \frac{u_{opposed}}N = \frac{2m}{\pi} \frac{R^3}{EI} \sum_{n = m, 2m, \dots} \frac{\sin^2 n\alpha}{(n^2-1)^2}

    with :math:`R = R_o + h/2`, :math:`I = L h^3/12`, :math:`A = L h`.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive with m planets, at least two; the loading rollers of each stand at plus and minus alpha from it.
    sides : Triangle
        Its triangle of centres.
    wall_thickness : Real
        Wall h of the ring [m].
    length : Real
        Length L of the ring along its axis [m].
    youngs_modulus : Real
        Young's modulus E of the ring [Pa].

    Returns
    -------
    ThinRingCompliance
        Inverse of a ``ring_bending_stiffness`` for both load cases.

    Notes
    -----
    Thin ring without support, in equilibrium under its loads. For the paper's drive and walls from 4 to 60 mm the first
    value is within 8 % of the difference between an exact free annulus and the wall in a rigid housing.

    References
    ----------
    S. Timoshenko, Strength of Materials II, on the bending of circular rings; here by Fourier series of the loads.
    """
    count = geometry.planet_count
    radius = geometry.ring_radius + 0.5 * wall_thickness
    polar = jnp.arctan2(sides.sin_polar, sides.cos_polar)
    order = np.arange(1.0, _HARMONICS + 1.0).reshape((-1,) + (1,) * jnp.ndim(polar)) * count
    flexibility = 2.0 * count / math.pi * 12.0 * (radius / wall_thickness) ** 3 / (youngs_modulus * length)
    stretch = count / math.pi * radius / (youngs_modulus * length * wall_thickness)
    return ThinRingCompliance(
        alike=flexibility * jnp.sum((jnp.cos(order * polar) / (order**2 - 1.0)) ** 2, axis=0) + stretch,
        opposed=flexibility * jnp.sum((jnp.sin(order * polar) / (order**2 - 1.0)) ** 2, axis=0),
    )
