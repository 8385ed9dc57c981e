"""A joint with a planar drive that turns under many torques and speeds."""

from __future__ import annotations

import jax
from jax import Array

from asperity.drive.state.state import DriveState
from asperity.joint.description import Joint, joint_contacts
from asperity.joint.laws import contact_laws
from asperity.joint.loading_cam import Pressed
from asperity.rolling.rolling import RollingResult
from asperity.rolling.turning import rolling_at


def rolling_over_loads(joint: Joint, rest: DriveState, torque: Array, input_speed: Array) -> RollingResult:
    """Steady rolling of a joint under torques at speeds.

    Parameters
    ----------
    joint : Joint
        One joint; its own torque and speed do not count.
    rest : DriveState
        Its assembled state without torque.
    torque, input_speed : Array
        Output torques [N·m] and angular velocities of the input [rad/s], shape (points,).

    Returns
    -------
    RollingResult
        The points along the first axis; nan where there is no steady rolling.

    References
    ----------
    Equations (B1) and (M3) of :doc:`/equations`.
    """
    contacts = joint_contacts(joint)
    found: RollingResult = jax.vmap(
        rolling_at(joint, contacts, Pressed(contact_laws(joint, contacts), rest))
    )(torque, input_speed)
    return found
