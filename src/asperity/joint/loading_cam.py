"""The loading cam of a joint: its preload under a torque, and what turning the cam takes."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable

from asperity.drive.state.state import DriveState
from asperity.drive.state.states import rest_forces
from asperity.drive.stiffness.loading_cam import cam_angle, cam_compliance, cam_preload, with_cam
from asperity.drive.stiffness.torsional_stiffness import Assembly
from asperity.engine.arrays import xp
from asperity.engine.derivatives import value_and_slope, without_slopes
from asperity.engine.module import Module
from asperity.implicit import SETTLED, settled_root
from asperity.joint.assembled import Pressed, pressed_around
from asperity.joint.description import Joint
from asperity.joint.machine import JointMachine
from asperity.types import Array, Document, Real


class CamOfJoint(Module):
    """What the cam of a joint does under a torque.

    Parameters
    ----------
    angle : Array
        By how much it has turned at the output, without sign [rad].
    compliance : Array
        Derivative of this angle by the torque [rad/(N·m)].
    pressed : DriveState
        The assembled joint as the cam presses it.
    """

    angle: Array
    compliance: Array
    pressed: DriveState


def pressed_at(machine: JointMachine, without_torque: Pressed) -> Callable[[Real], Pressed]:
    """A joint as its cam presses it under an output torque of either sign [N·m]; equation (I3) of :doc:`/equations`.

    Without a cam it is the same at every torque, as it is assembled under its preload or interference alone.
    """
    joint = machine.joint
    if joint.cam is None:
        return lambda torque: without_torque
    cam, rest = joint.cam, without_torque.rest

    def pressed(torque: Real) -> Pressed:
        preload = cam_preload(
            least_preload=mean_preload(joint, rest.normal),
            force_per_torque=cam.force_per_torque,
            output_torque=torque,
        )
        return _by_force(machine, rest, preload)

    return pressed


def mean_preload(joint: Joint, normal: Array) -> Array:
    """Preload of a joint by the normal forces without torque: of the first contact, the mean of unlike sectors [N]."""
    sectors = 1 if joint.unlike is None else joint.unlike.sectors
    return normal.reshape(sectors, -1)[:, 0].mean()


def _by_force(
    machine: JointMachine, least: DriveState, preload: Array, known: DriveState | None = None
) -> Pressed:
    """A joint that its cam presses with a force, from the state without it; where it is known, with its derivatives.

    Unlike sectors have nan where the laws of their contacts and their forces do not settle.
    """
    joint = machine.joint
    assert joint.cam is not None
    unlike, pattern = joint.unlike, xp.asarray(joint.cam.pattern, dtype=float)

    around = functools.partial(
        pressed_around,
        machine,
        pattern=pattern,
        preload=preload,
        added=least.interference,
        known=known,
        sectors=1 if unlike is None else unlike.sectors,
    )
    if unlike is None:
        return around(preload * rest_forces(drive=joint.drive, pattern=pattern))
    start = least.normal * preload / mean_preload(joint, least.normal) if known is None else known.normal
    start = without_slopes(start)

    def change(ratio: Array) -> Array:
        return around(start * ratio).rest.normal / start - ratio

    ratio = settled_root(change, xp.ones_like(start))
    laws, rest = around(start * ratio)
    known_only = xp.where(xp.max(xp.abs(rest.normal / (start * ratio) - 1.0)) < SETTLED, 1.0, xp.nan)
    return Pressed(
        dataclasses.replace(laws, reference_force=known_only * laws.reference_force),
        dataclasses.replace(rest, normal=known_only * rest.normal, worst=known_only * rest.worst),
    )


def turned_cam(machine: JointMachine, without_torque: DriveState, pressed: DriveState) -> CamOfJoint | None:
    """How far the cam of a joint has turned, and how much it gives way; equation (I3). None without a cam."""
    joint = machine.joint
    if joint.cam is None:
        return None
    preload = mean_preload(joint, pressed.normal)

    def interference(preload: Array) -> Array:
        return _by_force(machine, without_torque, preload, pressed).rest.interference

    _, softness = value_and_slope(interference, (preload,), (xp.ones_like(preload),))
    common: Document = {
        "branches": joint.drive.sectors,
        "rest_force": pressed.normal,
        "preload": preload,
        "force_per_torque": joint.cam.force_per_torque,
    }
    return CamOfJoint(
        angle=cam_angle(**common, closed=pressed.interference - without_torque.interference),
        compliance=cam_compliance(**common, softness=softness),
        pressed=pressed,
    )


def with_its_cam(assembly: Assembly, cam: CamOfJoint | None) -> Assembly:
    """An assembled drive in series with its cam; equation (I3). Unchanged without one."""
    return assembly if cam is None else with_cam(assembly=assembly, compliance=cam.compliance)
