"""A joint between motor and load: natural frequencies at its torque, damping by creep, frequency response."""

from __future__ import annotations

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.drive.layout.drive import speed_ratio
from asperity.drive.structure.dynamics import dynamic_stiffness, frequency_response, natural_frequencies
from asperity.errors import InputError
from asperity.joint.bodies import joint_inertias
from asperity.joint.description import Joint
from asperity.joint.solve import Solution, solve_joint
from asperity.joint.torque_limits import LIMIT_KINDS, MODEL_LIMITS
from asperity.standing.over_torque import lost_speed_slopes, standing_over_torque
from asperity.standing.standing import NO_SLIP_FRICTION
from asperity.types import Real

_FREQUENCIES = 400
_BESIDE = 1e-6  # of a natural frequency: on it a response without losses is infinite, or 0, and has no phase
_TORQUES = 25
_NEAR_CAPACITY = 0.98


class Inertias(eqx.Module):
    """What is coupled to a joint. SI units.

    Parameters
    ----------
    input : Real
        Moment of inertia of motor and coupling at the sun [kg·m^2].
    output : Real
        Moment of inertia of the load at the carrier [kg·m^2].
    loss_factor : Real
        Loss factor of the joint's spring [-].
    """

    input: Real
    output: Real
    loss_factor: Real


class JointDynamics(eqx.Module):
    """A joint with its inertias, linear about its output torque [N·m]. SI units, all referred to the output.

    Incremental stiffness of the assembled joint [N·m/rad]. Inertias [kg·m^2]: of motor and sun times the square of the
    speed ratio; of load, planets and loading rollers, the carrier belonging to the load. Natural frequencies with the
    motor locked, and with both sides free [Hz]. ``creep_damping``: torque per speed lost by creep [N·m·s/rad], infinite
    where the sun stands, nan where the joint does not roll. ``corner_frequency``: where creep and spring yield equally
    [Hz], below which the joint that turns is a damper, above it a spring; 0 where the sun stands.
    """

    output_torque: Array
    stiffness: Array
    input_inertia: Array
    output_inertia: Array
    locked_frequency: Array
    free_frequency: Array
    creep_damping: Array
    corner_frequency: Array


def _between_inertias(
    torque: Array, stiffness: Array, slope: Array, ratio: Real, bodies: tuple[Real, Real], inertias: Inertias
) -> JointDynamics:
    """A joint from its stiffness, and from the speed that creep takes over the torque."""
    sun, moving = bodies
    input_inertia = ratio**2 * (inertias.input + sun)
    output_inertia = inertias.output + moving
    frequencies = natural_frequencies(
        stiffness=stiffness, input_inertia=input_inertia, output_inertia=output_inertia
    )
    turns = slope > 0.0
    damping = jnp.where(
        turns, 1.0 / jnp.where(turns, slope, 1.0), jnp.where(jnp.isnan(slope), jnp.nan, jnp.inf)
    )
    shape = jnp.shape(stiffness)
    return JointDynamics(
        output_torque=torque,
        stiffness=stiffness,
        input_inertia=jnp.broadcast_to(input_inertia, shape),
        output_inertia=jnp.broadcast_to(output_inertia, shape),
        locked_frequency=jnp.asarray(frequencies.locked),
        free_frequency=jnp.asarray(frequencies.free),
        creep_damping=damping,
        corner_frequency=stiffness * slope / (2.0 * jnp.pi),
    )


def _over_torque(joint: Joint, inertias: Inertias, torques: np.ndarray) -> JointDynamics:
    """A joint about each of the torques, as NumPy arrays."""
    standing = standing_over_torque(joint, np.asarray(torques), no_slip_friction=NO_SLIP_FRICTION)
    stiffness = np.where(standing.solved, np.asarray(standing.assembly)[:, 0], np.nan)
    ratio = float(np.asarray(speed_ratio(joint.drive)))
    slope = lost_speed_slopes(joint, np.asarray(torques)) * abs(float(joint.input_speed) / ratio)
    made = _between_inertias(
        jnp.asarray(torques),
        jnp.asarray(stiffness),
        jnp.asarray(slope),
        ratio,
        joint_inertias(joint),
        inertias,
    )
    return jax.tree.map(np.asarray, made)


class Dynamics(eqx.Module):
    """What a designer of the control looks at.

    Parameters
    ----------
    at_torque : JointDynamics
        At the joint's own torque.
    over_torque : JointDynamics
        From no torque to nearly the capacity, or to the joint's torque if nothing limits it.
    frequency : Array
        Frequencies of the response [Hz].
    standing_motor, standing_load : Array
        Complex angles of both sides per torque at the input, of the joint that stands [rad/(N·m)].
    turning_motor, turning_load : Array
        The same at the joint's speed, where creep acts as a damper.
    """

    at_torque: JointDynamics
    over_torque: JointDynamics
    frequency: Array
    standing_motor: Array
    standing_load: Array
    turning_motor: Array
    turning_load: Array


def dynamics(joint: Joint, inertias: Inertias) -> Dynamics:
    """Natural frequencies over torque, and the frequency response at the joint's torque."""
    solution = solve_joint(joint)
    if not float(solution.result.assembly.stiffness.output) > 0.0:
        raise InputError("the assembled joint has no stiffness, so that it has no natural frequency")
    coupled: Inertias = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), inertias)
    output_torque = float(joint.output_torque)
    limit = _limit(solution, output_torque)
    largest = np.copysign(_NEAR_CAPACITY * limit, output_torque) if np.isfinite(limit) else output_torque
    torques = np.append(np.linspace(0.0, largest, _TORQUES), output_torque)
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    over = _over_torque(numbers, coupled, torques)
    at = jax.tree.map(lambda values: values[-1], over)
    spread = np.geomspace(at.locked_frequency / 100.0, 10.0 * at.free_frequency, _FREQUENCIES)
    beside = np.outer([at.locked_frequency, at.free_frequency], [1.0 - _BESIDE, 1.0 + _BESIDE])
    frequency: Array = jnp.asarray(np.sort(np.append(spread, beside)))
    both = [
        frequency_response(
            frequency=frequency,
            stiffness=dynamic_stiffness(
                frequency=frequency,
                stiffness=at.stiffness,
                loss_factor=coupled.loss_factor,
                creep_damping=damping,
            ),
            input_inertia=at.input_inertia,
            output_inertia=at.output_inertia,
        )
        for damping in (np.inf, at.creep_damping)
    ]
    return Dynamics(
        at,
        jax.tree.map(lambda values: values[:-1], over),
        frequency,
        *(angle for response in both for angle in response),
    )


def _limit(solution: Solution, torque: float) -> float:
    """Capacity in the direction of a torque [N·m]; where only what is computed ends there, at most twice the torque."""
    capacity = solution.reverse_standing_capacity if torque < 0.0 else solution.standing_capacity
    limit = float(capacity.output_torque)
    ends = LIMIT_KINDS[int(capacity.limit)] in MODEL_LIMITS and torque != 0.0
    return min(limit, 2.0 * abs(torque) / _NEAR_CAPACITY) if ends else limit
