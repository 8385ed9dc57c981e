"""The springs of a joint about its output torques, and the creep of its contacts there: what its vibrations need."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from asperity.drive.layout.drive import driving_sense
from asperity.drive.state.state import STATE_TOLERANCE, ContactLaws, DriveState, surface_speeds
from asperity.drive.state.states import standing_state
from asperity.drive.stiffness.network import SpringLaws
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, map_over
from asperity.engine.derivatives import value_and_slope
from asperity.joint.assembled import Pressed
from asperity.joint.bores import PinLoads, pin_loads
from asperity.joint.description import Joint
from asperity.joint.laws import creep_under
from asperity.joint.loading_cam import pressed_at, turned_cam, with_its_cam
from asperity.joint.machine import JointMachine, joint_machine
from asperity.joint.solve import Solution
from asperity.joint.stiffness import loaded_stiffness, working_springs
from asperity.standing.over_torque import (
    at_torques,
    rolling_with_its_torque,
    slope_of_lost_speed,
    with_its_torque,
)
from asperity.types import Array


class SpringsOverTorque(NamedTuple):
    """A joint about its output torques, along the first axis. SI units; nan where it has no such state.

    ``stiffness``: of the assembly at the output [N·m/rad]; ``cam_compliance``: of its loading cam there [rad/(N·m)];
    ``springs``: all springs of the joint that stands. Of the joint that rolls: ``lost_speed_slope``, slope of the lost
    share of the output speed over the torque [1/(N·m)]; ``creep_by_normal`` and ``creep_by_tangential``, slopes of the
    speeds at which the surfaces creep over the forces of their contacts, counter-clockwise as in
    :class:`asperity.drive.state.state.DriveState`, shape (torques, contacts) [m/(N·s)].
    """

    stiffness: Array
    cam_compliance: Array
    springs: SpringLaws
    lost_speed_slope: Array
    creep_by_normal: Array
    creep_by_tangential: Array


def springs_over_torque(joint: Joint, torques: np.ndarray) -> SpringsOverTorque:
    """The springs and the creep of a joint about output torques of either sign [N·m], as NumPy arrays."""
    found: SpringsOverTorque = at_torques(springs_of_assembled, joint, torques)
    return found


def springs_of_assembled(machine: JointMachine, without_torque: Pressed, torques: Array) -> SpringsOverTorque:
    """The same of a joint that is assembled."""
    pressed, unloaded = pressed_at(machine, without_torque), with_its_torque(machine)
    rolls, sense = rolling_with_its_torque(machine), driving_sense(machine.drive)

    def at(torque: Array) -> SpringsOverTorque:
        laws, rest = pressed(torque)
        load = dataclasses.replace(unloaded, output_torque=torque)
        state = standing_state(drive=machine.drive, laws=laws, rest=rest, load=load)
        forces = (state.normal, sense * state.tangential, state.slides, pin_loads(state, rest))
        cam = turned_cam(machine, without_torque.rest, rest)
        assembly = with_its_cam(loaded_stiffness(machine, *forces).assembly, cam)
        solved = state.residual < STATE_TOLERANCE
        slope, rolling = slope_of_lost_speed(machine, pressed, rolls, torque)
        known = xp.where(rolling.residual < STATE_TOLERANCE, 1.0, xp.nan)
        by_normal, by_tangential = _creep_slopes(machine, rolling)
        return SpringsOverTorque(
            stiffness=xp.where(solved, xp.asarray(assembly.stiffness.output), xp.nan),
            cam_compliance=xp.zeros(()) if cam is None else xp.asarray(cam.compliance),
            springs=working_springs(machine, *forces),
            lost_speed_slope=slope,
            creep_by_normal=known * by_normal,
            creep_by_tangential=known * by_tangential,
        )

    return map_over(at, torques)


def springs_of_solution(joint: Joint, solution: Solution) -> SpringLaws:
    """All springs of a joint that is solved, standing under its torque, as NumPy arrays."""
    result, standing = solution.result, solution.states.standing
    forces = (
        result.forces.normal,
        result.forces.tangential,
        standing.slides,
        pin_loads(standing, result.pressed),
    )
    found: SpringLaws = at_once(_of_forces, as_numbers(joint), solution.laws, *forces)
    return found


def _of_forces(
    joint: Joint, laws: ContactLaws, normal: Array, tangential: Array, slides: Array, pins: PinLoads
) -> SpringLaws:
    """The springs under known forces."""
    return working_springs(joint_machine(joint, laws.rims), normal, tangential, slides, pins)


def _creep_slopes(machine: JointMachine, rolling: DriveState) -> tuple[Array, Array]:
    """Slopes of the speeds of creep by the normal and by the tangential forces, shape (contacts,) [m/(N·s)]."""
    law = creep_under(machine)
    one, two = surface_speeds(drive=machine.drive, speed=rolling.speed * machine.joint.input_speed)

    def creeps(normal: Array, tangential: Array) -> Array:
        return law(normal, tangential).creepage

    forces, ones = (rolling.normal, rolling.tangential), xp.ones_like(rolling.normal)
    _, by_normal = value_and_slope(creeps, forces, (ones, 0.0 * ones))
    _, by_tangential = value_and_slope(creeps, forces, (0.0 * ones, ones))
    mean = 0.5 * (one + two)
    return mean * by_normal, mean * by_tangential
