"""Lives of the rolling bearings of a joint with a planar drive."""

from __future__ import annotations

import dataclasses

import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.planar.layout import PlanarDrive
from asperity.drive.planar.state import STATE_TOLERANCE, PlanarState
from asperity.drive.planar.states import loaded_states
from asperity.joint.bearing_lives import BearingLives, BearingState, lives_of_bearings
from asperity.joint.description import per_contact
from asperity.joint.planar.description import PlanarJoint, body_masses, planar_contacts
from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint.planar.laws import contact_laws, creep_law, drive_load
from asperity.joint.planar.loading_cam import Pressed, pressed_at
from asperity.joint.planar.working_loads import member_speeds, pin_speeds, working_planar_loads


def planar_bearing_lives(joint: PlanarJoint, result: PlanarResult) -> BearingLives:
    """Lives, static safeties and load ratios of the bearings of a planar drive; pure.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        Its result.

    Returns
    -------
    BearingLives
        Of the rollers on pins, then of input and output, which equal sectors do not load; as
        :func:`asperity.joint.bearing_lives.lives_of_bearings`.

    References
    ----------
    Equation (L2) of :doc:`/equations`.
    """
    drive, under = joint.drive, {}
    if joint.rolling.duty:
        points = per_contact(joint.rolling.duty)
        duty = _under_duty(joint, result.rest, points.output_torque, points.sun_speed)
        under = {"duty": duty, "shares": points.share}
    working = _state(drive, working_planar_loads(joint, result).pin, member_speeds(joint, result))
    rest = jnp.concatenate([jnp.abs(result.rest.pin_force), jnp.zeros(2)])
    return lives_of_bearings(joint.rated_bearings, working=working, rest=rest, **under)


def _state(drive: PlanarDrive, pin_force: Array, speeds: Array) -> BearingState:
    """The bearings of pins, input and output."""
    ends = jnp.array([drive.members.index(drive.input), drive.members.index(drive.output)])
    return BearingState(
        jnp.concatenate([jnp.abs(pin_force), jnp.zeros(2)]),
        jnp.concatenate([pin_speeds(drive, speeds), jnp.abs(speeds[ends])]),
    )


def _under_duty(joint: PlanarJoint, rest: PlanarState, torques: Array, speeds: Array) -> BearingState:
    """The bearings under the loads of the duty, which are the first axis."""
    contacts, masses = planar_contacts(joint), body_masses(joint)
    pressed = pressed_at(joint, contacts, Pressed(contact_laws(joint, contacts), rest))

    def under(torque: Array, speed: Array) -> BearingState:
        laws, rest = pressed(torque)
        both = loaded_states(
            drive=joint.drive,
            laws=laws,
            rest=rest,
            load=drive_load(dataclasses.replace(joint, input_speed=speed), masses, torque),
            creep_of=lambda normal, tangential: creep_law(joint, contacts, normal, tangential).law,
        )
        standing, rolling = (
            jnp.where(each.residual < STATE_TOLERANCE, 1.0, jnp.nan) * each.pin_force for each in both
        )
        turning = jnp.where(both[1].residual < STATE_TOLERANCE, 1.0, jnp.nan) * both[1].speed * speed
        return _state(
            joint.drive,
            jnp.where(speed > 0.0, rolling, standing),
            jnp.where(speed > 0.0, turning, 0.0),
        )

    found: BearingState = jax.vmap(under)(torques, speeds)
    return found
