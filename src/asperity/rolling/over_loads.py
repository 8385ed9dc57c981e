"""A joint that turns under many torques and speeds."""

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
    """Steady rolling of a joint under torques at speeds."""
    contacts = joint_contacts(joint)
    found: RollingResult = jax.vmap(
        rolling_at(joint, contacts, Pressed(contact_laws(joint, contacts), rest))
    )(torque, input_speed)
    return found
