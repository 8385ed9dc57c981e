"""A joint that turns: steady rolling at any torque and speed, and what it means."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive, speeds
from asperity.drive.state.state import DriveState, Resistance
from asperity.drive.state.states import loaded_states
from asperity.engine.arrays import xp
from asperity.joint.assembled import Pressed
from asperity.joint.contacts import JointContacts
from asperity.joint.description import Joint, body_masses, places
from asperity.joint.laws import creep_law, creep_under, rolling_load
from asperity.joint.loading_cam import pressed_at
from asperity.rolling.rolling import RollingResult, turning
from asperity.types import Array


def driving_sense(drive: Drive) -> Array:
    """Sign that makes tangential forces and creepages positive where the first body of a contact drives the second.

    +1 or −1, shape (contacts,): the sense in which the first surface moves, seen from the carrier.
    """
    first, _ = places(drive)
    speed = speeds(drive)
    return xp.sign(speed[np.array(first)] - speed[drive.members.index(CARRIER)])


def with_driving_sense(state: DriveState, sense: Array) -> DriveState:
    """A state whose tangential forces, creepages and resistances have the signs of :func:`driving_sense`."""
    signed = ("tangential", "creepage", *Resistance._fields)
    return dataclasses.replace(state, **{name: sense * getattr(state, name) for name in signed})


def rolling_at(
    joint: Joint, contacts: JointContacts, without_torque: Pressed
) -> Callable[[Array, Array], RollingResult]:
    """Steady rolling of an assembled joint, of an output torque [N·m] and an angular velocity of the input [rad/s].

    The joint's own torque and speed do not count; equations (B1) and (M3) of :doc:`/equations`.
    """
    pressed = pressed_at(joint, contacts, without_torque)

    def rolled(torque: Array, speed: Array) -> RollingResult:
        loaded_joint = dataclasses.replace(joint, output_torque=torque, input_speed=speed)
        masses, sense = body_masses(joint), driving_sense(joint.drive)
        laws, rest = pressed(torque)
        _, rolling = loaded_states(
            drive=joint.drive,
            laws=laws,
            rest=rest,
            load=rolling_load(loaded_joint, contacts, masses, torque),
            creep_of=creep_under(joint, contacts),
        )
        creep = creep_law(joint, contacts, rolling.normal, rolling.tangential)
        return turning(loaded_joint, contacts, creep, with_driving_sense(rolling, sense))

    return rolled
