"""Limits and objectives of a design as smooth functions of its variables, with exact derivatives.

A limit of a positive quantity is judged by the logarithm of its ratio to the limit, so that factors count alike for
a stiffness in N·m/rad and a slip ratio; the clearances are judged by their difference over the ring radius.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from asperity.joint_file.values import Values, numeric_keys, si_values
from asperity.study.design.design_problem import Constraint, DesignProblem
from asperity.study.design.scenarios import Scenarios, scenarios
from asperity.study.quantities import QUANTITIES, at_level, quantities_and_slopes, quantities_at

#: Largest logarithm of a ratio that the search sees: an absent force or an infinite slip ratio is this far away.
FARTHEST = 14.0

#: Logarithm of an objective that does not exist.
_NOWHERE = 30.0

#: A joint exists where every margin of its existence is larger than this: on the edge it does not.
INSIDE = 1e-6


@dataclass(frozen=True)
class Row:
    """One limit at one contact (or clearance) in one scenario."""

    constraint: Constraint
    row: int
    scenario: int


@dataclass(frozen=True)
class Judged:
    """A design seen by the search.

    Parameters
    ----------
    objective : ndarray
        Logarithm of the objectives in the judged scenarios, to be made small, shape (objectives, scenarios).
    objective_slopes : ndarray
        By the places of the variables, shape (objectives, scenarios, n).
    margins : ndarray
        Of the limits, fine from 0 on, shape (rows,).
    margin_slopes : ndarray
        Shape (rows, n).
    values : dict
        The quantities themselves.
    """

    objective: np.ndarray
    objective_slopes: np.ndarray
    margins: np.ndarray
    margin_slopes: np.ndarray
    values: dict[str, np.ndarray]


def log_ratio(value: np.ndarray, limit: float) -> np.ndarray:
    """ln(value/limit) within ± :data:`FARTHEST`; what is no number counts as infinitely far above."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.log(np.asarray(value) / limit)
    return np.clip(np.where(np.isnan(ratio), np.inf, ratio), -FARTHEST, FARTHEST)


