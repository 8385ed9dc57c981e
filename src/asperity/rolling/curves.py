"""A joint that turns over a range of creepages, torques and speeds: what its pictures show."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from asperity.drive.state.state import ContactLaws
from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, vectorised
from asperity.engine.module import Module
from asperity.joint.assembled import Pressed
from asperity.joint.description import Joint, without_duty
from asperity.joint.evaluation import JointResult
from asperity.joint.laws import creep_law
from asperity.joint.machine import joint_machine
from asperity.rolling.creep import traction_limit
from asperity.rolling.rolling import RollingResult
from asperity.rolling.turning import rolling_at
from asperity.types import Array

_TORQUES, _SPEEDS = 49, 17
_OVER_TORQUE, _OVER_SPEED = 2.0, 1.5  # ends of the axes over the joint's own numbers


class RollingCurves(Module):
    """Curves and map of one joint that turns. SI units; nan where a contact slips or nothing turns.

    ``torque_capacity`` [N·m] is not finite if friction does not limit it. Creep curve of each contact under its normal
    force: T/N and creepage, shape (contacts, n) [-]. Over the output torques ``torque``, shape (m,) [N·m]: drift per
    turn of the output [rad], life in turns and in hours. Map: efficiency over speeds of the input [rad/s] and output
    torques [N·m], shape (k, m - 1) [-]; no speeds where the input stands.
    """

    torque_capacity: Array
    contact_traction: Array
    contact_creepage: Array
    torque: Array
    drift_per_output_turn: Array
    life_turns: Array
    life_hours: Array
    map_torque: Array
    map_speed: Array
    efficiency: Array


def rolling_curves(
    *, joint: Joint, result: JointResult, laws: ContactLaws, torque_capacity: float
) -> RollingCurves:
    """Creep curves of the contacts; drift, life and efficiency of the joint over torque and speed.

    From 0 to the torque capacity [N·m], or to twice the joint's torque if it is infinite or nan; speeds up to 1.5 times
    the joint's.
    """
    numbers: Joint = as_numbers(without_duty(joint))
    output_torque, speed = float(numbers.output_torque), float(numbers.input_speed)
    limited = math.isfinite(torque_capacity)
    towards = np.linspace(0.0, 1.0, _TORQUES)
    # the curves are steep near gross slip
    torque = (
        torque_capacity * towards * (2.0 - towards) if limited else _OVER_TORQUE * output_torque * towards
    )
    speeds = np.linspace(0.0, _OVER_SPEED * speed, _SPEEDS + 1)[1:] if speed > 0.0 else np.zeros(0)
    grid_speed, grid_torque = np.meshgrid(speeds, torque[1:], indexing="ij")
    loads = (
        xp.concatenate([torque, grid_torque.ravel()]),
        xp.concatenate([np.full_like(torque, speed), grid_speed.ravel()]),
    )
    drift, turns, hours, efficiency = at_once(_over_loads, numbers, Pressed(laws, result.rest), *loads)
    traction, creepage = creep_curves(joint, result)
    return RollingCurves(
        torque_capacity=xp.asarray(torque_capacity),
        contact_traction=traction,
        contact_creepage=creepage,
        torque=xp.asarray(torque),
        drift_per_output_turn=drift[:_TORQUES],
        life_turns=turns[:_TORQUES],
        life_hours=hours[:_TORQUES],
        map_torque=xp.asarray(torque[1:]),
        map_speed=xp.asarray(speeds),
        efficiency=efficiency[_TORQUES:].reshape(grid_torque.shape),
    )


def _over_loads(*given: Any) -> tuple[Array, Array, Array, Array]:
    return _shown(rolling_over_loads(*given))


def _shown(rolling: RollingResult) -> tuple[Array, Array, Array, Array]:
    return (
        rolling.drift_per_output_turn,
        rolling.life_turns.drive,
        rolling.life_hours.drive,
        rolling.power.efficiency,
    )


def rolling_over_loads(
    joint: Joint, without_torque: Pressed, torque: Array, input_speed: Array
) -> RollingResult:
    """Steady rolling of a joint under torques at speeds."""
    machine = joint_machine(joint, without_torque.laws.rims)
    return vectorised(rolling_at(machine, without_torque))(torque, input_speed)


_POINTS, _LARGEST_SHARE = 60, 0.98


class CreepCurves(NamedTuple):
    """T/N and creepage of contacts in rolling, without signs, shape (contacts, points) [-]."""

    traction: Array
    creepage: Array


def creep_curves(joint: Joint, result: JointResult) -> CreepCurves:
    """Creepage of each contact for every traction up to gross slip, of a joint without batch axes.

    Asperities and skew are taken at each traction; nan where the joint does not roll.
    """
    numbers: Any = as_numbers(joint)
    normal = np.asarray(result.rolling.normal)
    return CreepCurves(*at_once(_curves, numbers, normal))


def _curves(joint: Joint, normal: Array) -> tuple[Array, Array]:
    machine = joint_machine(joint)
    pairs, without = machine.contacts.pairs, creep_law(machine, normal, xp.zeros_like(normal))
    most = xp.asarray(pairs.friction_coefficient)
    if without.oiled is not None:
        most = traction_limit(pairs=pairs, creep=without, normal_force=normal)

    def at(share: Array) -> tuple[Array, Array]:
        tangential = most * share * normal
        creepage = creep_law(machine, normal, tangential).creepage(normal, tangential)
        return tangential / normal, creepage

    return vectorised(at, out_axis=-1)(xp.linspace(0.0, _LARGEST_SHARE, _POINTS))
