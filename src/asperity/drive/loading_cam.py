r"""A loading cam: ramps that press the rollers together in proportion to the torque, :math:`N_0 = N_{min} + c\,|T|`.

The work that compresses the contacts comes from the torque, which therefore turns the cam: a drive with a cam is softer
than the same drive with a preload by interference, although its contacts are pressed as much.
"""

from __future__ import annotations

import dataclasses

import jax.numpy as jnp
from jax import Array

from asperity.drive.assembly import Assembly
from asperity.drive.geometry import DriveGeometry
from asperity.drive.interference import RestCompliance, incremental_interference, interference
from asperity.drive.mechanism import RestState
from asperity.drive.torsional_stiffness import TorsionalStiffness
from asperity.types import Real


def cam_preload(*, least_preload: Real, force_per_torque: Real, output_torque: Real) -> Array:
    r"""Preload under a torque, :math:`N_0 = N_{min} + c\,|T|`.

    Parameters
    ----------
    least_preload : Real
        N_min, without torque [N].
    force_per_torque : Real
        c, normal force between sun and planet for a torque at the output [N/(N·m)].
    output_torque : Real
        T, of either sign [N·m].

    Returns
    -------
    Array
        Normal force N_0 between sun and planet at rest [N].

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    return jnp.asarray(least_preload + force_per_torque * jnp.abs(jnp.asarray(output_torque)))


def _ring_force_per_torque(geometry: DriveGeometry, rest: RestState, preload: Real, cam: Real) -> Array:
    """Force on the ring's interference, over all branches, for a torque at the output [1/m]."""
    on_ring = (rest.normal_force[3] + rest.normal_force[4]) / preload
    return jnp.asarray(geometry.planet_count * on_ring * cam)


def cam_angle(
    *,
    geometry: DriveGeometry,
    rest: RestState,
    compliance: RestCompliance,
    least_preload: Real,
    preload: Real,
    force_per_torque: Real,
) -> Array:
    r"""Angle at the output by which the cam has turned.

    .. math::
        \varphi_c = n\,c\,\frac{N_{wro} + N_{wlo}}{N_0}\,\left[\delta(N_0) - \delta(N_{min})\right]

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    rest : RestState
        Its forces at rest under the preload [N].
    compliance : RestCompliance
        Interference over preload.
    least_preload, preload : Real
        N_min and N_0 [N].
    force_per_torque : Real
        c [N/(N·m)].

    Returns
    -------
    Array
        Angle [rad], without sign.

    Notes
    -----
    A cam without friction: what its torque does on the angle is the work that its force does on the interference,
    wherever in the drive it sits. Friction of the ramps adds to the angle on loading and makes it lag on unloading.

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    lever = _ring_force_per_torque(geometry, rest, preload, force_per_torque)
    closed = interference(compliance=compliance, preload=preload) - interference(
        compliance=compliance, preload=least_preload
    )
    return jnp.asarray(lever * closed)


def cam_compliance(
    *,
    geometry: DriveGeometry,
    rest: RestState,
    compliance: RestCompliance,
    preload: Real,
    force_per_torque: Real,
) -> Array:
    r"""Derivative of :func:`cam_angle` by the torque.

    .. math::
        \frac{d\varphi_c}{dT} = n\,c^2\,\frac{N_{wro} + N_{wlo}}{N_0}\,\frac{d\delta}{dN_0}

    Parameters
    ----------
    geometry : DriveGeometry
        The drive.
    rest : RestState
        Its forces at rest under the preload [N].
    compliance : RestCompliance
        Interference over preload.
    preload : Real
        N_0 [N].
    force_per_torque : Real
        c [N/(N·m)].

    Returns
    -------
    Array
        Compliance at the output [rad/(N·m)].

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    lever = _ring_force_per_torque(geometry, rest, preload, force_per_torque)
    softness = incremental_interference(compliance=compliance, preload=preload)
    return jnp.asarray(lever * force_per_torque * softness)


def with_cam(*, assembly: Assembly, compliance: Real) -> Assembly:
    r"""An assembled drive in series with the compliance of its cam.

    .. math:: \frac1K = \frac1{K_0} + \frac{d\varphi_c}{dT}

    Parameters
    ----------
    assembly : Assembly
        The drive with its cam held.
    compliance : Real
        Of the cam at the output, :func:`cam_compliance` [rad/(N·m)].

    Returns
    -------
    Assembly
        Stiffness and shares with the cam.

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    held = assembly.stiffness
    kept = 1.0 / (1.0 + jnp.asarray(held.output) * compliance)
    shares = {
        field.name: getattr(assembly, field.name) * kept
        for field in dataclasses.fields(assembly)
        if field.name.endswith("_share")
    }
    shares["loading_cam_share"] = 1.0 - kept
    return dataclasses.replace(
        assembly,
        stiffness=TorsionalStiffness(sun=held.sun * kept, output=held.output * kept),
        **shares,
    )
