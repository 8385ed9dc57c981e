"""Objectives and margins of a design as smooth functions of its variables, with exact derivatives.

Variables are scaled to 0 at their lower and 1 at their upper bound. The margin of a limit is positive where the limit
is kept. For a positive result it is the logarithm of the ratio to the limit, so that factors count alike for a
stiffness in N·m/rad and a slip ratio; for other results it is the difference over the size of the limit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from asperity.joint_file.si_tables import Values, numeric_keys, si_values
from asperity.results import RESULTS
from asperity.study.batch import derivative_block, derivatives_at
from asperity.study.design.design_problem import EXISTENCE, Constraint, DesignProblem, design_results
from asperity.study.design.scenarios import Scenarios, scenarios

#: Largest logarithm of a ratio that the search sees: an absent force or an infinite slip ratio is this far away.
FARTHEST = 14.0

#: Logarithm of an objective that does not exist.
_NOWHERE = 30.0

#: A joint exists where every margin of its existence is larger than this: at 0 it does not.
INSIDE = 1e-6

#: Places of the objectives of designs that do not exist, for methods that only compare.
_WORST = 1e300


@dataclass(frozen=True)
class MarginRow:
    """One limit at one contact (or clearance) in one scenario."""

    constraint: Constraint
    row: int
    scenario: int


@dataclass(frozen=True)
class EvaluatedDesign:
    """What the search knows about a design; slopes are derivatives by the n scaled variables.

    ``objective``, to be made small: of positive results the logarithm, in the scenarios that count, shape (objectives,
    scenarios), slopes (objectives, scenarios, n); ``margins`` of the limits, shape (rows,), slopes (rows, n).
    ``status`` codes of the scenarios, shape (scenarios,); results [SI], shape (rows, scenarios).
    """

    objective: np.ndarray
    objective_slopes: np.ndarray
    margins: np.ndarray
    margin_slopes: np.ndarray
    status: np.ndarray
    values: dict[str, np.ndarray]

    @property
    def violation(self) -> float:
        """Largest violation of a limit, in the measure of the margins; 0 if all are met."""
        return max(0.0, -float(self.margins.min()))


def _largest_radius(problem: DesignProblem) -> float:
    """The ring's radius where the file states it, otherwise the largest radius of a roller [m]."""
    stated = numeric_keys(problem.case)
    rollers = [key.value for path, key in stated.items() if path.endswith("_radius") and "crown" not in path]
    return stated["drive.ring_radius"].value if "drive.ring_radius" in stated else max(rollers)


