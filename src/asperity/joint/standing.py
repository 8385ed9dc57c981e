"""A joint that stands under torques of either sign: its stiffness on every level, as it is and without slip."""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array

from asperity.compilation import compile_fast
from asperity.drive.geometry import speed_ratio
from asperity.drive.planar.state import PlanarState
from asperity.drive.planar.stiffness import with_shafts
from asperity.joint.description import Joint
from asperity.joint.evaluation import JointResult, evaluate
from asperity.joint.planar.description import PlanarJoint
from asperity.joint.planar.over_torque import standing_over_torque
from asperity.joint.unlike_joint import UnlikeJoint, branch_joints
from asperity.types import Real

#: Levels of the stiffness, from the simplest.
LEVELS = ("published", "series_with_bulk", "assembly")

#: Stiffness of the assembly without its shafts, beside the levels.
WITHOUT_SHAFTS = "without_shafts"

#: Friction coefficient under which no contact slips at all: T/(mu N) is lost in the rounding of 1 − T/(mu N).
NO_SLIP_FRICTION = 1e30


class Standing(NamedTuple):
    """A joint at torques, as NumPy arrays. SI units.

    Parameters
    ----------
    solved : ndarray
        Whether the forces balance, shape (torques,).
    holds : ndarray
        Whether friction holds the torque, shape (torques,).
    slip_ratio : ndarray
        T/(mu N) of each contact, shape (contacts, torques) [-].
    levels, levels_without_slip : dict
        Name of a level → incremental stiffness at the output, shape (torques,) [N·m/rad]: as the joint is, and under
        the same normal forces with so much friction that no contact slips.
    """

    solved: np.ndarray
    holds: np.ndarray
    slip_ratio: np.ndarray
    levels: dict[str, np.ndarray]
    levels_without_slip: dict[str, np.ndarray]


def standing_at(
    joint: Joint | PlanarJoint | UnlikeJoint, torques: np.ndarray, rest: PlanarState | None = None
) -> Standing:
    """What a wind-up needs to know of a joint with any type of drive.

    Parameters
    ----------
    joint : Joint, PlanarJoint or UnlikeJoint
        One joint; its own output torque is replaced.
    torques : ndarray
        Output torques of either sign, shape (torques,) [N·m].
    rest : PlanarState, optional
        The assembled state of a planar drive without torque, where it is known.

    Returns
    -------
    Standing
        Play is left out.
    """
    if isinstance(joint, PlanarJoint):
        found = standing_over_torque(joint, torques, no_slip_friction=NO_SLIP_FRICTION, rest=rest)
        own, without = ({name: np.asarray(getattr(found, name))[:, k] for name in LEVELS} for k in range(2))
        holds, ratio = np.asarray(found.solved), np.asarray(found.slip_ratio).T
        return Standing(np.asarray(found.balanced), holds, ratio, own, without)
    if isinstance(joint, UnlikeJoint):
        speeds = np.where(torques < 0.0, -1.0, 1.0) * abs(float(joint.sun_speed))
        return standing_branches(joint, torques, speeds)
    return _of_joints(at_standstill(joint, jnp.asarray(torques)))


def _of_joints(joints: Joint) -> Standing:
    """Joints along one axis, each at its torque."""
    # one program evaluates both: two assemblies that run side by side can wait for each other for ever (LAPACK in XLA)
    count = jnp.size(joints.output_torque)
    twice: Joint = jax.tree.map(
        lambda leaf: jnp.tile(leaf, 2) if jnp.shape(leaf) == (count,) else leaf, joints
    )
    slips = np.arange(2 * count) < count
    batch = dataclasses.replace(
        twice,
        friction_coefficients=tuple(
            jnp.where(slips, own, none)
            for own, none in zip(
                twice.friction_coefficients, without_slip(twice).friction_coefficients, strict=True
            )
        ),
    )
    solved, slip_ratio, levels = jax.tree.map(np.asarray, compile_fast(_at_torques, batch)(batch))
    own, without = (
        {name: values[half] for name, values in levels.items()} for half in (slice(count), slice(count, None))
    )
    ratio = slip_ratio[:, :count]
    return Standing(solved[:count], ~np.any(ratio >= 1.0, axis=0), ratio, own, without)


