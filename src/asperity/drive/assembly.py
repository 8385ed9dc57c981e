r"""Torsional stiffness with floating bodies (A8): planet and loading rollers free to move in the plane.

In the published series (25) every roller turns about a fixed centre. In the machine only the sun's centre is fixed
(by symmetry); a tangential force on the planet displaces it laterally against the *normal* springs of its wedge.

One branch is a :class:`asperity.drive.planar_assembly.PlanarAssembly` of sun, planet and two loading rollers under a
unit torque on the sun. The shares :math:`c_j f_j^2` of its springs add up to the compliance.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.geometry import DriveGeometry, Triangle, speed_ratio
from asperity.drive.planar_assembly import GROUND, PlanarAssembly, spring_forces
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.types import Real


class StructureSprings(eqx.Module):
    """Springs of the structure around the rollers; ``math.inf`` is rigid, 0 is absent. SI units.

    Parameters
    ----------
    pin_stiffness : Real
        Of one carrier pin along its force on the loading roller [N/m].
    pin_transverse_stiffness : Real
        Of one carrier pin across that direction [N/m]; 0 where the roller is free to move radially.
    planet_support_stiffness : Real
        Of a planet's bearing on the carrier, in both directions of the plane [N/m]; 0 for a floating planet.
    ring_bending_stiffness : Real
        Of the outer ring as a whole under one loading roller's normal force [N/m].
    input_shaft_stiffness, output_shaft_stiffness : Real
        Torsional stiffness of the shafts [N·m/rad].
    ring_housing_stiffness : Real, optional
        Radial stiffness of the housing around the ring, per area of the ring's outer rim [N/m^3]. Not a spring of
        :func:`assembly_stiffness`: it belongs to the ring as an elastic body.

    Notes
    -----
    The radial stiffness of the sun's bearing is not included: under a torque the forces of the branches on the sun
    balance, so that the bearing carries no load.
    """

    pin_stiffness: Real
    pin_transverse_stiffness: Real
    planet_support_stiffness: Real
    ring_bending_stiffness: Real
    input_shaft_stiffness: Real
    output_shaft_stiffness: Real
    ring_housing_stiffness: Real = math.inf




class Assembly(eqx.Module):
    """Stiffness of the assembled drive and where its compliance comes from.

    Parameters
    ----------
    stiffness : TorsionalStiffness
        At the sun and at the output [N·m/rad]; 0 where the drive transmits no torque.
    tangential_share : Array
        Share of each contact's tangential spring in the compliance, shape (5, ...) [-].
    normal_share : Array
        Share of each contact's normal spring, which allows the planet to float in its wedge, shape (5, ...) [-].
    ring_bending_share, pin_share, planet_support_share, input_shaft_share, output_shaft_share : Array
        Shares of the structure [-]. All shares add up to 1.
    loading_cam_share : Real, optional
        Share of a loading cam that follows the torque, :func:`asperity.drive.loading_cam.with_cam` [-].
    """

    stiffness: TorsionalStiffness
    tangential_share: Array
    normal_share: Array
    ring_bending_share: Array
    pin_share: Array
    planet_support_share: Array
    input_shaft_share: Array
    output_shaft_share: Array
    loading_cam_share: Real = 0.0


#: The bodies of a branch. By symmetry the sun's centre does not move; the sun only turns.
_BODIES = ("sun", "planet", "right", "left")
_FREE = ((False, False, True), *3 * ((True, True, True),))
#: First body, second body, and whether the contact is external; in the order of the contacts.
_MEETINGS = (
    ("sun", "planet", 1),
    ("planet", "right", 1),
    ("planet", "left", 1),
    ("right", "ring", -1),
    ("left", "ring", -1),
)
_SUPPORTED = ("right", "right", "left", "left", "planet", "planet")
_RING_CONTACTS = np.array([second == "ring" for _, second, _ in _MEETINGS]).nonzero()[0]
_UNIT_TORQUE = np.eye(10)[0]  # force 1 along the sun's arc


def branch_assembly(*, geometry: DriveGeometry, sides: Triangle) -> PlanarAssembly:
    """Sun, planet and loading rollers of one branch, with their contacts, pins and planet support.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    sides : Triangle
        Its triangle of centres.

    Returns
    -------
    PlanarAssembly
        The planet lies on the y axis above the sun; pins along and across the carrier's force.

    References
    ----------
    Equation (A8) of :doc:`/equations`.
    """
    sin_a, cos_a = sides.sin_polar, sides.cos_polar
    sin_t, cos_t = sides.sin_direction, sides.cos_direction
    pins = []
    for hand, push in ((1.0, geometry.right_push_angle), (-1.0, geometry.left_push_angle)):
        inward, radial = (
            (-hand * cos_a, sin_a),
            (hand * sin_a, cos_a),
        )  # the pin forces push the rollers of a branch together
        cos_g, sin_g = jnp.cos(push), jnp.sin(push)
        pins.append([inward[k] * cos_g + radial[k] * sin_g for k in (0, 1)])
        pins.append([radial[k] * cos_g - inward[k] * sin_g for k in (0, 1)])
    index = {name: number for number, name in enumerate(_BODIES)} | {"ring": GROUND}
    return PlanarAssembly(
        free=_FREE,
        contacts=tuple((index[first], index[second], sense) for first, second, sense in _MEETINGS),
        supports=tuple(index[name] for name in _SUPPORTED),
        contact_direction=_stacked(
            (0.0, 1.0), (sin_t, cos_t), (-sin_t, cos_t), (sin_a, cos_a), (-sin_a, cos_a)
        ),
        support_direction=_stacked(*pins, (1.0, 0.0), (0.0, 1.0)),
    )


def _stacked(*vectors: Sequence[Real]) -> Array:
    """Vectors of two components as one array of shape (vectors, 2, ...)."""
    numbers = jnp.broadcast_arrays(*(jnp.asarray(number) for vector in vectors for number in vector))
    return jnp.stack(numbers).reshape((len(vectors), 2, *numbers[0].shape))


def _compliance(stiffness: Real) -> Array:
    """1/k with 1/inf = 0 and 1/0 = inf, and finite derivatives at both."""
    value = jnp.asarray(stiffness)
    finite = (value > 0.0) & jnp.isfinite(value)
    return jnp.where(finite, 1.0 / jnp.where(finite, value, 1.0), jnp.where(value > 0.0, 0.0, jnp.inf))


def _finite(compliance: Array) -> Array:
    """Factor on a spring's force: an absent spring carries none."""
    return jnp.where(jnp.isinf(compliance), 0.0, compliance)


