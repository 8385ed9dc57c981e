r"""Torsional stiffness with floating bodies (A8): planet and loading rollers free to move in the plane.

The published series (25) moves every roller about a fixed centre. In the machine only the sun's centre is held
(by symmetry); a tangential force on the planet pushes it sideways against the *normal* springs of its wedge.

One branch has the coordinates (arc lengths for rotations, so that all are lengths)
:math:`q = (R_s\psi_s;\; x_p, y_p, R_p\psi_p;\; x_r, y_r, R_w\psi_r;\; x_l, y_l, R_w\psi_l)`. Each spring
has an elongation :math:`e_j(q)` whose gradient is taken by automatic differentiation, and a compliance
:math:`c_j`; a rigid spring has :math:`c_j = 0` exactly. Forces and motions follow from

.. math::
    B q - C f = 0, \qquad B^\mathsf{T} f = g, \qquad B_{jk} = \partial e_j/\partial q_k

under a unit torque on the sun, and the shares :math:`c_j f_j^2` of the springs add up to the compliance.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.geometry import CONTACT_NAMES, DriveGeometry, Triangle, speed_ratio, triangle
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.types import Real

#: Relative to the stiffest spring: stiffness that holds a lifted roller, compliance that shares the load among
#: redundant rigid springs. Without it such systems are singular; with it they are wrong in the thirteenth digit.
_REGULARISATION = 1e-13


class Supports(eqx.Module):
    """Springs of the structure around the rollers; ``math.inf`` is rigid, 0 is absent. SI units.

    Parameters
    ----------
    pin_stiffness : Real
        Of one carrier pin along the carrier's push on its loading roller [N/m].
    pin_transverse_stiffness : Real
        Of one carrier pin across the push [N/m]; 0 where the roller is free to move radially.
    planet_support_stiffness : Real
        Of a planet's bearing on the carrier, in both directions of the plane [N/m]; 0 for a floating planet.
    ring_bending_stiffness : Real
        Of the outer ring as a whole under one loading roller's normal force [N/m].
    input_shaft_stiffness, output_shaft_stiffness : Real
        Torsional stiffness of the shafts [N·m/rad].

    Notes
    -----
    The radial stiffness of the sun's bearing is not among them: under a torque the branches hold the sun's centre
    in balance, so that it carries nothing.
    """

    pin_stiffness: Real
    pin_transverse_stiffness: Real
    planet_support_stiffness: Real
    ring_bending_stiffness: Real
    input_shaft_stiffness: Real
    output_shaft_stiffness: Real


#: Rigid pins along the push, free across it, floating planet, stiff ring and shafts.
RIGID_SUPPORTS = Supports(math.inf, 0.0, 0.0, math.inf, math.inf, math.inf)


class Assembly(eqx.Module):
    """Stiffness of the assembled drive and where its compliance comes from.

    Parameters
    ----------
    stiffness : TorsionalStiffness
        At the sun and at the output [N·m/rad]; 0 where the drive passes no torque.
    tangential_share : Array
        Share of each contact's tangential spring in the compliance, shape (5, ...) [-].
    normal_share : Array
        Share of each contact's normal spring: the float of the planet in its wedge, shape (5, ...) [-].
    ring_bending_share, pin_share, planet_support_share, input_shaft_share, output_shaft_share : Array
        Shares of the structure [-]. All shares add up to 1.
    """

    stiffness: TorsionalStiffness
    tangential_share: Array
    normal_share: Array
    ring_bending_share: Array
    pin_share: Array
    planet_support_share: Array
    input_shaft_share: Array
    output_shaft_share: Array


class _Body(NamedTuple):
    x: Array
    y: Array
    turn: Array  # rotation times radius: arc length


def _elongations(coordinates: Array, side: Triangle, geometry: DriveGeometry) -> Array:
    """Elongations of the 18 springs: 5 normal, 5 tangential, 4 pin, 2 planet support, 2 ring; compression positive."""
    sun = _Body(jnp.zeros_like(coordinates[0]), jnp.zeros_like(coordinates[0]), coordinates[0])
    planet, right, left = (_Body(*coordinates[k : k + 3]) for k in (1, 4, 7))
    ring = _Body(*jnp.zeros_like(coordinates[:3]))

    def contact(
        first: _Body, second: _Body, along_x: Real, along_y: Real, outer: float
    ) -> tuple[Array, Array]:
        """Approach and slip of two bodies; (along_x, along_y) points from the first centre to the contact."""
        approach = (first.x - second.x) * along_x + (first.y - second.y) * along_y
        slip = (
            (first.y - second.y) * along_x - (first.x - second.x) * along_y + first.turn + outer * second.turn
        )
        return approach, slip

    sin_a, cos_a = side.sin_polar, side.cos_polar
    sin_t, cos_t = side.sin_direction, side.cos_direction
    springs = (
        contact(sun, planet, 0.0, 1.0, 1.0),
        contact(planet, right, sin_t, cos_t, 1.0),
        contact(planet, left, -sin_t, cos_t, 1.0),
        contact(right, ring, sin_a, cos_a, -1.0),
        contact(left, ring, -sin_a, cos_a, -1.0),
    )
    pins = []
    for body, hand, push in ((right, 1.0, geometry.right_push_angle), (left, -1.0, geometry.left_push_angle)):
        tangent = body.x * cos_a - hand * body.y * sin_a
        radial = hand * body.x * sin_a + body.y * cos_a
        inward = -hand * tangent  # the carrier pushes the rollers of a branch towards each other's mate
        pins += [
            inward * jnp.cos(push) + radial * jnp.sin(push),
            radial * jnp.cos(push) - inward * jnp.sin(push),
        ]
    normal = [spring[0] for spring in springs]
    tangential = [spring[1] for spring in springs]
    return jnp.stack(jnp.broadcast_arrays(*normal, *tangential, *pins, planet.x, planet.y))


def _compliance(stiffness: Real) -> Array:
    """1/k with 1/inf = 0 and 1/0 = inf, and finite derivatives at both."""
    value = jnp.asarray(stiffness)
    finite = (value > 0.0) & jnp.isfinite(value)
    return jnp.where(finite, 1.0 / jnp.where(finite, value, 1.0), jnp.where(value > 0.0, 0.0, jnp.inf))


def _spring_forces(matrix: Array, compliance: Array) -> Array:
    """Spring forces under a unit force along the sun's arc, solved in units of one reference stiffness."""
    springs, coordinates = matrix.shape
    absent = jnp.isinf(compliance)
    finite = jnp.where(absent, 0.0, compliance)
    positive = jnp.where(finite > 0.0, finite, jnp.inf)
    reference = jnp.where(jnp.any(finite > 0.0), jnp.min(positive), 1.0)
    rows = jnp.where(absent[:, None], 0.0, matrix)
    diagonal = jnp.where(absent, 1.0, jnp.maximum(finite / reference, _REGULARISATION))
    system = jnp.block([[rows, -jnp.diag(diagonal)], [_REGULARISATION * jnp.eye(coordinates), matrix.T]])
    load = jnp.zeros(springs + coordinates).at[springs].set(1.0)
    return jnp.linalg.solve(system, load)[coordinates:]


