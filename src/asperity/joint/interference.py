"""Interference and preload of a joint, with the bodies of its assembly."""

from __future__ import annotations

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.coupling import coupled_compliance
from asperity.body.shapes import PlaneState, kolosov_constant
from asperity.compilation import compile_fast
from asperity.contact.crowned_line import CrownedLines
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.drive.geometry import triangle
from asperity.drive.interference import RestCompliance, preload_of_interference, rest_compliance
from asperity.drive.mechanism import RestState, rest_state
from asperity.joint.contacts import JointContacts, bulk_springs, joint_contacts
from asperity.joint.crowned_contacts import crowned_lines
from asperity.joint.description import BodyModel, Joint, with_one_rank
from asperity.joint.elastic_bodies import AssemblySprings, machine_bodies
from asperity.materials import Material
from asperity.types import Real


def logarithmic_decrease(*, contacts: JointContacts, body_model: BodyModel, plane_state: PlaneState) -> Array:
    """Decrease of the contacts' secant compliance with the logarithm of their force.

    Parameters
    ----------
    contacts : JointContacts
        The contacts.
    body_model : {"exact", "springs"}
        Their bodies; the springs are in plane strain.
    plane_state : {"plane_strain", "plane_stress"}
        Of the exact bodies.

    Returns
    -------
    Array
        Sum over both bodies, shape (contacts, ...) [m/N].

    References
    ----------
    :func:`asperity.contact.hertz_line.logarithmic_compliance`.
    """

    def of_body(body: Material) -> Real:
        numbers = {"youngs_modulus": body.youngs_modulus, "poisson_ratio": body.poisson_ratio}
        strain = logarithmic_compliance(contact_length=contacts.pairs.contact_length, **numbers)
        if body_model == "springs" or plane_state == "plane_strain":
            return strain
        stress, plane = (
            kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=state) + 1.0
            for state in ("plane_stress", "plane_strain")
        )
        return strain * (stress / plane)

    return jnp.asarray(of_body(contacts.driving) + of_body(contacts.driven))


def _crowned(contacts: JointContacts) -> CrownedLines | None:
    if contacts.crown_curvature is None:
        return None
    return crowned_lines(pairs=contacts.pairs, crown_curvature=contacts.crown_curvature)


def joint_rest_compliance(
    *, joint: Joint, contacts: JointContacts, rest: RestState, springs: AssemblySprings
) -> RestCompliance:
    r"""Interference over preload of a joint: bodies, ring spring and pins; smooth contacts, without the asperities.

    .. math:: W = \sum_{jk} N_j C_{jk} N_k + \sum_k l_k N_k^2

    Parameters
    ----------
    joint : Joint
        The joint; all numbers of one rank.
    contacts : JointContacts
        Its contacts.
    rest : RestState
        Its forces at rest.
    springs : AssemblySprings
        Springs of its assembly under any load.

    Returns
    -------
    RestCompliance
        At the joint's preload.

    Notes
    -----
    The exact compliance at rest is that under load with the logarithm of the half-widths changed; the remaining terms
    are of the order of the square of half-width over radius. The published contact law has no approach of the
    asperities: their plastic spots have no stiffness.

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    normal = rest.normal_force
    bend = logarithmic_decrease(contacts=contacts, body_model=joint.body_model, plane_state=joint.plane_state)
    width = contacts.pairs.half_width(normal)
    if springs.bodies is None or springs.half_width is None:
        bulk = bulk_springs(contacts=contacts, half_width=width)
        work = jnp.sum(bulk.secant_compliance * normal**2, axis=0)
    else:
        count = normal.shape[0]
        between = springs.bodies[:count, :count]
        at_contact = bend * (1.0 + 2.0 * jnp.log(springs.half_width / width))
        work = jnp.sum(normal * (jnp.sum(between * normal, axis=1) + at_contact * normal), axis=0)
    structure = joint.structure
    return rest_compliance(
        rest=rest,
        preload=joint.preload,
        secant_work=work,
        logarithmic_compliance=bend,
        ring_compliance=1.0 / jnp.asarray(structure.ring_bending_stiffness),
        pin_compliance=1.0 / jnp.asarray(structure.pin_stiffness),
        crowns=_crowned(contacts),
    )


def joint_preload(joint: Joint, interference: Real) -> Array:
    """Preload that an interference makes in a joint.

    Parameters
    ----------
    joint : Joint
        The joint; its own preload is not looked at.
    interference : Real
        Interference [m].

    Returns
    -------
    Array
        Normal force between sun and planet at rest [N]; 0 without interference, nan where the contacts would be as wide
        as their bodies.

    Notes
    -----
    Compiled where the numbers are known; part of the caller's program where they are not.

    References
    ----------
    Equation (I1) of :doc:`/equations`.
    """
    leaves = jax.tree.leaves((joint, interference))
    if any(isinstance(leaf, jax.core.Tracer) for leaf in leaves):
        return _joint_preload(joint, interference)
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), (joint, interference))
    return jnp.asarray(compile_fast(_joint_preload, *numbers)(*numbers))


#: How often the compliance is taken anew where crowns make it depend on the preload otherwise than by a logarithm.
_CROWNED_PASSES = 4


def _passes(joint: Joint) -> tuple[BodyModel, ...]:
    """Bodies with which the preload is found, one pass from each preload to a better one."""
    first: tuple[BodyModel, ...] = ("springs", "exact") if joint.body_model == "exact" else ("springs",)
    if joint.crowns is None:
        return first
    again: tuple[BodyModel, ...] = ("springs",)
    return again * _CROWNED_PASSES + first + first[1:]


def _joint_preload(joint: Joint, interference: Real) -> Array:
    # a force of the right order, at which the logarithm of the half-widths is taken first
    length = jnp.where(jnp.asarray(interference) > 0.0, interference, 1e-6)
    first = 0.1 * joint.bodies.planet.youngs_modulus * joint.contact_lengths[0] * length
    shape = jnp.broadcast_shapes(*(jnp.shape(leaf) for leaf in jax.tree.leaves((joint, length))))
    found = jnp.broadcast_to(first, shape)
    for model in _passes(joint):
        reference = found if joint.crowns is None else jnp.where(found > 0.0, found, first)
        there = with_one_rank(dataclasses.replace(joint, preload=reference))
        contacts, sides = joint_contacts(there), triangle(there.geometry)
        rest = rest_state(geometry=there.geometry, sides=sides, preload=there.preload)
        springs = AssemblySprings(rest.normal_force, rest.normal_force, None)
        if model == "exact":
            width = jnp.asarray(contacts.pairs.half_width(rest.normal_force))
            bodies = coupled_compliance(
                bodies=machine_bodies(there, sides),
                contact_lengths=contacts.pairs.contact_length,
                half_widths=width,
                stick_half_widths=width,
            )
            springs = springs._replace(bodies=bodies, half_width=width)
        compliance = joint_rest_compliance(
            joint=dataclasses.replace(there, body_model=model), contacts=contacts, rest=rest, springs=springs
        )
        found = preload_of_interference(compliance=compliance, interference=interference)
        found = jnp.where(found <= 0.0, 0.0, found) if model == joint.body_model else found
    return found
