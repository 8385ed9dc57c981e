"""What each of the unequal branches of a joint carries, from the states of the joint with every branch by itself."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np

from asperity.branches.branches import AssembledBranches, SectorDeviations, mean_interference
from asperity.drive.layout.drive import CARRIER, incidence
from asperity.drive.layout.unfolding import forces_on_centre
from asperity.drive.state.loads import (
    drag_pairs,
    member_moments,
    resistance_levers,
    resistance_moments,
)
from asperity.drive.state.state import STATE_TOLERANCE, DriveState
from asperity.drive.state.states import DriveStates
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.joint.description import Joint
from asperity.types import Array


@dataclass(frozen=True)
class BranchState:
    """The branches of a joint under a torque, standing or in rolling. SI units; branches last, shape (..., n).

    Parameters
    ----------
    torque : ndarray
        Torque of each branch at the output; they add up to that of the joint [N·m].
    central : str
        Name of the body on the axis that the next two are of: the input, or the first one where the carrier is the
        input.
    central_displacement, central_force : ndarray
        Its displacement [m], and the force of the sectors' rollers on it [N], shape (2,); the first planet lies on the
        first axis.
    centre_forces : dict
        Names of the other members on the axis → force of the branches on them, shape (2,) [N].
    torques : dict
        Names of the members on the axis → torque of contacts and pins on them, with the signs of the table of loads
        [N·m].
    input_torque : float
        Torque at the input of all branches [N·m]: in rolling that of the contacts.
    """

    torque: np.ndarray
    central: str
    central_displacement: np.ndarray
    central_force: np.ndarray
    centre_forces: dict[str, np.ndarray]
    torques: dict[str, float]
    input_torque: float

    @property
    def share(self) -> np.ndarray:
        """Share of each branch in the torque [-]; 1/n for equal branches, nan without a torque."""
        total = self.torque.sum()
        return self.torque / total if total else np.full_like(self.torque, np.nan)


@dataclass(frozen=True)
class UnequalBranches:
    """What unequal branches do to a joint.

    Parameters
    ----------
    sizes : SectorDeviations
        Sizes of the branches.
    noun : str
        What a branch is called.
    equal_preload : float
        Preload of equal branches [N].
    interference, preload : ndarray
        Of each branch without torque, the input where its bearings let it be, shape (n,) [m], [N].
    rest : BranchState
        Without torque.
    standing, rolling : BranchState or None
        Under the joint's torque; None where there is no such state.
    """

    sizes: SectorDeviations
    noun: str
    equal_preload: float
    interference: np.ndarray
    preload: np.ndarray
    rest: BranchState
    standing: BranchState | None
    rolling: BranchState | None


class _Sums(NamedTuple):
    """Sums over the contacts and pins of the states at rest, standing and in rolling, which come first."""

    centre_force: Array
    centre_moment: Array
    output_moment: Array
    interference: Array


def unequal_branches(branches: AssembledBranches, states: DriveStates) -> UnequalBranches:
    """What each branch carries; a state that does not exist is None. Equation (I4) of :doc:`/equations`."""
    equal, joint, count = branches.equal, branches.joint, branches.sectors
    drive_states = (states.rest, states.standing, states.rolling)
    sums: _Sums = at_once(partial(_sums, count, branches.floating), equal, joint, drive_states)
    torque = abs(float(joint.output_torque))
    branch_states = [_state(branches, sums, kind, state, torque) for kind, state in enumerate(drive_states)]
    balances = [float(state.worst) < STATE_TOLERANCE for state in drive_states]
    rest, standing, rolling = (
        state if balanced else None for state, balanced in zip(branch_states, balances, strict=True)
    )
    return UnequalBranches(
        sizes=branches.sizes,
        noun=branches.noun,
        equal_preload=float(branches.settled.equal.normal[0]),
        interference=mean_interference(equal, branches.settled, np.asarray(sums.interference)),
        preload=np.asarray(states.rest.normal).reshape(count, -1)[:, 0],
        rest=branch_states[0] if rest is None else rest,
        standing=standing,
        rolling=rolling,
    )


def _sums(
    sectors: int, floating: tuple[str, ...], equal: Joint, joint: Joint, states: tuple[DriveState, ...]
) -> _Sums:
    """Sums over the contacts and pins of these states, the first of them that at rest."""
    return _Sums(
        centre_force=xp.stack([_forces_on_axis(equal, joint, state) for state in states]),
        centre_moment=xp.stack([_moments_on_axis(equal, joint, state) for state in states]),
        output_moment=xp.stack([_output_moments(joint, state, sectors) for state in states]),
        interference=_working_interference(joint, floating, states[0]).reshape(sectors, -1),
    )


def _axis_bodies(joint: Joint) -> tuple[str, ...]:
    """Names of the bodies on the axis of a joint of equal sectors."""
    return tuple(body.name for body in joint.drive.bodies if body.place == "axis")


def _forces_on_axis(equal: Joint, joint: Joint, state: DriveState) -> Array:
    return forces_on_centre(
        drive=joint.drive,
        bodies=_axis_bodies(equal),
        normal=state.normal,
        tangential=state.tangential + drag_pairs(joint.drive, state.drag),
        pin_force=state.pin_force,
    )


def _moments_on_axis(equal: Joint, joint: Joint, state: DriveState) -> Array:
    """Moments that all sectors put on the bodies on the axis and on the carrier, counter-clockwise [N·m]."""
    drive = joint.drive
    moments = member_moments(drive, incidence(drive), state.tangential, state.pin_force)
    moments = moments + resistance_moments(drive, state.resistance)
    return moments[np.array([drive.members.index(name) for name in (*_axis_bodies(equal), CARRIER)])]


def _output_moments(joint: Joint, state: DriveState, sectors: int) -> Array:
    """Moments that the sectors pass to the output [N·m]."""
    drive, matrices = joint.drive, incidence(joint.drive)
    output = drive.members.index(drive.output)
    resisted = zip(resistance_levers(drive), state.resistance, strict=True)
    moments = sum(levers[output] * size for levers, size in resisted)
    moments = xp.sum(xp.reshape(moments, (sectors, -1)), axis=1)
    if drive.output == CARRIER:
        passed = matrices.levers * state.pin_force
    else:
        passed = -matrices.turning[:, output] * state.tangential
    return moments + xp.sum(passed.reshape(sectors, -1), axis=1)


def _working_interference(joint: Joint, floating: tuple[str, ...], rest: DriveState) -> Array:
    """Interference of the contacts, with what floating bodies on the axis take of it [m]."""
    drive = joint.drive
    central = np.array([drive.bodies[body].name in floating for body in drive.floating])
    return rest.interference + incidence(drive).approach @ xp.where(
        np.repeat(central, 2), rest.displacement.ravel(), 0.0
    )


def _state(
    branches: AssembledBranches, sums: _Sums, kind: int, state: DriveState, torque: float
) -> BranchState:
    """The branches at rest, standing or rolling: 0, 1 or 2."""
    drive, turned = branches.equal.drive, _towards_first(branches.equal)
    central = _axis_bodies(branches.equal)
    members = [*central, CARRIER]
    forces = dict(zip(members, sums.centre_force[kind] @ turned.T, strict=True))
    moments = np.zeros(branches.sectors)
    if kind and torque:
        moments = np.asarray(sums.output_moment[kind])
        moments = moments * (torque / moments.sum())
    body = drive.input if drive.input in central else central[0]
    return BranchState(
        torque=moments,
        central=body,
        central_displacement=turned @ state.displacement[0] if branches.floating else np.zeros(2),
        central_force=forces.pop(body),
        centre_forces=forces,
        torques=dict(zip(members, map(float, drive.sense * sums.centre_moment[kind]), strict=True)),
        input_torque=float(state.input_torque),
    )


def _towards_first(joint: Joint) -> np.ndarray:
    """Rotation to axes of which the first points to the first roller of the first sector."""
    x, y = np.asarray(joint.drive.centres)[joint.drive.floating[0]]
    return np.array([[x, y], [-y, x]]) / math.hypot(x, y)
