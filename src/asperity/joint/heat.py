"""The heat that a joint makes: its losses in rolling, as its temperatures decide them."""

from __future__ import annotations

from asperity.engine.arrays import xp
from asperity.joint.assembled import assembled
from asperity.joint.description import Joint
from asperity.joint.machine import joint_machine
from asperity.rolling.turning import rolling_at
from asperity.types import Array


def heat_made(joint: Joint) -> Array:
    """Losses of a joint under its torque at its speed [W]; 0 where the input stands, nan where it does not roll."""
    machine = joint_machine(joint)
    speed = xp.asarray(joint.input_speed)
    rolling = rolling_at(machine, assembled(machine))(xp.asarray(joint.output_torque), speed)
    return xp.where(speed == 0.0, 0.0, rolling.power.loss)
