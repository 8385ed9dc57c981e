r"""Compliance between all contacts of one body, radial and tangential.

A contact of half-width :math:`a_i` loads the rim, and averages its displacement, with the weight of a punch
(:mod:`asperity.body.punch`). Between contacts at angles :math:`\varphi_i`, :math:`\varphi_j` with
:math:`\Delta = \varphi_i - \varphi_j`,

.. math::
    C^{rr}_{ij} = \frac{1}{\pi R L}\left[\tfrac12 H^{rr}_0 + \sum_{n\ge1} J_0\!\left(\frac{n a_i}R\right)
    J_0\!\left(\frac{n a_j}R\right) H^{rr}_n \cos n\Delta\right],

:math:`C^{tt}` likewise, and :math:`C^{tr}_{ij} = C^{rt}_{ji}` with :math:`H^{tr}_n \sin n\Delta`. The part of
:math:`H_n` that decreases like :math:`1/n` is summed in closed form (:mod:`asperity.body.rim_kernel`), the rest mode by
mode.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from asperity.body.annulus_modes import ModeCompliance, Wall, added_compliance, support_weights
from asperity.body.punch import LARGEST_PUNCH_ARGUMENT, distance_moments, punch_factor
from asperity.body.rigid_modes import translation_compliance, uniform_compliance
from asperity.body.rim_kernel import RimSums, self_sums, separated_sums
from asperity.body.shapes import Annulus, Disc, kolosov_constant
from asperity.engine.arrays import xp
from asperity.engine.control import scan
from asperity.materials import shear_modulus
from asperity.types import Array, Real

#: Largest permissible share of the omitted modes in a compliance; above it the result is nan.
TRUNCATION = 1e-8


class _Sums(NamedTuple):
    """Sums over the modes for pairs of contacts; in units of 1/(4 pi G L)."""

    radial: Array
    tangential: Array
    coupling: Array


def wall_of(body: Annulus) -> Wall:
    r"""The annulus in units of its loaded radius and its shear modulus.

    Parameters
    ----------
    body : Annulus
        The body.

    Returns
    -------
    Wall
        Input of the modes: the ratio of :math:`R` of the other rim to that of the loaded one, and the support.

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    inner = body.loaded_rim == "inner"
    radius, other = (
        (body.inner_radius, body.outer_radius) if inner else (body.outer_radius, body.inner_radius)
    )
    modulus = shear_modulus(youngs_modulus=body.youngs_modulus, poisson_ratio=body.poisson_ratio)
    radial, tangential = (
        support_weights(support_stiffness=stiffness, radius=radius, shear_modulus=modulus)
        for stiffness in (body.radial_support_stiffness, body.tangential_support_stiffness)
    )
    kolosov = kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=body.plane_state)
    return Wall(-1.0 if inner else 1.0, other / radius, kolosov, radial, tangential)


def loaded_radius(body: Disc | Annulus) -> Real:
    """Radius of the rim that carries the contacts, R in equation (E1).

    Parameters
    ----------
    body : Disc or Annulus
        The body.

    Returns
    -------
    Real
        Radius [m].

    References
    ----------
    Equation (E1) of :doc:`/equations`.
    """
    if isinstance(body, Disc):
        return body.radius
    return body.inner_radius if body.loaded_rim == "inner" else body.outer_radius


def modes_needed(*, inner_radius: float, outer_radius: float, copies: int) -> int:
    r"""Number of modes that an annulus of this wall needs, from :math:`n^2 (R_i/R_o)^{2n} < 10^{-10}`.

    Parameters
    ----------
    inner_radius, outer_radius : float
        Radii [m]; of a batch those with the thinnest wall.
    copies : int
        Number of equal sectors; only modes that are multiples of it are summed [-].

    Returns
    -------
    int
        Number of modes.

    References
    ----------
    Equation (E2) of :doc:`/equations`.
    """
    rate = 2.0 * math.log(outer_radius / inner_radius)
    mode = 2.0
    while mode * rate - 2.0 * math.log(mode) < 10.0 * math.log(10.0):
        mode += 1.0
    return math.ceil(mode / copies)


