"""A joint whose sectors differ in size: every sector by itself, solved like any other drive."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

from asperity.drive.layout.unfolding import unfolded
from asperity.drive.state.state import DriveState
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.implicit import settled_root
from asperity.joint.assembled import Pressed, assembled
from asperity.joint.description import Joint, UnlikeSectors
from asperity.joint.machine import joint_machine
from asperity.types import Array, Real


class SectorSizes(Module):
    """What differs between the sectors of a joint. SI units.

    Parameters
    ----------
    added : Array
        Interference that the sizes of its bodies add to each contact of each sector, shape (sectors, contacts) [m].
    reference_force : Array
        Normal forces without torque around which the laws of the contacts are taken, shape (sectors, contacts) [N].
    support_stiffness : Real
        Radial stiffness of the bearings of the floating bodies on the axis [N/m].
    """

    added: Array
    reference_force: Array
    support_stiffness: Real


def unfolded_joint(joint: Joint, sizes: SectorSizes, *, sectors: int, floating: tuple[str, ...]) -> Joint:
    """The same joint with every sector by itself, without a duty; equation (I4) of :doc:`/equations`.

    ``floating``: the bodies on the axis whose centres can move.
    """
    sector_drive = joint.drive
    count = len(sector_drive.contacts)
    drive = unfolded(sector_drive, sectors=sectors, floating=floating)
    central = [i for i, body in enumerate(sector_drive.bodies) if body.place == "axis"]
    others = [i for i, body in enumerate(sector_drive.bodies) if body.place != "axis"]
    order = central + sectors * others

    def repeated(values: tuple[Any, ...]) -> tuple[Any, ...]:
        return values * sectors if len(values) == count else values

    held = xp.array([drive.bodies[body].name in floating for body in drive.floating])
    cam = joint.cam
    if cam is not None:
        cam = dataclasses.replace(cam, pattern=repeated(cam.pattern))
    fit = joint.fit
    if fit is not None:
        rollers = fit.warmer_rollers
        if rollers is not None:
            change = xp.tile(rollers.contact_change_per_kelvin, sectors)
            rollers = dataclasses.replace(rollers, contact_change_per_kelvin=change)
        fit = dataclasses.replace(
            fit,
            contact_change_per_kelvin=xp.tile(fit.contact_change_per_kelvin, sectors),
            warmer_rollers=rollers,
        )
    return dataclasses.replace(
        joint,
        drive=drive,
        shapes=tuple(joint.shapes[i] for i in order),
        materials=tuple(joint.materials[i] for i in order),
        wear_coefficients=None
        if joint.wear_coefficients is None
        else tuple(joint.wear_coefficients[i] for i in order),
        surfaces=repeated(joint.surfaces),
        contact_lengths=repeated(joint.contact_lengths),
        friction_coefficients=repeated(joint.friction_coefficients),
        pattern=joint.pattern * sectors,
        rolling=dataclasses.replace(
            joint.rolling,
            duty=(),
            skew=None if joint.rolling.skew is None else repeated(joint.rolling.skew),
            roughness=None if joint.rolling.roughness is None else repeated(joint.rolling.roughness),
        ),
        crown_curvatures=None if joint.crown_curvatures is None else repeated(joint.crown_curvatures),
        logarithmic_crowns=None if joint.logarithmic_crowns is None else repeated(joint.logarithmic_crowns),
        fit=fit,
        cam=cam,
        unlike=UnlikeSectors(
            added=sizes.added.ravel(),
            reference_force=sizes.reference_force.ravel(),
            support_stiffness=xp.where(held, sizes.support_stiffness, 0.0),
            sectors=sectors,
        ),
    )


class SettledSectors(NamedTuple):
    """A joint whose sectors differ, without torque.

    ``sizes`` have the normal forces around which the laws of the contacts are taken; ``equal`` is the assembled joint
    with equal sectors; ``change``, the largest relative difference of its forces from these, not small where they do
    not settle [-].
    """

    sizes: SectorSizes
    without_torque: Pressed
    equal: DriveState
    change: Array


def settled_sectors(
    sectors: int, floating: tuple[str, ...], joint: Joint, sizes: SectorSizes
) -> SettledSectors:
    r"""The laws of the contacts around the forces without torque of sectors that differ; pure.

    .. math:: N_{ref} = N_{ref}^{equal} \, \frac{N}{N^{equal}}

    ``floating``: the bodies on the axis whose centres can move; the forces of the sizes are not read. With equal sizes
    the laws are those of equal sectors. Equation (I4) of :doc:`/equations`.
    """
    alone = assembled(joint_machine(joint))
    base, equal = alone.laws.reference_force, alone.rest.normal

    def around(force: Array) -> Pressed:
        given = dataclasses.replace(sizes, reference_force=force)
        unlike = unfolded_joint(joint, given, sectors=sectors, floating=floating)
        return assembled(joint_machine(unlike))

    def change(ratio: Array) -> Array:
        return around(base * ratio).rest.normal.reshape(ratio.shape) / equal - ratio

    ratio = settled_root(change, xp.ones_like(sizes.added))
    without_torque = around(base * ratio)
    left = xp.max(xp.abs(without_torque.rest.normal.reshape(ratio.shape) / (equal * ratio) - 1.0))
    settled = dataclasses.replace(sizes, reference_force=base * ratio)
    return SettledSectors(settled, without_torque, alone.rest, left)
