r"""A joint whose branches differ in size: preload, load share and slip of each, capacity, and the sun's displacement.

Each planet and its loading rollers have their own interference, and so their own preload. At rest all branches are
wound up by the same rotation of sun and carrier, from a state without torque into which the drive has rolled; while the
drive turns, all creep by the same share of the speed. The sun moves in its bearings until they balance its forces. A
branch that slips keeps the torque that its friction holds.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import jax.numpy as jnp
import numpy as np
from scipy.interpolate import CubicSpline

from asperity.drive.geometry import CONTACT_NAMES, angles, speed_ratio, triangle
from asperity.drive.mechanism import RestState, rest_state
from asperity.drive.planar.stiffness import with_shafts
from asperity.drive.unequal_branches import (
    branch_directions,
)
from asperity.errors import InputError
from asperity.joint.branch_law import MEMBERS, BranchLaws, branch_laws
from asperity.joint.branch_results import (
    BranchRolling,
    BranchState,
    UnequalBranches,
    branch_rolling,
)
from asperity.joint.branch_sizes import WIDEST, BranchSizes, refuse_loading_cam
from asperity.joint.branch_solver import JUST_BELOW, BranchSolver, all_together
from asperity.joint.description import Joint
from asperity.joint.interference import joint_preload
from asperity.joint.rolling_power import RollingLosses
from asperity.joint.working_loads import loads_of_forces

_LENGTHS = 48  # of the curve of preload over interference
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
        standing = BranchSolver(self, sizes, self.laws.standing, turns=False, slip=slip)
        rolling = BranchSolver(self, sizes, self.laws.rolling, turns=True, slip=slip)
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
            stiffness=self._stiffness(standing, torque) if slip else None,
        )

    def _stiffness(self, standing: BranchSolver, torque: float) -> float | None:
        """Stiffness of the assembled joint that stands under a torque; None where its branches do not carry it."""
        found = standing.points(np.array([torque]))
        if not found.carried[0]:
            return None
        compliance = self.laws.states(found.preload[0], found.torque[0] * (1.0 - JUST_BELOW))["compliance"]
        holds = (found.preload[0] > 0.0) & ~found.slips[0] & (compliance > 0.0)
        each = np.where(holds, 1.0 / np.where(holds, compliance, 1.0), 0.0)
        structure = self.joint.structure
        whole, *_ = with_shafts(
            stiffness=jnp.asarray(found.moving_sun[0] * np.mean(each)),
            ratio=speed_ratio(self.joint.geometry),
            input_shaft_stiffness=structure.input_shaft_stiffness,
            output_shaft_stiffness=structure.output_shaft_stiffness,
        )
        return float(whole)

    def _turning(self, state: BranchState) -> BranchRolling:
        """Drift and powers of the joint that turns."""
        joint, found = (
            self.joint,
            self.laws.states(state.preload, self.count * state.torque * (1.0 - JUST_BELOW)),
        )
        bears = state.preload > 0.0
        speeds = {name: float(np.mean(found[name][bears])) for name in _TURNING}
        shafts = 2.0 * (
            joint.bearings.sun_torque * joint.sun_speed
            + joint.bearings.carrier_torque * speeds["output_speed"]
        )
        losses: dict[str, Any] = {
            name: all_together(found[name], bears, float(shafts) if name == "bearings" else 0.0)
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
        return BranchSolver(self, sizes, law, turns=turns, slip=True).under(
            abs(float(self.joint.output_torque))
        )

    def solver(self, sizes: BranchSizes, *, turns: bool) -> BranchSolver:
        """How branches of given sizes share torques, standing or in rolling."""
        law = self.laws.rolling if turns else self.laws.standing
        return BranchSolver(self, sizes, law, turns=turns, slip=False)

    def sun_turns(self, displacement: np.ndarray) -> np.ndarray:
        """Angle at the output by which a displacement of the sun, shape (..., 2), winds up each branch [rad]."""
        _, along = branch_directions(self.count)
        return np.asarray(self.laws.direction * self._turned * (displacement @ along.T))
