"""A joint over its output torque in both directions: stiffness at rest, and drift in either sense of rotation."""

from __future__ import annotations

import dataclasses

import equinox as eqx
import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.rolling_state import drift_per_turn, speed_loss
from asperity.joint.description import Joint
from asperity.joint.evaluation import evaluate
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.over_torque import over_torque
from asperity.joint.standing import LEVELS, NO_SLIP_FRICTION, standing_at
from asperity.joint.unlike_joint import UnlikeJoint, branch_joints


class BothSenses(eqx.Module):
    """One joint over torques of either sign. SI units; shape (n,).

    Parameters
    ----------
    torque : Array
        Output torques [N·m].
    published, series_with_bulk, assembly : Array
        Incremental stiffness on the three levels at rest, play left out [N·m/rad]; nan where a contact slips.
    slip_ratio : Array
        The largest T/(mu N) of all contacts at rest [-].
    driving_drift, braking_drift : Array
        Angle by which the output gives way to the torque in one turn of its own, with the sign of the torque [rad]:
        in steady rolling with the torque (the output falls behind), and against it (it runs ahead). nan where there is
        no steady rolling.
    """

    torque: Array
    published: Array
    series_with_bulk: Array
    assembly: Array
    slip_ratio: Array
    driving_drift: Array
    braking_drift: Array


def both_senses(*, joint: Joint | PlanarJoint | UnlikeJoint, torque: Array | np.ndarray) -> BothSenses:
    """Stiffness and drift of a joint at given torques.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint, without batch axes; its torque and the sense of its speed are replaced.
    torque : Array
        Output torques of either sign, shape (n,) [N·m].

    Returns
    -------
    BothSenses
        The stiffness is that of a joint that begins to move with its torque, as in a wind-up.
    """
    if isinstance(joint, PlanarJoint):
        return _planar(joint, torque)
    if isinstance(joint, UnlikeJoint):
        return _side_by_side(joint, np.asarray(torque))
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    numbers = dataclasses.replace(numbers, rolling=dataclasses.replace(numbers.rolling, duty=()))
    torques = jnp.asarray(torque)
    with_torque = jnp.where(torques < 0.0, -1.0, 1.0) * jnp.abs(jnp.asarray(numbers.sun_speed))
    found = []
    for sense in (1.0, -1.0):
        points = dataclasses.replace(numbers, output_torque=torques, sun_speed=sense * with_torque)
        found.append(jax.tree.map(np.asarray, compile_fast(_at_torques, points)(points)))
    published, series, assembly, slip, driving, _ = found[0]
    return BothSenses(torques, published, series, assembly, slip, driving, braking_drift=found[1][-1])


def _planar(joint: PlanarJoint, torque: Array | np.ndarray) -> BothSenses:
    found = over_torque(joint, np.asarray(torque), no_slip_friction=NO_SLIP_FRICTION)
    slip = np.max(np.asarray(found.slip_ratio), axis=1)
    solved = np.asarray(found.solved)
    levels = {
        name: jnp.asarray(np.where(solved, np.asarray(getattr(found, name))[:, 0], np.nan)) for name in LEVELS
    }
    driving, braking = jnp.asarray(found.drift).T
    return BothSenses(
        torque=jnp.asarray(torque),
        **levels,
        slip_ratio=jnp.asarray(np.where(solved, slip, np.nan)),
        driving_drift=driving,
        braking_drift=braking,
    )


def _side_by_side(unlike: UnlikeJoint, torques: np.ndarray) -> BothSenses:
    standing = standing_at(unlike, torques)
    holds = standing.holds & standing.solved
    drifts = []
    for sense in (1.0, -1.0):
        speeds = sense * np.where(torques < 0.0, -1.0, 1.0) * abs(float(unlike.sun_speed))
        points = branch_joints(unlike, torques, speeds, turns=True)
        *_, driving, braking = jax.tree.map(
            np.asarray, compile_fast(_at_torques, points.joints)(points.joints)
        )
        drift = points.alike(driving if sense > 0.0 else braking)
        drifts.append(jnp.asarray(np.where(points.stick, drift, np.nan)))
    return BothSenses(
        torque=jnp.asarray(torques),
        **{name: jnp.asarray(np.where(holds, standing.levels[name], np.nan)) for name in LEVELS},
        slip_ratio=jnp.asarray(np.where(holds, np.max(standing.slip_ratio, axis=0), np.nan)),
        driving_drift=drifts[0],
        braking_drift=drifts[1],
    )


def _at_torques(joint: Joint) -> tuple[Array, ...]:
    result = evaluate(joint)
    slip = jnp.max(result.diagnostics.slip_ratio, axis=0)
    holds = result.solved & (slip < 1.0) & result.contact_law_holds
    stiffness = (result.published.output, result.series_with_bulk.output, result.assembly.stiffness.output)
    creepage = jnp.abs(jnp.asarray(result.rolling.creepage))
    sign = jnp.sign(joint.output_torque)
    return (
        *(jnp.where(holds, level, jnp.nan) for level in stiffness),
        jnp.where(result.solved, slip, jnp.nan),
        sign * _drift(joint, creepage),
        -sign * _drift(joint, -creepage),
    )


def _drift(joint: Joint, creepage: Array) -> Array:
    """Angle lost in one turn of the output, (B3); negative where the creep runs ahead."""
    return drift_per_turn(speed_loss(geometry=joint.geometry, creepage=creepage))
