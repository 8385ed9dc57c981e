"""Torque capacity of a joint with a planar drive: the first limit, standing and in rolling, in both directions."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import jax
import jax.numpy as jnp
from jax import Array

from asperity.contact.hertz_line import half_width
from asperity.drive.capacity import FirstLimit, first_limit, slip_ratio
from asperity.drive.planar.state import STATE_TOLERANCE, ContactLaws, PlanarState
from asperity.drive.planar.states import loaded_state
from asperity.joint.capacity import TorqueCapacity, named_capacity
from asperity.joint.planar.description import PlanarJoint, body_masses, planar_contacts, tracks_of
from asperity.joint.planar.laws import creep_law, drive_load
from asperity.types import Real

_LIFTED = 1e-12


class PlanarCapacity(NamedTuple):
    """Capacities of a joint.

    Parameters
    ----------
    standing : TorqueCapacity
        At rest, positive and negative torque along the first axis.
    rolling : TorqueCapacity
        In rolling, likewise.
    """

    standing: TorqueCapacity
    rolling: TorqueCapacity


def smaller_sizes(joint: PlanarJoint) -> Array:
    """Radius of the smaller roller of each contact, or the wall of its ring or hollow roller if that is less.

    Parameters
    ----------
    joint : PlanarJoint
        The joint.

    Returns
    -------
    Array
        Lengths that a strip must stay below, shape (contacts,) [m].
    """
    sizes: list[Real] = [jnp.inf] * len(joint.drive.contacts)
    for number, shape in enumerate(joint.shapes):
        for radius, contacts in tracks_of(joint, number):
            size: Real = radius
            if shape.size is not None:
                size = shape.size if shape.kind == "ring" else radius - 0.5 * shape.size
            for k in contacts:
                sizes[k] = jnp.minimum(sizes[k], size)
    return jnp.stack([jnp.asarray(size) for size in sizes])


def planar_capacity(joint: PlanarJoint, rest: PlanarState, laws: ContactLaws) -> PlanarCapacity:
    """Largest output torque that keeps every limit: slip, lift-off, width of the strips, a solution of the equations.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    rest : PlanarState
        Its assembled state.
    laws : ContactLaws
        Laws of its contacts.

    Returns
    -------
    PlanarCapacity
        As positive torques [N·m].

    Notes
    -----
    Every torque of the search is a state of its own.

    References
    ----------
    Equations (A9) and (M3) of :doc:`/equations`.
    """
    drive, contacts = joint.drive, planar_contacts(joint)
    masses, sizes = body_masses(joint), smaller_sizes(joint)
    friction = contacts.pairs.friction_coefficient
    unloaded = drive_load(joint, masses, 0.0)

    def excesses_of(torque: Array, rolls: Array) -> Array:
        load = dataclasses.replace(unloaded, output_torque=torque)
        state = loaded_state(
            drive=drive,
            laws=laws,
            rest=rest,
            load=load,
            rolls=rolls,
            creep_of=lambda normal, tangential: creep_law(contacts, normal, tangential).law,
        )
        touching = state.normal > _LIFTED * rest.normal
        slip = slip_ratio(
            normal_force=state.normal, tangential_force=state.tangential, friction_coefficient=friction
        )
        width = half_width(
            normal_force=jnp.where(touching, state.normal, rest.normal),
            contact_length=contacts.pairs.contact_length,
            effective_radius=contacts.pairs.effective_radius,
            contact_modulus=contacts.pairs.moduli.contact_modulus,
        )
        return jnp.concatenate(
            [
                -jnp.ones(1),  # pins without friction do not lock
                jnp.where(touching, slip - 1.0, -1.0),
                _LIFTED - state.normal / rest.normal,
                jnp.where(touching, width / sizes - 1.0, -1.0),
                jnp.where(state.worst < STATE_TOLERANCE, -1.0, 1.0)[None],
            ]
        )

    direction = jnp.array([1.0, -1.0, 1.0, -1.0])
    rolls = jnp.array([False, False, True, True])

    def excesses(torque: Array) -> Array:
        return jax.vmap(excesses_of, out_axes=1)(direction * torque, rolls)

    orbit = jnp.max(jnp.abs(drive.centres)) + jnp.max(drive.second_radius)
    guess = jnp.min(friction * rest.normal) * orbit * drive.sectors
    found = first_limit(excesses=excesses, first_guess=jnp.full(4, guess))
    count = len(drive.contacts)
    both = [
        named_capacity(FirstLimit(found.value[part], found.which[part]), contacts=count)
        for part in (slice(0, 2), slice(2, 4))
    ]
    # what stands must not slip either before it rolls
    less = both[0].output_torque < both[1].output_torque
    rolling = dataclasses.replace(
        both[1],
        **{
            name: jnp.where(less, getattr(both[0], name), getattr(both[1], name))
            for name in ("output_torque", "limit", "limiting_contact")
        },
    )
    return PlanarCapacity(both[0], rolling)
