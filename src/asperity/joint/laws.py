"""What the drive of a joint is given: laws of its contacts, and the loads on its bodies."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Sequence

from asperity.body.shapes import PlaneState, kolosov_constant
from asperity.contact.carter import gross_slip_creepage
from asperity.contact.hertz_line import logarithmic_compliance
from asperity.contact.rolling_losses import hysteresis_moment
from asperity.drive.layout.drive import CARRIER, speeds
from asperity.drive.normal_springs import NormalSprings
from asperity.drive.state.creep import CreepLaw
from asperity.drive.state.state import ContactLaws, Creeping, CreepOf, DriveLoad, surface_speeds
from asperity.engine.arrays import xp
from asperity.engine.module import Partial
from asperity.joint.body_compliance import body_compliance
from asperity.joint.contacts import (
    JointContacts,
    bulk_springs,
    closure_springs,
    rough_joint_contacts,
    with_crowns,
)
from asperity.joint.crowned_contacts import lateral_strain_compliance
from asperity.joint.description import Joint, places
from asperity.joint.fit import BodyModel
from asperity.joint.machine import JointMachine
from asperity.materials import Material
from asperity.rolling.creep import CapacityOf, ContactCreep, axial_drag, contact_creep
from asperity.rolling.film import OiledSurfaces
from asperity.rolling.power import oil_drag
from asperity.rolling.surface import effusivity_of, mean_half_width
from asperity.types import Array, Real


def contact_laws(machine: JointMachine, reference_force: Array) -> ContactLaws:
    """Laws of the contacts around forces without torque, shape (contacts,) [N]; equations (A3), (B1) and (E3).

    Approach, slip, and the creep of smooth even rollers; a rolling state takes that of :func:`creep_law`.
    """
    joint, contacts = machine.joint, machine.contacts
    springs, coupling = approach_springs(machine, reference_force)
    crowned = contacts.crown_curvature is not None
    rough = rough_joint_contacts(
        contacts=contacts, normal_force=reference_force, tangential_force=xp.zeros_like(reference_force)
    )
    stiff = rough.tangential_stiffness > 0.0
    laws = ContactLaws(
        springs=with_crowns(springs, contacts=contacts, rest_force=reference_force),
        reference_force=reference_force,
        creep=smooth_creep(contacts, reference_force),
        asperity_compliance=xp.where(stiff, 1.0 / xp.where(stiff, rough.tangential_stiffness, 1.0), 0.0),
        coupling=coupling,
        lateral_strain_compliance=(
            lateral_strain_compliance(contacts.driving, contacts.driven) if crowned else None
        ),
        rims=contacts.rims,
        linear_compliance=machine.ring_compliance,
        bores=machine.bores,
        slip_exponent=contacts.pairs.surface.slip_exponent,
    )
    if joint.closure_springs is None:
        return laws
    bulk = closure_springs(contacts=contacts, rest_force=reference_force, model="bulk")
    asperities = 1.0 / rough.normal_stiffness if joint.closure_springs == "bulk_and_asperities" else None
    closure = dataclasses.replace(laws, springs=bulk, coupling=None, linear_compliance=asperities, bores=None)
    return dataclasses.replace(laws, closure=closure)


def approach_springs(machine: JointMachine, force: Array) -> tuple[NormalSprings, Array | None]:
    """Normal springs of the contacts at given forces, and their coupling."""
    joint, contacts = machine.joint, machine.contacts
    width = xp.asarray(contacts.pairs.half_width(force))
    if joint.body_model == "springs":
        return bulk_springs(contacts=contacts, half_width=width), None
    compliance = body_compliance(machine=machine, half_width=width, stick_half_width=width)
    normal = compliance[: force.size, : force.size]
    diagonal = xp.diag(normal)
    bend = logarithmic_decrease(contacts=contacts, body_model=joint.body_model, plane_state=joint.plane_state)
    springs = NormalSprings(secant_compliance=diagonal + bend, incremental_compliance=diagonal)
    return springs, normal - xp.diag(diagonal)


def smooth_creep(contacts: JointContacts, normal_force: Array) -> CreepLaw:
    """Creep of smooth even rollers with parallel axes, shape (contacts,)."""
    pairs = contacts.pairs
    limit = gross_slip_creepage(
        friction_coefficient=pairs.friction_coefficient,
        half_width=pairs.half_width(normal_force),
        effective_radius=pairs.effective_radius,
    )
    friction = xp.broadcast_to(pairs.friction_coefficient, normal_force.shape)
    return CreepLaw(friction, limit / xp.sqrt(normal_force))


def creep_law(machine: JointMachine, normal_force: Array, tangential_force: Array) -> ContactCreep:
    """Creep of the contacts with asperities, skew and oil around forces of shape (contacts,) [N].

    (B1), (B3), (F5).
    """
    return contact_creep(
        contacts=machine.contacts,
        skew=machine.joint.rolling.skew,
        normal_force=normal_force,
        tangential_force=tangential_force,
        surfaces=oiled_surfaces(machine),
    )


def creep_under(machine: JointMachine, *, searching: bool = False) -> CreepOf:
    """Creep by the law of :func:`creep_law` under any forces, as a module of numbers.

    ``searching``: whether states beyond what contacts with oil bear are of no interest but that they are beyond.
    """
    given = machine.joint.rolling.skew, machine.contacts, oiled_surfaces(machine)
    return Partial(functools.partial(_creep_under, "rough" if searching else "near"), given)


def _creep_under(
    capacity: CapacityOf,
    skew: tuple[Real, ...] | None,
    contacts: JointContacts,
    surfaces: OiledSurfaces | None,
    normal_force: Array,
    tangential_force: Array,
) -> Creeping:
    creep = contact_creep(
        contacts=contacts,
        skew=skew,
        normal_force=normal_force,
        tangential_force=tangential_force,
        surfaces=surfaces,
        capacity=capacity,
    )
    creepage = creep.creepage(normal_force, tangential_force)
    bears = creep.law.friction_coefficient * normal_force
    if creep.oiled is not None:
        bears = xp.where(creep.oiled.turns, creep.oiled.capacity.traction, bears)
    if creep.parallel:
        return Creeping(creepage, bears, xp.zeros_like(normal_force))
    drag = axial_drag(pairs=contacts.pairs, creep=creep, normal_force=normal_force, creepage=creepage)
    return Creeping(creepage, bears, drag)


def oiled_surfaces(machine: JointMachine) -> OiledSurfaces | None:
    """What the oil in the contacts meets; None without one whose traction is known."""
    joint, lubricant = machine.joint, machine.joint.rolling.lubricant
    if lubricant is None or lubricant.fluid.traction is None:
        return None
    heights = joint.rolling.roughness
    speed = rolling_speeds(joint)
    return OiledSurfaces(
        lubricant=lubricant,
        rolling_speed=speed,
        effusivity=_effusivities(joint),
        rms_height=None
        if heights is None
        else xp.stack([xp.asarray(height) for height in heights]) + 0.0 * speed,
    )


def _effusivities(joint: Joint) -> Array:
    """Means of the effusivities of the bodies of each contact, infinite where one is not known, shape (contacts,)."""
    means: list[Real] = []
    for bodies in zip(*places(joint.drive), strict=True):
        both = [joint.materials[body] for body in bodies]
        if any(one.thermal_conductivity is None or one.specific_heat_capacity is None for one in both):
            means.append(xp.asarray(math.inf))
            continue
        means.append(0.5 * sum(effusivity_of(one) for one in both))
    return xp.stack([xp.asarray(mean) for mean in means])


def rolling_speeds(joint: Joint) -> Array:
    """Mean speeds of both surfaces of each contact relative to it, without creep, shape (contacts,) [m/s]."""
    size = xp.abs(xp.asarray(joint.input_speed, dtype=float))
    one, two = surface_speeds(drive=joint.drive, speed=xp.asarray(speeds(joint.drive)) * size)
    return 0.5 * (one + two)


def centrifugal_forces(joint: Joint, masses: Sequence[Real]) -> Array:
    r"""Forces :math:`m \omega_c^2 r` on the floating bodies, shape (floating, 2) [N]."""
    drive = joint.drive
    carrier = speeds(drive)[drive.members.index(CARRIER)] * joint.input_speed
    forces = [masses[body] * carrier**2 * drive.centres[body] for body in drive.floating]
    return xp.stack(forces) if forces else xp.zeros((0, 2))


def drive_load(machine: JointMachine) -> DriveLoad:
    """What acts on the drive under its torque: centrifugal forces, and its springs.

    Equations (2)–(4) of Zou et al. 2025 have the same forces.
    """
    joint = machine.joint
    return DriveLoad(
        output_torque=xp.asarray(joint.output_torque, dtype=float),
        body_force=centrifugal_forces(joint, machine.masses),
        pin_compliance=machine.pin_compliance,
        bearings=joint.bearings,
        support_stiffness=None if joint.unlike is None else joint.unlike.support_stiffness,
        supports=machine.supports,
        rotation=xp.asarray(joint.input_speed, dtype=float),
        standing_rotation=xp.asarray(joint.input_speed, dtype=float),
        friction_on_carrier=joint.carrier_balance == "complete",
    )


def rolling_load(machine: JointMachine) -> DriveLoad:
    """As :func:`drive_load`, with what resists rolling: oil, hysteresis and skew, where the joint has them; (B9).

    The oil drags at speeds without creep.
    """
    load, joint, rolling = drive_load(machine), machine.joint, machine.joint.rolling
    if rolling.viscosity is None and rolling.hysteresis_loss_factor is None and rolling.skew is None:
        return load
    numbers = (rolling.viscosity, rolling.hysteresis_loss_factor, machine.contacts, rolling_speeds(joint))
    return dataclasses.replace(load, resistance_of=Partial(_resistance_under, numbers))


def _resistance_under(
    viscosity: Real | None,
    loss_factor: Real | None,
    contacts: JointContacts,
    rolling_speed: Array,
    normal_force: Array,
) -> tuple[Array, Array]:
    """Drag of the oil [N] and moment of hysteresis [N·m], which acts where the surfaces roll."""
    pairs, lines, none = contacts.pairs, contacts.loads_along(normal_force), xp.zeros_like(normal_force)
    drag, moment = none, none
    if viscosity is not None:
        drag = oil_drag(
            pairs=pairs,
            viscosity=viscosity,
            normal_force=normal_force,
            rolling_speed=rolling_speed,
            lines=lines,
        )
    if loss_factor is not None:
        moment = xp.asarray(
            hysteresis_moment(
                loss_factor=loss_factor,
                normal_force=normal_force,
                half_width=mean_half_width(pairs=pairs, lines=lines, normal_force=normal_force),
            )
        )
    return drag, moment


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

    return xp.asarray(of_body(contacts.driving) + of_body(contacts.driven))
