"""What the drive of a joint is given: laws of its contacts, and the loads on its bodies."""

from __future__ import annotations

import dataclasses

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.arrays import namespace
from asperity.body.shapes import PlaneState, kolosov_constant
from asperity.contact.carter import gross_slip_creepage
from asperity.contact.exponential import RandomRoughness
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.drive.layout.drive import CARRIER, speeds
from asperity.drive.mechanism import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.equal_springs import rest_forces
from asperity.drive.state.state import ContactLaws, CreepOf, DriveLoad
from asperity.drive.state.states import state_at_rest
from asperity.drive.state.supports import Supports, carrier_supports
from asperity.joint.bodies import body_compliance
from asperity.joint.bores import pin_compliances, pins_in_bores
from asperity.joint.contacts import (
    JointContacts,
    bulk_springs,
    closure_springs,
    rough_joint_contacts,
    with_crowns,
)
from asperity.joint.crowned_contacts import crown_compressions, lateral_strain_compliance
from asperity.joint.description import Joint, body_masses
from asperity.joint.fit import BodyModel
from asperity.materials import Material
from asperity.rolling.creep import ContactCreep, contact_creep
from asperity.types import Real

#: A force that is small for every wall: over Young's modulus times length times interference.
_SMALL_FORCE = 1e-5
_REFERENCE_STEPS, _CROWNED_STEPS = 4, 10
#: Each leaves less than a thousandth of what its preload is away from that around which its laws are taken.
_ASSEMBLIES = 2


def contact_laws(joint: Joint, contacts: JointContacts) -> ContactLaws:
    """Laws of the contacts of a joint around their forces without torque.

    Parameters
    ----------
    joint : Joint
        The joint.
    contacts : JointContacts
        Its contacts.

    Returns
    -------
    ContactLaws
        Approach, slip, and the creep of smooth even rollers; a rolling state takes that of :func:`creep_law`.

    Notes
    -----
    Where the preload is an interference, the laws are taken around the force that it makes in the assembled drive. The
    same force, stated as the preload, gives the same laws.

    References
    ----------
    Equations (A3), (B1) and (E3) of :doc:`/equations`.
    """
    return _laws_around(joint, contacts, _reference_force(joint, contacts))


def _laws_around(joint: Joint, contacts: JointContacts, reference: Array) -> ContactLaws:
    """Laws of the contacts around given forces without torque [N]."""
    springs, coupling = _approach(joint, contacts, reference)
    crowned = contacts.crown_curvature is not None
    rough = rough_joint_contacts(
        contacts=contacts, normal_force=reference, tangential_force=jnp.zeros_like(reference)
    )
    stiff = rough.tangential_stiffness > 0.0
    laws = ContactLaws(
        springs=with_crowns(springs, contacts=contacts, rest_force=reference),
        reference_force=reference,
        creep=smooth_creep(contacts, reference),
        asperity_compliance=jnp.where(stiff, 1.0 / jnp.where(stiff, rough.tangential_stiffness, 1.0), 0.0),
        coupling=coupling,
        lateral_strain_compliance=(
            lateral_strain_compliance(contacts.driving, contacts.driven) if crowned else None
        ),
        rims=contacts.rims,
        linear_compliance=ring_springs(joint),
        bores=pins_in_bores(joint),
        slip_exponent=1.0 if isinstance(contacts.pairs.surface, RandomRoughness) else 1.0 / 3.0,
    )
    if joint.closure_springs is None:
        return laws
    bulk = closure_springs(contacts=contacts, rest_force=reference, model="bulk")
    asperities = 1.0 / rough.normal_stiffness if joint.closure_springs == "bulk_and_asperities" else None
    closure = dataclasses.replace(laws, springs=bulk, coupling=None, linear_compliance=asperities, bores=None)
    return dataclasses.replace(laws, closure=closure)


