"""Notes on a solved joint that can exist, but whose numbers lie outside what the model or the practice knows."""

from __future__ import annotations

import dataclasses
import math

import equinox as eqx
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.assembly import assembly_stiffness
from asperity.drive.geometry import CONTACT_NAMES, triangle
from asperity.drive.ring_bending import thin_ring_compliance
from asperity.joint.contact_notes import Note, contact_notes, crown_notes
from asperity.joint.contacts import JointContacts, joint_contacts, loaded_contacts
from asperity.joint.description import Joint
from asperity.joint.elastic_bodies import AssemblySprings, assembly_springs
from asperity.joint.evaluation import JointResult
from asperity.types import Real
from asperity.units import format_quantity

#: Loss of assembled stiffness from which the bending of a ring is worth a warning [-].
RING_BENDING_LIMIT = 0.05


class CheckedSizes(eqx.Module):
    """The numbers of a joint that :func:`plausibility` looks at. SI units.

    Parameters
    ----------
    contact_length, friction_coefficient, smaller_radius, effective_radius : Array
        Of the contacts, shape (5,) [m], [-], [m], [m].
    crown_curvature : Array or None
        Of the contacts, shape (5,) [1/m]; None where no roller is crowned.
    ring_bending_stiffness : Array
        Of a ring that carries itself, under each loading roller, by thin-ring theory [N/m].
    bent_stiffness : Array
        Assembled torsional stiffness of a joint whose ring carries itself [N·m/rad]: with that spring where the bodies
        are springs, otherwise with a ring of free rim; nan where the joint states what holds the ring.
    """

    contact_length: Array
    friction_coefficient: Array
    smaller_radius: Array
    effective_radius: Array
    ring_bending_stiffness: Array
    bent_stiffness: Array
    crown_curvature: Array | None = None


def checked_sizes(joint: Joint, result: JointResult) -> CheckedSizes:
    """What :func:`plausibility` needs beside the result: pure, compiled with the joint's solution.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.

    Returns
    -------
    CheckedSizes
        Sizes of the contacts, and the assembled stiffness with a ring that carries itself.
    """
    contacts = joint_contacts(joint)
    pairs = contacts.pairs
    shape = (len(CONTACT_NAMES),)
    length = jnp.broadcast_to(pairs.contact_length, shape)
    sides = triangle(joint.geometry)
    bending = thin_ring_compliance(
        geometry=joint.geometry,
        sides=sides,
        wall_thickness=joint.ring_wall_thickness,
        length=jnp.max(length[3:]),
        youngs_modulus=joint.bodies.ring.youngs_modulus,
    )
    spring = 1.0 / bending.opposed
    return CheckedSizes(
        contact_length=length,
        friction_coefficient=jnp.broadcast_to(pairs.friction_coefficient, shape),
        smaller_radius=jnp.broadcast_to(jnp.minimum(pairs.radius_1, pairs.radius_2), shape),
        effective_radius=jnp.broadcast_to(pairs.effective_radius, shape),
        ring_bending_stiffness=jnp.asarray(spring),
        bent_stiffness=_bent_stiffness(joint, contacts, result, spring),
        crown_curvature=contacts.crown_curvature,
    )


def _bent_stiffness(
    joint: Joint, contacts: JointContacts, result: JointResult, ring_bending_stiffness: Real
) -> Array:
    """Assembled stiffness at the output with a ring that carries itself; nan if the joint states what holds it."""
    if joint.ring_support is not None:
        return jnp.asarray(jnp.nan)
    structure, sides, forces = joint.structure, triangle(joint.geometry), result.forces
    springs = AssemblySprings(
        jnp.asarray(result.interfaces.normal), jnp.asarray(result.interfaces.tangential), None
    )
    if joint.body_model == "springs":
        structure = dataclasses.replace(structure, ring_bending_stiffness=ring_bending_stiffness)
    else:
        springs = assembly_springs(
            joint=dataclasses.replace(joint, ring_support="free"),
            sides=sides,
            contacts=contacts,
            loaded=loaded_contacts(
                contacts=contacts, normal_force=forces.normal, tangential_force=forces.tangential
            ),
        )
    bent = assembly_stiffness(
        geometry=joint.geometry,
        sides=sides,
        normal_stiffness=springs.normal_stiffness,
        tangential_stiffness=springs.tangential_stiffness,
        structure=structure,
        coupling=springs.coupling,
    )
    return jnp.asarray(bent.stiffness.output)


def plausibility(joint: Joint, result: JointResult, sizes: CheckedSizes) -> tuple[Note, ...]:
    """Notes on the ring's wall, the friction, the lengths, the oil film, and the sizes for which lambda was made.

    Parameters
    ----------
    joint : Joint
        One joint.
    result : JointResult
        Its result.
    sizes : CheckedSizes
        Its sizes, as NumPy arrays.

    Returns
    -------
    tuple of Note
        One for the drive or for each contact; those that are not ok are warnings.
    """
    lengths, effective = sizes.contact_length, sizes.effective_radius
    films = np.asarray(result.rolling.film_ratio)
    notes = list(_ring_bending(joint, result, sizes))
    for index, name in enumerate(CONTACT_NAMES):
        notes += contact_notes(
            name,
            friction_coefficient=float(sizes.friction_coefficient[index]),
            contact_length=float(lengths[index]),
            smaller_radius=float(sizes.smaller_radius[index]),
            effective_radius=float(effective[index]),
            film_ratio=float(films[index]),
            contact_factor_model=joint.contact_factor_model,
        )
        if sizes.crown_curvature is not None and sizes.crown_curvature[index] > 0.0:
            notes += crown_notes(name, result.diagnostics, index)
    return tuple(notes)


def _ring_bending(joint: Joint, result: JointResult, sizes: CheckedSizes) -> tuple[Note, ...]:
    """What a ring that carries itself would lose, where the joint does not say what holds it."""
    stated = joint.ring_support is not None or not math.isinf(float(joint.structure.ring_bending_stiffness))
    if stated or float(joint.geometry.planet_count) < 2.0:
        return ()
    held, bent = float(result.assembly.stiffness.output), float(sizes.bent_stiffness)
    if not held > 0.0:
        return ()
    loss = 1.0 - bent / held
    stiffness, bent_to, held_at = (
        format_quantity(value, unit, 3)
        for value, unit in (
            (float(sizes.ring_bending_stiffness), "N/um"),
            (bent, "N*m/rad"),
            (held, "N*m/rad"),
        )
    )
    if joint.body_model == "exact":
        means = "ring_support is not stated, and a rigid housing is assumed to hold the ring. In a ring that"
        remedy = "state ring_support, or hold the ring in a rigid housing"
    else:
        means = (
            "the springs are those of a ring in a rigid housing. By thin-ring theory, with a ring_bending_stiffness of "
            f"about {stiffness} under each loading roller, in a ring that"
        )
        remedy = 'choose bodies = "exact", give ring_bending_stiffness, or hold the ring in a rigid housing'
    ok = loss <= RING_BENDING_LIMIT
    return (
        Note(
            "ring_bending_loss",
            "stiffness lost by bending of the ring",
            None,
            loss,
            RING_BENDING_LIMIT,
            ok,
            "accuracy",
            f"{means} carries itself the assembled stiffness would be {bent_to} instead of {held_at}",
            None if ok else remedy,
        ),
    )
