"""The curve that a joint with given unknowns would show, with its derivatives by the unknowns.

Angles are weighted sums of the compliance at fixed torques. So is the drift of a joint that rolls: torque times drift
per torque, which stands in for the compliance there.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import jax.numpy as jnp
import numpy as np

from asperity.errors import InputError
from asperity.joint.play import play_compliance
from asperity.joint_file.build import joint_from_values
from asperity.joint_file.section_build import play_of
from asperity.joint_file.si_tables import AnyCase, numeric_keys, replace_values, si_values
from asperity.standing.windup import StiffnessLevel, is_symmetric
from asperity.study.calibration.joint_points import JointPoints, joint_points
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.torque_history import History, curve_operator
from asperity.study.calibration.unknowns import CURVE_UNKNOWNS, added_to_curve
from asperity.study.design.design_problem import Variable
from asperity.types import Document

#: Below this share of its median a stiffness is replaced by this value, so that a search that strays past the
#: torque capacity finds back. A fit that ends there is refused.
STIFFNESS_FLOOR = 0.01

#: Torques of a drift curve, each of which is solved, at most.
MOST_DRIFT_TORQUES = 1000

#: Points of one call for many sets of unknowns: up to here the program that the fit uses serves.
_POINTS = 4096


class CurveModel:
    """Predicts a measurement from scaled values of the unknowns (0 at the lower bound, 1 at the upper).

    ``case``: the joint file; ``measurement``: torques, times and repetitions of the data, and what was measured;
    ``unknowns``: what is looked for; ``level``: which stiffness the joint is taken to have, on which a drift does not
    depend; ``history``, "virgin" or "cycled": state before the first row, of which a drift has none. An ``InputError``
    is raised if all torques are zero, or a drift curve has too many different ones.
    """

    def __init__(
        self,
        *,
        case: AnyCase,
        measurement: Measurement,
        unknowns: tuple[Variable, ...],
        level: StiffnessLevel,
        history: History,
    ) -> None:
        self.unknowns, self.level, self.measurement = unknowns, level, measurement
        self.values = si_values(case)
        self.in_joint = [index for index, unknown in enumerate(unknowns) if not added_to_curve(unknown.path)]
        self.in_curve = [index for index in range(len(unknowns)) if index not in self.in_joint]
        self.paths = tuple(unknowns[index].path for index in self.in_joint)
        stated = numeric_keys(case)
        self.first = np.array([self._first(unknown, stated) for unknown in unknowns])
        self.rolls = measurement.drift is not None
        self._kept: tuple[np.ndarray, JointPoints] | None = None
        symmetric = self._symmetric()
        if self.rolls:
            self.torque = np.unique(measurement.torque[measurement.torque != 0.0])
            self.slips = np.ones(self.torque.size, bool)
            _refuse_torques(self.torque, measurement)
            self.weights: np.ndarray | None = np.where(
                measurement.torque[:, None] == self.torque, self.torque, 0.0
            )
        elif measurement.angle is not None:
            operator = curve_operator(measurement.torque, history, symmetric=symmetric)
            self.torque, self.slips = operator.torque, operator.slips
            self.weights = operator.weights
        else:
            self.torque = np.abs(measurement.torque) if symmetric else measurement.torque
            self.slips, self.weights = np.ones(self.torque.size, bool), None

    def _symmetric(self) -> bool:
        """Whether the joint behaves alike in both directions, whatever its unknowns are."""
        between = {
            self.unknowns[index].path: float(
                self.unknowns[index].from_unit(0.3 + 0.4 * order / len(self.unknowns))
            )
            for order, index in enumerate(self.in_joint)
        }
        return "branch" not in self.values and is_symmetric(
            joint_from_values(replace_values(self.values, between))
        )

    def _first(self, unknown: Variable, stated: dict) -> float:
        """Scaled value of the first guess: the file's value, no play, no drift."""
        kind = _kind(unknown.path)
        if kind in CURVE_UNKNOWNS:
            guess = 0.0 if kind == "drift" else 0.5 * (unknown.lower + unknown.upper)
        elif unknown.path in stated:
            guess = stated[unknown.path].value
        elif unknown.path == "play.angle":
            guess = 0.0
        else:
            guess = float(unknown.from_unit(0.5))
        return float(np.clip(unknown.to_unit(min(max(guess, unknown.lower), unknown.upper)), 0.01, 0.99))

    def point(self, scaled_values: np.ndarray) -> dict[str, float]:
        """Values [SI] of the unknowns."""
        return {u.path: float(u.from_unit(p)) for u, p in zip(self.unknowns, scaled_values, strict=True)}

    def stiffness(self, scaled_values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Stiffness at the model's torques, its slopes by the joint's unknowns, largest slip ratio at rest [SI].

        Of a joint that rolls, torque over drift per turn instead of the stiffness.
        """
        if self._kept is None or not np.array_equal(self._kept[0], scaled_values):
            point = self.point(scaled_values)
            one = np.array([[point[path] for path in self.paths]])
            self._kept = scaled_values.copy(), self._points(one, self.torque, self.slips, slopes=True)
        points = self._kept[1]
        value, by_joint, slip = points.value[0], points.slopes[0], points.slip_ratio[0]
        if self.rolls:
            return self.torque / value, by_joint * (-self.torque / value**2)[:, None], slip
        return value, by_joint, slip

    def _points(
        self, sets: np.ndarray, torque: np.ndarray, slips: np.ndarray, *, slopes: bool
    ) -> JointPoints:
        """The joint's curve for each row of its unknowns, shape (sets, unknowns of the joint) [SI]."""
        return joint_points(
            self.values,
            self.paths,
            sets,
            torque=torque,
            slips=slips,
            shown="drift" if self.rolls else self.level,
            slopes=slopes,
        )

    def floored(self, stiffness: np.ndarray) -> np.ndarray:
        """At which of the model's torques :data:`STIFFNESS_FLOOR` replaces the joint's stiffness there [N·m/rad]."""
        return ~np.isfinite(stiffness) | (stiffness < self._floor(stiffness))

    def _floor(self, stiffness: np.ndarray) -> float:
        usable = np.isfinite(stiffness) & (stiffness > 0.0)
        return STIFFNESS_FLOOR * float(np.median(stiffness[usable])) if usable.any() else 1.0

    def __call__(self, scaled_values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Predicted angles [rad], stiffnesses [N·m/rad] or drifts per turn [rad], with derivatives by scaled values.

        Shape (points,) and (points, unknowns).
        """
        point = self.point(scaled_values)
        steps = np.array([u.slope(point[u.path]) for u in self.unknowns])
        stiffness, by_joint, _ = self.stiffness(scaled_values)
        floored = self.floored(stiffness)
        safe = np.where(floored, self._floor(stiffness), stiffness)
        slopes = np.zeros((self.measurement.torque.size, len(self.unknowns)))
        by_joint = np.where(floored[:, None] | ~np.isfinite(by_joint), 0.0, by_joint)
        if self.weights is None:
            factor = 1.0 / (1.0 + safe * self._play_compliance())
            slopes[:, self.in_joint] = by_joint * factor[:, None] ** 2
            return safe * factor, slopes * steps
        slopes[:, self.in_joint] = self.weights @ (-by_joint / safe[:, None] ** 2)
        for index in self.in_curve:
            slopes[:, index] = self.curve_slope(self.unknowns[index].path, point)
        return self.weights @ (1.0 / safe) + self.curve_part(point), slopes * steps

    def of_joint(self, scaled_values: np.ndarray) -> np.ndarray:
        """What a relative error of the joint's compliance does to the prediction, shape (points,) [rad, N·m/rad]."""
        prediction, _ = self(scaled_values)
        if self.weights is not None:
            return prediction - self.curve_part(self.point(scaled_values))
        stiffness, _, _ = self.stiffness(scaled_values)
        return prediction**2 / stiffness

    def compliances(self, scaled_values: np.ndarray) -> np.ndarray:
        """Compliance at the model's torques, without :data:`STIFFNESS_FLOOR`, shape (sets, torques) [rad/(N·m)].

        Of scaled values, shape (sets, unknowns); nan for the whole set where the joint has no solution or no stiffness
        at one of the torques, the largest measured one included.
        """
        torque, slips = self.torque, self.slips
        if self.weights is not None:  # the ends of the measured range, which the quadrature does not touch
            largest = float(np.max(np.abs(self.measurement.torque)))
            ends = [sign * largest for sign in (1.0, -1.0) if np.any(sign * torque > 0.0)]
            torque, slips = np.append(torque, ends), np.append(slips, [True] * len(ends))
        rows = max(1, _POINTS // torque.size)
        parts = [
            self._compliances(part, torque, slips)
            for part in np.split(scaled_values, range(rows, len(scaled_values), rows))
        ]
        return np.concatenate(parts)[:, : self.torque.size]

    def _compliances(self, scaled_values: np.ndarray, torque: np.ndarray, slips: np.ndarray) -> np.ndarray:
        sets = [self.unknowns[index].from_unit(scaled_values[:, index]) for index in self.in_joint]
        columns = np.stack(sets, axis=1) if sets else np.zeros((len(scaled_values), 0))
        points = self._points(columns, torque, slips, slopes=False)
        stiffness = torque / points.value if self.rolls else points.value
        holds = np.isfinite(stiffness) & (stiffness > 0.0) & points.exists
        exists = np.all(holds, axis=1)[:, None]
        return np.where(exists, 1.0 / np.where(exists, stiffness, 1.0), np.nan)

    def predictions(self, scaled_values: np.ndarray) -> np.ndarray:
        """Predictions without :data:`STIFFNESS_FLOOR`, shape (sets, points) [rad] or [N·m/rad].

        Of scaled values, shape (sets, unknowns); nan for a set whose joint does not exist, see :meth:`compliances`.
        """
        compliance = self.compliances(scaled_values)
        if self.weights is None:
            return 1.0 / (compliance + self._play_compliance())
        added = [self.curve_part(self.point(scaled_value)) for scaled_value in scaled_values]
        return compliance @ self.weights.T + np.array(added).reshape(len(scaled_values), -1)

    def _play_compliance(self) -> np.ndarray:
        """Of the play that the joint file states, at the measured torques [rad/(N·m)]."""
        play = play_of(self.values)
        return np.asarray(play_compliance(play=play, output_torque=jnp.asarray(self.measurement.torque)))

    def _play(self, point: Document) -> tuple[Any, Any]:
        """Play angle and take-up torque: unknowns, or as the joint file has them; nothing where it has none."""
        stated = self.values.get("play", {})
        names = ("angle", "take_up_torque")
        angle, width = (point.get(f"play.{name}", stated.get(name, 0.0)) for name in names)
        return angle, width

    def _taken_up(self, width: Any, tanh: Callable[[Any], Any]) -> Any:
        """Share of the play that is taken up on its side, −1 to 1."""
        if isinstance(width, float | int) and width == 0.0:
            return np.sign(self.measurement.torque)
        return tanh(self.measurement.torque / width)

    def curve_part(self, point: Document, tanh: Callable[[Any], Any] = np.tanh) -> Any:
        """What play, offset and drift add to the angles, shape (points,) [rad]; ``tanh`` is NumPy's or JAX's."""
        angle, width = (0.0, 0.0) if self.rolls else self._play(point)
        total = 0.5 * angle * self._taken_up(width, tanh)
        for path, value in point.items():
            if _kind(path) in ("offset", "drift"):
                total = total + value * self._share(path)
        return total

    def curve_slope(self, path: str, point: dict[str, float]) -> np.ndarray:
        """Derivative of :meth:`curve_part` by one of the unknowns, shape (points,) [rad per SI unit of the unknown]."""
        angle, width = self._play(point)
        if path == "play.angle":
            return np.asarray(0.5 * self._taken_up(width, np.tanh))
        if path == "play.take_up_torque":
            torque = self.measurement.torque
            return np.asarray(-0.5 * angle * (1.0 - np.tanh(torque / width) ** 2) * torque / width**2)
        return self._share(path)

    def _share(self, path: str) -> np.ndarray:
        """Slope of each angle by an offset or a drift, shape (rows,)."""
        data = self.measurement
        if _kind(path) == "drift":
            assert data.time is not None
            return data.time - data.time[0]
        label = path.partition(" ")[2]
        return (
            np.ones(data.torque.size)
            if not label or self.rolls
            else (data.repetition == float(label)).astype(float)
        )


def _refuse_torques(torque: np.ndarray, measurement: Measurement) -> None:
    if torque.size == 0:
        raise InputError(f"{measurement.source}: all torques are zero; a drift curve needs others")
    if torque.size > MOST_DRIFT_TORQUES:
        raise InputError(
            f"{measurement.source}: a drift curve of {torque.size} different torques; at most {MOST_DRIFT_TORQUES} are "
            "solved, so average the data over steps of the torque"
        )


def _kind(path: str) -> str:
    return path.partition(" ")[0]