class DesignEvaluator:
    """Evaluates designs of one problem; keeps the last one, which the search asks for several times."""

    def __init__(self, problem: DesignProblem) -> None:
        self.problem = problem
        self.results = design_results(problem)
        self.scenarios: Scenarios = scenarios(problem)
        self.values: Values = si_values(problem.case)
        self.variables = problem.variables
        self.paths = tuple(variable.path for variable in problem.variables)
        self.counted = np.flatnonzero(self.scenarios.counted)
        #: Of :func:`asperity.study.batch.derivatives_at`: as many points as one design takes with its derivatives.
        self.block = derivative_block(self.scenarios.torques.size * len(self.paths))
        self._largest_radius = _largest_radius(problem)
        self.rows = tuple(
            MarginRow(constraint, row, int(scenario))
            for constraint in problem.constraints
            for row in constraint.rows
            for scenario in self.counted
        )
        #: How far each margin may fall below 0 before the joint cannot exist, shape (rows,); infinite for limits
        #: that have nothing to do with it.
        self.existence_slack = np.array([self._existence_slack(row.constraint) for row in self.rows])
        self.evaluations = 0
        #: Of each constraint the best margin of all designs that had a value, and the value [SI]; nan before the first.
        self.nearest = [(-math.inf, math.nan) for _ in problem.constraints]
        self._last: tuple[bytes, EvaluatedDesign] | None = None

    def point(self, scaled: np.ndarray) -> dict[str, float]:
        """Values [SI] of the scaled variables."""
        return {v.path: float(v.from_unit(u)) for v, u in zip(self.variables, scaled, strict=True)}

    def scaled(self, point: dict[str, float]) -> np.ndarray:
        """Scaled variables from values [SI]."""
        return np.array([v.to_unit(point[v.path]) for v in self.variables])

    def nonexistence(self, design: EvaluatedDesign) -> float:
        """How far a design is from a joint that can exist: whose rollers fit, do not slip and stay in contact.

        The largest violation, in the measure of the margins; 0 where it exists in every scenario.
        """
        return max(0.0, -float((design.margins + self.existence_slack).min()))

    def existing(self, margins: np.ndarray) -> np.ndarray:
        """Which of many designs, by their margins of :meth:`many`, are joints that can exist in every scenario."""
        slack = [self._existence_slack(limit) for limit in self.problem.constraints for _ in limit.rows]
        return (margins + np.array(slack)).min(axis=1) >= 0.0

    def _existence_slack(self, constraint: Constraint) -> float:
        """No joint exists if rollers overlap, slip or lift off, whatever limit is stated for them."""
        bound = EXISTENCE.get((constraint.name, constraint.at_most))
        if bound is None:
            return float("inf")
        if RESULTS[constraint.name].positive:
            return abs(float(np.log(bound / constraint.limit))) - INSIDE
        return abs(constraint.limit - bound) / self._size(constraint) - INSIDE

    def _size(self, constraint: Constraint) -> float:
        """Scale of the distance from a limit: its absolute value; of a limit of 0 the largest radius or 1 [SI]."""
        if constraint.limit != 0.0:
            return abs(constraint.limit)
        return self._largest_radius if RESULTS[constraint.name].axis == "clearance" else 1.0

    def _margins(self, constraint: Constraint, value: np.ndarray) -> np.ndarray:
        """Margins of a limit; a value that does not exist (nan) misses an upper limit and a lower one."""
        sign = -1.0 if constraint.at_most else 1.0
        if RESULTS[constraint.name].positive:
            return np.where(np.isnan(value), -FARTHEST, sign * _log_ratio(value, constraint.limit))
        distance = (value - constraint.limit) / self._size(constraint)
        return np.where(np.isfinite(distance), sign * distance, -1.0)

    def _keep_nearest(self, constraint: Constraint, value: np.ndarray, margin: np.ndarray) -> None:
        index, worst = self.problem.constraints.index(constraint), int(np.argmin(margin))
        if not np.isnan(value).any() and margin.flat[worst] > self.nearest[index][0]:
            self.nearest[index] = (float(margin.flat[worst]), float(value.flat[worst]))

    def _margin_weights(self, constraint: Constraint, value: np.ndarray) -> np.ndarray:
        """Derivative of the margin by the value."""
        sign = -1.0 if constraint.at_most else 1.0
        if not RESULTS[constraint.name].positive:
            return np.full_like(value, sign / self._size(constraint))
        inside = np.isfinite(value) & (np.abs(_log_ratio(value, constraint.limit)) < FARTHEST)
        return np.where(inside, sign / np.where(inside, value, 1.0), 0.0)

    def __call__(self, scaled: np.ndarray) -> EvaluatedDesign:
        """Objectives and margins of a design with their derivatives, by scaled variables, shape (n,)."""
        mark = np.asarray(scaled, float).tobytes()
        if self._last is not None and self._last[0] == mark:
            return self._last[1]
        self.evaluations += 1
        point = self.point(scaled)
        changes = self.scenarios.changes(dict(point))
        status, results, slopes = derivatives_at(
            self.values, changes, self.results, self.paths, block=self.block
        )
        steps = np.array([v.slope(point[v.path]) for v in self.variables])

        objective, objective_slopes = [], []
        for goal in self.problem.objectives:
            value, slope = (goal.of(arrays)[:, self.counted] for arrays in (results, slopes))
            # the worst contact
            row, scenario = np.argmax(goal.sign * value, axis=0), np.arange(value.shape[1])
            picked, steep = value[row, scenario], _finite(slope[row, scenario]) * steps
            positive = RESULTS[goal.name].positive
            usable = np.isfinite(picked) & ((picked > 0.0) | (not positive))
            safe = np.where(usable, picked, 1.0)
            # an objective that does not exist, such as the stiffness of a slipping joint, is worse than any other
            objective.append(np.where(usable, goal.sign * (np.log(safe) if positive else safe), _NOWHERE))
            weight = np.where(usable, 1.0 / safe, 0.0) if positive else usable.astype(float)
            objective_slopes.append(goal.sign * steep * weight[:, None])

        margins, margin_slopes = [], []
        for constraint in self.problem.constraints:
            rows = np.ix_(np.array(constraint.rows), self.counted)
            value, slope = results[constraint.name][rows], _finite(slopes[constraint.name][rows]) * steps
            margins.append(self._margins(constraint, value).reshape(-1))
            self._keep_nearest(constraint, value, margins[-1])
            weight = self._margin_weights(constraint, value)
            margin_slopes.append((weight[..., None] * slope).reshape(-1, len(self.paths)))
        design = EvaluatedDesign(
            objective=np.array(objective),
            objective_slopes=np.array(objective_slopes),
            margins=np.concatenate(margins),
            margin_slopes=np.concatenate(margin_slopes),
            status=status,
            values=results,
        )
        self._last = (mark, design)
        return design

    def margins_of(self, results: dict[str, np.ndarray]) -> list[np.ndarray]:
        """Margins of each limit from results in all scenarios [SI], rows first, in the scenarios that count."""
        return [
            self._margins(limit, results[limit.name][np.ix_(np.array(limit.rows), self.counted)]).reshape(-1)
            for limit in self.problem.constraints
        ]

    def many(self, scaled: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Worst objectives and worst margins of many designs over the scenarios, without derivatives.

        Of scaled variables, shape (designs, n): shapes (designs, objectives), to be made small [SI], and (designs,
        limits and rows).
        """
        designs, count = scaled.shape[0], self.scenarios.torques.size
        point = {v.path: v.from_unit(scaled[:, [i]]) for i, v in enumerate(self.variables)}
        changes = {
            path: np.broadcast_to(value, (designs, count)).reshape(-1)
            for path, value in self.scenarios.changes(point).items()
        }
        _, results, _ = derivatives_at(self.values, changes, self.results, block=self.block)
        results = {name: row.reshape(-1, designs, count)[..., self.counted] for name, row in results.items()}
        self.evaluations += designs
        objectives = []
        for goal in self.problem.objectives:
            value = goal.sign * goal.of(results)
            worst = np.max(np.where(np.isnan(value), np.inf, value), axis=(0, 2))
            objectives.append(np.where(np.isfinite(worst), worst, _WORST))
        margins = [
            self._margins(limit, results[limit.name][list(limit.rows)]) for limit in self.problem.constraints
        ]
        return np.stack(objectives, axis=1), np.min(np.concatenate(margins), axis=2).T


def exists(objectives: np.ndarray) -> np.ndarray:
    """Which objectives of :meth:`DesignEvaluator.many`, of any shape, belong to designs that exist."""
    return np.abs(objectives) < _WORST


def _log_ratio(value: np.ndarray, limit: float) -> np.ndarray:
    """ln(value/limit) within ± :data:`FARTHEST`."""
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = np.log(np.asarray(value) / limit)
    return np.clip(ratio, -FARTHEST, FARTHEST)


def _finite(slope: np.ndarray) -> np.ndarray:
    """Slopes with 0 in place of those that are not finite."""
    return np.where(np.isfinite(slope), slope, 0.0)
