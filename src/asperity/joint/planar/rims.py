"""Strength of the rings and hollow rollers of a planar drive that bend: stresses along their rims."""

from __future__ import annotations

import jax
import jax.numpy as jnp
from jax import Array

from asperity.joint.planar.bodies import exact_bodies
from asperity.joint.planar.description import PlanarJoint, places, tracks_of
from asperity.joint.planar.evaluation import PlanarResult, driving_sense
from asperity.joint.rim_safety import BodyRims, body_rims


def bends(joint: PlanarJoint) -> tuple[bool, ...]:
    """Which bodies have a rim that nothing holds, and one track.

    Parameters
    ----------
    joint : PlanarJoint
        The joint.

    Returns
    -------
    tuple of bool
        In the order of the drive's bodies. The tracks of a stepped roller lie in different planes: what bends it is not
        part of plane elasticity.
    """
    return tuple(
        (shape.kind == "hollow" or (shape.kind == "ring" and shape.support == "free"))
        and len(tracks_of(joint, number)) == 1
        for number, shape in enumerate(joint.shapes)
    )


def planar_rims(joint: PlanarJoint, result: PlanarResult) -> BodyRims:
    """Strength of the bodies that bend; pure.

    Parameters
    ----------
    joint : PlanarJoint
        One joint.
    result : PlanarResult
        Its result.

    Returns
    -------
    BodyRims
        With the axis of the bodies last; nan for the others. Away from the contacts, whose own stresses are judged by
        yield, shakedown and rolling fatigue.

    Notes
    -----
    Exact plane elasticity. Where the input turns, the forces under the torque are those of rolling. The stress of the
    pins' pressure on the bores and of rotation is not included.

    References
    ----------
    Equation (L3) of :doc:`/equations`.
    """
    drive, sense = joint.drive, driving_sense(joint.drive)
    turns = jnp.asarray(joint.input_speed) > 0.0
    moving, standing = result.rolling, result.forces
    working = (
        jnp.where(turns, moving.normal, standing.normal),
        sense * jnp.where(turns, moving.tangential, standing.tangential),
    )
    states = (working, (result.rest.normal, result.rest.tangential))
    width = jnp.asarray(result.diagnostics.hertz_half_width)
    first, _ = places(drive)
    exact = [number for number in range(len(drive.bodies)) if len(tracks_of(joint, number)) == 1]
    members = dict(zip(exact, exact_bodies(joint), strict=True))
    found = []
    for number, acts in enumerate(bends(joint)):
        if not acts:
            continue
        member = members[number]
        signs = tuple(
            1.0 if first[k] != number and drive.contacts[k].internal else -1.0 for k in member.contacts
        )
        found.append(body_rims(member, joint.materials[number], states, width, signs))
    return _in_order(found, bends(joint))


def _in_order(found: list[BodyRims], there: tuple[bool, ...]) -> BodyRims:
    """The bodies that bend in the order of all bodies; nan for the others."""
    at = [number for number, acts in enumerate(there) if acts]
    pair = jnp.full((2, len(there)), jnp.nan)
    one = jnp.full(len(there), jnp.nan)
    empty = BodyRims(pair, pair, pair, pair, one, one)

    def placed(base: Array, *values: Array) -> Array:
        return base.at[..., jnp.array(at)].set(jnp.stack(values, axis=-1)) if values else base

    placed_rims: BodyRims = jax.tree.map(placed, empty, *found)
    return placed_rims
