"""The bodies of a joint by exact plane elasticity: the springs of its assembly and their coupling."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.coupling import BodyInMachine, coupled_compliance
from asperity.body.rim_moments import WIDEST_CONTACT, walls_resolved
from asperity.body.shapes import Annulus, Disc
from asperity.drive.geometry import Triangle
from asperity.joint.contacts import JointContacts, LoadedContacts
from asperity.joint.description import Joint
from asperity.materials import Material
from asperity.types import Real

#: Half-width over effective radius that stands for an open contact, whose springs are left out.
_CLOSED = 1e-3


class AssemblySprings(NamedTuple):
    """Springs of the contacts in the assembly.

    Parameters
    ----------
    normal_stiffness, tangential_stiffness : Array
        Incremental, asperities and bodies in series, shape (contacts, ...) [N/m]; 0 where a contact is open or slips.
    coupling : Array or None
        Compliances between the contacts, shape (2 contacts, 2 contacts, ...) [m/N]; None without.
    bodies : Array or None
        Compliance of the bodies, without asperities, of the same shape [m/N], at the half-widths :attr:`half_width`
        [m]; None without.
    """

    normal_stiffness: Array
    tangential_stiffness: Array
    coupling: Array | None
    bodies: Array | None = None
    half_width: Array | None = None


def ring_housing_stiffness(joint: Joint) -> Real:
    """Radial stiffness of the ring's support.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    Real
        Per area of the outer rim [N/m^3]: 0 for a ring that carries itself, ``math.inf`` for a rigid housing.
    """
    if joint.ring_support == "free":
        return 0.0
    return joint.structure.ring_housing_stiffness if joint.ring_support == "elastic_housing" else math.inf


def machine_bodies(joint: Joint, sides: Triangle) -> list[BodyInMachine]:
    """Sun, planet, right and left loading roller and ring with their contacts, the planet above the sun.

    Parameters
    ----------
    joint : Joint
        The joint; all numbers of one rank.
    sides : Triangle
        Its triangle of centres.

    Returns
    -------
    list of BodyInMachine
        As long as the longest of their contacts. The inner rim of a hollow roller is free. A rigid housing holds the
        ring's outer rim in both directions, an elastic one in the radial direction only.
    """
    geometry, materials = joint.geometry, joint.bodies
    polar = jnp.arctan2(sides.sin_polar, sides.cos_polar)
    direction = jnp.arctan2(sides.sin_direction, sides.cos_direction)
    up, turn = 0.5 * math.pi, math.pi
    lengths = joint.contact_lengths if len(joint.contact_lengths) > 1 else joint.contact_lengths * 5

    def longest(*contacts: int) -> Real:
        found = lengths[contacts[0]]
        for contact in contacts[1:]:
            found = found if lengths[contact] is found else jnp.maximum(found, lengths[contact])
        return found

    def roller(radius: Real, bore: Real | None, material: Material, *contacts: int) -> Disc | Annulus:
        length, young, poisson = longest(*contacts), material.youngs_modulus, material.poisson_ratio
        if bore is None:
            return Disc(radius, length, young, poisson, joint.plane_state)
        return Annulus(0.5 * bore, radius, length, young, poisson, 0.0, 0.0, "outer", joint.plane_state)

    housing = jnp.asarray(ring_housing_stiffness(joint))
    ring = Annulus(
        inner_radius=geometry.ring_radius,
        outer_radius=geometry.ring_radius + joint.ring_wall_thickness,
        length=longest(3, 4),
        youngs_modulus=materials.ring.youngs_modulus,
        poisson_ratio=materials.ring.poisson_ratio,
        radial_support_stiffness=housing,
        tangential_support_stiffness=jnp.where(jnp.isinf(housing), math.inf, 0.0),
        loaded_rim="inner",
        plane_state=joint.plane_state,
    )
    planet, small, count = geometry.planet_radius, geometry.loading_roller_radius, geometry.planet_count
    sun = Disc(
        geometry.sun_radius,
        longest(0),
        materials.sun.youngs_modulus,
        materials.sun.poisson_ratio,
        joint.plane_state,
    )
    level = jnp.zeros_like(polar)
    members = (
        (sun, (0,), (level + up,), count),
        (
            roller(planet, joint.planet_bore, materials.planet, 0, 1, 2),
            (0, 1, 2),
            (level - up, up - direction, up + direction),
            None,
        ),
        *(
            (
                roller(small, joint.loading_roller_bore, materials.loading_roller, *contacts),
                contacts,
                (turn + up - hand * direction, up - hand * polar),
                None,
            )
            for contacts, hand in (((1, 3), 1.0), ((2, 4), -1.0))
        ),
        (ring, (3, 4), (up - polar, up + polar), count),
    )
    return [
        BodyInMachine(body, contacts, jnp.stack(angles), sectors)
        for body, contacts, angles, sectors in members
    ]


def walls_hold(joint: Joint, half_width: Array) -> Array:
    """Whether every ring and hollow roller has a wall for which its exact compliance is known.

    Parameters
    ----------
    joint : Joint
        The joint.
    half_width : Array
        Half-widths of the contacts, shape (contacts, ...) [m].

    Returns
    -------
    Array
        Truth values, shape (...): the wall is at least five half-widths and not too thin for the number of modes.
        Always true where the bodies are springs.
    """
    holds = jnp.ones((), dtype=bool)
    if joint.body_model == "springs":
        return holds
    geometry, count = joint.geometry, joint.geometry.planet_count
    annuli: list[tuple[Real, Real, tuple[int, ...], bool]] = [
        (geometry.ring_radius, geometry.ring_radius + joint.ring_wall_thickness, (3, 4), False)
    ]
    if joint.planet_bore is not None:
        annuli.append((0.5 * joint.planet_bore, geometry.planet_radius, (0, 1, 2), True))
    if joint.loading_roller_bore is not None:
        annuli.append((0.5 * joint.loading_roller_bore, geometry.loading_roller_radius, (1, 2, 3, 4), True))
    for inner, outer, contacts, alone in annuli:
        widest = jnp.max(half_width[np.array(contacts)], axis=0)
        resolved = walls_resolved(ratio=inner / outer, sectors=count, one_sector=alone)
        holds = holds & resolved & ~(widest > WIDEST_CONTACT * (outer - inner))
    return holds


def assembly_springs(
    *, joint: Joint, sides: Triangle, contacts: JointContacts, loaded: LoadedContacts
) -> AssemblySprings:
    r"""Springs of the contacts of a joint in its assembly.

    .. math:: C = \sum_b P_b^\mathsf{T} C^{(b)} P_b + \operatorname{diag}(1/k_{asperities})

    Parameters
    ----------
    joint : Joint
        The joint; all numbers of one rank.
    sides : Triangle
        Its triangle of centres.
    contacts : JointContacts
        Its contacts.
    loaded : LoadedContacts
        Its contacts under their forces.

    Returns
    -------
    AssemblySprings
        For ``body_model = "springs"`` one spring for each contact, without coupling.

    References
    ----------
    Equation (E3) of :doc:`/equations`.
    """
    bodies = None if joint.body_model == "springs" else machine_bodies(joint, sides)
    return springs_of_bodies(bodies=bodies, contacts=contacts, loaded=loaded)


def springs_of_bodies(
    *, bodies: Sequence[BodyInMachine] | None, contacts: JointContacts, loaded: LoadedContacts
) -> AssemblySprings:
    """Springs of the contacts between given bodies, see :func:`assembly_springs`.

    Parameters
    ----------
    bodies : sequence of BodyInMachine or None
        Exact bodies of one branch; None for one spring for each contact.
    contacts : JointContacts
        The contacts.
    loaded : LoadedContacts
        The contacts under their forces.

    Returns
    -------
    AssemblySprings
        Without coupling where the bodies are springs.

    References
    ----------
    Equation (E3) of :doc:`/equations`.
    """
    interfaces = loaded.interfaces
    normal, tangential = jnp.asarray(interfaces.normal), jnp.asarray(interfaces.tangential)
    if bodies is None:
        return AssemblySprings(normal, tangential, None)
    width, stick_width = widths_of_bodies(contacts=contacts, loaded=loaded)
    compliance = coupled_compliance(
        bodies=bodies,
        contact_lengths=contacts.pairs.contact_length,
        half_widths=width,
        stick_half_widths=stick_width,
    )
    return springs_of_compliance(compliance=compliance, half_width=width, loaded=loaded)


def widths_of_bodies(*, contacts: JointContacts, loaded: LoadedContacts) -> tuple[Array, Array]:
    r"""Half-widths at which the compliance of exact bodies is taken.

    Parameters
    ----------
    contacts : JointContacts
        The contacts.
    loaded : LoadedContacts
        The contacts under their forces.

    Returns
    -------
    tuple of Array
        Half-widths of the strips and of their stick zones, shape (contacts, ...) [m]; those of an open contact stand
        for it only.

    References
    ----------
    Cattaneo's stick zone, :math:`c = b\sqrt{1 - T/(\mu N)}`.
    """
    touching = jnp.asarray(loaded.interfaces.normal) > 0.0
    sticking = jnp.asarray(loaded.interfaces.tangential) > 0.0
    width = jnp.where(touching, loaded.half_width, _CLOSED * contacts.pairs.effective_radius)
    return width, width * jnp.sqrt(jnp.where(sticking, 1.0 - loaded.traction, 1.0))


def springs_of_compliance(*, compliance: Array, half_width: Array, loaded: LoadedContacts) -> AssemblySprings:
    """Springs of the contacts from the compliance of their bodies, the asperities in series.

    Parameters
    ----------
    compliance : Array
        Of the bodies, shape (2 contacts, 2 contacts, ...) [m/N].
    half_width : Array
        Half-widths for which it holds [m].
    loaded : LoadedContacts
        The contacts under their forces.

    Returns
    -------
    AssemblySprings
        With the coupling between the contacts.

    References
    ----------
    Equation (E3) of :doc:`/equations`.
    """
    interfaces = loaded.interfaces
    touching = jnp.asarray(interfaces.normal) > 0.0
    sticking = jnp.asarray(interfaces.tangential) > 0.0
    acts = jnp.concatenate([touching, sticking])
    asperities = jnp.concatenate(
        [
            jnp.broadcast_to(interfaces.asperity_normal, touching.shape),
            jnp.broadcast_to(interfaces.asperity_tangential, sticking.shape),
        ]
    )
    own = jnp.einsum("ii...->i...", compliance)
    if loaded.crown is not None:
        own = own + jnp.concatenate(jnp.broadcast_arrays(*loaded.crown))
    stiffness = jnp.where(acts, 1.0 / (own + 1.0 / jnp.where(acts, asperities, 1.0)), 0.0)
    others = 1.0 - jnp.eye(acts.shape[0]).reshape((acts.shape[0],) * 2 + (1,) * (acts.ndim - 1))
    coupling = jnp.where(acts[:, None] & acts[None], others * compliance, 0.0)
    half = touching.shape[0]
    return AssemblySprings(stiffness[:half], stiffness[half:], coupling, compliance, half_width)
