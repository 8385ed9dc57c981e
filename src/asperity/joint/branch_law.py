"""What one branch of a joint does, by its preload and by how far it is wound up or how fast it creeps: as tables."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jax import Array
from scipy.interpolate import CubicSpline, PchipInterpolator, RectBivariateSpline

from asperity.compilation import compile_fast
from asperity.errors import InputError
from asperity.joint.capacity import torque_capacity
from asperity.joint.description import Joint
from asperity.joint.evaluation import evaluate
from asperity.joint.rolling_capacity import rolling_torque_capacity
from asperity.joint.rolling_power import losses_of
from asperity.joint.working_loads import bearing_speeds, loads_of_forces, stacked_speeds

_PRELOADS, _STEPS, _SHARES = 12, 24, 41
_LEAST_PRELOAD = 0.05  # of the joint's own; below, forces and capacity are in proportion to the preload
#: Members on the axis, in the order of the torques of :class:`asperity.drive.structure_loads.StructureLoads`.
MEMBERS = ("sun", "carrier", "ring")

_ALMOST = 1.0 - 1e-9  # of the capacity: a contact that slips has no stiffness


@dataclass(frozen=True)
class BranchLaw:
    """Share of its capacity that a branch uses, over what it is forced to do.

    Parameters
    ----------
    preloads : ndarray
        Preloads of the tables, increasing, shape (m,) [N].
    capacity : callable
        Torque at the output, for the whole drive, at which branches of a preload slip [N·m].
    demand_at_slip : callable
        What the branch is forced to do when it slips: angle at the output [rad], or speed loss [-].
    used, normal, tangential : RectBivariateSpline
        Over demand over that at slip, and logarithm of the preload: share of the capacity; over that share and the
        logarithm: forces of the sun's contact over the preload [-].
    """

    preloads: np.ndarray
    capacity: Callable[[Any], np.ndarray]
    demand_at_slip: Callable[[Any], np.ndarray]
    used: RectBivariateSpline
    normal: RectBivariateSpline
    tangential: RectBivariateSpline

    def share(self, preload: np.ndarray, demand: np.ndarray) -> np.ndarray:
        """Share of its capacity that each branch uses, −1 to 1; 1 where it slips, 0 where it is loose."""
        bears = preload > 0.0
        limit = np.where(bears, self.demand_at_slip(np.maximum(preload, 0.0)), 1.0)
        over = np.where(bears & (limit > 0.0), demand / np.where(limit > 0.0, limit, 1.0), 0.0)
        size = np.minimum(np.abs(over), 1.0)
        found = np.clip(self.used.ev(size, self._log(preload)), 0.0, 1.0)
        return np.sign(over) * np.where(size >= 1.0, 1.0, found)

    def torque(self, preload: np.ndarray, share: np.ndarray) -> np.ndarray:
        """Torque of each branch, for the whole drive [N·m]."""
        return share * np.where(preload > 0.0, self.capacity(np.maximum(preload, 0.0)), 0.0)

    def sun_forces(self, preload: np.ndarray, share: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Normal and tangential force of each branch's sun contact [N].

        What the bearings take has the sense of the drive's motion, also in a branch that is wound back.
        """
        place = self._log(preload)
        bears, size = np.maximum(preload, 0.0), np.abs(share)
        friction = self.tangential.ev(np.zeros_like(size), place)
        tangential = friction + np.sign(share) * (self.tangential.ev(size, place) - friction)
        return bears * self.normal.ev(size, place), bears * tangential

    def _log(self, preload: np.ndarray) -> np.ndarray:
        return np.log(np.clip(preload, self.preloads[0], self.preloads[-1]))


