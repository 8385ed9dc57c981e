"""A joint whose sectors differ in size: every sector by itself, solved like any other drive."""

from __future__ import annotations

import dataclasses
from typing import Any

import equinox as eqx
import jax.numpy as jnp
from jax import Array

from asperity.drive.layout.unfolding import unfolded
from asperity.drive.state.state import DriveState
from asperity.drive.state.states import state_at_rest
from asperity.joint.description import (
    Joint,
    UnlikeSectors,
    body_masses,
    joint_contacts,
)
from asperity.joint.laws import contact_laws, drive_load
from asperity.types import Real


class SectorSizes(eqx.Module):
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
    """The same joint with every sector by itself.

    Parameters
    ----------
    joint : Joint
        A joint with equal sectors and an interference.
    sizes : SectorSizes
        What differs between them.
    sectors : int
        Their number.
    floating : tuple of str
        Names of the bodies on the axis whose centres can move.

    Returns
    -------
    Joint
        Without a duty.

    References
    ----------
    Equation (I4) of :doc:`/equations`.
    """
    own = joint.drive
    count = len(own.contacts)
    drive = unfolded(own, sectors=sectors, floating=floating)
    central = [i for i, body in enumerate(own.bodies) if body.place == "axis"]
    others = [i for i, body in enumerate(own.bodies) if body.place != "axis"]
    order = central + sectors * others

    def each(values: tuple[Any, ...]) -> tuple[Any, ...]:
        return values * sectors if len(values) == count else values

    held = jnp.array([drive.bodies[body].name in floating for body in drive.floating])
    fit = joint.fit
    if fit is not None:
        fit = dataclasses.replace(
            fit, contact_change_per_kelvin=jnp.tile(fit.contact_change_per_kelvin, sectors)
        )
    return dataclasses.replace(
        joint,
        drive=drive,
        shapes=tuple(joint.shapes[i] for i in order),
        materials=tuple(joint.materials[i] for i in order),
        surfaces=each(joint.surfaces),
        contact_lengths=each(joint.contact_lengths),
        friction_coefficients=each(joint.friction_coefficients),
        pattern=joint.pattern * sectors,
        rolling=dataclasses.replace(
            joint.rolling,
            duty=(),
            skew=None if joint.rolling.skew is None else each(joint.rolling.skew),
            roughness=None if joint.rolling.roughness is None else each(joint.rolling.roughness),
        ),
        crown_curvatures=None if joint.crown_curvatures is None else each(joint.crown_curvatures),
        fit=fit,
        unlike=UnlikeSectors(
            added=sizes.added.ravel(),
            reference_force=sizes.reference_force.ravel(),
            support_stiffness=jnp.where(held, sizes.support_stiffness, 0.0),
            sectors=sectors,
        ),
    )


def reference_force(joint: Joint) -> Array:
    """Normal forces without torque around which the laws of a joint with equal sectors are taken.

    Shape (contacts,) [N].
    """
    return contact_laws(joint, joint_contacts(joint)).reference_force


def assembled_sectors(
    sectors: int, floating: tuple[str, ...], joint: Joint, sizes: SectorSizes
) -> DriveState:
    """The assembled joint without torque."""
    whole = unfolded_joint(joint, sizes, sectors=sectors, floating=floating)
    assert whole.interference is not None
    return state_at_rest(
        drive=whole.drive,
        laws=contact_laws(whole, joint_contacts(whole)),
        pattern=whole.working_pattern,
        interference=whole.interference,
        load=drive_load(whole, body_masses(whole), 0.0),
    )
