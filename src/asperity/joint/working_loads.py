"""Loads of a joint's structure in the state in which it works, and the speeds of its bearings."""

from __future__ import annotations

import equinox as eqx
import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.existence import some_contact_slips
from asperity.drive.geometry import triangle
from asperity.drive.mechanism import opposed, rest_state
from asperity.drive.rolling_speeds import rolling_speeds
from asperity.drive.structure_loads import StructureLoads, structure_loads
from asperity.joint.description import Joint, sense_of_rotation
from asperity.joint.evaluation import JointResult
from asperity.types import Real


class BearingSpeeds(eqx.Module):
    """Speeds of the bearings, without signs. SI units; nan where the joint does not roll.

    Parameters
    ----------
    pin : Array
        Of a loading roller relative to the carrier, right and left, shape (2, ...) [rad/s].
    sun, carrier : Array
        Relative to the housing [rad/s].
    """

    pin: Array
    sun: Array
    carrier: Array


def working_forces(joint: Joint, result: JointResult) -> tuple[Array, Array]:
    """Forces of the contacts in the state in which a joint works.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        Its result.

    Returns
    -------
    normal, tangential : Array
        Of the rolling state where the sun turns, else of the state standing under the torque, shape (5, ...) [N];
        nan where a contact slips or the equations are not solved.

    References
    ----------
    :mod:`asperity.drive.force_balance`, :mod:`asperity.drive.rolling_state`.
    """
    turns = jnp.asarray(joint.sun_speed) > 0.0
    forces, rolling = result.forces, result.rolling
    holds = result.solved & ~some_contact_slips(slip_ratio=result.diagnostics.slip_ratio)
    normal, tangential = (
        jnp.where(turns, moving, jnp.where(holds, standing, jnp.nan))
        for moving, standing in ((rolling.normal, forces.normal), (rolling.tangential, forces.tangential))
    )
    return normal, tangential


def working_loads(joint: Joint, result: JointResult) -> StructureLoads:
    """Loads of the structure under the joint's torque.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        Its result.

    Returns
    -------
    StructureLoads
        Under the :func:`working_forces`.

    References
    ----------
    Equation (L1) of :doc:`/equations`.
    """
    return loads_of_forces(joint, *working_forces(joint, result))


def loads_at_rest(joint: Joint) -> StructureLoads:
    """Loads of the structure by the preload alone, without a torque and friction.

    Parameters
    ----------
    joint : Joint
        The joint.

    Returns
    -------
    StructureLoads
        Its pins' forces; no torques but those of friction.

    References
    ----------
    Equations (A3) and (L1) of :doc:`/equations`.
    """
    normal = rest_state(
        geometry=joint.geometry, sides=triangle(joint.geometry), preload=joint.preload
    ).normal_force
    loads = loads_of_forces(joint, normal, jnp.zeros_like(normal))
    free: StructureLoads = eqx.tree_at(lambda each: each.sun_torque, loads, jnp.zeros_like(loads.sun_torque))
    return free


def loads_of_forces(joint: Joint, normal: Array, tangential: Array) -> StructureLoads:
    """Loads of the structure from the forces of the contacts.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    normal, tangential : Array
        Forces of the contacts, shape (5, ...) [N].

    Returns
    -------
    StructureLoads
        Of the drive in this state.

    References
    ----------
    Equation (L1) of :doc:`/equations`.
    """
    return structure_loads(
        geometry=joint.geometry,
        sides=triangle(joint.geometry),
        bearings=opposed(bearings=joint.bearings, sense_of_rotation=sense_of_rotation(joint)),
        normal=normal,
        tangential=tangential,
    )


def bearing_speeds(joint: Joint, result: JointResult) -> BearingSpeeds:
    """Speeds of the bearings of a joint, creep taken off.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.
    result : JointResult
        Its result.

    Returns
    -------
    BearingSpeeds
        0 where the sun stands.

    References
    ----------
    :func:`asperity.drive.rolling_speeds.rolling_speeds`.
    """
    speeds = rolling_speeds(
        geometry=joint.geometry, creepage=result.rolling.creepage, sun_speed=joint.sun_speed
    )
    stands = jnp.asarray(joint.sun_speed) == 0.0

    def still(speed: Real) -> Array:
        return jnp.where(stands, 0.0, speed)

    return jax.tree.map(
        still, BearingSpeeds(speeds.body[2:4], jnp.asarray(joint.sun_speed, dtype=float), speeds.output)
    )


def stacked_speeds(speeds: BearingSpeeds) -> Array:
    """Speeds of the bearings in the order of every bearing axis.

    Parameters
    ----------
    speeds : BearingSpeeds
        From :func:`bearing_speeds`.

    Returns
    -------
    Array
        Shape (4, ...) [rad/s].

    References
    ----------
    :data:`asperity.drive.structure_loads.BEARING_NAMES`.
    """
    return jnp.stack(jnp.broadcast_arrays(*speeds.pin, speeds.sun, speeds.carrier))