@dataclass(frozen=True)
class BranchLaws:
    """Both laws of a joint's branches, and the program behind their tables.

    Parameters
    ----------
    standing, rolling : BranchLaw
        Over the angle at the output with the sun held, and over the speed loss.
    joint : Joint
        The joint, its numbers as NumPy arrays.
    direction : float
        Sense of the torque, +1 or −1.
    """

    standing: BranchLaw
    rolling: BranchLaw
    joint: Joint
    direction: float

    def states(self, preload: np.ndarray, torque: np.ndarray) -> dict[str, np.ndarray]:
        """Forces and slip of branches, without the tables.

        Parameters
        ----------
        preload, torque : ndarray
            Of each branch, shape (n,); the torques as if all branches carried the same, without sign [N], [N·m].

        Returns
        -------
        dict
            Normal and tangential forces and slip ratios, standing and in rolling, Hertz pressure over first yield and
            over the shakedown limit, shape (5, n); radial and tangential forces on the pins, shape (2, 2, n); speeds of
            the bearings, shape (4, n); speed loss, life [h], compliance at the output [rad/(N·m)] and torques of sun,
            carrier and ring as of :class:`asperity.drive.structure_loads.StructureLoads`, shape (n,); what the drive
            loses and drifts if all branches were like one, as of :class:`asperity.joint.rolling.RollingResult`. nan
            where a branch is loose.
        """
        shape = (_PRELOADS, _STEPS)
        most = shape[0] * shape[1]
        if preload.size > most:
            raise InputError(f"at most {most} branches, got {preload.size}")
        bears = preload > 0.0
        whole = float(self.joint.preload)
        n, x = np.full(most, whole), np.zeros(most)
        n[: preload.size], x[: preload.size] = np.where(bears, preload, whole), np.where(bears, torque, 0.0)
        found = _program(self.joint, n.reshape(shape), self.direction * x.reshape(shape))
        flat = {name: value.reshape(*value.shape[:-2], most) for name, value in found.items()}
        return {name: np.where(bears, value[..., : preload.size], np.nan) for name, value in flat.items()}


def branch_laws(joint: Joint, *, largest_preload: float) -> BranchLaws:
    """Tables of what the branches of a joint do.

    Parameters
    ----------
    joint : Joint
        One joint without a loading cam.
    largest_preload : float
        Preload up to which the tables reach, larger than the joint's own [N].

    Returns
    -------
    BranchLaws
        In the direction of the joint's torque.

    Raises
    ------
    InputError
        If friction does not limit the torque, or the joint has no stiffness.
    """
    numbers: Joint = jax.tree.map(lambda leaf: np.asarray(leaf, dtype=float), joint)
    numbers = dataclasses.replace(numbers, fit=None, rolling=dataclasses.replace(numbers.rolling, duty=()))
    direction = -1.0 if float(numbers.output_torque) < 0.0 else 1.0
    own = float(numbers.preload)
    preloads = np.geomspace(_LEAST_PRELOAD * own, 1.02 * largest_preload, _PRELOADS)
    preloads[1 + np.argmin(np.abs(np.log(preloads[1:-1] / own)))] = own  # exact there
    points = dataclasses.replace(numbers, preload=jnp.asarray(preloads))
    standing, rolling = (
        np.asarray(each)
        for each in compile_fast(_capacities, points, np.full(_PRELOADS, direction))(
            points, np.full(_PRELOADS, direction)
        )
    )
    if not (np.isfinite(standing).all() and standing.max() > 0.0):
        raise InputError("the branches cannot be compared: their torque has no limit, or they pass none")
    rolling = np.minimum(rolling, standing)
    laws = []
    for capacity, rolls in ((standing, False), (rolling, True)):
        holds = capacity > 0.0
        capacity = np.where(holds, capacity, capacity[holds].min())
        steps = np.linspace(0.0, 1.0, _STEPS)
        used = 1.0 - (1.0 - steps) ** 3  # stiffness and creep are steep near slip
        used[-1] = _ALMOST
        found = _program(
            numbers, np.repeat(preloads[:, None], _STEPS, 1), direction * capacity[:, None] * used
        )
        laws.append(_law(preloads, capacity, holds, steps, used, found, rolls))
    return BranchLaws(laws[0], laws[1], numbers, direction)


def _law(
    preloads: np.ndarray,
    capacity: np.ndarray,
    holds: np.ndarray,
    steps: np.ndarray,
    used: np.ndarray,
    found: dict[str, np.ndarray],
    rolls: bool,
) -> BranchLaw:
    demand = _speed_loss(used, found) if rolls else _angle(steps, capacity, found)
    prefix = "rolling_" if rolls else ""
    normal, tangential = (
        _without_gaps(used, found[f"{prefix}{kind}"][0]) / preloads[:, None]
        for kind in ("normal", "tangential")
    )
    if not np.all(np.isfinite(demand[holds])):
        raise InputError(
            "the branches cannot be compared: the joint has no stiffness or no creep at some preload"
        )
    at_slip = demand[:, -1]
    even = np.linspace(0.0, 1.0, _SHARES)
    rows = np.array([PchipInterpolator(each / each[-1], used)(even) for each in demand[holds]])
    rows[:, -1] = 1.0
    logarithm = np.log(preloads[holds])
    order = min(3, logarithm.size - 1)

    def table(x: np.ndarray, values: np.ndarray) -> RectBivariateSpline:
        return RectBivariateSpline(x, logarithm, values.T, kx=3, ky=order)

    reach = np.append(used[:-1], 1.0)
    return BranchLaw(
        preloads=preloads[holds],
        capacity=_over_preload(preloads[holds], capacity[holds], proportional=True),
        demand_at_slip=_over_preload(preloads[holds], at_slip[holds], proportional=False),
        used=table(even, rows),
        normal=table(reach, normal[holds]),
        tangential=table(reach, tangential[holds]),
    )


