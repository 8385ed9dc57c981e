"""Torque capacity of a joint: the first limit, standing and in rolling, in both directions."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from asperity.body.rim_moments import WIDEST_CONTACT
from asperity.drive.state.first_limit import (
    FirstLimit,
    first_limit,
    first_limit_of_numbers,
    of_each,
    slip_ratio,
)
from asperity.drive.state.state import SLIP_TOLERANCE, STATE_TOLERANCE, ContactLaws, DriveState
from asperity.drive.state.states import loaded_state
from asperity.engine import trees
from asperity.engine.arrays import xp
from asperity.engine.control import at_once, cond, least_at, map_over
from asperity.joint.assembled import Pressed
from asperity.joint.body_compliance import contact_walls
from asperity.joint.description import Joint, contact_values, tracks_of
from asperity.joint.laws import creep_law, creep_under, rolling_load
from asperity.joint.loading_cam import pressed_at
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.torque_limits import TorqueCapacity, limit_entries, named_capacity
from asperity.rolling.creep import traction_limit
from asperity.types import Array, Real

_LIFTED = 1e-12


class TorqueCapacities(NamedTuple):
    """Capacities of a joint at rest and in rolling, for positive and negative torque along the first axis.

    ``first_slip``: torques at rest at which the first contact slides, while others may still hold; the capacity where
    another limit comes first.
    """

    standing: TorqueCapacity
    rolling: TorqueCapacity
    first_slip: TorqueCapacity


def smaller_sizes(joint: Joint) -> Array:
    """Lengths that a strip must stay below, shape (contacts,) [m].

    Radius of the smaller roller of each contact, or the wall of its ring or hollow roller if that is less.
    """
    sizes: list[Real] = [xp.inf] * len(joint.drive.contacts)
    for number, shape in enumerate(joint.shapes):
        for radius, contacts in tracks_of(joint, number):
            size: Real = radius
            if shape.size is not None:
                size = shape.size if shape.kind == "ring" else radius - 0.5 * shape.size
            for k in contacts:
                sizes[k] = xp.minimum(sizes[k], size)
    return xp.stack([xp.asarray(size) for size in sizes])


def _widths_of_walls(machine: JointMachine) -> tuple[Array, ...]:
    """Half-widths up to which the compliance of the walls at the contacts is known, if any; shape (contacts,) [m]."""
    joint = machine.joint
    if joint.cam is None or joint.body_model == "springs":
        return ()
    widths = xp.full(len(joint.drive.contacts), xp.inf)
    for contacts, wall in contact_walls(machine):
        widths = least_at(widths, np.array(contacts), WIDEST_CONTACT * wall)
    return (widths,)


class UnderTorque(NamedTuple):
    """A joint under a torque, standing or rolling.

    ``pressed`` is the assembled state, as its loading cam presses it under the torque, without a cam as it is without
    torque; ``excesses``, by how much each limit is exceeded, negative where it is kept [-].
    """

    state: DriveState
    pressed: DriveState
    excesses: Array


def loading(
    machine: JointMachine, without_torque: Pressed, *, sliding: Array | None = None
) -> Callable[[Array, Array | bool, Array | bool], UnderTorque]:
    """How a joint under output torques [N·m] keeps its limits, from its assembled state; equations (A9) and (M3).

    Of a torque and the flags of :func:`asperity.drive.state.states.loaded_state`. The limits are slip, lift-off, widths
    of strips and walls, and a solution. ``sliding``: signs of the contacts that slide in rolling, None for none.
    """
    joint, contacts = machine.joint, machine.contacts
    limits = (smaller_sizes(joint), *_widths_of_walls(machine))
    friction = contacts.pairs.friction_coefficient
    unloaded = rolling_load(machine)
    pressed = pressed_at(machine, without_torque)

    def rolling_limit(state: DriveState) -> Array:
        """What skew leaves of friction, or film and asperities bear, in the joint that turns."""
        creep = creep_law(machine, state.normal, state.tangential)
        return traction_limit(pairs=contacts.pairs, creep=creep, normal_force=state.normal)

    def at(torque: Array, rolls: Array | bool, holds: Array | bool) -> UnderTorque:
        laws, rest = pressed(torque)
        state = loaded_state(
            drive=machine.drive,
            laws=laws,
            rest=rest,
            load=dataclasses.replace(unloaded, output_torque=xp.asarray(torque, dtype=float)),
            rolls=rolls,
            holds=holds,
            creep_of=creep_under(machine, searching=True),
            sliding=sliding,
        )
        touching = state.normal > _LIFTED * rest.normal
        available = friction
        if joint.rolling.skew is not None or joint.rolling.lubricant is not None:
            available = cond(rolls, rolling_limit, lambda state: friction + 0.0 * state.normal, state)
        slip = slip_ratio(
            normal_force=state.normal, tangential_force=state.tangential, friction_coefficient=available
        )
        width = contacts.largest_half_width(xp.where(touching, state.normal, rest.normal))
        if joint.cam is not None:
            width = xp.fmax(width, contacts.largest_half_width(laws.reference_force))
        strips, *of_walls = (width / largest - 1.0 for largest in limits)
        strips = xp.where(touching | (joint.cam is not None), strips, -1.0)
        return UnderTorque(state, rest, excesses_of(state, rest.normal, slip, strips, *of_walls))

    return at


def excesses_of(state: DriveState, normal_at_rest: Array, slip: Array, *sizes: Array) -> Array:
    """By how much a state exceeds each limit, in the order of :func:`asperity.joint.torque_limits.named_capacity` [-].

    ``slip``: slip ratios; ``sizes``: excesses of the widths of strips, then of walls, shape (contacts,). Where no state
    was found, slip and widths have no meaning and are not exceeded; a contact that has lifted off, as its force became
    nothing in the search, is the reason why there is none.
    """
    found = state.worst < STATE_TOLERANCE
    touching = state.normal > _LIFTED * normal_at_rest
    begins = xp.where(state.slides != 0.0, -1.0, slip - 1.0 - SLIP_TOLERANCE)
    return xp.concatenate(
        [
            -xp.ones(1),  # pins without friction do not lock
            xp.where(found & touching, begins, -1.0),
            _LIFTED - state.normal / normal_at_rest,
            *(xp.where(found, size, -1.0) for size in sizes),
            xp.where(found, -1.0, 1.0)[None],
        ]
    )


def first_guess(joint: Joint, rest: DriveState) -> Real:
    """The torque at which all contacts of one kind would slip [N·m]."""
    drive = joint.drive
    friction = contact_values(joint, joint.friction_coefficients)
    orbit = xp.max(abs(xp.asarray(drive.centres))) + xp.max(drive.second_radius)
    return xp.min(friction * rest.normal) * orbit * drive.sectors


def limits_of(joint: Joint) -> tuple[tuple[str, int], ...]:
    """Kind and contact of each of the excesses of :class:`UnderTorque`."""
    walls = joint.cam is not None and joint.body_model != "springs"
    return limit_entries(contacts=len(joint.drive.contacts), walls=walls)


def _named(joint: Joint, limit: FirstLimit) -> TorqueCapacity:
    return named_capacity(limit, limits_of(joint), contacts=len(joint.drive.contacts))


def torque_capacities(machine: JointMachine, without_torque: Pressed) -> TorqueCapacities:
    """Torque capacities of one joint, of NumPy's numbers, in both directions, and its first slip, as positive torques.

    [N·m], equations (A9) and (M3) of :doc:`/equations`.
    """
    ways, still = np.array([1.0, -1.0]), np.repeat([False, True], 2)
    standing = searched_torques(machine, without_torque, direction=np.tile(ways, 2), rolls=False, holds=still)
    rolling = searched_torques(machine, without_torque, direction=ways, rolls=True, holds=still[:2])
    with_slip, holding = (trees.map(lambda leaf, at=at: leaf[at], standing) for at in (np.s_[:2], np.s_[2:]))
    return TorqueCapacities(with_slip, rolling, holding)


def searched_torques(
    machine: JointMachine,
    without_torque: Pressed,
    *,
    direction: np.ndarray,
    rolls: bool,
    holds: np.ndarray,
) -> TorqueCapacity:
    """As :func:`limiting_torques`, of one joint of NumPy's numbers: all searches side by side, without derivatives."""

    def search(machine: JointMachine, without_torque: Pressed) -> TorqueCapacity:
        loaded = loading(machine, without_torque)
        each = of_each(
            lambda torque, sign, hold: loaded(sign * torque, rolls, hold).excesses, direction, holds
        )
        guess = xp.full(direction.size, first_guess(machine.joint, without_torque.rest))
        return _named(machine.joint, first_limit_of_numbers(excesses=each, first_guess=guess))

    found: TorqueCapacity = at_once(search, machine, without_torque)
    return found