def _reference_force(joint: Joint, contacts: JointContacts) -> Array:
    """Forces without torque around which the laws are taken [N]."""
    if joint.unlike is not None:
        return joint.unlike.reference_force
    forces = rest_forces(drive=joint.drive, pattern=jnp.asarray(joint.pattern))
    if joint.preload is not None:
        return jnp.asarray(joint.preload) * forces
    load, preload = drive_load(joint, body_masses(joint), 0.0), _expected_preload(joint, contacts, forces)
    for _ in range(_ASSEMBLIES):
        rest = state_at_rest(
            drive=joint.drive,
            laws=_laws_around(joint, contacts, preload * forces),
            pattern=joint.working_pattern,
            interference=joint.interference,
            load=load,
        )
        preload = rest.normal[0]
    return preload * forces


def _expected_preload(joint: Joint, contacts: JointContacts, forces: Array) -> Array:
    """Preload by the work of the interference, if nothing but the contacts gives way, all by one share."""
    young, length = joint.materials[0].youngs_modulus, jnp.asarray(contacts.pairs.contact_length)[0]
    small = _SMALL_FORCE * young * length * jnp.asarray(joint.interference)
    return _preload_by_work(joint, contacts, forces, small)


def _preload_by_work(joint: Joint, contacts: JointContacts, forces: Array, at: Array) -> Array:
    """Preload by the work of the interference, with the compliance at a preload and its logarithm."""
    springs, coupling = _approach(joint, contacts, at * forces)
    share = jnp.sum(joint.working_pattern * forces) * jnp.asarray(joint.interference)
    work = jnp.sum(springs.secant_compliance * forces**2)
    work = work if coupling is None else work + forces @ coupling @ forces
    rings = ring_springs(joint)
    work = work if rings is None else work + jnp.sum(rings * forces**2)
    # the work falls by this for each e-fold of the force
    softer = jnp.sum((springs.secant_compliance - springs.incremental_compliance) * forces**2)

    def even(preload: Array) -> Array:
        return jnp.maximum(work - softer * jnp.log(preload / at), 0.2 * work)

    curvature, preload = contacts.crown_curvature, at
    if curvature is None:
        for _ in range(_REFERENCE_STEPS):
            preload = share / even(preload)
        return preload

    def improve(_: int, preload: Array) -> Array:
        added = crown_compressions(
            pairs=contacts.pairs, crown_curvature=curvature, normal_force=preload * forces
        )
        return share / (even(preload) + jnp.sum(added * forces) / preload)

    crowned_preload: Array = jax.lax.fori_loop(0, _CROWNED_STEPS, improve, at)
    return crowned_preload


def _approach(joint: Joint, contacts: JointContacts, force: Array) -> tuple[NormalSprings, Array | None]:
    """Normal springs of the contacts at given forces, and their coupling."""
    width = jnp.asarray(contacts.pairs.half_width(force))
    if joint.body_model == "springs":
        return bulk_springs(contacts=contacts, half_width=width), None
    compliance = body_compliance(joint=joint, contacts=contacts, half_width=width, stick_half_width=width)
    normal = compliance[: force.size, : force.size]
    diagonal = jnp.diag(normal)
    bend = logarithmic_decrease(contacts=contacts, body_model=joint.body_model, plane_state=joint.plane_state)
    springs = NormalSprings(secant_compliance=diagonal + bend, incremental_compliance=diagonal)
    return springs, normal - jnp.diag(diagonal)


def smooth_creep(contacts: JointContacts, normal_force: Array) -> CreepLaw:
    """Creep of smooth even rollers with parallel axes, shape (contacts,)."""
    pairs = contacts.pairs
    limit = gross_slip_creepage(
        friction_coefficient=pairs.friction_coefficient,
        half_width=pairs.half_width(normal_force),
        effective_radius=pairs.effective_radius,
    )
    friction = jnp.broadcast_to(pairs.friction_coefficient, normal_force.shape)
    return CreepLaw(friction, limit / jnp.sqrt(normal_force))