def _closed_part(side: float, kolosov: Real, angle: Array, normal: Array, shear: Array) -> _Sums:
    """Contribution of the disc (side +1) or of the hole in an infinite plate (side -1) for modes n >= 1.

    Angles have the shape (copies, n, n, ...), punch angles (n, ...).
    """
    diagonal = np.zeros(angle.shape[:3], bool)
    diagonal[0] = np.eye(angle.shape[1], dtype=bool)
    same = xp.asarray(diagonal).reshape(diagonal.shape + (1,) * (angle.ndim - 3))
    plus, minus = (kolosov, 1.0) if side > 0.0 else (1.0, kolosov)
    safe = xp.where(same, math.pi, angle)

    def straight(punch: Array) -> Array:
        sums = _separated(safe, punch, punch)
        self_plus, self_minus = self_sums(punch)
        itself = (plus * self_plus + minus * self_minus)[None, :, None]
        return xp.sum(xp.where(same, itself, plus * sums.cosine_plus + minus * sums.cosine_minus), axis=0)

    sums = _separated(safe, normal, shear)
    crossed = xp.where(same, 0.0, plus * sums.sine_plus - minus * sums.sine_minus)
    return _Sums(straight(normal), straight(shear), xp.sum(crossed, axis=0))


def _separated(angle: Array, punch_1: Array, punch_2: Array) -> RimSums:
    second, fourth = distance_moments(punch_1[None, :, None], punch_2[None, None, :])
    return separated_sums(angle=angle, second_moment=second, fourth_moment=fourth)


class _Modes(NamedTuple):
    """Sums over the modes so far, and the powers that the next mode needs."""

    sums: _Sums
    decay: Array
    cosine: Array
    sine: Array


def _added_part(wall: Wall, angle: Array, normal: Array, shear: Array, copies: int, mode_count: int) -> _Sums:
    """Contribution of the other rim, summed over the modes n >= 2 that are multiples of the number of copies."""
    first, step = float(max(copies, 2)), float(copies)
    rate = wall.ratio**wall.side
    cosine, sine = xp.cos(step * angle), xp.sin(step * angle)

    def one_more(modes: _Modes, mode: Array) -> tuple[_Modes, None]:
        added = added_compliance(mode=mode, decay=modes.decay, wall=wall)
        weight_n, weight_t = punch_factor(mode * normal), punch_factor(mode * shear)
        sums = _plus(modes.sums, added, weight_n, weight_t, modes.cosine, modes.sine)
        return _Modes(
            sums,
            modes.decay * rate**copies,
            modes.cosine * cosine - modes.sine * sine,
            modes.sine * cosine + modes.cosine * sine,
        ), None

    shape = xp.broadcast_shapes(angle.shape, normal[:, None].shape, xp.shape(rate), xp.shape(wall.kolosov))
    decay = xp.asarray(rate ** int(first))
    zero = xp.zeros(shape)
    start = _Modes(_Sums(zero, zero, zero), decay, xp.cos(first * angle), xp.sin(first * angle))
    (sums, *_), _ = scan(one_more, start, first + step * xp.arange(mode_count, dtype=float))
    # modes left out: the first of them times a geometric series, or those beyond the punch factor's range
    widest = xp.max(xp.maximum(normal, shear), axis=0)
    reach = xp.minimum(first + step * mode_count, LARGEST_PUNCH_ARGUMENT / widest)
    left_out = added_compliance(mode=reach, decay=rate**reach, wall=wall)
    size = xp.abs(left_out.radial) + xp.abs(left_out.tangential)
    converged = size < TRUNCATION * (1.0 - rate ** (2 * copies))
    return _Sums(*(xp.where(converged, part, xp.nan) for part in sums))


