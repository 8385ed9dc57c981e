"""The search for a design: starts, SLSQP with exact gradients, the smallest violation, the optimality conditions."""

from __future__ import annotations

import warnings
from collections.abc import Callable

import numpy as np
from scipy.optimize import Bounds, NonlinearConstraint, minimize, nnls
from scipy.stats import qmc

from asperity.joint_file.si_tables import si_values
from asperity.results import RESULTS
from asperity.study.design.design_evaluation import DesignEvaluator
from asperity.study.design.design_result import OPTIMAL

#: Margin below zero (logarithm of the ratio to the limit) that still counts as met: the tolerance of the search.
FEASIBLE = 1e-7

#: Designs among which a start is looked for where the searches find no value of a limit.
_SAMPLED = 64

#: A limit with a smaller margin than this is active.
ACTIVE = 1e-5


class SearchProgress:
    """Counts the searches of a design, done and known to come; ``report`` is called when one of the numbers changes."""

    def __init__(self, report: Callable[[int, int], None] | None) -> None:
        self._report = report or (lambda done, total: None)
        self._done = self._total = 0

    def expect(self, searches: int) -> None:
        """More searches are to come."""
        self._total += searches
        self._report(self._done, self._total)

    def step(self) -> None:
        """One search is done."""
        self._done += 1
        self._report(self._done, self._total)


def starting_points(evaluator: DesignEvaluator) -> list[np.ndarray]:
    """Where the search begins: the joint of the file, where it lies within the bounds, then a Latin hypercube.

    Shape (n,).
    """
    problem = evaluator.problem
    values = si_values(problem.case)
    first = []
    for variable in problem.variables:
        node: object = values
        for part in variable.path.split("."):
            node = node.get(part) if isinstance(node, dict) else None
        inside = isinstance(node, float) and variable.lower <= node <= variable.upper
        first.append(variable.to_unit(node) if inside and isinstance(node, float) else 0.5)
    sampler = qmc.LatinHypercube(d=len(first), rng=np.random.default_rng(problem.seed))
    starts = [np.clip(np.array(first), 0.0, 1.0)]
    while len(starts) < problem.starts:
        starts.extend(sampler.random(max(problem.starts - 1, 1)))
    return starts[: problem.starts]


def sampled_start(evaluator: DesignEvaluator) -> np.ndarray:
    """The nearest of many designs within the bounds: one that has values where the starts have none.

    Shape (n,).
    """
    sampler = qmc.LatinHypercube(
        d=len(evaluator.variables), rng=np.random.default_rng(evaluator.problem.seed)
    )
    points: np.ndarray = sampler.random(_SAMPLED)
    margins = evaluator.many(points)[1]
    return points[np.lexsort((-margins.min(axis=1), ~evaluator.existing(margins)))[0]]


def local_optimum(
    evaluator: DesignEvaluator, start: np.ndarray, *, fixed: np.ndarray | None = None
) -> tuple[np.ndarray, bool]:
    """Where SLSQP ended from one start, and whether that is a local optimum.

    Where its line search fails far from the limits, it begins once more within them; where that fails too,
    trust-constr goes on. Scaled variables, shape (n,); ``fixed`` ones keep their value.
    """
    search = _Search(evaluator, start, np.zeros(start.size, dtype=bool) if fixed is None else fixed)
    end, found = search.sequential(start)
    if found:
        return end, True
    if evaluator(end).violation > FEASIBLE:
        if search.fixed.any():
            return end, False
        end = smallest_violation(evaluator, end)
        if evaluator(end).violation > FEASIBLE:
            return end, False  # nothing to go on from: the limits conflict, at least around here
        again, found = search.sequential(end)
        if found and evaluator(again).violation <= FEASIBLE:
            return again, True
    other = search.trust_region(end)
    better = (evaluator(other).violation, float(evaluator(other).objective.max())) < (
        evaluator(end).violation,
        float(evaluator(end).objective.max()),
    )
    end = other if better else end
    return end, search.optimal(end)


