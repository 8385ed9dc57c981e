"""The contacts of a joint: one array of each number over all of them, and what they do under load."""

from __future__ import annotations

from typing import NamedTuple

from asperity.body.rim_moments import RimKernel
from asperity.contact.crowned_line import CrownedLine
from asperity.contact.hertz_line import (
    logarithmic_compliance,
    ring_secant_compliance,
    roller_secant_compliance,
)
from asperity.contact.interface import Interface, RoughContact, bulk_tangential_stiffness
from asperity.contact.population import ContactFactorModel
from asperity.contact.roller_pairs import RollerPairs, contact_factors, rough_contacts
from asperity.drive.normal_springs import NormalSprings, crowned_springs
from asperity.engine.arrays import xp
from asperity.engine.control import traced_once
from asperity.engine.module import Module, static
from asperity.joint.crowned_contacts import (
    CrownCompliance,
    contact_of_slices,
    crown_compliances,
    crowned_lines,
    loads_along,
    rough_slices,
)
from asperity.joint.fit import ClosureSprings
from asperity.materials import Material
from asperity.types import Array, Real


class JointContacts(Module):
    """Everything about the contacts of a joint that no load changes; the contact axis comes first.

    Parameters
    ----------
    pairs : RollerPairs
        Radii, lengths, friction, moduli and surfaces.
    driving, driven : Material
        Materials of the two bodies.
    ring_wall_thickness : Real
        Wall of the ring, the driven body of the internal contacts [m].
    contact_factor_model : {"printed", "hertz_area", "unity"}
        Model of lambda.
    crown_curvature : Array or None
        Curvatures of the crowns, shape (contacts, ...) [1/m]; None where no roller is crowned.
    logarithmic : Array or None, optional
        Which crowns are logarithmic profiles, 1, or circles, 0 [-]; None where all are circles.
    rims : RimKernel or None, optional
        Of the exact bodies, :func:`asperity.body.coupling.machine_kernel`; None where it is not known.
    """

    pairs: RollerPairs
    driving: Material
    driven: Material
    ring_wall_thickness: Real
    contact_factor_model: ContactFactorModel = static()
    crown_curvature: Array | None = None
    logarithmic: Array | None = None
    rims: RimKernel | None = None

    def loads_along(self, normal_force: Array) -> CrownedLine | None:
        """How normal forces [N] spread over crowned contacts, slices first; None where they are even."""
        if self.crown_curvature is None:
            return None
        return loads_along(
            pairs=self.pairs,
            crown_curvature=self.crown_curvature,
            normal_force=normal_force,
            logarithmic=self.logarithmic,
        )

    def largest_half_width(self, normal_force: Array) -> Array:
        """Half-widths where the contacts are widest, for one newton where they are open, shape (contacts, ...) [m]."""
        lines = self.loads_along(normal_force)
        return xp.asarray(self.pairs.half_width(normal_force)) if lines is None else lines.half_width[0]


class LoadedContacts(NamedTuple):
    """The contacts of a joint under their forces, shape (contacts, ...).

    ``half_width`` of the Hertzian strips under even loads [m], 0 where a contact is open; ``traction`` T/(mu N) [-], 1
    where a contact is open or slips; ``interfaces``, stiffnesses of asperities and of bulk [N/m], all 0 where a contact
    is open. ``lines`` are the loads along crowned contacts, for one newton where they are open, None where the loads
    are even; ``crown`` is what the crowns add to the bodies, contained in the interfaces.
    """

    half_width: Array
    traction: Array
    rough: RoughContact
    interfaces: Interface
    lines: CrownedLine | None = None
    crown: CrownCompliance | None = None


def elastic_material(material: Material) -> Material:
    """A material without its thermal properties, which not every material has."""
    return Material(
        youngs_modulus=material.youngs_modulus,
        poisson_ratio=material.poisson_ratio,
        density=material.density,
        yield_strength=material.yield_strength,
        hardness=material.hardness,
    )


def bulk_springs(*, contacts: JointContacts, half_width: Real) -> NormalSprings:
    """Secant and incremental normal compliance of the bodies by half-widths [m], shape (contacts, ...) [m/N].

    Two solid rollers in series, or a roller and the ring's wall.
    """
    pairs = contacts.pairs
    body_1, body_2 = (
        {
            "contact_length": pairs.contact_length,
            "youngs_modulus": body.youngs_modulus,
            "poisson_ratio": body.poisson_ratio,
        }
        for body in (contacts.driving, contacts.driven)
    )
    as_roller = roller_secant_compliance(radius=pairs.radius_2, half_width=half_width, **body_2)
    as_ring = ring_secant_compliance(
        wall_thickness=contacts.ring_wall_thickness, half_width=half_width, **body_2
    )
    secant = roller_secant_compliance(radius=pairs.radius_1, half_width=half_width, **body_1) + xp.where(
        pairs.sign > 0.0, as_roller, as_ring
    )
    bend = logarithmic_compliance(**body_1) + logarithmic_compliance(**body_2)
    return NormalSprings(secant_compliance=secant, incremental_compliance=secant - bend)


