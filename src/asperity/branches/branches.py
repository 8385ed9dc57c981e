"""A joint whose sectors differ: share, slip and pressure of each, and the force on the centre.

Every sector is described by itself and has the interference of its own sizes; the solver is that of equal sectors.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np

from asperity.branches.results import (
    BranchCapacity,
    BranchRolling,
    BranchState,
    UnequalBranches,
    branch_rolling,
)
from asperity.branches.sector_states import sector_states
from asperity.branches.sizes import SectorDeviations, refuse_wide
from asperity.compilation import compile_fast
from asperity.drive.layout.drive import CARRIER
from asperity.drive.layout.expansion import ring_interference
from asperity.drive.state.loads import pin_components
from asperity.drive.state.state import STATE_TOLERANCE
from asperity.errors import InputError, NoSolutionError
from asperity.implicit import SETTLED
from asperity.joint.description import Joint
from asperity.joint.solve import Solution
from asperity.joint.torque_limits import LIMIT_KINDS, TorqueCapacity, limit_words
from asperity.joint.unfolding import SectorSizes, SettledSectors, settled_sectors, unfolded_joint
from asperity.units import format_quantity

_FIRST = {
    "gross_slip": "slips",
    "lift_off": "lifts off",
    "contact_too_wide": "becomes too wide",
    "wall_too_thin": "becomes too wide for its wall",
}


class BranchedJoint:
    """A joint made ready for sectors of any sizes.

    Parameters
    ----------
    joint : Joint
        One joint, its preload by interference; a loading cam adds to it under a torque.
    solution : Solution
        What it does with equal sectors.
    """

    def __init__(self, joint: Joint, solution: Solution) -> None:
        if joint.interference is None:
            raise InputError("sizes of branches make no preload that a spring holds: give load.interference")
        numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
        self.joint, self.solution = numbers, solution
        self.count = round(float(joint.drive.sectors))
        self.noun = "planet" if joint.type in ("planetary", "stepped_planet") else "sector"
        result = solution.result
        self.interference, self.own_preload = float(result.interference), float(result.rest.normal[0])
        self._equal = np.asarray(result.rest.normal)

    def branches(self, sizes: SectorDeviations) -> UnequalBranches:
        """Everything about sectors of given sizes.

        Parameters
        ----------
        sizes : SectorDeviations
            One deviation for each sector.

        Returns
        -------
        UnequalBranches
            At rest, under the joint's torque, and at slip.

        Raises
        ------
        InputError
            If the number of sizes is not that of the sectors, or a sector is loose.
        NoSolutionError
            If no balance was found.
        """
        floating, settled = self._assembled(sizes)
        return self._told(sizes, floating, sector_states(self.count, floating, self.joint, settled))

    def unfolded(self, sizes: SectorDeviations) -> Joint:
        """The joint with every sector by itself, for whatever takes a joint: wind-up, rolling, dynamics.

        Parameters
        ----------
        sizes : SectorDeviations
            One deviation for each sector.

        Returns
        -------
        Joint
            One sector with all bodies; contacts and rollers have the number of their sector behind their names. Its
            laws are taken around the forces of these sectors without torque.

        Raises
        ------
        InputError, NoSolutionError
            As :meth:`branches`.

        References
        ----------
        Equation (I4) of :doc:`/equations`.
        """
        floating, settled = self._assembled(sizes)
        whole = unfolded_joint(self.joint, settled.sizes, sectors=self.count, floating=floating)
        rolling = dataclasses.replace(whole.rolling, duty=self.joint.rolling.duty)
        numbers: Joint = jax.tree.map(np.asarray, dataclasses.replace(whole, rolling=rolling))
        return numbers

    def _assembled(self, sizes: SectorDeviations) -> tuple[tuple[str, ...], SettledSectors]:
        """Names of what floats, and the sectors without torque; or a refusal."""
        if len(sizes.added) != self.count:
            raise InputError(
                f"the drive has {self.count} {self.noun}s, got the sizes of {len(sizes.added)} branches"
            )
        floating = self._floating(sizes)
        own = self._own_interference(sizes.added)
        refuse_wide(own, float(np.mean(self._own_interference(np.zeros_like(sizes.added)))))
        if not floating and not any(contact.sector for contact in self.joint.drive.contacts):
            self._refuse_loose(own)
        return floating, self._settled(floating, sizes)

    def _floating(self, sizes: SectorDeviations) -> tuple[str, ...]:
        """The input where its bearings give way."""
        if math.isinf(sizes.sun_support_stiffness):
            return ()
        sun = self.joint.drive.input
        if sun == CARRIER:
            raise InputError(
                "compliance.sun_support_stiffness: the input of this drive is the carrier, which stays centred; leave "
                "it out"
            )
        if self.count < 3 and sizes.sun_support_stiffness == 0.0:
            raise InputError(
                f"nothing holds a floating {sun} between two sectors; give compliance.sun_support_stiffness a value "
                "above 0, or leave it out"
            )
        return (sun,)

    def _settled(self, floating: tuple[str, ...], sizes: SectorDeviations) -> SettledSectors:
        """The sectors without torque, with the forces around which the laws of the contacts are taken."""
        support = 0.0 if math.isinf(sizes.sun_support_stiffness) else sizes.sun_support_stiffness
        given = SectorSizes(*map(jnp.asarray, (sizes.added, np.zeros_like(sizes.added), support)))
        compiled = compile_fast(settled_sectors, self.joint, given, options=(self.count, floating))
        found: SettledSectors = jax.tree.map(np.asarray, compiled(self.joint, given))
        if not found.without_torque.rest.residual < STATE_TOLERANCE:
            raise NoSolutionError(
                f"no balance without torque presses every {self.noun}: one is loose, or nothing holds it; with the "
                f"members on the axis centred their interferences are {self._own_words(sizes)}; state smaller "
                "deviations, or raise load.interference"
            )
        if not found.change < SETTLED:
            raise NoSolutionError(
                "the laws of the contacts and the forces of the branches do not settle; state smaller deviations"
            )
        return found

    def _own_interference(self, added: np.ndarray) -> np.ndarray:
        """Interference of each sector with the members on the axis centred [m]."""
        joint = self.joint
        assert joint.interference is not None
        common = np.asarray(joint.working_pattern) * joint.interference
        return self._mean(common + added)

    def _mean(self, each: np.ndarray) -> np.ndarray:
        """Interference of the rings that does the work of those of all contacts, sector by sector [m]."""
        drive, forces = self.joint.drive, jnp.asarray(self._equal)
        return np.array(
            [
                float(ring_interference(drive=drive, forces=forces, interference=jnp.asarray(row)))
                for row in each
            ]
        )

    def _own_words(self, sizes: SectorDeviations) -> str:
        own = self._own_interference(sizes.added)
        return ", ".join(format_quantity(float(each), "um", 3) for each in own)

    def _refuse_loose(self, own: np.ndarray) -> None:
        loose = np.flatnonzero(own <= 0.0)
        if loose.size == own.size:
            raise InputError(
                "the deviations of the radii leave no branch with an interference: the drive is loose"
            )
        if loose.size:
            raise InputError(
                f"{self.noun} {loose[0] + 1} is loose: its sizes leave an interference of "
                f"{format_quantity(float(own[loose[0]]), 'um', 4)}; a drive of this type is solved with all of them "
                "pressed: state smaller deviations, or raise load.interference"
            )

    def _told(self, sizes: SectorDeviations, floating: tuple[str, ...], found: Any) -> UnequalBranches:
        """What was found, of which the leaves are NumPy arrays, by the names of the paper's drive."""
        joint, torque = self.joint, abs(float(self.joint.output_torque))
        way = 1 if float(joint.output_torque) < 0.0 else 0
        first: tuple[TorqueCapacity, ...] = tuple(
            jax.tree.map(lambda leaf, i=i: leaf[i], found.limits) for i in range(2)
        )
        own = self.solution
        equal, equal_rolling = (
            (own.reverse_capacity, own.reverse_rolling_capacity)
            if way
            else (own.capacity, own.rolling_capacity)
        )
        standing = rolling = None
        if torque < float(found.most_torque):
            standing = self._state(found, 1, floating, torque)
        if np.isfinite(found.rolling.residual):
            rolling = self._state(found, 2, floating, torque)
        return UnequalBranches(
            sizes=sizes,
            torque=torque,
            own_preload=self.own_preload,
            interference=self._mean(found.interference),
            preload=found.rest.normal.reshape(self.count, -1)[:, 0],
            rest=self._state(found, 0, floating, 0.0),
            standing=standing,
            rolling=rolling,
            capacity=self._capacity(first[0], float(found.most_torque), equal),
            rolling_capacity=self._capacity(first[1], math.nan, equal_rolling),
            noun=self.noun,
            stiffness=None if standing is None else float(found.assembly.stiffness.output),
            turning=None if rolling is None else self._turning(found),
        )

    def _turning(self, found: Any) -> BranchRolling:
        """Drift and powers of the joint that turns."""
        drive, speed = self.joint.drive, float(self.joint.input_speed)
        state = found.rolling
        out = speed * abs(
            state.speed[-1] if drive.output == CARRIER else state.speed[self._axis(drive.output)]
        )
        return branch_rolling(
            losses=found.losses,
            speed_loss=float(state.speed_loss),
            drift_per_output_turn=float(found.drift_per_output_turn),
            output_torque=float(self.joint.output_torque),
            output_speed=float(out),
            input_speed=speed,
        )

    def _axis(self, name: str) -> int:
        """Place of a member among those on the axis and the carrier, which comes last, in states and moments."""
        return [*(body.name for body in self.joint.drive.bodies if body.place == "axis"), CARRIER].index(name)

    def _capacity(self, first: TorqueCapacity, last: float, equal: TorqueCapacity) -> BranchCapacity:
        """Of the joint that stands, or of the one that turns, which rolls up to its first slip."""
        names, kind = self.joint.contact_names, LIMIT_KINDS[int(first.limit)]
        if kind not in _FIRST:
            each = tuple(f"{name} of sector {sector + 1}" for sector in range(self.count) for name in names)
            words = limit_words(first, contacts=each)
            raise NoSolutionError(
                "the branches cannot be compared: "
                f"{words} (beyond {format_quantity(float(first.output_torque), 'N*m')})"
            )
        branch, contact = divmod(int(first.limiting_contact), len(names))
        return BranchCapacity(
            first_slip=float(first.output_torque),
            branch=branch,
            contact=contact,
            all_slip=last,
            equal=float(equal.output_torque),
            contact_names=names,
            event=_FIRST[kind],
        )

    def _state(self, found: Any, kind: int, floating: tuple[str, ...], torque: float) -> BranchState:
        """The sectors at rest, standing or rolling: 0, 1 or 2."""
        state = (found.rest, found.standing, found.rolling)[kind]
        turned = self._towards_first()
        joint, drive = self.joint, self.joint.drive
        central = [body.name for body in drive.bodies if body.place == "axis"]
        members = [*central, CARRIER]
        forces = dict(zip(members, found.centre_force[kind] @ turned.T, strict=True))
        speeds = np.append(state.speed[: len(central)], state.speed[-1]) * float(joint.input_speed)
        sun = drive.input if drive.input in central else central[0]
        moments, slip = np.zeros(self.count), np.zeros_like(found.slip_ratio)
        limits: dict[str, np.ndarray] = {}
        if kind == 1:
            slip, limits = found.slip_ratio, {"pressure_over_first_yield": found.pressure_over_first_yield.T}
        if kind == 2:
            slip = found.rolling_slip_ratio
            limits = {"shakedown_ratio": found.shakedown_ratio.T, "life_hours": found.life_hours}
        if kind and torque:
            moments = found.output_moment[kind - 1]
            moments = moments * (torque / moments.sum())
        return BranchState(
            preload=state.normal.reshape(self.count, -1)[:, 0],
            torque=moments,
            slip_ratio=np.max(slip, axis=1),
            sun_displacement=turned @ state.displacement[0] if floating else np.zeros(2),
            sun_force=forces.pop(sun),
            sun=sun,
            limits=limits,
            centre_forces=forces,
            pins=np.array(
                pin_components(drive=drive, force=state.pin_force.reshape(self.count, -1))
            ).swapaxes(1, 2),
            contact_forces=np.array([state.normal, state.tangential])
            .reshape(2, self.count, -1)
            .swapaxes(1, 2),
            bearing_speed=self._bearing_speed(state) if kind == 2 else np.zeros(len(joint.bearing_names)),
            input_torque=float(state.input_torque),
            torques=dict(zip(members, map(float, drive.sense * found.centre_moment[kind]), strict=True)),
            speeds=dict(zip(members, np.abs(speeds) if kind == 2 else np.zeros(speeds.size), strict=True)),
        )

    def _bearing_speed(self, state: Any) -> np.ndarray:
        """Speeds of the bearings of the joint that rolls [rad/s]."""
        joint, bodies = self.joint, self.joint.drive.bodies
        members = joint.drive.members
        central = [body.place == "axis" for body in bodies]
        others = state.speed[sum(central) : -1].reshape(self.count, -1)
        each = np.empty((self.count, len(members)))
        each[:, :-1][:, central] = state.speed[: sum(central)]
        each[:, :-1][:, np.logical_not(central)] = others
        each[:, -1] = state.speed[-1]
        pins = np.abs(each[:, list(joint.drive.pinned)] - each[:, -1:]).max(axis=0)
        ends = np.abs(each[0, [members.index(joint.drive.input), members.index(joint.drive.output)]])
        return np.concatenate([pins, ends]) * float(joint.input_speed)

    def _towards_first(self) -> np.ndarray:
        """Rotation to axes of which the first points to the first roller of the first sector."""
        x, y = np.asarray(self.joint.drive.centres)[self.joint.drive.floating[0]]
        return np.array([[x, y], [-y, x]]) / math.hypot(x, y)