class _Search:
    """One search: scaled variables of shape (n,), and behind them a number that bounds the objective from above."""

    def __init__(self, evaluator: DesignEvaluator, start: np.ndarray, fixed: np.ndarray) -> None:
        self.evaluator, self.fixed = evaluator, fixed
        self.lower, self.upper = np.where(fixed, start, 0.0), np.where(fixed, start, 1.0)
        self.bounds = Bounds(np.append(self.lower, -np.inf), np.append(self.upper, np.inf))
        self.upward = np.append(np.zeros(start.size), 1.0)

    def inequalities(self, x: np.ndarray) -> np.ndarray:
        design = self.evaluator(np.clip(x[:-1], self.lower, self.upper))
        return np.concatenate([x[-1] - design.objective[0], design.margins])

    def slopes(self, x: np.ndarray) -> np.ndarray:
        design = self.evaluator(np.clip(x[:-1], self.lower, self.upper))
        top = np.hstack([-design.objective_slopes[0], np.ones((design.objective.shape[1], 1))])
        return np.vstack([top, np.hstack([design.margin_slopes, np.zeros((design.margins.size, 1))])])

    def begin(self, scaled: np.ndarray) -> np.ndarray:
        return np.append(scaled, self.evaluator(scaled).objective.max())

    def optimal(self, end: np.ndarray) -> bool:
        if self.evaluator(end).violation > FEASIBLE:
            return False
        return optimality(self.evaluator, end, fixed=self.fixed)[0] < OPTIMAL

    def sequential(self, start: np.ndarray) -> tuple[np.ndarray, bool]:
        """Where SLSQP ends from here, and whether that is a local optimum."""
        solution = minimize(
            lambda x: x[-1],
            self.begin(start),
            jac=lambda x: self.upward,
            bounds=self.bounds,
            constraints=[{"type": "ineq", "fun": self.inequalities, "jac": self.slopes}],
            method="SLSQP",
            options={"maxiter": 200, "ftol": 1e-12},
        )
        finite = np.all(np.isfinite(solution.x))
        end = np.clip(solution.x[:-1], self.lower, self.upper) if finite else start
        return end, bool(solution.success) or self.optimal(end)

    def trust_region(self, start: np.ndarray) -> np.ndarray:
        """Where trust-constr ends from here, shape (n,)."""
        size = self.upward.size
        with warnings.catch_warnings():
            # delta_grad == 0 warnings of the quasi-Newton update of a linear objective
            warnings.simplefilter("ignore")
            solution = minimize(
                lambda x: x[-1],
                self.begin(start),
                jac=lambda x: self.upward,
                hess=lambda x: np.zeros((size, size)),
                bounds=self.bounds,
                constraints=[NonlinearConstraint(self.inequalities, 0.0, np.inf, jac=self.slopes)],
                method="trust-constr",
                options={"maxiter": 300, "gtol": 1e-9, "xtol": 1e-10},
            )
        return np.clip(solution.x[:-1], self.lower, self.upper)


def violation_rank(evaluator: DesignEvaluator, scaled: np.ndarray) -> tuple[float, float]:
    """How badly limits are missed, to be compared.

    The lack of existence, 0 for every joint that exists; largest violation.
    """
    design = evaluator(scaled)
    lack = evaluator.nonexistence(design)
    return (lack if lack > FEASIBLE else 0.0), design.violation


def smallest_violation(evaluator: DesignEvaluator, start: np.ndarray) -> np.ndarray:
    """The design whose largest violation of a limit is smallest, among joints that exist, shape (n,)."""
    end = _smallest_violation_from(evaluator, start, stated=True)
    if violation_rank(evaluator, end)[0] > 0.0:
        end = _smallest_violation_from(evaluator, start, stated=False)
        if violation_rank(evaluator, end)[0] == 0.0:
            end = min(
                end,
                _smallest_violation_from(evaluator, end, stated=True),
                key=lambda design: violation_rank(evaluator, design),
            )
    return min(end, start, key=lambda design: violation_rank(evaluator, design))


