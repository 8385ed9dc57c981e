"""The largest torque under which a joint can roll."""

from __future__ import annotations

import dataclasses

import jax
import jax.numpy as jnp
from jax import Array

from asperity.drive.capacity import first_limit, slip_ratio
from asperity.drive.force_balance import BALANCE_TOLERANCE, force_balance
from asperity.drive.rolling_state import ROLLING_TOLERANCE, rolling_state
from asperity.joint.contacts import joint_contacts, rough_joint_contacts
from asperity.joint.description import Joint, with_one_rank
from asperity.joint.evaluation import drive_under, mechanism
from asperity.joint.rolling_creep import capacity_loss, contact_creep
from asperity.types import Real


def rolling_torque_capacity(joint: Joint, *, direction: Real) -> Array:
    r"""Largest output torque in a direction under which a joint has a steady rolling state.

    .. math:: \max_i \frac{T_i}{(1 - \lambda_i) \mu_i N_i} = 1

    with the forces of :func:`asperity.drive.rolling_state.rolling_state`, and the share λ of the friction that skew
    takes, of :func:`asperity.joint.rolling_creep.capacity_loss`.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes; its own output torque is not used.
    direction : Real
        +1 for positive torques, −1 for negative ones [-].

    Returns
    -------
    Array
        The torque, positive [N·m]; 0 where the joint never rolls, infinite where friction does not limit it.

    Notes
    -----
    Friction and the balance of forces are the limits; the capacity at rest, :func:`asperity.joint.capacity`, has
    others, and the smaller of the two holds. Beyond the capacity a skewed joint still turns, while a contact slips as a
    whole: its drift is many times larger. The derivatives are implicit.

    References
    ----------
    Equations (A9) and (B3) of :doc:`/equations`.
    """
    joint = with_one_rank(joint)
    drive = mechanism(dataclasses.replace(joint, output_torque=jnp.asarray(direction)))
    contacts = joint_contacts(joint)
    friction = contacts.pairs.friction_coefficient

    def excesses(torque: Array) -> Array:
        loaded = drive_under(joint, drive, direction * torque)
        forces = force_balance(mechanism=loaded, output_torque=direction * torque)
        rough = rough_joint_contacts(
            contacts=contacts,
            normal_force=forces.normal,
            tangential_force=jnp.zeros_like(forces.tangential),
        )
        creep = contact_creep(
            contacts=contacts,
            skew=joint.rolling.skew,
            normal_force=forces.normal,
            tangential_force=forces.tangential,
            asperity_normal_stiffness=rough.normal_stiffness,
        )
        state = rolling_state(mechanism=loaded, standing=forces, law=creep.law)
        lost = capacity_loss(
            creep=creep,
            friction_coefficient=friction,
            width_over_radius=contacts.pairs.half_width(state.normal) / contacts.pairs.effective_radius,
        )
        slip = slip_ratio(
            normal_force=state.normal,
            tangential_force=state.tangential,
            friction_coefficient=friction * (1.0 - lost),
        )
        rolls = (forces.balance_residual < BALANCE_TOLERANCE) & (state.residual < ROLLING_TOLERANCE)
        rest = jnp.broadcast_to(jnp.where(rolls, -1.0, 1.0), slip.shape[1:])
        return jnp.concatenate([slip - 1.0, rest[None]])

    guess = jnp.min(friction, axis=0) * joint.preload * drive.sides.roller_orbit * joint.geometry.planet_count
    shape = jnp.broadcast_shapes(*(jnp.shape(leaf) for leaf in (*jax.tree.leaves(joint), direction)))
    return first_limit(excesses=excesses, first_guess=jnp.broadcast_to(guess, shape)).value