def _over_preload(
    preloads: np.ndarray, values: np.ndarray, *, proportional: bool
) -> Callable[[Any], np.ndarray]:
    """Positive values, cubic in the logarithms; below the smallest preload in proportion to it, or constant."""
    curve = CubicSpline(np.log(preloads), np.log(values))

    def at(preload: Any) -> np.ndarray:
        found = np.exp(curve(np.log(np.clip(preload, preloads[0], preloads[-1]))))
        return found * np.minimum(np.maximum(preload, 0.0) / preloads[0], 1.0) if proportional else found

    return at


def _angle(steps: np.ndarray, capacity: np.ndarray, found: dict[str, np.ndarray]) -> np.ndarray:
    """Angle at the output of a branch, the integral of its compliance over the torque."""
    slope = np.zeros_like(found["compliance"])  # at slip the compliance grows less than the steps shrink
    slope[:, :-1] = found["compliance"][:, :-1] * 3.0 * capacity[:, None] * (1.0 - steps[:-1]) ** 2
    return np.array([CubicSpline(steps, each).antiderivative()(steps) for each in slope])


def _speed_loss(used: np.ndarray, found: dict[str, np.ndarray]) -> np.ndarray:
    """Share of the speed that a branch loses, beyond that without torque."""
    loss = np.abs(_without_gaps(used, found["speed_loss"]))
    return loss - loss[:, :1]


def _without_gaps(used: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values whose last ones, at the very slip, may be missing."""
    filled = values.copy()
    for row in filled:
        known = np.isfinite(row)
        if known.sum() > 3:
            row[~known] = PchipInterpolator(used[known], row[known])(used[~known])
    return filled


def _program(joint: Joint, preload: np.ndarray, torque: np.ndarray) -> dict[str, np.ndarray]:
    points = dataclasses.replace(joint, preload=jnp.asarray(preload), output_torque=jnp.asarray(torque))
    return {name: np.asarray(value) for name, value in compile_fast(_states, points)(points).items()}


def _states(joint: Joint) -> dict[str, Array]:
    result = evaluate(joint)
    assembly, rolling = result.assembly, result.rolling
    shafts = assembly.input_shaft_share + assembly.output_shaft_share  # common to all branches
    shape = jnp.broadcast_shapes(jnp.shape(joint.preload), jnp.shape(joint.output_torque))
    found: dict[str, Any] = {
        "normal": result.forces.normal,
        "tangential": result.forces.tangential,
        "slip_ratio": result.diagnostics.slip_ratio,
        "rolling_normal": rolling.normal,
        "rolling_tangential": rolling.tangential,
        "rolling_slip_ratio": rolling.slip_ratio,
        "pressure_over_first_yield": result.diagnostics.pressure_over_first_yield,
        "shakedown_ratio": rolling.shakedown_ratio,
        "life_hours": rolling.life_hours.drive,
        "speed_loss": rolling.speed_loss,
        "compliance": jnp.asarray((1.0 - shafts) / assembly.stiffness.output),
        "bearing_speed": stacked_speeds(bearing_speeds(joint, result)),
        "drift_per_output_turn": rolling.drift_per_output_turn,
        "output_speed": rolling.output_speed,
        **losses_of(rolling.power)._asdict(),
    }
    for prefix, forces in (("", result.forces), ("rolling_", rolling)):
        loads = loads_of_forces(joint, forces.normal, forces.tangential)
        found |= {f"{prefix}pins": jnp.stack([loads.pin_radial, loads.pin_tangential])}
        found |= {
            f"{prefix}{name}_torque": jnp.asarray(value)
            for name, value in zip(
                MEMBERS, (loads.sun_torque, loads.carrier_torque, loads.housing_torque), strict=True
            )
        }
    return {
        name: jnp.broadcast_to(
            jnp.where(result.solved, value, jnp.nan),
            (*value.shape[: value.ndim - result.solved.ndim], *shape),
        )
        for name, value in found.items()
    }


def _capacities(joint: Joint, direction: Array) -> tuple[Array, Array]:
    return (
        torque_capacity(joint, direction=direction).output_torque,
        rolling_torque_capacity(joint, direction=direction),
    )