def _smallest_violation_from(evaluator: DesignEvaluator, start: np.ndarray, *, stated: bool) -> np.ndarray:
    """SLSQP on the largest violation: of the stated limits among joints that exist, or of existence itself."""
    size, must = start.size, np.isfinite(evaluator.existence_slack)
    upward = np.append(np.zeros(size), 1.0)

    def inequalities(x: np.ndarray) -> np.ndarray:
        margins = evaluator(np.clip(x[:-1], 0.0, 1.0)).margins
        exists = (margins + evaluator.existence_slack)[must]
        return np.concatenate([margins + x[-1], exists]) if stated else exists + x[-1]

    def slopes(x: np.ndarray) -> np.ndarray:
        steep = evaluator(np.clip(x[:-1], 0.0, 1.0)).margin_slopes
        rows = np.vstack([steep, steep[must]]) if stated else steep[must]
        moved = np.ones(len(rows))
        moved[len(steep) :] = 0.0
        return np.hstack([rows, moved[:, None]])

    begin = -float(inequalities(np.append(start, 0.0)).min())
    solution = minimize(
        lambda x: x[-1],
        np.append(start, max(0.0, begin)),
        jac=lambda x: upward,
        bounds=Bounds(np.zeros(size + 1), np.append(np.ones(size), np.inf)),
        constraints=[{"type": "ineq", "fun": inequalities, "jac": slopes}],
        method="SLSQP",
        options={"maxiter": 200, "ftol": 1e-12},
    )
    return np.clip(solution.x[:-1], 0.0, 1.0) if np.all(np.isfinite(solution.x)) else start


def optimality(
    evaluator: DesignEvaluator, scaled: np.ndarray, *, fixed: np.ndarray | None = None
) -> tuple[float, np.ndarray]:
    """Optimality residual and multipliers (shadow prices) of the limits, by non-negative least squares.

    Shape (rows,) [-].
    """
    design, size = evaluator(scaled), scaled.size
    if design.violation <= FEASIBLE:
        worst = design.objective[0]
        objective = design.objective_slopes[0][worst >= worst.max() - ACTIVE]
        if not RESULTS[evaluator.problem.objectives[0].name].positive:  # no logarithm, so that it has a size
            objective = objective / (abs(float(worst.max())) or 1.0)
        active = design.margins < ACTIVE
    else:
        objective, active = np.zeros((0, size)), design.margins < -design.violation + ACTIVE
    # where limits are missed, existence restricts the design too, but is no part of the violation
    existence = (design.margins + evaluator.existence_slack < ACTIVE) & ~active
    bounds = np.vstack([np.eye(size)[scaled < 1e-7], -np.eye(size)[scaled > 1.0 - 1e-7]])
    gradients = np.vstack([-objective, design.margin_slopes[active], design.margin_slopes[existence], bounds])
    if fixed is not None:
        gradients = gradients[:, ~fixed]
    # weights of the worst scenarios (or of the violated limits) add up to one
    adds_up = np.zeros(len(gradients))
    adds_up[: len(objective) or int(active.sum())] = 1.0
    scale = max(1e-12, float(np.abs(gradients).max(initial=0.0)) or 1.0)
    system = np.vstack([gradients.T / scale, adds_up[None, :]])
    weights, _ = nnls(system, np.append(np.zeros(len(system) - 1), 1.0))
    weights /= weights @ adds_up  # less than one where a gradient is left over
    count = len(objective)
    steepness = float(np.linalg.norm(gradients[:count].T @ weights[:count])) if count else 1.0
    residual = float(np.linalg.norm(gradients.T @ weights)) / max(steepness, 1.0)
    multipliers = np.zeros(design.margins.size)
    multipliers[active] = weights[count : count + int(active.sum())]
    return residual, multipliers