class Judge:
    """Evaluates designs of one problem; remembers the last point, which the search asks for several times.

    Parameters
    ----------
    problem : DesignProblem
        The problem.
    """

    def __init__(self, problem: DesignProblem) -> None:
        self.problem = problem
        self.states: Scenarios = scenarios(problem)
        self.values: Values = si_values(problem.case)
        self.variables = problem.variables
        self.paths = tuple(variable.path for variable in problem.variables)
        self.length_scale = numeric_keys(problem.case)["drive.ring_radius"].value
        self.judged = np.flatnonzero(self.states.judged)
        self.rows = tuple(
            Row(constraint, row, int(scenario))
            for constraint in problem.constraints
            for row in constraint.rows
            for scenario in self.judged
        )
        #: How far each margin may fall below 0 before the joint cannot exist, shape (rows,); infinite for limits
        #: that are wishes.
        self.room = np.array([self._room(row.constraint) for row in self.rows])
        self.evaluations = 0
        self._last: tuple[bytes, Judged] | None = None

    def point(self, places: np.ndarray) -> dict[str, float]:
        """Values [SI] of the variables at places between their bounds."""
        return {v.path: float(v.from_unit(u)) for v, u in zip(self.variables, places, strict=True)}

    def places(self, point: dict[str, float]) -> np.ndarray:
        """Places of values [SI] between the bounds."""
        return np.array([v.to_unit(point[v.path]) for v in self.variables])

    def margins(self, found: dict[str, np.ndarray]) -> np.ndarray:
        """Margins of all limits, shape (limits and rows, ...scenarios as given)."""
        parts = []
        for constraint in self.problem.constraints:
            value = found[at_level(constraint.name, self.problem.level)][list(constraint.rows)]
            sign = -1.0 if constraint.at_most else 1.0
            if QUANTITIES[constraint.name].ratio:
                parts.append(sign * log_ratio(value, constraint.limit))
            else:
                parts.append(sign * self._difference(constraint, value))
        return np.concatenate(parts)

    def _room(self, constraint: Constraint) -> float:
        """Rollers that overlap, slip grossly or lift off make no joint, whatever limit of them is stated."""
        if constraint.name == "slip_ratio":
            return -float(np.log(constraint.limit)) - INSIDE
        if constraint.name in ("clearance", "normal_over_rest") and not constraint.at_most:
            return constraint.limit / self._scale(constraint) - INSIDE
        return float("inf")

    def _scale(self, constraint: Constraint) -> float:
        return self.length_scale if constraint.name == "clearance" else 1.0

    def _difference(self, constraint: Constraint, value: np.ndarray) -> np.ndarray:
        apart = (value - constraint.limit) / self._scale(constraint)
        return np.where(np.isfinite(apart), apart, -1.0)

    def __call__(self, places: np.ndarray) -> Judged:
        """Judge the design at these places of its variables.

        Parameters
        ----------
        places : ndarray
            Shape (n,), 0 to 1.

        Returns
        -------
        Judged
            Objectives and margins with their derivatives by the places.
        """
        mark = np.asarray(places, float).tobytes()
        if self._last is not None and self._last[0] == mark:
            return self._last[1]
        self.evaluations += 1
        point = self.point(places)
        changes = self.states.changes(dict(point))
        found, slopes = quantities_and_slopes(self.values, changes, self.paths)
        steps = np.array([v.slope(point[v.path]) for v in self.variables])

        objective, objective_slopes = [], []
        for goal in self.problem.objectives:
            name = at_level(goal.name, self.problem.level)
            value, slope = found[name], slopes[name]
            ratio = QUANTITIES[goal.name].ratio
            row = np.argmax(goal.sign * value, axis=0)  # the worst contact
            picked = value[row, np.arange(value.shape[1])][self.judged]
            steep = slope[row, np.arange(value.shape[1])][self.judged] * steps
            usable = np.isfinite(picked) & ((picked > 0.0) | (not ratio))
            # an objective that does not exist, such as the stiffness of a slipping joint, is worse than any other
            sized = goal.sign * (np.log(np.where(usable, picked, 1.0)) if ratio else picked)
            objective.append(np.where(usable, sized, _NOWHERE))
            weight = (
                np.where(usable, 1.0 / np.where(usable, picked, 1.0), 0.0) if ratio else np.ones_like(picked)
            )
            objective_slopes.append(goal.sign * _finite(steep) * weight[:, None])

        margin_slopes = []
        for constraint in self.problem.constraints:
            name = at_level(constraint.name, self.problem.level)
            value = found[name][list(constraint.rows)][:, self.judged]
            slope = _finite(slopes[name][list(constraint.rows)][:, self.judged]) * steps
            sign = -1.0 if constraint.at_most else 1.0
            if QUANTITIES[constraint.name].ratio:
                inside = np.isfinite(value) & (np.abs(log_ratio(value, constraint.limit)) < FARTHEST)
                weight = np.where(inside, 1.0 / np.where(inside, value, 1.0), 0.0)
            else:
                weight = np.full_like(value, 1.0 / self._scale(constraint))
            margin_slopes.append((sign * weight[..., None] * slope).reshape(-1, len(self.paths)))
        judged = Judged(
            objective=np.array(objective),
            objective_slopes=np.array(objective_slopes),
            margins=self.margins({name: value[:, self.judged] for name, value in found.items()}).reshape(-1),
            margin_slopes=np.concatenate(margin_slopes),
            values=found,
        )
        self._last = (mark, judged)
        return judged

    def judge_many(self, places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Worst objectives and worst margins of many designs at once, without derivatives.

        Parameters
        ----------
        places : ndarray
            Shape (designs, n).

        Returns
        -------
        objectives, margins : ndarray
            Shape (designs, objectives) and (designs, limits and rows); each at its worst over the scenarios.
        """
        designs, count = places.shape[0], self.states.torques.size
        point = {v.path: v.from_unit(places[:, [i]]) for i, v in enumerate(self.variables)}
        changes = {
            path: np.broadcast_to(value, (designs, count)).reshape(-1)
            for path, value in self.states.changes(point).items()
        }
        found = {
            name: value.reshape(value.shape[0], designs, count)[..., self.judged]
            for name, value in quantities_at(self.values, changes).items()
        }
        self.evaluations += designs
        objectives = []
        for goal in self.problem.objectives:
            value = goal.sign * found[at_level(goal.name, self.problem.level)]
            worst = np.max(np.where(np.isnan(value), np.inf, value), axis=(0, 2))
            objectives.append(np.where(np.isfinite(worst), worst, 1e300))
        return np.stack(objectives, axis=1), np.min(self.margins(found), axis=2).T


def _finite(slope: np.ndarray) -> np.ndarray:
    """Slopes that are no numbers, where a state does not exist, lead nowhere."""
    return np.where(np.isfinite(slope), slope, 0.0)