def capacity_both_ways(joint: Joint, rest: DriveState, laws: ContactLaws, *, rolls: bool) -> TorqueCapacity:
    """Capacity of a joint as positive torques, of positive and of negative ones [N·m], with derivatives; (A9), (M3).

    At rest, or in rolling; ``rest`` is its assembled state without torque, and the laws are those of its contacts
    there.
    """
    both = xp.array([1.0, -1.0])
    machine = joint_machine(joint, laws.rims)
    return limiting_torques(
        machine, Pressed(laws, rest), direction=both, rolls=rolls, holds=xp.zeros(2, dtype=bool)
    )


def limiting_torques(
    machine: JointMachine, without_torque: Pressed, *, direction: Array, rolls: bool, holds: Array
) -> TorqueCapacity:
    """Largest output torques that keep every limit, shape (searches,) [N·m], with derivatives.

    ``direction``: their signs; ``rolls`` and ``holds``, the flags of :func:`loading`.
    """
    loaded = loading(machine, without_torque)
    guess = first_guess(machine.joint, without_torque.rest)

    def search(given: tuple[Array, Array]) -> FirstLimit:
        sign, hold = given
        return first_limit(
            excesses=lambda torque: loaded(sign * torque, rolls, hold).excesses, first_guess=guess
        )

    return _named(machine.joint, map_over(search, (direction, holds)))
