"""The largest torque under which a joint can roll."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.capacity import first_limit, slip_ratio
from asperity.drive.force_balance import BALANCE_TOLERANCE, force_balance
from asperity.drive.rolling_state import ROLLING_TOLERANCE, rolling_state
from asperity.errors import NoSolutionError
from asperity.joint.contacts import joint_contacts, rough_joint_contacts
from asperity.joint.description import Joint, with_one_rank
from asperity.joint.evaluation import mechanism
from asperity.joint.rolling import contact_creep
from asperity.joint.rolling_document import unknown_because
from asperity.joint.solve import Solution, solve_program
from asperity.types import Real
from asperity.units import format_quantity

_HALVINGS = 30  # the capacity to 1e-9 of that at rest


def rolling_torque_capacity(joint: Joint, *, direction: Real) -> Array:
    r"""Largest output torque in a direction under which a joint has a steady rolling state.

    .. math:: \max_i \frac{T_i}{\mu_i N_i} = 1

    with the forces of :func:`asperity.drive.rolling_state.rolling_state`.

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
    others, and the smaller of the two holds. The derivatives are implicit.

    References
    ----------
    Equations (A9) and (B3) of :doc:`/equations`.
    """
    joint = with_one_rank(joint)
    drive = mechanism(dataclasses.replace(joint, output_torque=jnp.asarray(direction)))
    contacts = joint_contacts(joint)
    friction = contacts.pairs.friction_coefficient

    def excesses(torque: Array) -> Array:
        forces = force_balance(mechanism=drive, output_torque=direction * torque)
        rough = rough_joint_contacts(
            contacts=contacts,
            normal_force=forces.normal,
            tangential_force=jnp.zeros_like(forces.tangential),
        )
        creep = contact_creep(
            joint=joint,
            contacts=contacts,
            forces=forces,
            asperity_normal_stiffness=rough.normal_stiffness,
        )
        state = rolling_state(mechanism=drive, standing=forces, law=creep.law)
        slip = slip_ratio(
            normal_force=state.normal, tangential_force=state.tangential, friction_coefficient=friction
        )
        rolls = (forces.balance_residual < BALANCE_TOLERANCE) & (state.residual < ROLLING_TOLERANCE)
        rest = jnp.broadcast_to(jnp.where(rolls, -1.0, 1.0), slip.shape[1:])
        return jnp.concatenate([slip - 1.0, rest[None]])

    guess = jnp.min(friction, axis=0) * joint.preload * drive.sides.roller_orbit * joint.geometry.planet_count
    shape = jnp.broadcast_shapes(*(jnp.shape(leaf) for leaf in (*jax.tree.leaves(joint), direction)))
    return first_limit(excesses=excesses, first_guess=jnp.broadcast_to(guess, shape)).value


def rolling_capacity_of(joint: Joint, solution: Solution, *, direction: float) -> float:
    """Torque capacity in rolling of one solved joint.

    The same number as the smaller of :func:`rolling_torque_capacity` and the capacity at rest, by the program that is
    compiled already.

    Parameters
    ----------
    joint : Joint
        One joint.
    solution : Solution
        What it does at rest.
    direction : float
        +1 for positive torques, −1 for negative ones [-].

    Returns
    -------
    float
        A positive torque [N·m], at most the capacity at rest, which it is below where equal creep on both sides of a
        planet loads the weaker side more; infinite or nan where the capacity at rest is.
    """
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    program = compile_fast(solve_program, numbers)
    at_rest = solution.reverse_capacity if direction < 0.0 else solution.capacity

    def rolls(torque: float) -> bool:
        result, *_ = program(dataclasses.replace(numbers, output_torque=np.float64(direction * torque)))
        return bool(np.isfinite(np.asarray(result.rolling.residual)))

    return _largest(rolls, float(at_rest.output_torque))


def _largest(rolls: Callable[[float], bool], at_rest: float) -> float:
    """The largest torque that rolls, by halving; the states form one interval from 0."""
    if not math.isfinite(at_rest):
        return at_rest
    low, high = 0.0, at_rest
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if rolls(middle) else (low, middle)
    return low


def refuse_no_rolling(joint: Joint, solution: Solution, capacity: float) -> None:
    """Refuse a joint that stands but has no steady rolling state.

    Parameters
    ----------
    joint : Joint
        One joint.
    solution : Solution
        What it does at rest.
    capacity : float
        Its torque capacity in rolling, in the direction of its torque [N·m].

    Raises
    ------
    NoSolutionError
        With the reason, and the capacity.
    """
    if np.isfinite(np.asarray(solution.result.rolling.residual)):
        return
    reasons = "; ".join(unknown_because(joint, solution.result))
    own = float(joint.output_torque)
    torque, limit = (format_quantity(value, "N*m") for value in (own, math.copysign(capacity, own)))
    known = f"the joint rolls up to {limit}" if capacity > 0.0 else "it never rolls"
    raise NoSolutionError(
        f"{reasons}: the output torque is {torque}, {known}; lower the torque or the skew, or raise the preload or the "
        "friction coefficient"
    )
