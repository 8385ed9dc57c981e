r"""A drive whose branches differ in size: interference of each, and what their forces do to the sun.

A branch is a planet with its two loading rollers. Sun, ring and carrier are common: ring and carrier are centred, the
sun moves by :math:`u` in its bearings. Towards a planet it counts like a larger sun; across it turns the contact as a
rotation :math:`u \cdot t/R_s` of the sun would.
"""

from __future__ import annotations

import numpy as np
from jax import Array

from asperity.drive.interference import interference_of_sizes
from asperity.drive.mechanism import RestState
from asperity.types import Real


def branch_directions(planet_count: int) -> tuple[np.ndarray, np.ndarray]:
    r"""Directions of the planets of a drive, and those in which the sun pushes them.

    .. math::
        e_b = (\cos\phi_b, \sin\phi_b), \quad t_b = (\sin\phi_b, -\cos\phi_b), \quad \phi_b = \frac{2\pi (b-1)}{n}

    Parameters
    ----------
    planet_count : int
        Number n of planets [-].

    Returns
    -------
    radial, tangential : ndarray
        Unit vectors from the sun to each planet, and of the sun's tangential force on it under a positive torque, shape
        (n, 2) [-].

    References
    ----------
    Equation (I4) of :doc:`/equations`; equation (2) of Zou et al. 2025 has the planet above the sun, and its
    tangential force to the right.
    """
    angle = 2.0 * np.pi * np.arange(planet_count) / planet_count
    radial = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    return radial, np.stack([radial[:, 1], -radial[:, 0]], axis=1)


def added_interference(
    *, rest: RestState, approach: Real, planet: Real, right_roller: Real, left_roller: Real
) -> Array:
    r"""Interference that a branch has more than the nominal one.

    .. math::
        (N_{wro} + N_{wlo})\,\Delta\delta_b = N_{sp}\, u \cdot e_b + (N_{sp} + N_{pwr} + N_{pwl})\,\varepsilon_p
        + (N_{pwr} + N_{wro})\,\varepsilon_{wr} + (N_{pwl} + N_{wlo})\,\varepsilon_{wl}

    Parameters
    ----------
    rest : RestState
        Forces at rest; only their ratios matter [N].
    approach : Real
        Displacement of the sun towards the planet, u · e [m].
    planet, right_roller, left_roller : Real
        Deviations of their radii, larger positive [m].

    Returns
    -------
    Array
        Interference [m].

    References
    ----------
    Equations (I1) and (I4) of :doc:`/equations`.
    """
    return interference_of_sizes(
        rest=rest, sun=approach, planet=planet, right_roller=right_roller, left_roller=left_roller, ring=0.0
    )


def force_on_sun(*, normal: np.ndarray, tangential: np.ndarray) -> np.ndarray:
    r"""Force of the planets on the sun.

    .. math:: F = -\sum_b \left(N_{sp,b}\, e_b + T_{sp,b}\, t_b\right)

    Parameters
    ----------
    normal, tangential : ndarray
        Forces of the sun's contacts, branches last, shape (..., n) [N].

    Returns
    -------
    ndarray
        Shape (..., 2) [N]; zero for equal branches.

    References
    ----------
    Equation (I4) of :doc:`/equations`.
    """
    radial, along = branch_directions(normal.shape[-1])
    return np.asarray(-(normal @ radial + tangential @ along))


def roller_directions(planet_count: int, polar: float) -> tuple[np.ndarray, np.ndarray]:
    r"""Directions of the loading rollers of a drive, the right one of each planet clockwise of it.

    .. math::
        e_{b,s} = (\cos\psi, \sin\psi), \quad t_{b,s} = (-\sin\psi, \cos\psi), \quad \psi = \phi_b \mp \alpha

    Parameters
    ----------
    planet_count : int
        Number of planets [-].
    polar : float
        Angle :math:`\alpha` between a planet and its loading rollers, seen from the axis [rad].

    Returns
    -------
    radial, tangential : ndarray
        Unit vectors away from the axis, and counter-clockwise along the carrier's circle, shape (2, n, 2): right and
        left, planets, components [-].

    References
    ----------
    Equation (2) of Zou et al. 2025 has the planet above the sun, and its right roller on its right.
    """
    angle = 2.0 * np.pi * np.arange(planet_count) / planet_count + polar * np.array([[-1.0], [1.0]])
    radial = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    return radial, np.stack([-radial[..., 1], radial[..., 0]], axis=-1)


def force_on_carrier(*, radial: np.ndarray, tangential: np.ndarray, polar: float) -> np.ndarray:
    r"""Force of the loading rollers on the carrier.

    .. math:: F = \sum_{b,s} \left(F_{r,b,s}\, e_{b,s} + F_{t,b,s}\, t_{b,s}\right)

    Parameters
    ----------
    radial, tangential : ndarray
        Forces on the pins away from the axis and counter-clockwise, right and left, shape (2, n) [N].
    polar : float
        Angle between a planet and its loading rollers, seen from the axis [rad].

    Returns
    -------
    ndarray
        Shape (2,) [N]; zero for equal branches.

    References
    ----------
    Balance of the carrier; equations (I4) and (L1) of :doc:`/equations`.
    """
    outward, along = roller_directions(radial.shape[-1], polar)
    return np.asarray(np.einsum("sb,sbx->x", radial, outward) + np.einsum("sb,sbx->x", tangential, along))


def force_on_ring(*, normal: np.ndarray, tangential: np.ndarray, polar: float) -> np.ndarray:
    r"""Force of the loading rollers on the ring.

    .. math:: F = \sum_{b,s} \left(N_{b,s}\, e_{b,s} - T_{b,s}\, t_{b,s}\right)

    Parameters
    ----------
    normal, tangential : ndarray
        Forces of the ring's contacts, right and left, shape (2, n) [N].
    polar : float
        Angle between a planet and its loading rollers, seen from the axis [rad].

    Returns
    -------
    ndarray
        Shape (2,) [N]; zero for equal branches.

    References
    ----------
    Balance of the ring; equation (I4) of :doc:`/equations`.
    """
    outward, along = roller_directions(normal.shape[-1], polar)
    return np.asarray(np.einsum("sb,sbx->x", normal, outward) - np.einsum("sb,sbx->x", tangential, along))
