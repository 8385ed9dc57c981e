"""A joint with a planar drive that turns under many torques and speeds."""

from __future__ import annotations

import jax
from jax import Array

from asperity.drive.planar.state import PlanarState
from asperity.joint.planar.description import PlanarJoint, planar_contacts
from asperity.joint.planar.laws import contact_laws
from asperity.joint.planar.loading_cam import Pressed
from asperity.joint.planar.turning import rolling_at
from asperity.joint.rolling import RollingResult


def rolling_over_loads(
    joint: PlanarJoint, rest: PlanarState, torque: Array, input_speed: Array
) -> RollingResult:
    """Steady rolling of a joint under torques at speeds.

    Parameters
    ----------
    joint : PlanarJoint
        One joint; its own torque and speed do not count.
    rest : PlanarState
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
    contacts = planar_contacts(joint)
    found: RollingResult = jax.vmap(
        rolling_at(joint, contacts, Pressed(contact_laws(joint, contacts), rest))
    )(torque, input_speed)
    return found