def assembly_stiffness(
    *,
    geometry: DriveGeometry,
    normal_stiffness: Array,
    tangential_stiffness: Array,
    supports: Supports,
) -> Assembly:
    """Torsional stiffness of the drive with floating planet and rollers, and the budget of its compliance.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    normal_stiffness, tangential_stiffness : Array
        Incremental stiffnesses of the contacts at the operating point, shape (5, ...) [N/m]; ``inf`` is rigid.
    supports : Supports
        Springs of the structure.

    Returns
    -------
    Assembly
        Stiffness and shares.

    Notes
    -----
    Linearised at the operating point, without the (much smaller) stiffness that a preload has by turning with its
    contact. With rigid normal springs and pins each side's two tangential springs lie in series and the sides
    in parallel, which is (25) exactly where both sides share the load alike.

    References
    ----------
    Equation (A8) of :doc:`/equations`.
    """
    side = triangle(geometry)
    sp, pwr, pwl, wro, wlo = tangential_stiffness
    passes = (sp > 0.0) & (((pwr > 0.0) & (wro > 0.0)) | ((pwl > 0.0) & (wlo > 0.0)))
    ring = _compliance(supports.ring_bending_stiffness)
    parts = [
        *(_compliance(k) for k in normal_stiffness),
        *(_compliance(k) for k in jnp.where(passes, tangential_stiffness, 1.0)),
        *(_compliance(k) for k in 2 * (supports.pin_stiffness, supports.pin_transverse_stiffness)),
        *(_compliance(k) for k in 2 * (supports.planet_support_stiffness,)),
    ]
    shape = jnp.broadcast_shapes(*(jnp.shape(leaf) for leaf in (*parts, ring, *jax.tree.leaves(geometry))))
    compliance = jnp.stack([jnp.broadcast_to(part, shape) for part in parts])
    with_ring = compliance.at[3:5].add(jnp.broadcast_to(ring, shape))

    def branch(compliances: Array, local_side: Triangle, local_geometry: DriveGeometry) -> Array:
        matrix = jax.jacfwd(lambda q: _elongations(q, local_side, local_geometry))(jnp.zeros(10))
        return _spring_forces(matrix, compliances)

    solve = branch
    for _ in shape:
        solve = jax.vmap(solve, in_axes=(1, 0, 0), out_axes=1)
    full = jax.tree.map(lambda leaf: jnp.broadcast_to(leaf, shape), (side, geometry))
    force = solve(with_ring, *full)

    energy = (
        jnp.where(jnp.isinf(compliance), 0.0, compliance) * force**2
    )  # c_j f_j^2 per unit force on the sun's arc
    ring_energy = jnp.sum(jnp.broadcast_to(ring, shape) * force[3:5] ** 2, axis=0)
    lever = geometry.planet_count * geometry.sun_radius**2
    input_shaft = _compliance(supports.input_shaft_stiffness) * lever
    output_shaft = _compliance(supports.output_shaft_stiffness) * lever * speed_ratio(geometry) ** 2
    total = jnp.sum(energy, axis=0) + ring_energy + input_shaft + output_shaft
    at_sun = jnp.where(passes, lever / jnp.where(passes, total, 1.0), 0.0)

    def share(part: Array) -> Array:
        return jnp.where(passes, part / jnp.where(passes, total, 1.0), jnp.nan)

    return Assembly(
        stiffness=TorsionalStiffness(sun=at_sun, output=at_sun * speed_ratio(geometry) ** 2),
        tangential_share=share(energy[5:10]),
        normal_share=share(energy[0:5]),
        ring_bending_share=share(ring_energy),
        pin_share=share(jnp.sum(energy[10:14], axis=0)),
        planet_support_share=share(jnp.sum(energy[14:16], axis=0)),
        input_shaft_share=share(input_shaft),
        output_shaft_share=share(output_shaft),
    )


#: Names of the springs of a branch, in the order in which the elongations are listed.
SPRING_NAMES = (
    *(f"{name} normal" for name in CONTACT_NAMES),
    *(f"{name} tangential" for name in CONTACT_NAMES),
    "right pin along push",
    "right pin across push",
    "left pin along push",
    "left pin across push",
    "planet support x",
    "planet support y",
)
