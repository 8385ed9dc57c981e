"""A joint that turns: steady rolling at any torque and speed, and what it means."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.arrays import namespace
from asperity.drive.layout.drive import CARRIER, Drive, speeds
from asperity.drive.mechanism import leading_sense
from asperity.drive.state.bearings import friction_moments, friction_power
from asperity.drive.state.rolling_speeds import RollingSpeeds
from asperity.drive.state.state import DriveState, surface_speeds
from asperity.drive.state.states import loaded_states
from asperity.joint.contacts import JointContacts
from asperity.joint.description import Joint, bodies_of_contacts, body_masses, places
from asperity.joint.laws import creep_law, drive_load
from asperity.joint.loading_cam import Pressed, pressed_at
from asperity.rolling.creep import ContactCreep
from asperity.rolling.rolling import RollingResult, turning_result


def driving_sense(drive: Drive) -> Array:
    """Sign that makes tangential forces and creepages positive where the first body of a contact drives the second.

    Parameters
    ----------
    drive : Drive
        The drive.

    Returns
    -------
    Array
        +1 or −1, shape (contacts,) [-]: the sense in which the first surface moves, seen from the carrier.

    References
    ----------
    The sign convention of Zou et al. 2025 for a torque that resists the rotation.
    """
    first, _ = places(drive)
    speed = speeds(drive)
    relative: Array = namespace(speed).sign(speed[np.array(first)] - speed[drive.members.index(CARRIER)])
    return relative


def rolling_at(
    joint: Joint, contacts: JointContacts, without_torque: Pressed
) -> Callable[[Array, Array], RollingResult]:
    """Steady rolling of an assembled joint at any torque and speed.

    Parameters
    ----------
    joint : Joint
        One joint; its own torque and speed do not count.
    contacts : JointContacts
        Its contacts.
    without_torque : Pressed
        The joint as it is assembled.

    Returns
    -------
    callable
        Of an output torque [N·m] and an angular velocity of the input [rad/s].

    References
    ----------
    Equations (B1) and (M3) of :doc:`/equations`.
    """
    pressed = pressed_at(joint, contacts, without_torque)

    def rolled(torque: Array, speed: Array) -> RollingResult:
        there = dataclasses.replace(joint, output_torque=torque, input_speed=speed)
        masses, sense = body_masses(joint), driving_sense(joint.drive)
        laws, rest = pressed(torque)
        _, rolling = loaded_states(
            drive=joint.drive,
            laws=laws,
            rest=rest,
            load=drive_load(there, masses, torque),
            creep_of=lambda normal, tangential: creep_law(joint, contacts, normal, tangential).law,
        )
        creep = creep_law(joint, contacts, rolling.normal, rolling.tangential)
        seen = dataclasses.replace(
            rolling, tangential=sense * rolling.tangential, creepage=sense * rolling.creepage
        )
        return turning(there, contacts, creep, seen)

    return rolled


def turning(joint: Joint, contacts: JointContacts, creep: ContactCreep, state: DriveState) -> RollingResult:
    """The joint that turns, from its rolling state.

    Parameters
    ----------
    joint : Joint
        One joint.
    contacts : JointContacts
        Its contacts.
    creep : ContactCreep
        Their creep around the forces of the rolling drive.
    state : DriveState
        The rolling state, its tangential forces and creepages with the sense of the drive.

    Returns
    -------
    RollingResult
        Drift, losses and life.

    References
    ----------
    Equations (B1) and (M3) of :doc:`/equations`.
    """
    drive = joint.drive
    first, second = places(drive)
    carrier = state.speed[drive.members.index(CARRIER)]
    one, two = surface_speeds(drive=drive, speed=state.speed)
    backwards = jnp.where(jnp.asarray(joint.input_speed) < 0.0, -1.0, 1.0)
    unit = RollingSpeeds(
        driving=one,
        driven=two,
        body=jnp.abs(state.speed[:-1] - carrier),
        output=jnp.abs(state.speed[drive.members.index(drive.output)]),
    )
    return turning_result(
        contacts=contacts,
        conditions=joint.rolling,
        materials=[(joint.materials[a], joint.materials[b]) for a, b in zip(first, second, strict=True)],
        bodies=bodies_of_contacts(joint),
        branches=jnp.asarray(drive.sectors),
        creep=creep,
        state=state,
        unit_speeds=unit,
        input_speed=jnp.abs(jnp.asarray(joint.input_speed)),
        bearing_power=_bearing_power(joint, state),
        output_torque=backwards * jnp.asarray(joint.output_torque),
    )


def _bearing_power(joint: Joint, state: DriveState) -> Array:
    """Power lost in bearings and pins at the joint's speed [W]."""
    if joint.bearings is None:
        return jnp.zeros_like(state.speed_loss)
    sense = leading_sense(rotation=joint.input_speed, output_torque=joint.output_torque)
    moments = friction_moments(
        drive=joint.drive,
        bearings=joint.bearings,
        pin_force=state.pin_force,
        ideal=sense * speeds(joint.drive),
    )
    return friction_power(drive=joint.drive, moments=moments, speed=state.speed * joint.input_speed)