def creep_law(
    joint: Joint, contacts: JointContacts, normal_force: Array, tangential_force: Array
) -> ContactCreep:
    """Creep of the contacts of a drive with the factors of asperities and skew around given forces.

    Parameters
    ----------
    joint : Joint
        The joint.
    contacts : JointContacts
        The contacts.
    normal_force, tangential_force : Array
        Forces, shape (contacts,) [N].

    Returns
    -------
    ContactCreep
        Of :func:`asperity.rolling.creep.contact_creep`.

    References
    ----------
    Equations (B1) and (B3) of :doc:`/equations`.
    """
    return contact_creep(
        contacts=contacts,
        skew=joint.rolling.skew,
        normal_force=normal_force,
        tangential_force=tangential_force,
    )


def creep_under(joint: Joint, contacts: JointContacts) -> CreepOf:
    """The creep law of :func:`creep_law` of any forces, as a module of numbers."""
    return jax.tree_util.Partial(_creep_under, joint.rolling.skew, contacts)


def _creep_under(
    skew: tuple[Real, ...] | None, contacts: JointContacts, normal_force: Array, tangential_force: Array
) -> CreepLaw:
    return contact_creep(
        contacts=contacts, skew=skew, normal_force=normal_force, tangential_force=tangential_force
    ).law


def ring_springs(joint: Joint) -> Array | None:
    """Compliance of the springs in series with the contacts of rings, shape (contacts,) [m/N]; None for none."""
    if joint.ring_bending_stiffness is None:
        return None
    inside = np.array([contact.internal for contact in joint.drive.contacts])
    return jnp.where(inside, 1.0 / jnp.asarray(joint.ring_bending_stiffness, dtype=float), 0.0)


def supports_of(joint: Joint) -> Supports | None:
    """Springs that hold the rollers of a joint on the carrier besides its pins along their push; None for none."""
    drive = joint.drive
    planets = tuple(
        body
        for body in drive.floating
        if drive.bodies[body].place == "free" and not drive.bodies[body].on_axis
    )
    return carrier_supports(
        drive=drive,
        pin_transverse_stiffness=joint.pin_transverse_stiffness,
        planet_support_stiffness=joint.planet_support_stiffness,
        planets=planets,
    )


def centrifugal_forces(joint: Joint, masses: list[Real]) -> Array:
    r"""Forces :math:`m \omega_c^2 r` on the floating bodies, shape (floating, 2) [N]."""
    drive = joint.drive
    carrier = speeds(drive)[drive.members.index(CARRIER)] * joint.input_speed
    forces = [masses[body] * carrier**2 * drive.centres[body] for body in drive.floating]
    xp = namespace(forces)
    together: Array = xp.stack(forces) if forces else xp.zeros((0, 2))
    return together


def drive_load(joint: Joint, masses: list[Real], torque: Real) -> DriveLoad:
    """What acts on the drive of a joint: torque, centrifugal forces, and its springs.

    Parameters
    ----------
    joint : Joint
        The joint.
    masses : list of Real
        Masses of its bodies [kg].
    torque : Real
        Output torque [N·m].

    Returns
    -------
    DriveLoad
        For :func:`asperity.drive.state.states.drive_states`.

    References
    ----------
    Equations (2)–(4) of Zou et al. 2025 have the same forces.
    """
    return DriveLoad(
        output_torque=jnp.asarray(torque, dtype=float),
        body_force=centrifugal_forces(joint, masses),
        pin_compliance=pin_compliances(joint),
        bearings=joint.bearings,
        support_stiffness=None if joint.unlike is None else joint.unlike.support_stiffness,
        supports=supports_of(joint),
        rotation=jnp.asarray(joint.input_speed, dtype=float),
        standing_rotation=jnp.asarray(joint.input_speed, dtype=float),
        friction_on_carrier=joint.carrier_balance == "complete",
    )


def logarithmic_decrease(*, contacts: JointContacts, body_model: BodyModel, plane_state: PlaneState) -> Array:
    """Decrease of the contacts' secant compliance with the logarithm of their force.

    Shape (contacts, ...) [m/N].
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
