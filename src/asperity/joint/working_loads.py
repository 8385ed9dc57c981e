"""Loads of the structure of a joint in the state in which it works, and speeds of its members."""

from __future__ import annotations

import numpy as np

from asperity.drive.layout.drive import CARRIER, Drive, creeping_speeds, driving_sense
from asperity.drive.layout.unfolding import forces_on_centre
from asperity.drive.state.loads import MemberLoads, drag_pairs, member_loads
from asperity.drive.state.state import Resistance
from asperity.drive.structure.pin_beam import pin_bending_moment, pin_bending_stress
from asperity.engine.arrays import xp
from asperity.engine.control import put
from asperity.joint.description import Joint, track_lengths
from asperity.joint.evaluation import JointResult
from asperity.joint.laws import centrifugal_forces
from asperity.types import Array


def working_loads(joint: Joint, result: JointResult) -> MemberLoads:
    """Loads of the structure of a joint under its torque, equations (M1) and (M3) of :doc:`/equations`; pure.

    Of steady rolling where the input turns, else of the state standing under the torque; nan where there is none.
    """
    known = xp.where(joint.input_speed != 0.0, xp.isfinite(result.rolling.residual), result.solved)
    normal, tangential, resistance = _contact_forces(joint, result)
    loads = member_loads(
        drive=joint.drive,
        normal=normal,
        tangential=tangential,
        body_force=centrifugal_forces(joint, [result.masses[k] for k in range(len(joint.shapes))]),
        resistance=resistance,
    )
    return MemberLoads(*(xp.where(known, load, xp.nan) for load in loads))


def working_forces(joint: Joint, result: JointResult) -> tuple[Array, Array]:
    """Normal forces in the working state, and tangential ones with those of the oil, shape (contacts,) [N]; pure."""
    normal, tangential, resistance = _contact_forces(joint, result)
    return normal, tangential + drag_pairs(joint.drive, resistance.drag)


def _contact_forces(joint: Joint, result: JointResult) -> tuple[Array, Array, Resistance]:
    """Normal and tangential forces in the working state, and what resists rolling, counter-clockwise."""
    turns, sense = joint.input_speed != 0.0, driving_sense(joint.drive)
    moving, standing = result.rolling, result.forces
    return (
        xp.where(turns, moving.normal, standing.normal),
        sense * xp.where(turns, moving.tangential, standing.tangential),
        Resistance(*(sense * xp.where(turns, getattr(moving, name), 0.0) for name in Resistance._fields)),
    )


def loads_without_torque(joint: Joint, result: JointResult) -> MemberLoads:
    """Loads of the structure of an assembled joint without torque; pure."""
    return member_loads(
        drive=joint.drive,
        normal=xp.asarray(result.rest.normal),
        tangential=xp.asarray(result.rest.tangential),
        body_force=xp.zeros((len(joint.drive.floating), 2)),
    )


def forces_on_axis(joint: Joint, normal: Array, tangential: Array, pin_force: Array) -> Array:
    """Sizes of the forces on the members that bearings on the axis carry, shape (members,) [N]: zero for equal sectors.

    Those on axes of their own in the frame too. Of contacts, counter-clockwise, shape (contacts,), and pins, shape
    (pins,) [N]; equation (I4) of :doc:`/equations`.
    """
    drive = joint.drive
    axis_forces = xp.zeros(len(drive.members))
    if joint.unlike is None and not drive.layout.in_frame:
        return axis_forces
    bodies = tuple(body.name for body in drive.bodies if body.on_axis)
    forces = forces_on_centre(
        drive=drive, bodies=bodies, normal=normal, tangential=tangential, pin_force=pin_force
    )
    at = np.array([drive.members.index(name) for name in (*bodies, CARRIER)])
    return put(axis_forces, at, xp.linalg.norm(forces, axis=1))


def member_speeds(joint: Joint, result: JointResult) -> Array:
    """Angular velocities of the members, creep taken off, counter-clockwise, shape (members,) [rad/s]; pure.

    0 where the input stands, nan where the joint does not roll.
    """
    speed = joint.input_speed
    creepage = driving_sense(joint.drive) * xp.sign(speed) * result.rolling.creepage
    unit, _ = creeping_speeds(drive=joint.drive, creepage=creepage)
    return xp.where(speed != 0.0, unit * speed, 0.0)


def pin_speeds(drive: Drive, speeds: Array) -> Array:
    """Sizes of the angular velocities of the rollers on pins relative to the carrier, shape (pins,) [rad/s]."""
    carrier = drive.members.index(CARRIER)
    return abs(speeds[np.array(drive.pinned, dtype=int)] - speeds[carrier])


def pin_bending(joint: Joint, force: Array) -> tuple[Array, Array]:
    """Largest bending moment [N·m] and stress [Pa] of each pin under forces of shape (pins, ...) [N]; pure.

    nan where the pins have no length, or no diameter; equation (L1) of :doc:`/equations`.
    """
    if joint.pin is None:
        unknown = xp.full_like(force, xp.nan)
        return unknown, unknown
    moments = [
        pin_bending_moment(
            force=abs(pin_force),
            free_length=joint.pin.free_length,
            roller_length=sum(track_lengths(joint, body)),
            support=joint.pin.support,
        )
        for pin_force, body in zip(force, joint.drive.pinned, strict=True)
    ]
    moment = xp.stack(moments) if moments else xp.zeros_like(force)
    return moment, pin_bending_stress(moment=moment, diameter=joint.pin.diameter)
