r"""A joint whose branches differ in size: preload, load share and slip of each, capacity, and the sun's displacement.

Each planet and its loading rollers have their own interference, and so their own preload. At rest all branches are
wound up by the same rotation of sun and carrier, from a state without torque into which the drive has rolled; while the
drive turns, all creep by the same share of the speed. The sun moves in its bearings until they balance its forces. A
branch that slips keeps the torque that its friction holds.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
import numpy as np
from scipy.interpolate import CubicSpline
from scipy.optimize import brentq, root

from asperity.drive.geometry import CONTACT_NAMES, angles, speed_ratio, triangle
from asperity.drive.mechanism import RestState, rest_state
from asperity.drive.unequal_branches import (
    added_interference,
    branch_directions,
    force_on_carrier,
    force_on_ring,
    force_on_sun,
)
from asperity.errors import InputError, NoSolutionError
from asperity.joint.branch_law import MEMBERS, BranchLaw, BranchLaws, branch_laws
from asperity.joint.branch_results import (
    BranchCapacity,
    BranchRolling,
    BranchState,
    UnequalBranches,
    branch_rolling,
)
from asperity.joint.branch_sizes import WIDEST, BranchSizes, refuse_loading_cam, refuse_wide
from asperity.joint.description import Joint
from asperity.joint.interference import joint_preload
from asperity.joint.rolling_power import RollingLosses
from asperity.joint.working_loads import loads_at_rest, loads_of_forces

_LENGTHS = 48  # of the curve of preload over interference
_LEAST_SUPPORT = 1e-9  # over preload per interference: holds a floating sun where nothing else does
# shares below the first slip at which its contacts are looked at, until all of them have a state
_BELOW_SLIP = (1e-9, 1e-6, 1e-4, 1e-3, 1e-2)
_TOLERANCE = 1e-13
_BELOW = 1e-9  # share of a branch's torque below which its contacts are looked at
_TURNING = ("speed_loss", "drift_per_output_turn", "output_speed")  # common to all branches


class BranchedJoint:
    """A joint made ready for branches of any sizes: the tables of its branches, and its preload over interference.

    Parameters
    ----------
    joint : Joint
        One joint without a loading cam, its preload by interference.
    interference : float
        Its nominal interference [m].
    """

    def __init__(self, joint: Joint, interference: float) -> None:
        refuse_loading_cam(joint.cam_force_per_torque)
        geometry = joint.geometry
        self.joint, self.interference = joint, interference
        self.own_preload = float(joint.preload)
        self.count = round(float(geometry.planet_count))
        sides = triangle(geometry)
        self.polar = float(angles(sides).polar)
        self.rest: RestState = rest_state(geometry=geometry, sides=sides, preload=1.0)
        length = interference * np.geomspace(1e-3, WIDEST, _LENGTHS)
        plain = dataclasses.replace(joint, fit=None)
        force = np.asarray(joint_preload(plain, jnp.asarray(length)))
        if not np.all(force > 0.0):
            raise InputError("the branches cannot be compared: contacts would be as wide as their bodies")
        self._log_force = CubicSpline(np.log(length), np.log(force))
        self._least = float(length[0])
        self.laws: BranchLaws = branch_laws(joint, largest_preload=float(force[-1]))
        still = loads_of_forces(joint, jnp.zeros(len(CONTACT_NAMES)), jnp.zeros(len(CONTACT_NAMES)))
        self.friction = dict(
            zip(
                MEMBERS,
                map(float, (still.sun_torque, still.carrier_torque, still.housing_torque)),
                strict=True,
            )
        )
        self._turned = 1.0 / (float(geometry.sun_radius) * abs(float(speed_ratio(geometry))))

    def preload(self, interference: np.ndarray) -> np.ndarray:
        """Preload that an interference makes in a branch, 0 without one [N]; beyond the tables in proportion to it."""
        inside = np.clip(interference, self._least, WIDEST * self.interference)
        nominal = self._log_force(math.log(self.interference))
        found = self.own_preload * np.exp(
            self._log_force(np.log(inside)) - nominal
        )  # exact for the nominal one
        return np.where(interference > 0.0, found * interference / inside, 0.0)

    def branches(self, sizes: BranchSizes, *, slip: bool = True) -> UnequalBranches:
        """Everything about branches of given sizes.

        Parameters
        ----------
        sizes : BranchSizes
            One deviation for each planet.
        slip : bool, optional
            Whether the slip ratios of the contacts are wanted, which take most of the time.

        Returns
        -------
        UnequalBranches
            At rest, under the joint's torque, and at slip.

        Raises
        ------
        InputError
            If the number of sizes is not that of the planets, or every branch is loose.
        NoSolutionError
            If no balance of the sun was found.
        """
        if sizes.planet.size != self.count:
            raise InputError(
                f"the drive has {self.count} planets, got the sizes of {sizes.planet.size} branches"
            )
        standing = _Solver(self, sizes, self.laws.standing, turns=False, slip=slip)
        rolling = _Solver(self, sizes, self.laws.rolling, turns=True, slip=slip)
        rest = standing.at(0.0)
        if not np.any(rest.preload > 0.0):
            raise InputError(
                "the deviations of the radii leave no branch with an interference: the drive is loose"
            )
        torque = abs(float(self.joint.output_torque))
        return UnequalBranches(
            sizes=sizes,
            torque=torque,
            own_preload=self.own_preload,
            interference=standing.lengths(rest.sun_displacement),
            preload=rest.preload,
            rest=rest,
            standing=standing.under(torque),
            rolling=(turns := rolling.under(torque)),
            capacity=standing.capacity(),
            rolling_capacity=rolling.capacity(),
            turning=None if turns is None or not slip else self._turning(turns),
        )

    def _turning(self, state: BranchState) -> BranchRolling:
        """Drift and powers of the joint that turns."""
        joint, found = self.joint, self.laws.states(state.preload, self.count * state.torque * (1.0 - _BELOW))
        bears = state.preload > 0.0
        speeds = {name: float(np.mean(found[name][bears])) for name in _TURNING}
        shafts = 2.0 * (
            joint.bearings.sun_torque * joint.sun_speed
            + joint.bearings.carrier_torque * speeds["output_speed"]
        )
        losses: dict[str, Any] = {
            name: _of_all(found[name], bears, float(shafts) if name == "bearings" else 0.0)
            for name in RollingLosses._fields
        }
        return branch_rolling(
            losses=RollingLosses(**losses),
            output_torque=float(joint.output_torque),
            input_speed=float(joint.sun_speed),
            **speeds,
        )

    def working(self, sizes: BranchSizes) -> BranchState | None:
        """The state in which branches work under the joint's torque, as one of :meth:`branches`."""
        turns = float(self.joint.sun_speed) != 0.0
        law = self.laws.rolling if turns else self.laws.standing
        return _Solver(self, sizes, law, turns=turns, slip=True).under(abs(float(self.joint.output_torque)))

    def sun_turns(self, displacement: np.ndarray) -> np.ndarray:
        """Angle at the output by which a displacement of the sun winds up each branch, shape (n,) [rad]."""
        _, along = branch_directions(self.count)
        return np.asarray(self.laws.direction * self._turned * (along @ displacement))


