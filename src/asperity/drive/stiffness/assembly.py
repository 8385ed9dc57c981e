r"""Torsional stiffness with floating bodies (A8): planet and loading rollers free to move in the plane.

In the published series (25) every roller turns about a fixed centre. In the machine only the sun's centre is fixed
(by symmetry); a tangential force on the planet displaces it laterally against the *normal* springs of its wedge.

The assembly is that of :func:`asperity.drive.stiffness.network.network_stiffness`, whose shares add up to 1.
"""

from __future__ import annotations

import equinox as eqx
from jax import Array

from asperity.drive.stiffness.torsional_stiffness import TorsionalStiffness
from asperity.types import Real


class Assembly(eqx.Module):
    """Stiffness of the assembled drive and where its compliance comes from.

    Parameters
    ----------
    stiffness : TorsionalStiffness
        At the sun and at the output [N·m/rad]; 0 where the drive transmits no torque.
    tangential_share : Array
        Share of each contact's tangential spring in the compliance, shape (5, ...) [-].
    normal_share : Array
        Share of each contact's normal spring, which allows the planet to float in its wedge, shape (5, ...) [-].
    ring_bending_share, pin_share, planet_support_share, input_shaft_share, output_shaft_share : Array
        Shares of the structure [-]. All shares add up to 1.
    loading_cam_share : Real, optional
        Share of a loading cam that follows the torque, :func:`asperity.drive.stiffness.loading_cam.with_cam` [-].
    """

    stiffness: TorsionalStiffness
    tangential_share: Array
    normal_share: Array
    ring_bending_share: Array
    pin_share: Array
    planet_support_share: Array
    input_shaft_share: Array
    output_shaft_share: Array
    loading_cam_share: Real = 0.0