def standing_branches(unlike: UnlikeJoint, torques: np.ndarray, speeds: np.ndarray) -> Standing:
    """As :func:`standing_at` for unlike branches of the paper's drive; the shafts are common to them.

    Parameters
    ----------
    unlike : UnlikeJoint
        The joint; its own torque and speed are replaced.
    torques, speeds : ndarray
        Output torques [N·m] and speeds of the sun, whose sense bearing friction resists [rad/s], shape (torques,).

    Returns
    -------
    Standing
        Contacts branch by branch; a branch that slips has no stiffness, one that is loose no T/(mu N).
    """
    points = branch_joints(unlike, torques, speeds, turns=False)
    found = _of_joints(points.joints)
    holds = points.of_each(found.holds) & ~points.slips
    structure = unlike.joint.structure

    def whole(levels: dict[str, np.ndarray], acts: np.ndarray | bool) -> dict[str, np.ndarray]:
        made = {
            name: points.together(np.where(acts, points.of_each(values), 0.0).ravel())
            for name, values in levels.items()
        }
        made["assembly"] = np.asarray(
            with_shafts(
                stiffness=jnp.asarray(points.moving_sun * made[WITHOUT_SHAFTS]),
                ratio=speed_ratio(unlike.geometry),
                input_shaft_stiffness=structure.input_shaft_stiffness,
                output_shaft_stiffness=structure.output_shaft_stiffness,
            )[0]
        )
        return made

    ratio = np.where(points.bears, np.minimum(points.of_each(found.slip_ratio), 1.0), 0.0)
    return Standing(
        solved=np.all(points.of_each(found.solved) | ~points.bears, axis=0),
        holds=points.carried,
        slip_ratio=ratio.swapaxes(0, 1).reshape(-1, torques.size),
        levels=whole(found.levels, holds),
        levels_without_slip=whole(found.levels_without_slip, True),
    )


def without_slip(joint: Joint) -> Joint:
    """The same joint with so much friction that no contact slips; its normal forces do not change.

    Parameters
    ----------
    joint : Joint
        One joint, or many along trailing batch axes.

    Returns
    -------
    Joint
        The joint with :data:`NO_SLIP_FRICTION` in every contact.
    """
    return dataclasses.replace(
        joint,
        friction_coefficients=tuple(
            NO_SLIP_FRICTION + 0.0 * jnp.asarray(friction) for friction in joint.friction_coefficients
        ),
    )


def at_standstill(joint: Joint, output_torque: Array) -> Joint:
    """The joint at given torques with its bearing friction against the motion that each torque drives.

    Parameters
    ----------
    joint : Joint
        One joint.
    output_torque : Array
        Output torques of either sign, shape (points,) [N·m].

    Returns
    -------
    Joint
        A batch of joints; the sun's speed has the sign of the torque.
    """
    return dataclasses.replace(
        joint,
        output_torque=output_torque,
        sun_speed=jnp.where(output_torque < 0.0, -1.0, 1.0) * jnp.abs(jnp.asarray(joint.sun_speed)),
    )


def _at_torques(joint: Joint) -> tuple[Real, Real, dict[str, Array]]:
    """Whether the balance closes, T/(mu N), and the stiffness on every level."""
    result = evaluate(joint)
    return result.solved, result.diagnostics.slip_ratio, _levels(result)


def _levels(result: JointResult) -> dict[str, Array]:
    assembly = result.assembly
    shafts = assembly.input_shaft_share + assembly.output_shaft_share
    return {
        WITHOUT_SHAFTS: jnp.asarray(assembly.stiffness.output / (1.0 - shafts)),
        "published": jnp.asarray(result.published.output),
        "series_with_bulk": jnp.asarray(result.series_with_bulk.output),
        "assembly": jnp.asarray(result.assembly.stiffness.output),
    }
