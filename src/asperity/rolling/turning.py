"""A joint that turns: steady rolling at any torque and speed, and what it means."""

from __future__ import annotations

from collections.abc import Callable

from asperity.drive.state.states import loaded_states
from asperity.joint.assembled import Pressed
from asperity.joint.laws import creep_under, rolling_load
from asperity.joint.loading_cam import pressed_at
from asperity.joint.machine import JointMachine
from asperity.rolling.rolling import RollingResult, turning
from asperity.types import Array


def rolling_at(machine: JointMachine, without_torque: Pressed) -> Callable[[Array, Array], RollingResult]:
    """Steady rolling of an assembled joint, of an output torque [N·m] and an angular velocity of the input [rad/s].

    The joint's own torque and speed do not count; equations (B1) and (M3) of :doc:`/equations`.
    """
    pressed = pressed_at(machine, without_torque)

    def rolled(torque: Array, speed: Array) -> RollingResult:
        loaded = machine.under(torque, speed)
        laws, rest = pressed(torque)
        _, rolling = loaded_states(
            drive=machine.drive,
            laws=laws,
            rest=rest,
            load=rolling_load(loaded),
            creep_of=creep_under(loaded),
        )
        return turning(loaded, rolling)

    return rolled