class _Solver:
    """Branches of given sizes, standing or in rolling: one common angle or speed loss decides everything."""

    def __init__(
        self, drive: BranchedJoint, sizes: BranchSizes, law: BranchLaw, *, turns: bool, slip: bool
    ) -> None:
        self.drive, self.sizes, self.law, self.turns, self.slip = drive, sizes, law, turns, slip
        self.radial, _ = branch_directions(drive.count)
        none = {"planet": 0.0, "right_roller": 0.0, "left_roller": 0.0}
        self.per_approach = float(added_interference(rest=drive.rest, approach=1.0, **none))
        own = added_interference(
            rest=drive.rest,
            approach=0.0,
            planet=jnp.asarray(sizes.planet),
            right_roller=jnp.asarray(sizes.right_roller),
            left_roller=jnp.asarray(sizes.left_roller),
        )
        self.own = drive.interference + np.asarray(own)
        self.origin = self._last = np.zeros(2)
        if not turns:
            self.origin = self._found(lambda moved: self._loads(np.zeros(drive.count), moved)[2])

    def lengths(self, displacement: np.ndarray) -> np.ndarray:
        """Interference of each branch [m]."""
        return self.own + self.per_approach * (self.radial @ displacement)

    def _demands(self, common: float, displacement: np.ndarray) -> np.ndarray:
        even = np.full(self.drive.count, common)
        return even if self.turns else even + self.drive.sun_turns(displacement - self.origin)

    def _loads(
        self, demand: np.ndarray, displacement: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Preload, share of the capacity, and the force on the sun."""
        preload = self.drive.preload(self.lengths(displacement))
        share = self.law.share(preload, demand)
        normal, tangential = self.law.sun_forces(preload, share)
        return preload, share, force_on_sun(normal=normal, tangential=tangential)

    def displacement(self, common: float) -> np.ndarray:
        """Displacement of the sun at an angle or a speed loss [m]."""
        return self._found(lambda moved: self._loads(self._demands(common, moved), moved)[2])

    def _found(self, force_at: Callable[[np.ndarray], np.ndarray]) -> np.ndarray:
        """Displacement of the sun at which its bearings balance the planets [m]."""
        support, force = self.sizes.sun_support_stiffness, self.drive.own_preload
        held = np.zeros(2)
        if math.isinf(support):
            return held
        size = self.drive.interference
        support = max(support, _LEAST_SUPPORT * force / size)

        def misfit(scaled: np.ndarray) -> np.ndarray:
            moved = scaled * size
            return (force_at(moved) - support * moved) / force

        if np.max(np.abs(misfit(held))) < _TOLERANCE:
            return held
        found = root(misfit, self._last, method="hybr", options={"xtol": 1e-12})
        left = float(np.max(np.abs(misfit(found.x))))
        if left > 1e-6:
            raise NoSolutionError(
                f"no place was found at which the bearings of the sun balance its branches: {left:.1g} of the preload "
                "are left; hold the sun, by leaving out compliance.sun_support_stiffness, or state smaller deviations"
            )
        self._last = found.x  # near the next one
        return np.asarray(found.x * size)

    def total(self, common: float) -> float:
        """Torque of all branches [N·m]."""
        moved = self.displacement(common)
        preload, share, _ = self._loads(self._demands(common, moved), moved)
        return float(np.mean(self.law.torque(preload, share)))

    def _most(self) -> float:
        """An angle or speed loss at which all branches slip."""
        most = 3.0 * self.drive.preload(np.array([np.max(self.own), self.drive.interference])).max()
        return 3.0 * float(self.law.demand_at_slip(min(most, float(self.law.preloads[-1]))))

    def under(self, torque: float) -> BranchState | None:
        """The state under a torque; None where all branches slip below it."""
        most = self._most()
        if torque > 0.0 and self.total(most) < torque:
            return None
        common = 0.0 if torque == 0.0 else _zero(lambda x: self.total(x) - torque, most)
        state = self.at(common)
        whole = float(np.sum(state.torque))
        # the common angle is found to rounding only
        return dataclasses.replace(state, torque=state.torque * (torque / whole)) if whole > 0.0 else state

    def at(self, common: float) -> BranchState:
        """The state at an angle or a speed loss."""
        moved = self.displacement(common)
        refuse_wide(self.lengths(moved), self.drive.interference)
        preload, share, force = self._loads(self._demands(common, moved), moved)
        torque = self.law.torque(preload, share)
        slip, known = np.full((len(CONTACT_NAMES), self.drive.count), np.nan), {}
        if self.slip:
            known = self._contacts(preload, torque * (1.0 - _BELOW), loaded=self.turns or common > 0.0)
            slip = known.pop("slip_ratio")
        return BranchState(
            preload=preload,
            torque=torque / self.drive.count,
            slip_ratio=np.where(preload > 0.0, np.where(share >= 1.0, 1.0, np.max(slip, axis=0)), np.nan),
            sun_displacement=moved,
            sun_force=force,
            **known,
        )

    def _contacts(self, preload: np.ndarray, torque: np.ndarray, *, loaded: bool) -> dict[str, Any]:
        """What the contacts of each branch do, as fields of its state, without the tables; or the preload alone."""
        drive, bears = self.drive, preload > 0.0
        found = drive.laws.states(preload, torque)
        prefix = "rolling_" if self.turns else ""
        limits = ("shakedown_ratio", "life_hours") if self.turns else ("pressure_over_first_yield",)
        forces = np.stack([found[f"{prefix}{kind}"] for kind in ("normal", "tangential")])
        pins = found[f"{prefix}pins"]
        if not loaded:
            forces = np.stack([np.outer(drive.rest.normal_force, preload), np.zeros(forces.shape[1:])])
            free = loads_at_rest(dataclasses.replace(drive.joint, preload=1.0))
            pins = np.stack([free.pin_radial, free.pin_tangential])[..., None] * preload
        forces, pins = (np.where(bears, each, 0.0) for each in (forces, pins))
        speed = np.max(np.where(bears, found["bearing_speed"], 0.0), axis=-1)
        torques = {
            name: float(_of_all(found[f"{prefix}{name}_torque"], bears, drive.friction[name]))
            for name in MEMBERS
        }
        return {
            "slip_ratio": found[f"{prefix}slip_ratio"],
            "limits": {name: found[name] for name in limits},
            "pins": pins,
            "contact_forces": forces,
            "centre_forces": {
                "carrier": force_on_carrier(radial=pins[0], tangential=pins[1], polar=drive.polar),
                "ring": force_on_ring(normal=forces[0, 3:], tangential=forces[1, 3:], polar=drive.polar),
            },
            "bearing_speed": speed if self.turns else np.zeros_like(speed),
            "torques": torques if loaded else {},
            "input_torque": torques["sun"] if loaded else 0.0,
            "speeds": dict(zip(("sun", "carrier"), speed[2:], strict=True)) if self.turns else {},
        }

    def _used(self, common: float) -> float:
        """How far the branch nearest to slip is wound up or creeps, over that at which it slips."""
        moved = self.displacement(common)
        preload = self.drive.preload(self.lengths(moved))
        bears = preload > 0.0
        return float(np.max(self._demands(common, moved)[bears] / self.law.demand_at_slip(preload[bears])))

    def capacity(self) -> BranchCapacity:
        """Torque at the first slip, and that at which all branches slip."""
        most = self._most()
        first = _zero(lambda x: self._used(x) - 1.0, most)
        moved = self.displacement(first)
        preload = self.drive.preload(self.lengths(moved))
        over = np.where(
            preload > 0.0,
            self._demands(first, moved) / self.law.demand_at_slip(np.maximum(preload, 1e-9)),
            0.0,
        )
        branch = int(np.argmax(over))
        slips = np.full(len(CONTACT_NAMES), np.nan)
        for below in _BELOW_SLIP if self.slip else ():
            almost = self.law.torque(preload, np.minimum(over, 1.0) * (1.0 - below))
            slips = self._contacts(preload, almost, loaded=True)["slip_ratio"][:, branch]
            if np.all(np.isfinite(slips)):
                break
        return BranchCapacity(
            first_slip=self.total(first),
            branch=branch,
            contact=int(np.nanargmax(slips)) if np.any(np.isfinite(slips)) else None,
            all_slip=self.total(most),
            equal=float(self.law.capacity(self.drive.own_preload)),
        )


def _of_all(each: np.ndarray, bears: np.ndarray, common: float) -> np.ndarray:
    """What all branches do together, from what the drive would do if all were like each; a loose one does nothing.

    ``common`` is the part of each that no branch does.
    """
    own = np.where(bears, each - common, 0.0)
    return np.asarray(np.sum(own, axis=-1) / bears.size + common)


def _zero(function: Callable[[float], float], upper: float) -> float:
    return float(brentq(function, 0.0, upper, xtol=1e-15 * upper, rtol=1e-14))