def _plus(
    sums: _Sums, mode: ModeCompliance, normal: Array, shear: Array, cosine: Array, sine: Array
) -> _Sums:
    """Sums with one more mode, weighted with the punch factors of the contacts."""
    return _Sums(
        sums.radial + mode.radial * cosine * (normal[:, None] * normal[None]),
        sums.tangential + mode.tangential * cosine * (shear[:, None] * shear[None]),
        sums.coupling + mode.coupling * sine * (normal[:, None] * shear[None]),
    )


def compliance_matrix(
    *,
    body: Disc | Annulus,
    contact_angles: Array,
    half_widths: Array,
    stick_half_widths: Array,
    copies: int,
    mode_count: int,
) -> Array:
    r"""Compliance between the contacts of one body, each rim displacement weighted like the load.

    .. math::
        \begin{pmatrix} u^r \\ u^t \end{pmatrix} =
        \begin{pmatrix} C^{rr} & C^{rt} \\ C^{tr} & C^{tt} \end{pmatrix}
        \begin{pmatrix} F^r \\ F^t \end{pmatrix}

    Parameters
    ----------
    body : Disc or Annulus
        The body.
    contact_angles : Array
        Polar angles of n contacts about the body's centre, counter-clockwise, shape (n, ...) [rad].
    half_widths : Array
        Half-widths of the contacts, which increments of normal force load, shape (n, ...) [m].
    stick_half_widths : Array
        Half-widths of their stick zones, which increments of tangential force load, shape (n, ...) [m].
    copies : int
        Number of equal sectors of the machine that load this body equally, 1 for none: the same loads repeat at
        angles turned by a full turn over this number [-].
    mode_count : int
        Modes to sum for an annulus, :func:`modes_needed`; a disc needs none [-].

    Returns
    -------
    Array
        Compliance, shape (2n, 2n, ...), first all radial, then all tangential components, outward and
        counter-clockwise positive for forces and displacements alike [m/N]. Symmetric. nan for an annulus with too
        few modes, or with contacts wider than about half its wall.

    Notes
    -----
    Plane elasticity, contacts narrow against radius and wall. The loads of an unsupported body must be balanced; its
    rigid motion is excluded, so that the result for unbalanced loads has no meaning.

    References
    ----------
    Equations (E1) and (E2) of :doc:`/equations`.
    """
    radius = loaded_radius(body)
    kolosov = kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=body.plane_state)
    modulus = shear_modulus(youngs_modulus=body.youngs_modulus, poisson_ratio=body.poisson_ratio)
    side = -1.0 if isinstance(body, Annulus) and body.loaded_rim == "inner" else 1.0
    normal, shear = half_widths / radius, stick_half_widths / radius
    angle = contact_angles[:, None] - contact_angles[None]
    turned = xp.stack([angle + copy * (2.0 * math.pi / copies) for copy in range(copies)])
    sums = _closed_part(side, kolosov, turned, normal, shear)
    if isinstance(body, Disc):
        uniform = 0.5 * copies * (kolosov - 1.0)
        sums = sums._replace(radial=sums.radial + uniform)
    else:
        wall = wall_of(body)
        uniform, twist = uniform_compliance(wall)
        sums = _Sums(
            sums.radial + 0.5 * copies * uniform, sums.tangential + 0.5 * copies * twist, sums.coupling
        )
        if copies == 1:
            weights = punch_factor(normal), punch_factor(shear)
            sums = _plus(sums, translation_compliance(wall), *weights, xp.cos(angle), xp.sin(angle))
        added = _added_part(wall, angle, normal, shear, copies, mode_count)
        sums = _Sums(*(total + copies * part for total, part in zip(sums, added, strict=True)))
    scale = 1.0 / (4.0 * math.pi * modulus * body.length)
    radial, tangential, coupling = (scale * part for part in xp.broadcast_arrays(*sums))
    return xp.concatenate(
        [
            xp.concatenate([radial, -coupling], axis=1),
            xp.concatenate([-xp.swapaxes(coupling, 0, 1), tangential], axis=1),
        ],
        axis=0,
    )
