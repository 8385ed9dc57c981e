"""Robust design of a joint: the best objective that every limit allows, by SLSQP with exact gradients."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint.status import ALL_PLASTIC, UNBALANCED, has_value
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case
from asperity.joint_file.si_tables import si_values
from asperity.made_files import DESIGNED_BY
from asperity.precision import require_double_precision
from asperity.results import RESULTS
from asperity.study.batch import DERIVATIVE_BATCH, derivatives_at
from asperity.study.design.design_evaluation import FARTHEST, DesignEvaluator, EvaluatedDesign
from asperity.study.design.design_problem import SUMMARY, DesignProblem
from asperity.study.design.design_result import (
    OPTIMAL,
    DesignResult,
    LimitReport,
    StartReport,
    crossed_limits,
    joint_diagnostics,
    met_words,
)
from asperity.study.design.design_search import (
    ACTIVE,
    FEASIBLE,
    SearchProgress,
    local_optimum,
    optimality,
    sampled_start,
    smallest_violation,
    starting_points,
    violation_rank,
)
from asperity.study.design.rounding import rounded_design, shortened_design
from asperity.units import format_quantity

_Ended = list[tuple[np.ndarray, EvaluatedDesign, bool]]


def design(problem: DesignProblem, *, progress: Callable[[int, int], None] | None = None) -> DesignResult:
    """Find the best design that meets all limits in all scenarios; or the smallest violation if none does.

    Parameters
    ----------
    problem : DesignProblem
        The problem, with one objective.
    progress : callable, optional
        Called with the number of finished searches and of all. More follow the starts where limits conflict, or where
        variables are rounded.

    Returns
    -------
    DesignResult
        The best of all starts, rounded where variables have steps. ``feasible`` says whether the limits are met.

    Raises
    ------
    InputError
        If there are several objectives (see :func:`asperity.study.design.pareto.pareto_front`).
    NoSolutionError
        If the search ended nowhere, or the joint at its end has no solution.

    Notes
    -----
    The objective at its worst scenario is an extra variable that bounds the objective of every scenario; so the
    problem stays smooth. A local method from several starts finds a local optimum (the optimality residual is part of
    the result), and makes a better one elsewhere unlikely, not impossible.

    References
    ----------
    D. Kraft, DFVLR-FB 88-28 (1988), SLSQP, as in SciPy; A. R. Conn, N. I. M. Gould and P. L. Toint, Trust-Region
    Methods, SIAM 2000, for the fallback.
    """
    require_double_precision()
    if len(problem.objectives) != 1:
        raise InputError(
            f"a design has one objective, got {len(problem.objectives)}; several make a Pareto front"
        )
    evaluator, count = DesignEvaluator(problem), SearchProgress(progress)
    starts = starting_points(evaluator)
    count.expect(len(starts))
    ended: _Ended = []
    for start in starts:
        end, converged = local_optimum(evaluator, start)
        ended.append((end, evaluator(end), converged))
        count.step()
    feasible = [search for search in ended if search[1].violation <= FEASIBLE]
    if feasible:
        best = min(feasible, key=lambda search: float(search[1].objective.max()))[0]
    else:
        best = _nearest(evaluator, ended, count)
    fixed, unrounded = np.zeros(best.size, dtype=bool), None
    if any(variable.step is not None for variable in problem.variables):
        unrounded = _worst_objective(evaluator, evaluator(best))
        best, fixed = rounded_design(evaluator, best, count)
        _refuse_what_cannot_exist(evaluator, evaluator(best))
    return _result(evaluator, best, fixed, unrounded, ended)


def _nearest(evaluator: DesignEvaluator, ended: _Ended, count: SearchProgress) -> np.ndarray:
    """The design of the smallest violation; a better one where the way to the limits is found only now."""
    ends = sorted((search[0] for search in ended), key=lambda end: violation_rank(evaluator, end))
    ends = ends[: max(3, len(ends) // 2)]
    if evaluator(ends[0]).violation >= FARTHEST:  # a limit without a value has no slope that leads to one
        ends = [sampled_start(evaluator), *ends]
    count.expect(len(ends))
    tries = []
    for end in ends:
        tries.append(smallest_violation(evaluator, end))
        count.step()
    best = min(tries, key=lambda candidate: violation_rank(evaluator, candidate))
    _refuse_what_cannot_exist(evaluator, evaluator(best))
    if evaluator(best).violation <= FEASIBLE:
        again, _ = local_optimum(evaluator, best)
        if evaluator(again).violation <= FEASIBLE:
            return again
    return best


def _refuse_what_cannot_exist(evaluator: DesignEvaluator, nearest: EvaluatedDesign) -> None:
    """Raise if the nearest design found cannot exist: then the stated limits cannot be assessed."""
    if evaluator.nonexistence(nearest) <= FEASIBLE:
        return
    lack = nearest.margins + evaluator.existence_slack
    worst: dict[str, int] = {}
    for index in np.argsort(lack):
        if lack[index] < 0.9 * lack.min():
            worst.setdefault(evaluator.rows[index].constraint.name, int(index))
    parts = []
    for name, index in worst.items():
        row, result = evaluator.rows[index], evaluator.problem.table[name]
        value = format_quantity(float(nearest.values[name][row.row, row.scenario]), result.display_unit)
        torque = format_quantity(float(evaluator.scenarios.torques[row.scenario]), "N*m")
        allowed = "at most 1" if row.constraint.at_most else "at least 0"
        where = result.row_names[row.row].replace("_", " ")
        parts.append(f"{result.label} at {where} {value} at {torque}, allowed is {allowed}")
    raise NoSolutionError(
        f"within the bounds no joint was found that exists in every scenario; the nearest has {'; '.join(parts)}; "
        "widen the bounds, or lower the torque"
    )


def _result(
    evaluator: DesignEvaluator, best: np.ndarray, fixed: np.ndarray, unrounded: float | None, ended: _Ended
) -> DesignResult:
    problem, goal = evaluator.problem, evaluator.problem.objectives[0]
    residual, multipliers = optimality(evaluator, best, fixed=fixed)
    exact, reached = evaluator.point(best), _tight(evaluator, evaluator(best))
    point, best = shortened_design(evaluator, best, fixed)
    optimum = evaluator(best)
    starts = tuple(
        StartReport(evaluator.point(end), _worst_objective(evaluator, reached), reached.violation, converged)
        for end, reached, converged in ended
    )
    _refuse_without_result(evaluator, optimum)
    diagnostics = joint_diagnostics(joint_file_text(problem.case, point, comment=""))
    judged = crossed_limits(problem, diagnostics)
    feasible = optimum.violation <= FEASIBLE and not judged.crossed
    verdict = met_words(feasible=feasible, allowed=judged.allowed, unknown=judged.unknown)
    if not feasible and optimum.violation > FEASIBLE:
        verdict += ": this is the smallest violation"
    if feasible and residual >= OPTIMAL and not any(start.converged for start in starts):
        verdict += ", but no search converged: this is no optimum"
    head = f"{DESIGNED_BY} from {Path(problem.joint_file).name}: {problem.goal}.\n{verdict}."
    text = joint_file_text(problem.case, point, comment=head)
    status, before, _ = derivatives_at(
        evaluator.values, evaluator.scenarios.changes({}), evaluator.results, block=evaluator.block
    )
    worst_before = goal.sign * goal.of(before)[:, evaluator.counted]
    return DesignResult(
        problem=problem,
        feasible=feasible,
        **judged._asdict(),
        point=point,
        optimum=exact,
        at_bound={
            variable.path: "lower" if place < 0.5 else "upper"
            for variable, place in zip(evaluator.variables, evaluator.scaled(exact), strict=True)
            if not 1e-7 < place < 1.0 - 1e-7
        },
        objective_before=float(goal.sign * worst_before.max()),
        objective_after=_worst_objective(evaluator, optimum),
        objective_unrounded=unrounded,
        missed_before=_missed(evaluator, before),
        summary_before=_summary(evaluator, status, before),
        summary_after=_summary(evaluator, optimum.status, optimum.values),
        limits=tuple(_limits(evaluator, optimum, multipliers, reached)),
        optimality_residual=residual,
        starts=starts,
        evaluations=evaluator.evaluations,
        joint_text=text,
        diagnostics=diagnostics,
        nominal=nominal_results(text, evaluator.results, evaluator.block),
    )


def _refuse_without_result(evaluator: DesignEvaluator, optimum: EvaluatedDesign) -> None:
    """Refuse a design whose objective has no value in a scenario that counts, or whose contacts are all plastic."""
    status = optimum.status[evaluator.counted]
    if np.any(status == UNBALANCED):
        raise NoSolutionError(
            "the force balance of the design found did not close in every scenario; narrow the bounds"
        )
    problem = evaluator.problem
    asked = [(goal.name, goal.of(optimum.values)) for goal in problem.objectives]
    asked += [(limit.name, optimum.values[limit.name][list(limit.rows)]) for limit in problem.constraints]
    unknown = dict.fromkeys(name for name, value in asked if np.isnan(value[:, evaluator.counted]).any())
    if unknown and np.any(status == ALL_PLASTIC):
        raise NoSolutionError(
            f"the nearest design found has no value of {', '.join(unknown)}: every spot of a contact is plastic, where "
            "the contact law has no stiffness; use a surface of larger fractal_dimension or smaller fractal_roughness"
        )
    goal = problem.objectives[0].name
    if goal in unknown:
        if np.all(status == 0) and (none := RESULTS[goal].has_none):
            raise NoSolutionError(f"the nearest design found has no value of {goal}: there is none {none}")
        raise NoSolutionError(
            f"the nearest design found has no value of {goal}: its joint slips, lifts off or is not carried; widen the "
            "bounds, or lower the torque"
        )


def _worst_objective(evaluator: DesignEvaluator, evaluated: EvaluatedDesign) -> float:
    """The objective at its worst scenario [SI]."""
    goal = evaluator.problem.objectives[0]
    worst = goal.sign * float(evaluated.objective[0].max())
    return float(np.exp(worst)) if RESULTS[goal.name].positive else worst


def _summary(
    evaluator: DesignEvaluator, status: np.ndarray, values: dict[str, np.ndarray]
) -> dict[str, float]:
    summary = {}
    for name, which in SUMMARY.items():
        if name not in values:
            continue
        table = np.where(has_value(status, RESULTS[name].needs), values[name], np.nan)
        counted = table[:, evaluator.counted]
        summary[name] = float(
            {"nominal": table[0, 0], "largest": counted.max(), "smallest": counted.min()}[which]
        )
    return summary


def nominal_results(
    joint_text: str, results: tuple[str, ...], block: int = DERIVATIVE_BATCH
) -> dict[str, np.ndarray]:
    """Results of a joint file as it stands, shape (rows,) [SI]."""
    values = si_values(parse_case(joint_text, source="the designed joint"))
    torque = np.array([values["load"]["output_torque"]])
    _, result_values, _ = derivatives_at(values, {"load.output_torque": torque}, results, block=block)
    return {name: value[:, 0] for name, value in result_values.items()}


def _missed(evaluator: DesignEvaluator, values: dict[str, np.ndarray]) -> tuple[LimitReport, ...]:
    """The limits that the joint of the file misses, from its results in all scenarios [SI]."""
    margins = np.concatenate(evaluator.margins_of(values))
    given = EvaluatedDesign(np.zeros(0), np.zeros(0), margins, np.zeros(0), np.zeros(0), values)
    reports = _limits(evaluator, given, np.zeros(margins.size), _tight(evaluator, given))
    return tuple(report for report in reports if not report.met)


def _tight(evaluator: DesignEvaluator, best: EvaluatedDesign) -> np.ndarray:
    """Which limits restrict a design, before its numbers are rounded to few digits."""
    tight = best.margins < ACTIVE - (best.violation if best.violation > FEASIBLE else 0.0)
    return tight | (best.margins + evaluator.existence_slack < ACTIVE)


def _limits(
    evaluator: DesignEvaluator, best: EvaluatedDesign, multipliers: np.ndarray, tight: np.ndarray
) -> list[LimitReport]:
    reports = []
    for constraint, (_, nearest) in zip(evaluator.problem.constraints, evaluator.nearest, strict=True):
        mine = [index for index, row in enumerate(evaluator.rows) if row.constraint is constraint]
        worst = min(mine, key=lambda index: best.margins[index])
        row = evaluator.rows[worst]
        value = float(best.values[constraint.name][row.row, row.scenario])
        missed = abs(value - constraint.limit) if best.margins[worst] < -FEASIBLE else 0.0
        reports.append(
            LimitReport(
                name=constraint.name,
                label=evaluator.problem.table[constraint.name].said,
                row=evaluator.problem.table[constraint.name].row_names[row.row],
                at_most=constraint.at_most,
                limit=constraint.limit,
                value=value,
                missed_by=missed / (abs(constraint.limit) or 1.0),
                active=bool(np.any(tight[mine])),
                multiplier=float(sum(multipliers[index] for index in mine)),
                implied=constraint.implied,
                output_torque=float(evaluator.scenarios.torques[row.scenario]),
                nearest=nearest,
            )
        )
    return reports
