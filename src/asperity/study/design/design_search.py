"""The search for a design: starts, SLSQP with exact gradients, the least violation, and the proof of an optimum."""

from __future__ import annotations

import numpy as np

from asperity.joint_file.values import si_values
from asperity.study.design.judgement import Judge, Judged

#: Margin below zero (logarithm of the ratio to the limit) that still counts as met: what the search leaves behind.
FEASIBLE = 1e-7

#: A limit with a smaller margin than this is one that holds the design back.
ACTIVE = 1e-5

#: Largest gradient that the active limits leave unexplained, relative to that of the objective, in a proven optimum.
OPTIMAL = 1e-3


def starting_places(judge: Judge) -> list[np.ndarray]:
    """Where the search begins: the joint of the file, where it lies within the bounds, then a Latin hypercube.

    Parameters
    ----------
    judge : Judge
        The problem.

    Returns
    -------
    list of ndarray
        Places of the variables, each of shape (n,).
    """
    from scipy.stats import qmc

    problem = judge.problem
    values = si_values(problem.case)
    first = []
    for variable in problem.variables:
        node: object = values
        for part in variable.path.split("."):
            node = node.get(part) if isinstance(node, dict) else None
        inside = isinstance(node, float) and variable.lower <= node <= variable.upper
        first.append(variable.to_unit(node) if inside and isinstance(node, float) else 0.5)
    sampler = qmc.LatinHypercube(d=len(first), rng=np.random.default_rng(problem.seed))
    found = [np.clip(np.array(first), 0.0, 1.0)]
    while len(found) < problem.starts:
        found.extend(sampler.random(max(problem.starts - 1, 1)))
    return found[: problem.starts]


def largest_violation(judged: Judged) -> float:
    """Largest violation of a limit, 0 if all are met.

    Parameters
    ----------
    judged : Judged
        A design.

    Returns
    -------
    float
        Logarithm of the ratio to the limit [-].
    """
    return max(0.0, -float(judged.margins.min()))


def local_optimum(judge: Judge, start: np.ndarray) -> tuple[np.ndarray, bool]:
    """SLSQP from one start; trust-constr where it gives up. The last variable bounds the objective from above.

    Parameters
    ----------
    judge : Judge
        The problem.
    start : ndarray
        Places of the variables, shape (n,).

    Returns
    -------
    places : ndarray
        Where it ended.
    converged : bool
        Whether that is a local optimum.
    """
    from scipy.optimize import Bounds, NonlinearConstraint, minimize

    size = start.size
    bounds = Bounds(np.append(np.zeros(size), -np.inf), np.append(np.ones(size), np.inf))
    upward = np.append(np.zeros(size), 1.0)

    def inequalities(x: np.ndarray) -> np.ndarray:
        judged = judge(np.clip(x[:-1], 0.0, 1.0))
        return np.concatenate([x[-1] - judged.objective[0], judged.margins])

    def slopes(x: np.ndarray) -> np.ndarray:
        judged = judge(np.clip(x[:-1], 0.0, 1.0))
        top = np.hstack([-judged.objective_slopes[0], np.ones((judged.objective.shape[1], 1))])
        return np.vstack([top, np.hstack([judged.margin_slopes, np.zeros((judged.margins.size, 1))])])

    begin = np.append(start, judge(start).objective.max())
    found = minimize(
        lambda x: x[-1],
        begin,
        jac=lambda x: upward,
        bounds=bounds,
        constraints=[{"type": "ineq", "fun": inequalities, "jac": slopes}],
        method="SLSQP",
        options={"maxiter": 200, "ftol": 1e-12},
    )
    end = np.clip(found.x[:-1], 0.0, 1.0) if np.all(np.isfinite(found.x)) else start
    if found.success or (
        largest_violation(judge(end)) <= FEASIBLE and optimality_gap(judge, end)[0] < OPTIMAL
    ):
        return end, True
    if largest_violation(judge(end)) > FEASIBLE:
        end = least_violation(judge, end)
        if largest_violation(judge(end)) > FEASIBLE:
            return end, False  # nothing to go on from: the limits conflict, at least around here
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter(
            "ignore"
        )  # delta_grad == 0 warnings of the quasi-Newton update of a linear objective
        second = minimize(
            lambda x: x[-1],
            np.append(end, judge(end).objective.max()),
            jac=lambda x: upward,
            hess=lambda x: np.zeros((size + 1, size + 1)),
            bounds=bounds,
            constraints=[NonlinearConstraint(inequalities, 0.0, np.inf, jac=slopes)],
            method="trust-constr",
            options={"maxiter": 300, "gtol": 1e-9, "xtol": 1e-10},
        )
    other = np.clip(second.x[:-1], 0.0, 1.0)
    better = (largest_violation(judge(other)), float(judge(other).objective.max())) < (
        largest_violation(judge(end)),
        float(judge(end).objective.max()),
    )
    end = other if better else end
    return end, largest_violation(judge(end)) <= FEASIBLE and optimality_gap(judge, end)[0] < OPTIMAL


def nonexistence(judge: Judge, judged: Judged) -> float:
    """How far a design is from a joint that can exist: whose rollers fit, roll without gross slip and stay in contact.

    Parameters
    ----------
    judge : Judge
        The problem.
    judged : Judged
        A design.

    Returns
    -------
    float
        Largest violation, in the measure of the margins [-]; 0 where it exists in every scenario.
    """
    return max(0.0, -float((judged.margins + judge.room).min()))


