"""Torque capacity of a joint: the first limit, standing and in rolling, in both directions."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.body.rim_moments import WIDEST_CONTACT
from asperity.body.shapes import Annulus
from asperity.drive.state.first_limit import FirstLimit, first_limit, slip_ratio
from asperity.drive.state.state import SLIP_TOLERANCE, STATE_TOLERANCE, ContactLaws, DriveState
from asperity.drive.state.states import loaded_state
from asperity.joint.bodies import exact_bodies
from asperity.joint.description import (
    Joint,
    body_masses,
    joint_contacts,
    tracks_of,
)
from asperity.joint.laws import creep_law, creep_under, drive_load
from asperity.joint.loading_cam import Pressed, pressed_at
from asperity.joint.motion import in_motion
from asperity.joint.torque_limits import TorqueCapacity, named_capacity
from asperity.rolling.creep import capacity_loss
from asperity.types import Real

_LIFTED = 1e-12


class TorqueCapacities(NamedTuple):
    """Capacities of a joint.

    Parameters
    ----------
    standing : TorqueCapacity
        At rest, positive and negative torque along the first axis.
    rolling : TorqueCapacity
        In rolling, likewise.
    first_slip : TorqueCapacity or None
        Torques at rest at which the first contact slides, while others may still hold, likewise; the capacity where
        another limit comes first. None where it was not asked for.
    """

    standing: TorqueCapacity
    rolling: TorqueCapacity
    first_slip: TorqueCapacity | None = None


def smaller_sizes(joint: Joint) -> Array:
    """Radius of the smaller roller of each contact, or the wall of its ring or hollow roller if that is less.

    Parameters
    ----------
    joint : Joint
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


def _widths_of_walls(joint: Joint) -> Array | None:
    """Half-widths up to which the compliance of the walls at the contacts is known, shape (contacts,) [m]."""
    if joint.cam is None or joint.body_model == "springs":
        return None
    widths = jnp.full(len(joint.drive.contacts), jnp.inf)
    for member in exact_bodies(joint):
        if isinstance(member.body, Annulus):
            wall = member.body.outer_radius - member.body.inner_radius
            widths = widths.at[np.array(member.contacts)].min(WIDEST_CONTACT * wall)
    return widths


def torque_capacities(
    joint: Joint, rest: DriveState, laws: ContactLaws, *, first_slip: bool = False
) -> TorqueCapacities:
    """Torque capacities of a joint in both directions.

    Parameters
    ----------
    joint : Joint
        One joint.
    rest : DriveState
        Its assembled state without torque.
    laws : ContactLaws
        Laws of its contacts there.
    first_slip : bool, optional
        Whether the torque of the first slip is wanted too.

    Returns
    -------
    TorqueCapacities
        As positive torques [N·m].

    References
    ----------
    Equations (A9) and (M3) of :doc:`/equations`.
    """
    searches = 6 if first_slip else 4
    found = limiting_torques(
        joint,
        rest,
        laws,
        direction=jnp.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])[:searches],
        rolls=jnp.array([False, False, True, True, False, False])[:searches],
        at_first=jnp.arange(searches) >= 4,
    )
    return TorqueCapacities(
        *(jax.tree.map(lambda leaf, k=k: leaf[k : k + 2], found) for k in range(0, searches, 2))
    )


def capacity_both_ways(joint: Joint, rest: DriveState, laws: ContactLaws, *, rolls: bool) -> TorqueCapacity:
    """Torque capacity of a joint in both directions, at rest or in rolling: a half of :func:`torque_capacities`.

    [N·m].
    """
    return limiting_torques(
        joint,
        rest,
        laws,
        direction=jnp.array([1.0, -1.0]),
        rolls=rolls,
        at_first=jnp.zeros(2, dtype=bool),
    )


def limiting_torques(
    joint: Joint,
    rest: DriveState,
    laws: ContactLaws,
    *,
    direction: Array,
    rolls: Array | bool,
    at_first: Array,
) -> TorqueCapacity:
    """Largest output torques that keep every limit: slip, lift-off, widths of strips and walls, a solution.

    Shape (searches,) [N·m].
    """
    joint = in_motion(joint)
    drive, contacts = joint.drive, dataclasses.replace(joint_contacts(joint), rims=laws.rims)
    masses, sizes, walls = body_masses(joint), smaller_sizes(joint), _widths_of_walls(joint)
    friction = contacts.pairs.friction_coefficient
    unloaded = drive_load(joint, masses, 0.0)
    pressed = pressed_at(joint, contacts, Pressed(laws, rest))

    def friction_left(state: DriveState) -> Array:
        """Friction that skew leaves to the joint that turns."""
        lost = capacity_loss(
            creep=creep_law(joint, contacts, state.normal, state.tangential),
            friction_coefficient=friction,
            width_over_radius=contacts.pairs.half_width(state.normal) / contacts.pairs.effective_radius,
        )
        return friction * (1.0 - lost)

    def excesses(torque: Array, at_first: Array, rolls: Array | bool) -> Array:
        load = dataclasses.replace(unloaded, output_torque=torque)
        laws, rest = pressed(torque)
        state = loaded_state(
            drive=drive,
            laws=laws,
            rest=rest,
            load=load,
            rolls=rolls,
            holds=at_first,
            creep_of=creep_under(joint, contacts),
        )
        touching = state.normal > _LIFTED * rest.normal
        available = friction
        if joint.rolling.skew is not None:
            available = jnp.where(rolls, friction_left(state), friction)
        slip = slip_ratio(
            normal_force=state.normal, tangential_force=state.tangential, friction_coefficient=available
        )
        slides = state.slides != 0.0
        width = contacts.largest_half_width(jnp.where(touching, state.normal, rest.normal))
        if joint.cam is not None:
            width = jnp.fmax(width, contacts.largest_half_width(laws.reference_force))
        return jnp.concatenate(
            [
                -jnp.ones(1),  # pins without friction do not lock
                jnp.where(
                    touching,
                    jnp.where(slides, -1.0, slip - 1.0 - SLIP_TOLERANCE),
                    -1.0,
                ),
                _LIFTED - state.normal / rest.normal,
                jnp.where(touching | (joint.cam is not None), width / sizes - 1.0, -1.0),
                *(() if walls is None else (width / walls - 1.0,)),
                jnp.where(state.worst < STATE_TOLERANCE, -1.0, 1.0)[None],
            ]
        )

    orbit = jnp.max(jnp.abs(drive.centres)) + jnp.max(drive.second_radius)
    guess = jnp.min(friction * rest.normal) * orbit * drive.sectors

    def search(sign: Array, at_first: Array, rolls: Array | bool) -> FirstLimit:
        return first_limit(
            excesses=lambda torque: excesses(sign * torque, at_first, rolls), first_guess=guess
        )

    each = (direction, at_first)
    if isinstance(rolls, bool):
        found = jax.lax.map(lambda given: search(given[0], given[1], rolls), each)
    else:
        found = jax.lax.map(lambda given: search(given[0], given[1], given[2]), (*each, rolls))
    return named_capacity(found, contacts=len(drive.contacts), walls=walls is not None)
