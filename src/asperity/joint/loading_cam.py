"""The loading cam of a joint: how far it has turned, what that takes from the stiffness, and how a document says so."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import jax.numpy as jnp
from jax import Array

from asperity.drive.assembly import Assembly
from asperity.drive.interference import RestCompliance, incremental_interference, interference
from asperity.drive.loading_cam import cam_angle, cam_compliance, held_cam_stiffness, with_cam
from asperity.drive.mechanism import Mechanism
from asperity.joint.description import Joint
from asperity.types import Real

if TYPE_CHECKING:
    from asperity.joint.planar.evaluation import PlanarResult


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
        "branches": joint.geometry.planet_count,
        "rest_force": drive.rest.normal_force[3:],  # those on the ring
        "preload": drive.preload,
        "force_per_torque": joint.cam_force_per_torque,
    }
    closed = interference(compliance=compliance, preload=drive.preload) - interference(
        compliance=compliance, preload=joint.preload
    )
    softness = incremental_interference(compliance=compliance, preload=drive.preload)
    return cam_angle(**cam, closed=closed[None]), with_cam(
        assembly=assembly, compliance=cam_compliance(**cam, softness=softness[None])
    )


def loading_cam_document(
    result: PlanarResult, *, least_preload: Real, force_per_torque: Real | None
) -> dict[str, Any] | None:
    """What a loading cam does under the torque.

    Parameters
    ----------
    result : PlanarResult
        Result of one joint.
    least_preload : Real
        Its preload without torque [N].
    force_per_torque : Real or None
        What each unit of output torque adds to it [N/(N·m)]; None without a cam.

    Returns
    -------
    dict or None
        Preload, angle at the output, and stiffness with the cam held; None without a cam.
    """
    if force_per_torque is None:
        return None
    return {
        "least_preload_N": least_preload,
        "force_per_torque_N_per_Nm": force_per_torque,
        "angle_rad": result.cam_angle,
        "held_stiffness_output_Nm_per_rad": held_cam_stiffness(result.assembly),
    }
