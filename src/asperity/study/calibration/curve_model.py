"""The curve that a joint with given unknowns would show, with its derivatives by the unknowns."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from asperity.joint.results import name_at_level
from asperity.joint.windup import StiffnessLevel
from asperity.joint_file.model import Case
from asperity.joint_file.si_tables import numeric_keys, si_values
from asperity.study.batch import derivatives_at
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.torque_history import History, curve_operator
from asperity.study.calibration.unknowns import CURVE_UNKNOWNS
from asperity.study.design.design_problem import Variable

#: Below this share of its median a stiffness is held, so that a search that strays past the torque capacity finds
#: back. A curve that ends there is refused.
STIFFNESS_FLOOR = 0.01

#: Points of one call for many sets of unknowns: up to here the program that the fit uses serves.
_POINTS = 4096


class CurveModel:
    """Predicts a measurement from places of the unknowns between their bounds.

    Parameters
    ----------
    case : Case
        The joint file.
    measurement : Measurement
        Torques, times and repetitions of the data.
    unknowns : tuple of Variable
        What is looked for.
    level : {"published", "series_with_bulk", "assembly"}
        Which stiffness the joint is taken to have.
    history : {"virgin", "cycled"}
        State before the first row.
    """

    def __init__(
        self,
        *,
        case: Case,
        measurement: Measurement,
        unknowns: tuple[Variable, ...],
        level: StiffnessLevel,
        history: History,
    ) -> None:
        self.unknowns, self.level, self.measurement = unknowns, level, measurement
        self.values = si_values(case)
        self.in_joint = [
            index for index, each in enumerate(unknowns) if _kind(each.path) not in CURVE_UNKNOWNS
        ]
        self.in_curve = [index for index in range(len(unknowns)) if index not in self.in_joint]
        self.paths = tuple(unknowns[index].path for index in self.in_joint)
        if measurement.angle is not None:
            operator = curve_operator(measurement.torque, history)
            self.torque = operator.torque
            self.weights: np.ndarray | None = operator.weights
        else:
            self.torque, self.weights = np.abs(measurement.torque), None
        stated = numeric_keys(case)
        self.first = np.array([self._first(each, stated) for each in unknowns])

    def _first(self, unknown: Variable, stated: dict) -> float:
        """Place of the first guess: the file's value, no play, no drift."""
        kind = _kind(unknown.path)
        if kind in CURVE_UNKNOWNS:
            guess = {"offset": 0.5 * (unknown.lower + unknown.upper), "drift": 0.0, "play": 0.0}.get(
                kind, (unknown.lower * unknown.upper) ** 0.5
            )
        elif unknown.path in stated:
            guess = stated[unknown.path].value
        else:
            guess = float(unknown.from_unit(0.5))
        return float(np.clip(unknown.to_unit(min(max(guess, unknown.lower), unknown.upper)), 0.01, 0.99))

    def point(self, places: np.ndarray) -> dict[str, float]:
        """Values [SI] of the unknowns."""
        return {u.path: float(u.from_unit(p)) for u, p in zip(self.unknowns, places, strict=True)}

    def stiffness(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Stiffness at the model's torques, its slopes by the joint's unknowns, largest slip ratio [SI]."""
        point = self.point(places)
        changes = {path: np.full(self.torque.size, point[path]) for path in self.paths}
        name = name_at_level("stiffness", self.level)
        _, found, slopes = derivatives_at(
            self.values, {**changes, "load.output_torque": self.torque}, (name, "slip_ratio"), self.paths
        )
        return found[name][0], slopes[name][0], found["slip_ratio"].max(axis=0)

    def held(self, stiffness: np.ndarray) -> np.ndarray:
        """At which of the model's torques the prediction uses :data:`STIFFNESS_FLOOR` instead of the joint's stiffness.

        Parameters
        ----------
        stiffness : ndarray
            Of the joint at the model's torques, shape (torques,) [N·m/rad].

        Returns
        -------
        ndarray of bool
            Shape (torques,).
        """
        return ~np.isfinite(stiffness) | (stiffness < self._floor(stiffness))

    def _floor(self, stiffness: np.ndarray) -> float:
        usable = np.isfinite(stiffness) & (stiffness > 0.0)
        return STIFFNESS_FLOOR * float(np.median(stiffness[usable])) if usable.any() else 1.0

    def __call__(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Predicted angles [rad] or stiffnesses [N·m/rad], and their derivatives by the places.

        Parameters
        ----------
        places : ndarray
            Shape (unknowns,), 0 to 1.

        Returns
        -------
        prediction, slopes : ndarray
            Shape (points,) and (points, unknowns).
        """
        point = self.point(places)
        steps = np.array([u.slope(point[u.path]) for u in self.unknowns])
        stiffness, by_joint, _ = self.stiffness(places)
        held = self.held(stiffness)
        safe = np.where(held, self._floor(stiffness), stiffness)
        slopes = np.zeros((self.measurement.torque.size, len(self.unknowns)))
        by_joint = np.where(held[:, None] | ~np.isfinite(by_joint), 0.0, by_joint)
        if self.weights is None:
            slopes[:, self.in_joint] = by_joint
            return safe, slopes * steps
        prediction = self.weights @ (1.0 / safe)
        slopes[:, self.in_joint] = self.weights @ (-by_joint / safe[:, None] ** 2)
        for index in self.in_curve:
            unknown = self.unknowns[index]
            value, slope = self.curve_part(unknown.path, point)
            prediction = prediction + value
            slopes[:, index] = slope
        return prediction, slopes * steps

    def compliances(self, places: np.ndarray) -> np.ndarray:
        """Compliance at the model's torques, with nothing held.

        Parameters
        ----------
        places : ndarray
            Shape (sets, unknowns).

        Returns
        -------
        ndarray
            Shape (sets, torques) [rad/(N·m)]; nan for the whole set where the joint has no solution or no stiffness
            at one of the torques, the largest measured one included.
        """
        largest = float(np.max(np.abs(self.measurement.torque)))
        torque = self.torque if self.weights is None else np.append(self.torque, largest)
        rows = max(1, _POINTS // torque.size)
        found = [self._compliances(part, torque) for part in np.split(places, range(rows, len(places), rows))]
        return np.concatenate(found)[:, : self.torque.size]

    def _compliances(self, places: np.ndarray, torque: np.ndarray) -> np.ndarray:
        changes = {
            self.unknowns[index].path: np.repeat(
                self.unknowns[index].from_unit(places[:, index]), torque.size
            )
            for index in self.in_joint
        }
        name = name_at_level("stiffness", self.level)
        points = {**changes, "load.output_torque": np.tile(torque, len(places))}
        status, found, _ = derivatives_at(self.values, points, (name, "slip_ratio"))
        shape = (len(places), torque.size)
        stiffness = found[name][0].reshape(shape)
        holds = np.isfinite(stiffness) & (stiffness > 0.0) & (status.reshape(shape) == 0)
        exists = np.all(holds, axis=1)[:, None]
        return np.where(exists, 1.0 / np.where(exists, stiffness, 1.0), np.nan)

    def predictions(self, places: np.ndarray) -> np.ndarray:
        """Predictions of many sets of unknowns, with nothing held.

        Parameters
        ----------
        places : ndarray
            Shape (sets, unknowns).

        Returns
        -------
        ndarray
            Shape (sets, points) [rad] or [N·m/rad]; nan for a set whose joint does not exist, see :meth:`compliances`.
        """
        compliance = self.compliances(places)
        if self.weights is None:
            return 1.0 / compliance
        found = compliance @ self.weights.T
        for row, place in zip(found, places, strict=True):
            point = self.point(place)
            for index in self.in_curve:
                row += self.curve_part(self.unknowns[index].path, point)[0]
        return found

    def curve_part(
        self, path: str, point: dict[str, Any], tanh: Callable[[Any], Any] = np.tanh
    ) -> tuple[Any, Any]:
        """What an unknown of the curve adds to the angles, and the derivative by it (``tanh``: NumPy's or JAX's)."""
        data, kind = self.measurement, _kind(path)
        none = np.zeros(data.torque.size)
        if kind == "offset":
            label = path.partition(" ")[2]
            where = np.ones(none.size) if not label else (data.repetition == float(label)).astype(float)
            return point[path] * where, where
        if kind == "drift":
            assert data.time is not None
            elapsed = data.time - data.time[0]
            return point[path] * elapsed, elapsed
        width = point.get("play_torque")
        side = np.sign(data.torque) if width is None else tanh(data.torque / width)
        if kind == "play":
            return 0.5 * point["play"] * side, 0.5 * side
        assert width is not None
        return none, -0.5 * point["play"] * (1.0 - side**2) * data.torque / width**2


def _kind(path: str) -> str:
    return path.partition(" ")[0]