def assembly_stiffness(
    *,
    geometry: DriveGeometry,
    sides: Triangle,
    normal_stiffness: Array,
    tangential_stiffness: Array,
    structure: StructureSprings,
    coupling: Array | None = None,
) -> Assembly:
    """Torsional stiffness of the drive with floating planet and rollers, and its compliance budget.

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    sides : Triangle
        Its triangle of centres.
    normal_stiffness, tangential_stiffness : Array
        Incremental stiffnesses of the contacts at the operating point, shape (5, ...) [N/m]; ``inf`` is rigid, 0 open.
    structure : StructureSprings
        Springs of the structure.
    coupling : Array, optional
        Compliances between the contacts, normal springs first, shape (10, 10, ...) [m/N]: symmetric, 0 on the diagonal
        and where a contact is open. Required for bodies that deform as a whole.

    Returns
    -------
    Assembly
        Stiffness and shares.

    Notes
    -----
    Linearised at the operating point, without the (much smaller) geometric stiffness of a preload that turns with its
    contact. With rigid normal springs and pins each side's two tangential springs lie in series and the sides
    in parallel, which is (25) exactly where both sides share the load equally.

    References
    ----------
    Equation (A8) of :doc:`/equations`.
    """
    contacts = [*_compliance(normal_stiffness), *_compliance(tangential_stiffness)]
    pins = [structure.pin_stiffness, structure.pin_transverse_stiffness] * 2
    held = [_compliance(stiffness) for stiffness in (*pins, *2 * (structure.planet_support_stiffness,))]
    *springs, ring = jnp.broadcast_arrays(*contacts, *held, _compliance(structure.ring_bending_stiffness))
    compliance = jnp.stack(springs)
    force, carried = spring_forces(
        assembly=branch_assembly(geometry=geometry, sides=sides),
        compliance=compliance.at[_RING_CONTACTS].add(ring),
        coupling=coupling,
        load=_UNIT_TORQUE,
    )
    # work per unit force on the sun's arc
    energy = _finite(compliance) * force**2
    if coupling is not None:
        acting = force[: coupling.shape[0]]
        energy = energy.at[: coupling.shape[0]].add(acting * jnp.sum(coupling * acting, axis=1))
    ring_energy = jnp.sum(_finite(ring) * force[_RING_CONTACTS] ** 2, axis=0)
    sp, pwr, pwl, wro, wlo = tangential_stiffness
    passes = carried & (sp > 0.0) & (((pwr > 0.0) & (wro > 0.0)) | ((pwl > 0.0) & (wlo > 0.0)))
    lever = geometry.planet_count * geometry.sun_radius**2
    ratio_squared = speed_ratio(geometry) ** 2
    input_shaft = _compliance(structure.input_shaft_stiffness) * lever
    output_shaft = _compliance(structure.output_shaft_stiffness) * lever * ratio_squared
    total = jnp.sum(energy, axis=0) + ring_energy + input_shaft + output_shaft
    at_sun = jnp.where(passes, lever / jnp.where(passes, total, 1.0), 0.0)

    def share(part: Array) -> Array:
        return jnp.where(passes, part / jnp.where(passes, total, 1.0), jnp.nan)

    return Assembly(
        stiffness=TorsionalStiffness(sun=at_sun, output=at_sun * ratio_squared),
        tangential_share=share(energy[5:10]),
        normal_share=share(energy[0:5]),
        ring_bending_share=share(ring_energy),
        pin_share=share(jnp.sum(energy[10:14], axis=0)),
        planet_support_share=share(jnp.sum(energy[14:16], axis=0)),
        input_shaft_share=share(input_shaft),
        output_shaft_share=share(output_shaft),
    )
