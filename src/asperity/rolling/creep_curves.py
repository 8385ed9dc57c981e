"""Creep curves of the contacts of a joint that turns: traction over creepage up to gross slip, for every drive."""

from __future__ import annotations

from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.state.creep import creepages
from asperity.joint.description import Joint, joint_contacts
from asperity.joint.evaluation import JointResult
from asperity.joint.laws import creep_law

_POINTS, _LARGEST_SHARE = 60, 0.98


class CreepCurves(NamedTuple):
    """Creep curves of the contacts under their normal forces in rolling.

    Parameters
    ----------
    traction, creepage : Array
        T/N and creepage, without signs, shape (contacts, points) [-].
    """

    traction: Array
    creepage: Array


def creep_curves(joint: Joint, result: JointResult) -> CreepCurves:
    """Creepage of each contact for every traction up to gross slip.

    Parameters
    ----------
    joint : Joint
        One joint, without batch axes.
    result : JointResult
        What it does under its own torque and speed.

    Returns
    -------
    CreepCurves
        With asperities and skew taken at each traction; nan where the joint does not roll.
    """
    numbers: Any = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    normal = np.asarray(result.rolling.normal)
    return CreepCurves(*jax.tree.map(np.asarray, compile_fast(_curves, numbers, normal)(numbers, normal)))


def _tractions() -> Array:
    """Shares of the friction limit."""
    return jnp.linspace(0.0, _LARGEST_SHARE, _POINTS)


def _curves(joint: Joint, normal: Array) -> tuple[Array, Array]:
    contacts = joint_contacts(joint)

    def at(share: Array) -> tuple[Array, Array]:
        tangential = jnp.asarray(contacts.pairs.friction_coefficient) * share * normal
        law = creep_law(joint, contacts, normal, tangential).law
        return tangential / normal, creepages(law=law, normal=normal, tangential=tangential)

    traction, creepage = jax.vmap(at, out_axes=-1)(_tractions())
    return traction, creepage