def with_crowns(springs: NormalSprings, *, contacts: JointContacts, rest_force: Array) -> NormalSprings:
    """Normal springs of even contacts with what the crowns of their rollers add."""
    if contacts.crown_curvature is None:
        return springs
    lines = crowned_lines(
        pairs=contacts.pairs,
        crown_curvature=contacts.crown_curvature,
        logarithmic=contacts.logarithmic,
    )
    crowns = crowned_springs(lines=lines, rest_force=rest_force)
    return NormalSprings(springs.secant_compliance, springs.incremental_compliance, crowns)


@traced_once  # traced once for all states of the contacts
def rough_joint_contacts(
    *, contacts: JointContacts, normal_force: Array, tangential_force: Array, lines: CrownedLine | None = None
) -> RoughContact:
    """The fractal contact law at the contacts of a joint under forces of shape (contacts, ...) [N].

    ``lines``: loads along crowned contacts, where they are known already.
    """
    lines = contacts.loads_along(normal_force) if lines is None else lines
    if lines is not None:
        return _rough_crowned(contacts, lines, normal_force, tangential_force)
    factor = contact_factors(
        pairs=contacts.pairs, model=contacts.contact_factor_model, normal_force=normal_force
    )
    return rough_contacts(
        pairs=contacts.pairs,
        contact_factor=factor,
        normal_force=normal_force,
        tangential_force=tangential_force,
    )


def _rough_crowned(
    contacts: JointContacts, lines: CrownedLine, normal_force: Array, tangential_force: Array
) -> RoughContact:
    slices = rough_slices(
        pairs=contacts.pairs,
        model=contacts.contact_factor_model,
        lines=lines,
        normal_force=normal_force,
        tangential_force=tangential_force,
    )
    return contact_of_slices(slices=slices, lines=lines)


def loaded_contacts(
    *, contacts: JointContacts, normal_force: Array, tangential_force: Array
) -> LoadedContacts:
    """Strips, spots and stiffnesses of the contacts of a joint under their forces."""
    touching = normal_force > 0.0
    width = contacts.pairs.half_width(normal_force)
    springs = bulk_springs(contacts=contacts, half_width=width)
    lines = contacts.loads_along(normal_force)
    rough = rough_joint_contacts(
        contacts=contacts, normal_force=normal_force, tangential_force=tangential_force, lines=lines
    )
    crown: CrownCompliance | None = None
    friction = contacts.pairs.friction_coefficient * xp.where(touching, normal_force, 1.0)
    traction = xp.where(touching, xp.abs(tangential_force) / friction, 1.0)
    bulk_normal = xp.where(touching, 1.0 / springs.incremental_compliance, 0.0)
    bulk_tangential = bulk_tangential_stiffness(
        normal_compliance=springs.incremental_compliance,
        logarithmic_compliance=springs.secant_compliance - springs.incremental_compliance,
        normal_force=normal_force,
        tangential_force=xp.abs(tangential_force),
        friction_coefficient=contacts.pairs.friction_coefficient,
    )
    if contacts.crown_curvature is not None:
        crown = crown_compliances(
            pairs=contacts.pairs,
            crown_curvature=contacts.crown_curvature,
            driving=contacts.driving,
            driven=contacts.driven,
            normal_force=normal_force,
            tangential_force=tangential_force,
            logarithmic=contacts.logarithmic,
        )
        bulk_normal = bulk_normal / (1.0 + bulk_normal * crown.normal)
        bulk_tangential = bulk_tangential / (1.0 + bulk_tangential * crown.tangential)
    return LoadedContacts(
        half_width=xp.where(touching, width, 0.0),
        traction=xp.where(traction < 1.0, traction, 1.0),
        rough=rough,
        interfaces=Interface(
            asperity_normal=rough.normal_stiffness,
            asperity_tangential=rough.tangential_stiffness,
            bulk_normal=bulk_normal,
            bulk_tangential=bulk_tangential,
        ),
        lines=lines,
        crown=crown,
    )


def closure_springs(*, contacts: JointContacts, rest_force: Array, model: ClosureSprings) -> NormalSprings:
    """Normal springs of the elastic closure around the state at rest, shape (contacts, ...) [m/N]."""
    bulk = with_crowns(
        bulk_springs(contacts=contacts, half_width=contacts.pairs.half_width(rest_force)),
        contacts=contacts,
        rest_force=rest_force,
    )
    if model == "bulk":
        return bulk
    asperities = (
        1.0
        / rough_joint_contacts(
            contacts=contacts, normal_force=rest_force, tangential_force=xp.zeros_like(rest_force)
        ).normal_stiffness
    )
    return NormalSprings(
        secant_compliance=bulk.secant_compliance + asperities,
        incremental_compliance=bulk.incremental_compliance + asperities,
        crowns=bulk.crowns,
    )
