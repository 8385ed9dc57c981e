"""Creep curves of the contacts of a joint that turns: traction over creepage up to gross slip, for every drive."""

from __future__ import annotations

import dataclasses
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.contact.creep_layer import SLIP_RATIO_RANGE
from asperity.drive.rolling_state import creepages
from asperity.joint.contacts import joint_contacts
from asperity.joint.description import Joint, with_one_rank
from asperity.joint.evaluation import JointResult
from asperity.joint.planar.description import PlanarJoint, planar_contacts
from asperity.joint.planar.evaluation import PlanarResult
from asperity.joint.planar.laws import creep_law
from asperity.joint.rolling_creep import contact_creep

_POINTS = 60


class CreepCurves(NamedTuple):
    """Creep curves of the contacts under their normal forces in rolling.

    Parameters
    ----------
    traction, creepage : Array
        T/N and creepage, without signs, shape (contacts, points) [-].
    """

    traction: Array
    creepage: Array


def creep_curves(joint: Joint | PlanarJoint, result: JointResult | PlanarResult) -> CreepCurves:
    """Creepage of each contact for every traction up to gross slip.

    Parameters
    ----------
    joint : Joint or PlanarJoint
        One joint, without batch axes.
    result : JointResult or PlanarResult
        What it does under its own torque and speed.

    Returns
    -------
    CreepCurves
        With asperities and skew taken at each traction; nan where the joint does not roll.
    """
    numbers: Any = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    normal = np.asarray(result.rolling.normal)
    if isinstance(joint, PlanarJoint):
        return CreepCurves(*jax.tree.map(np.asarray, compile_fast(_planar, numbers, normal)(numbers, normal)))
    numbers = dataclasses.replace(numbers, rolling=dataclasses.replace(numbers.rolling, duty=()))
    law = (numbers, normal, np.asarray(result.interfaces.asperity_normal))
    return CreepCurves(*jax.tree.map(np.asarray, compile_fast(_papers, *law)(*law)))


def _tractions() -> Array:
    """Shares of the friction limit."""
    return jnp.linspace(0.0, SLIP_RATIO_RANGE[1], _POINTS)


def _papers(joint: Joint, normal: Array, asperity_normal_stiffness: Array) -> tuple[Array, Array]:
    share = _tractions()
    curves = with_one_rank(dataclasses.replace(joint, output_torque=joint.output_torque + 0.0 * share))
    contacts = joint_contacts(curves)
    force = jnp.broadcast_to(normal[:, None], (normal.size, share.size))
    tangential = contacts.pairs.friction_coefficient * share * force
    creep = contact_creep(
        contacts=contacts,
        skew=curves.rolling.skew,
        normal_force=force,
        tangential_force=tangential,
        asperity_normal_stiffness=asperity_normal_stiffness[:, None],
    )
    return tangential / force, creepages(law=creep.law, normal=force, tangential=tangential)


def _planar(joint: PlanarJoint, normal: Array) -> tuple[Array, Array]:
    contacts = planar_contacts(joint)

    def at(share: Array) -> tuple[Array, Array]:
        tangential = jnp.asarray(contacts.pairs.friction_coefficient) * share * normal
        law = creep_law(joint, contacts, normal, tangential).law
        return tangential / normal, creepages(law=law, normal=normal, tangential=tangential)

    traction, creepage = jax.vmap(at, out_axes=-1)(_tractions())
    return traction, creepage
