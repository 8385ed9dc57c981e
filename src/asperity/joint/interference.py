"""Interference of a joint at its preload, with the bodies of its assembly."""

from __future__ import annotations

import jax.numpy as jnp
from jax import Array

from asperity.body.shapes import kolosov_constant
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.drive.interference import RestCompliance, rest_compliance
from asperity.drive.mechanism import RestState
from asperity.joint.contacts import JointContacts, bulk_springs
from asperity.joint.description import Joint
from asperity.joint.elastic_bodies import AssemblySprings
from asperity.materials import Material
from asperity.types import Real


def _logarithmic(joint: Joint, contacts: JointContacts) -> Array:
    """Decrease of the contacts' secant compliance with the logarithm of their force, shape (5, ...) [m/N]."""

    def of_body(body: Material) -> Real:
        numbers = {"youngs_modulus": body.youngs_modulus, "poisson_ratio": body.poisson_ratio}
        strain = logarithmic_compliance(contact_length=contacts.pairs.contact_length, **numbers)
        if joint.body_model == "springs" or joint.plane_state == "plane_strain":
            return strain
        stress, plane = (
            kolosov_constant(poisson_ratio=body.poisson_ratio, plane_state=state) + 1.0
            for state in ("plane_stress", "plane_strain")
        )
        return strain * (stress / plane)

    return jnp.asarray(of_body(contacts.driving) + of_body(contacts.driven))


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
    normal, bend = rest.normal_force, _logarithmic(joint, contacts)
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
    )
