r"""A loading cam: ramps that press the rollers together in proportion to the torque, :math:`N_0 = N_{min} + c\,|T|`.

The work that compresses the contacts comes from the torque, which therefore turns the cam: a drive with a cam is softer
than the same drive with a preload by interference, although its contacts are pressed as much.
"""

from __future__ import annotations

import dataclasses

from asperity.drive.stiffness.torsional_stiffness import Assembly, TorsionalStiffness
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real


class LoadingCam(Module):
    """A loading cam of a drive. SI units.

    Parameters
    ----------
    force_per_torque : Real
        c, normal force of the first contact for a torque at the output [N/(N·m)].
    pattern : tuple of Real
        By how much the cam increases the interference of each contact, over that of the drive [-].
    """

    force_per_torque: Real
    pattern: tuple[Real, ...]


def cam_preload(*, least_preload: Real, force_per_torque: Real, output_torque: Real) -> Array:
    r"""Preload under a torque, :math:`N_0 = N_{min} + c\,|T|`.

    Parameters
    ----------
    least_preload : Real
        N_min, without torque [N].
    force_per_torque : Real
        c, normal force of the first contact for a torque at the output [N/(N·m)].
    output_torque : Real
        T, of either sign [N·m].

    Returns
    -------
    Array
        Normal force N_0 of the first contact at rest [N].

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    return xp.asarray(least_preload + force_per_torque * xp.abs(xp.asarray(output_torque)))


def cam_angle(
    *, branches: Real, rest_force: Array, preload: Real, force_per_torque: Real, closed: Array
) -> Array:
    r"""Angle at the output by which the cam has turned.

    .. math::
        \varphi_c = n\,c\,\sum_k \frac{N_k}{N_0}\,\left[\delta_k(N_0) - \delta_k(N_{min})\right]

    Parameters
    ----------
    branches : Real
        Number n of equal branches [-].
    rest_force : Array
        Normal forces of the contacts of one branch that have an interference, at rest under the preload, shape
        (contacts, ...) [N].
    preload : Real
        N_0 [N].
    force_per_torque : Real
        c [N/(N·m)].
    closed : Array
        By how much the cam has increased their interference, shape (contacts, ...) or one for all, shape (1, ...) [m].

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
    return xp.asarray(branches * force_per_torque * xp.sum(rest_force * closed, axis=0) / preload)


def cam_compliance(
    *, branches: Real, rest_force: Array, preload: Real, force_per_torque: Real, softness: Array
) -> Array:
    r"""Derivative of :func:`cam_angle` by the torque.

    .. math::
        \frac{d\varphi_c}{dT} = n\,c^2\,\sum_k \frac{N_k}{N_0}\,\frac{d\delta_k}{dN_0}

    Parameters
    ----------
    branches, rest_force, preload, force_per_torque
        As of :func:`cam_angle`.
    softness : Array
        Derivative of the interference of these contacts by the preload, shape (contacts, ...) or (1, ...) [m/N].

    Returns
    -------
    Array
        Compliance at the output [rad/(N·m)].

    Notes
    -----
    The ratios of the forces at rest are taken as those of any preload. They are where statics alone decides them.

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    per_force = cam_angle(
        branches=branches,
        rest_force=rest_force,
        preload=preload,
        force_per_torque=force_per_torque,
        closed=softness,
    )
    return xp.asarray(force_per_torque * per_force)


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
    kept = 1.0 / (1.0 + xp.asarray(held.output) * compliance)
    shares = {
        field.name: getattr(assembly, field.name) * kept
        for field in dataclasses.fields(assembly)
        if field.name.endswith("_share")
    }
    shares["loading_cam_share"] = 1.0 - kept
    return dataclasses.replace(
        assembly, stiffness=TorsionalStiffness(input=held.input * kept, output=held.output * kept), **shares
    )


def held_cam_stiffness(assembly: Assembly) -> Array:
    """Stiffness of an assembled drive whose cam does not follow the torque.

    Parameters
    ----------
    assembly : Assembly
        The drive in series with its cam, of :func:`with_cam`.

    Returns
    -------
    Array
        At the output [N·m/rad]; that of the assembly without a cam.

    References
    ----------
    Equation (I3) of :doc:`/equations`.
    """
    return xp.asarray(assembly.stiffness.output / (1.0 - assembly.loading_cam_share))