def badness(judge: Judge, places: np.ndarray) -> tuple[float, float]:
    """What is made small where limits are missed: first the lack of existence, then the largest violation.

    Parameters
    ----------
    judge : Judge
        The problem.
    places : ndarray
        Shape (n,).

    Returns
    -------
    tuple of float
        To be compared; the first is 0 for every joint that exists.
    """
    judged = judge(places)
    lack = nonexistence(judge, judged)
    return (lack if lack > FEASIBLE else 0.0), largest_violation(judged)


def least_violation(judge: Judge, start: np.ndarray) -> np.ndarray:
    """Places at which the largest violation of a limit is smallest, among joints that exist.

    Parameters
    ----------
    judge : Judge
        The problem.
    start : ndarray
        Places of the variables, shape (n,).

    Returns
    -------
    ndarray
        Places, shape (n,); where no joint that exists was found, those nearest to one.
    """
    end = _least(judge, start, wishes=True)
    if badness(judge, end)[0] > 0.0:
        end = _least(judge, start, wishes=False)
        if badness(judge, end)[0] == 0.0:
            end = min(end, _least(judge, end, wishes=True), key=lambda each: badness(judge, each))
    return min(end, start, key=lambda each: badness(judge, each))


def _least(judge: Judge, start: np.ndarray, *, wishes: bool) -> np.ndarray:
    """SLSQP on the largest violation: of the stated limits among joints that exist, or of existence itself."""
    from scipy.optimize import Bounds, minimize

    size, must = start.size, np.isfinite(judge.room)
    upward = np.append(np.zeros(size), 1.0)

    def inequalities(x: np.ndarray) -> np.ndarray:
        margins = judge(np.clip(x[:-1], 0.0, 1.0)).margins
        exists = (margins + judge.room)[must]
        return np.concatenate([margins + x[-1], exists]) if wishes else exists + x[-1]

    def slopes(x: np.ndarray) -> np.ndarray:
        steep = judge(np.clip(x[:-1], 0.0, 1.0)).margin_slopes
        rows = np.vstack([steep, steep[must]]) if wishes else steep[must]
        moved = np.ones(len(rows))
        moved[len(steep) :] = 0.0
        return np.hstack([rows, moved[:, None]])

    begin = -float(inequalities(np.append(start, 0.0)).min())
    found = minimize(
        lambda x: x[-1],
        np.append(start, max(0.0, begin)),
        jac=lambda x: upward,
        bounds=Bounds(np.zeros(size + 1), np.append(np.ones(size), np.inf)),
        constraints=[{"type": "ineq", "fun": inequalities, "jac": slopes}],
        method="SLSQP",
        options={"maxiter": 200, "ftol": 1e-12},
    )
    return np.clip(found.x[:-1], 0.0, 1.0) if np.all(np.isfinite(found.x)) else start


def optimality_gap(judge: Judge, places: np.ndarray) -> tuple[float, np.ndarray]:
    """Unexplained part of the objective's gradient and multipliers of all margins, by non-negative least squares.

    Parameters
    ----------
    judge : Judge
        The problem.
    places : ndarray
        Shape (n,).

    Returns
    -------
    gap : float
        What the active limits and bounds leave of the gradient, relative to it, or to one logarithmic unit over the
        range of a variable where the objective is flatter than that [-].
    multipliers : ndarray
        Of all margins, shape (rows,); where limits are missed, of the largest violation, adding up to one.
    """
    from scipy.optimize import nnls

    judged = judge(places)
    violation = largest_violation(judged)
    size = places.size
    if violation <= FEASIBLE:
        worst = judged.objective[0]
        top = judged.objective_slopes[0][worst >= worst.max() - ACTIVE]
        near = judged.margins < ACTIVE
    else:
        top, near = np.zeros((0, size)), judged.margins < -violation + ACTIVE
    # where limits are missed, existence holds the design back too, but is no part of the violation
    exists = (judged.margins + judge.room < ACTIVE) & ~near
    bounds = np.vstack([np.eye(size)[places < 1e-7], -np.eye(size)[places > 1.0 - 1e-7]])
    pull = np.vstack([-top, judged.margin_slopes[near], judged.margin_slopes[exists], bounds])
    # weights of the worst scenarios (or of the violated limits) add up to one
    ones = np.concatenate(
        [
            np.ones(len(top)),
            np.full(int(near.sum()), 0.0 if len(top) else 1.0),
            np.zeros(int(exists.sum()) + len(bounds)),
        ]
    )
    scale = max(1e-12, float(np.abs(pull).max()) if pull.size else 1.0)
    system = np.vstack([pull.T / scale, ones[None, :]])
    weights, _ = nnls(system, np.append(np.zeros(size), 1.0))
    gradient = np.linalg.norm(pull[: len(top)].T @ weights[: len(top)]) if len(top) else 1.0
    rest = float(np.linalg.norm(pull.T @ weights) / max(float(gradient), 1.0))
    multipliers = np.zeros(judged.margins.size)
    multipliers[near] = weights[len(top) : len(top) + int(near.sum())]
    return rest, multipliers
