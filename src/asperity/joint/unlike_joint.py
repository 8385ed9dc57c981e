r"""A joint with the paper's drive whose branches differ in size, as ordinary joints: one for each branch and torque.

Each stands for a drive all of whose n branches are like one of them. They lie side by side:

.. math:: T = \frac1n \sum_b T_b, \qquad K = \frac{s}{n} \sum_b K_b

with the factor s by which a sun that gives way in its bearings changes the stiffness, 1 for a sun that is held.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any, NamedTuple

import jax
import jax.numpy as jnp
import numpy as np

from asperity.drive.geometry import CONTACT_NAMES, DriveGeometry
from asperity.joint.branch_results import UnequalBranches
from asperity.joint.branch_sizes import BranchSizes
from asperity.joint.description import Joint
from asperity.joint.play import Play
from asperity.joint.rolling_conditions import RollingConditions


@dataclass(frozen=True)
class UnlikeJoint:
    """A joint with the paper's drive and the sizes of its branches. SI units.

    Parameters
    ----------
    joint : Joint
        The joint with equal branches.
    interference : float
        Its interference [m].
    sizes : BranchSizes
        Sizes of its branches.
    """

    joint: Joint
    interference: float
    sizes: BranchSizes

    @property
    def output_torque(self) -> Any:
        """Torque at the carrier [N·m]."""
        return self.joint.output_torque

    @property
    def sun_speed(self) -> Any:
        """Angular velocity of the sun [rad/s]."""
        return self.joint.sun_speed

    @property
    def play(self) -> Play:
        """Play at the output."""
        return self.joint.play

    @property
    def geometry(self) -> DriveGeometry:
        """Geometry of equal branches."""
        return self.joint.geometry

    @property
    def rolling(self) -> RollingConditions:
        """Conditions under which it rolls."""
        return self.joint.rolling

    @property
    def ends(self) -> tuple[str, str]:
        """Names of input and output."""
        return self.joint.ends

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of the contacts with the number of their branch, branch by branch."""
        count = self.sizes.planet.size
        return tuple(f"{name}_{branch}" for branch in range(1, count + 1) for name in CONTACT_NAMES)

    def under(self, output_torque: float, sun_speed: float) -> UnlikeJoint:
        """The same under another torque [N·m] and speed of the sun [rad/s]."""
        joint = dataclasses.replace(self.joint, output_torque=output_torque, sun_speed=sun_speed)
        return dataclasses.replace(self, joint=joint)

    def branches(self) -> UnequalBranches:
        """What its branches do under its torque and at its speed."""
        from asperity.joint.branches import BranchedJoint

        return BranchedJoint(self.joint, self.interference).branches(self.sizes)


class BranchJoints(NamedTuple):
    """The branches of a joint under torques, as ordinary joints.

    Parameters
    ----------
    joints : Joint
        Numbers with a last axis of branches times torques, the torques fastest.
    bears, slips : ndarray
        Which branches are pressed, and which slip as a whole, shape (branches, torques).
    share : ndarray
        Share of each in the torque, shape (branches, torques) [-]; nan without a torque.
    moving_sun : ndarray
        Factor s of a sun that gives way, shape (torques,) [-].
    carried : ndarray
        Whether the branches carry the torque, shape (torques,).
    """

    joints: Joint
    bears: np.ndarray
    slips: np.ndarray
    share: np.ndarray
    moving_sun: np.ndarray
    carried: np.ndarray

    @property
    def stick(self) -> np.ndarray:
        """Whether the branches carry the torque and none of them slips as a whole, shape (torques,)."""
        return self.carried & ~np.any(self.slips, axis=0)

    def of_each(self, values: np.ndarray) -> np.ndarray:
        """Values of the joints, shape (..., branches, torques)."""
        return np.asarray(values).reshape(*np.shape(values)[:-1], *self.bears.shape)

    def together(self, values: np.ndarray) -> np.ndarray:
        """Mean over the branches of what adds up where they lie side by side; a loose one adds nothing."""
        return np.mean(np.where(self.bears, self.of_each(values), 0.0), axis=-2)

    def alike(self, values: np.ndarray) -> np.ndarray:
        """Mean over the branches that are not loose, of what is the same for all of them; nan where there are none."""
        count = np.sum(self.bears, axis=0)
        whole = np.sum(np.where(self.bears, self.of_each(values), 0.0), axis=-2)
        return np.where(count > 0, whole / np.maximum(count, 1), np.nan)


def branch_joints(
    unlike: UnlikeJoint, torques: np.ndarray, speeds: np.ndarray, *, turns: bool
) -> BranchJoints:
    """How the branches of a joint share torques.

    Parameters
    ----------
    unlike : UnlikeJoint
        The joint; its own torque and speed are replaced.
    torques, speeds : ndarray
        Output torques [N·m] and speeds of the sun [rad/s] of either sign, shape (torques,).
    turns : bool
        Whether the joint turns, so that all branches creep at the same rate; else all are wound up alike.

    Returns
    -------
    BranchJoints
        Torques that the branches do not carry are not ``carried``; the joints there have no torque.

    Raises
    ------
    InputError
        If the branches cannot be compared.
    NoSolutionError
        If no balance of the sun was found.

    References
    ----------
    Equation (I4) of :doc:`/equations`.
    """
    from asperity.joint.branches import BranchedJoint

    joint, count = unlike.joint, unlike.sizes.planet.size
    preload, torque, slips = np.zeros((3, count, torques.size))
    moving, carried = np.ones(torques.size), np.ones(torques.size, dtype=bool)
    senses = np.where(torques < 0.0, -1.0, 1.0)
    for sense, speed in sorted(
        set(zip(senses.tolist(), np.asarray(speeds, dtype=float).tolist(), strict=True))
    ):
        there = unlike.under(sense * float(np.max(np.abs(torques))), speed).joint
        solver = BranchedJoint(there, unlike.interference).solver(unlike.sizes, turns=turns)
        here = (senses == sense) & (speeds == speed)
        found = solver.points(np.abs(torques[here]))
        carried[here], moving[here] = found.carried, np.where(found.carried, found.moving_sun, 1.0)
        for whole, each in ((preload, found.preload), (torque, found.torque), (slips, found.slips)):
            whole[:, here] = np.where(found.carried, each.T, 0.0)
    bears = preload > 0.0
    whole = np.sum(torque, axis=0)
    numbers = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    joints = dataclasses.replace(
        numbers,
        preload=jnp.asarray(np.where(bears, preload, float(joint.preload)).ravel()),
        output_torque=jnp.asarray((senses * np.where(bears, torque, 0.0)).ravel()),
        sun_speed=jnp.asarray(np.broadcast_to(speeds, bears.shape).ravel()),
        fit=None,
        rolling=dataclasses.replace(numbers.rolling, duty=()),
    )
    with np.errstate(invalid="ignore"):
        share = np.where(whole > 0.0, torque / whole, np.nan)
    return BranchJoints(joints, bears, slips.astype(bool), share, moving, carried)
