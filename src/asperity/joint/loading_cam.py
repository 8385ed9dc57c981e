"""The loading cam of a joint: how far it has turned, what that takes from the stiffness, and how a document says so."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from asperity.drive.loading_cam import held_cam_stiffness
from asperity.types import Real

if TYPE_CHECKING:
    from asperity.joint.planar.evaluation import PlanarResult


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
