"""What is known about the unequal branches of a joint."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import jax
import numpy as np

from asperity.branches.sizes import SectorDeviations
from asperity.drive.wedge.geometry import CONTACT_NAMES
from asperity.rolling.power import RollingLosses, RollingPower, power_budget


@dataclass(frozen=True)
class BranchState:
    """The branches of a joint under a torque, standing or in rolling. SI units; branches last, shape (..., n).

    Parameters
    ----------
    preload : ndarray
        Preload of each branch where the sun now is [N]; 0 for a loose one.
    torque : ndarray
        Torque of each branch at the output; they add up to that of the joint [N·m].
    slip_ratio : ndarray
        The largest T/(mu N) of each branch [-]; 1 where it slips, nan where it is loose or was not asked for.
    sun_displacement, sun_force : ndarray
        Displacement of the sun [m], and the force of the planets on it [N], shape (2,); the first planet lies on the
        first axis.
    limits : dict
        By the names of the table of results: standing the Hertz pressure over first yield, in rolling that over the
        shakedown limit, of each contact of each branch, shape (5, n) [-]; and ``life_hours`` at the joint's torque, as
        if all branches were like this one, shape (n,) [h]. Empty where slip was not asked for.
    centre_forces : dict
        Names of the other members on the axis → force of the branches on them, shape (2,) [N].
    pins : ndarray
        Radial and tangential force of the rollers of each branch on their pins, with the signs of the table of loads,
        shape (2, pins, n) [N]. Empty where slip was not asked for.
    contact_forces : ndarray
        Normal and tangential forces of the contacts of each branch, shape (2, contacts, n) [N]. Empty where slip was
        not asked for.
    bearing_speed : ndarray
        Speeds of the rolling bearings of the drive, without signs, shape (bearings,) [rad/s]; 0 where it stands.
    sun : str
        Name of the member that is called the sun here: the input of another drive.
    torques : dict
        Names of the members on the axis → torque of contacts and pins on them, with the signs of the table of loads
        [N·m]; of the sun that of its shaft. Empty where slip was not asked for.
    speeds : dict
        Names of these members → speed, without sign, creep taken off [rad/s]; 0 where the joint stands. Likewise.
    input_torque : float
        Torque at the input of all branches [N·m]: in rolling that of the contacts; nan where slip was not asked for.
    """

    preload: np.ndarray
    torque: np.ndarray
    slip_ratio: np.ndarray
    sun_displacement: np.ndarray
    sun_force: np.ndarray
    limits: dict[str, np.ndarray] = field(default_factory=dict)
    centre_forces: dict[str, np.ndarray] = field(default_factory=dict)
    pins: np.ndarray = field(default_factory=lambda: np.zeros((2, 0, 0)))
    contact_forces: np.ndarray = field(default_factory=lambda: np.zeros((2, 0, 0)))
    bearing_speed: np.ndarray = field(default_factory=lambda: np.zeros(0))
    sun: str = "sun"
    torques: dict[str, float] = field(default_factory=dict)
    speeds: dict[str, float] = field(default_factory=dict)
    input_torque: float = math.nan

    @property
    def share(self) -> np.ndarray:
        """Share of each branch in the torque [-]; 1/n for equal branches, nan without a torque."""
        whole = self.torque.sum()
        return self.torque / whole if whole else np.full_like(self.torque, np.nan)

    @property
    def largest_pins(self) -> np.ndarray:
        """The same forces on each pin of the branch that loads it most, shape (2, pins) [N]."""
        branch = np.argmax(np.hypot(*self.pins), axis=-1)
        return np.take_along_axis(self.pins, branch[None, :, None], axis=-1)[..., 0]

    def force_on(self, member: str) -> float:
        """Size of the force of the branches on a member on the axis [N]; nan where it is not known."""
        if member == self.sun:
            return math.hypot(*self.sun_force)
        return math.hypot(*self.centre_forces.get(member, (math.nan,)))


@dataclass(frozen=True)
class BranchRolling:
    """A joint whose unequal branches roll under its torque. SI units.

    Parameters
    ----------
    speed_loss, drift_per_output_turn, drift_rate : float
        Share of the output speed that creep takes [-]; angle that the output falls behind in one turn of its own [rad],
        and per time [rad/s], nan where the input stands.
    output_speed : float
        Without sign, creep taken off [rad/s].
    power : RollingPower
        Losses, contacts as those of one branch, all branches together, and efficiency; nan where the input stands.
    """

    speed_loss: float
    drift_per_output_turn: float
    drift_rate: float
    output_speed: float
    power: RollingPower


def branch_rolling(
    *,
    losses: RollingLosses,
    speed_loss: float,
    drift_per_output_turn: float,
    output_torque: float,
    output_speed: float,
    input_speed: float,
) -> BranchRolling:
    """What a joint does whose unequal branches roll."""
    power = power_budget(losses, output_power=output_torque * output_speed)
    turns = input_speed > 0.0
    power = jax.tree.map(lambda leaf: np.asarray(leaf) if turns else np.full_like(leaf, np.nan), power)
    rate = drift_per_output_turn * output_speed / (2.0 * math.pi)
    return BranchRolling(speed_loss, drift_per_output_turn, rate if turns else math.nan, output_speed, power)


@dataclass(frozen=True)
class BranchCapacity:
    """How much torque unequal branches pass together, standing or in rolling.

    Parameters
    ----------
    first_slip : float
        Torque at which the weakest branch that is not loose slips [N·m].
    branch : int
        Which one, from 0.
    contact : int or None
        Which of its contacts; None where it was not asked for.
    all_slip : float
        Torque at which all branches slip [N·m]: the most that the drive passes; nan where steady rolling ends at the
        first slip.
    equal : float
        The same for equal branches of nominal size, for which both are one [N·m].
    contact_names : tuple of str, optional
        Names of the contacts of a branch.
    event : str, optional
        What that contact does first.
    """

    first_slip: float
    branch: int
    contact: int | None
    all_slip: float
    equal: float
    contact_names: tuple[str, ...] = CONTACT_NAMES
    event: str = "slips"

    @property
    def contact_name(self) -> str:
        """Name of the contact that slips first; empty where it was not asked for."""
        return "" if self.contact is None else self.contact_names[self.contact]


@dataclass(frozen=True)
class UnequalBranches:
    """What unequal branches do to a joint.

    Parameters
    ----------
    sizes : SectorDeviations
        Sizes of the branches.
    torque, own_preload : float
        Torque of the joint, without sign, and the preload of equal branches [N·m], [N].
    interference, preload : ndarray
        Of each branch without torque, the sun where its bearings let it be, shape (n,) [m], [N].
    rest : BranchState
        Without torque.
    standing, rolling : BranchState or None
        Under the joint's torque; None where it is more than all branches pass.
    capacity, rolling_capacity : BranchCapacity
        At rest and in rolling.
    noun : str, optional
        What a branch is called.
    stiffness : float or None, optional
        Torsional stiffness at the output under the joint's torque, assembled [N·m/rad]; None where it was not computed.
    duty : tuple, optional
        The state of :meth:`working` under each load of the duty.
    turning : BranchRolling or None, optional
        Drift and powers of the rolling joint; None where it does not roll, or where slip was not asked for.
    """

    sizes: SectorDeviations
    torque: float
    own_preload: float
    interference: np.ndarray
    preload: np.ndarray
    rest: BranchState
    standing: BranchState | None
    rolling: BranchState | None
    capacity: BranchCapacity
    rolling_capacity: BranchCapacity
    noun: str = "planet"
    stiffness: float | None = None
    duty: tuple[BranchState | None, ...] = ()
    turning: BranchRolling | None = None

    def working(self, *, turns: bool) -> BranchState | None:
        """The state in which the joint works under its torque: rolling where it turns; None where there is none."""
        return self.rolling if turns else self.standing

    def contact_forces(self, state: BranchState | None) -> tuple[np.ndarray, np.ndarray]:
        """Forces of the contacts in a state and without torque; nan where there is none [N]."""
        rest = self.rest.contact_forces
        return np.full_like(rest, np.nan) if state is None else state.contact_forces, rest

    def cases(self, *, turns: bool) -> tuple[BranchState | None, ...]:
        """States without torque, under the working torque, and under the loads of the duty, as in a table of loads."""
        return (self.rest, self.working(turns=turns), *self.duty)

    @property
    def contact_names(self) -> tuple[str, ...]:
        """Names of the contacts of a branch."""
        return self.capacity.contact_names

    @property
    def beyond_equal(self) -> bool:
        """Whether equal branches do not carry the torque."""
        return self.torque >= self.capacity.equal
