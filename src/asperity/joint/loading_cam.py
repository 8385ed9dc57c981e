"""The loading cam of a joint: how far it has turned, and what that takes from the stiffness."""

from __future__ import annotations

from typing import Any

import jax.numpy as jnp
from jax import Array

from asperity.drive.assembly import Assembly
from asperity.drive.interference import RestCompliance
from asperity.drive.loading_cam import cam_angle, cam_compliance, with_cam
from asperity.drive.mechanism import Mechanism
from asperity.joint.description import Joint


def followed_by_cam(
    *, joint: Joint, drive: Mechanism, compliance: RestCompliance, assembly: Assembly
) -> tuple[Array, Assembly]:
    """Angle of the loading cam, and the assembled drive with it.

    Parameters
    ----------
    joint : Joint
        The joint.
    drive : Mechanism
        Its drive under its torque.
    compliance : RestCompliance
        Interference over preload at the drive's preload.
    assembly : Assembly
        The assembled drive with its cam held.

    Returns
    -------
    tuple
        Angle at the output [rad], 0 without a cam; the assembly, unchanged without a cam.

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    if joint.cam_force_per_torque is None:
        return jnp.zeros_like(assembly.stiffness.output), assembly
    cam: dict[str, Any] = {
        "geometry": joint.geometry,
        "rest": drive.rest,
        "compliance": compliance,
        "preload": drive.preload,
        "force_per_torque": joint.cam_force_per_torque,
    }
    turned = cam_angle(**cam, least_preload=joint.preload)
    return turned, with_cam(assembly=assembly, compliance=cam_compliance(**cam))
