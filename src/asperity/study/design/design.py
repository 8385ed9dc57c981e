"""Robust design of a joint: the best objective that every limit allows, by SLSQP with exact gradients."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.reader import parse_case
from asperity.joint_file.values import si_values
from asperity.precision import require_double_precision
from asperity.study.design.design_problem import DesignProblem
from asperity.study.design.design_search import (
    ACTIVE,
    FEASIBLE,
    badness,
    largest_violation,
    least_violation,
    local_optimum,
    nonexistence,
    optimality_gap,
    starting_places,
)
from asperity.study.design.joint_text import joint_file_text
from asperity.study.design.judgement import Judge, Judged
from asperity.study.quantities import QUANTITIES, at_level, quantities_and_slopes


@dataclass(frozen=True)
class LimitReport:
    """How a design stands to one limit, at its worst scenario and contact.

    Parameters
    ----------
    name, row : str
        The quantity and, if it has several rows, which one is closest to the limit.
    at_most : bool
        Whether the limit is an upper one.
    limit, value : float
        The limit and the value closest to it [SI].
    margin : float
        From 0 on fine; see :mod:`asperity.study.design.judgement`.
    active : bool
        Whether it holds the design back.
    multiplier : float
        Relative gain of the objective (or of the least violation) per relative relaxation of the limit [-].
    implied : bool
        Whether it holds for every design, without being stated.
    output_torque : float
        Torque of the worst scenario [N·m].
    """

    name: str
    row: str
    at_most: bool
    limit: float
    value: float
    margin: float
    active: bool
    multiplier: float
    implied: bool
    output_torque: float


@dataclass(frozen=True)
class StartReport:
    """One start of the search: where it ended and whether all limits are met there."""

    point: dict[str, float]
    objective: float
    violation: float
    converged: bool


@dataclass(frozen=True)
class DesignResult:
    """The outcome of a design.

    Parameters
    ----------
    problem : DesignProblem
        What was asked.
    feasible : bool
        Whether all limits are met. If not, the point is the one of least violation.
    point : dict
        Dotted path → value of the variables [SI].
    at_bound : dict
        Dotted path → "lower" or "upper" for the variables that lie on a bound.
    before, after : dict
        Name → worst value over the judged scenarios of the joint file and of the design [SI]; ``nan`` where the
        file's joint does not exist.
    objective_before, objective_after : float
        The objective at its worst scenario [SI].
    limits : tuple of LimitReport
        All limits.
    violation : float
        Largest violation: logarithm of the ratio to the limit; 0 for a feasible design.
    optimality : float
        Gradient that the active limits do not explain, relative to that of the objective [-].
    starts : tuple of StartReport
        All starts.
    evaluations : int
        Evaluations of all scenarios, with derivatives.
    joint_text : str
        The designed joint as a joint file.
    nominal : dict
        Quantities of that file at its own torque [SI], shape (rows,).
    """

    problem: DesignProblem
    feasible: bool
    point: dict[str, float]
    at_bound: dict[str, str]
    objective_before: float
    objective_after: float
    limits: tuple[LimitReport, ...]
    violation: float
    optimality: float
    starts: tuple[StartReport, ...]
    evaluations: int
    joint_text: str
    nominal: dict[str, np.ndarray] = field(repr=False)


def design(problem: DesignProblem, *, progress: Callable[[int, int], None] | None = None) -> DesignResult:
    """Find the best design that meets all limits in all scenarios; or the least violation if none does.

    Parameters
    ----------
    problem : DesignProblem
        The problem, with one objective.
    progress : callable, optional
        Called with the number of finished starts and of all starts.

    Returns
    -------
    DesignResult
        The best of all starts. ``feasible`` says whether the limits are met.

    Raises
    ------
    InputError
        If there are several objectives (see :func:`asperity.study.design.pareto.pareto_front`).
    NoSolutionError
        If the search ended nowhere, or the joint at its end has no solution.

    Notes
    -----
    The objective at its worst scenario is an extra variable that bounds the objective of every scenario; so the
    problem stays smooth. A local method from several starts proves a local optimum (its optimality conditions are
    part of the result), and makes a better one elsewhere unlikely, not impossible.

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
    judge = Judge(problem)
    starts = starting_places(judge)
    ended: list[tuple[np.ndarray, Judged, bool]] = []
    for index, start in enumerate(starts):
        end, converged = local_optimum(judge, start)
        ended.append((end, judge(end), converged))
        if progress is not None:
            progress(index + 1, len(starts))
    feasible = [each for each in ended if largest_violation(each[1]) <= FEASIBLE]
    if feasible:
        places, judged, _ = min(feasible, key=lambda each: float(each[1].objective.max()))
    else:
        nearest = sorted(ended, key=lambda each: badness(judge, each[0]))
        tries = [least_violation(judge, each[0]) for each in nearest[: max(3, len(nearest) // 2)]]
        places = min(tries, key=lambda each: badness(judge, each))
        judged = judge(places)
        _refuse_what_cannot_exist(judge, judged)
        if (
            largest_violation(judged) <= FEASIBLE
        ):  # the way to the limits was found only now: go on from there
            again, converged = local_optimum(judge, places)
            if largest_violation(judge(again)) <= FEASIBLE:
                places = again
            judged = judge(places)
    return _result(judge, places, judged, ended)


def _refuse_what_cannot_exist(judge: Judge, judged: Judged) -> None:
    """Raise if the nearest that was found is no joint: then nothing can be said about the stated limits."""
    from asperity.units import format_quantity

    if nonexistence(judge, judged) <= FEASIBLE:
        return
    lack = judged.margins + judge.room
    worst: dict[str, int] = {}
    for index in np.argsort(lack):
        if lack[index] < 0.9 * lack.min():
            worst.setdefault(judge.rows[index].constraint.name, int(index))
    parts = []
    for name, index in worst.items():
        row, kind = judge.rows[index], QUANTITIES[name]
        value = format_quantity(float(judged.values[name][row.row, row.scenario]), kind.unit)
        torque = format_quantity(float(judge.states.torques[row.scenario]), "N*m")
        allowed = "at most 1" if row.constraint.at_most else "at least 0"
        parts.append(f"{kind.label} at {kind.row_names[row.row]} {value} at {torque}, allowed is {allowed}")
    raise NoSolutionError(
        f"within the bounds no joint was found that exists in every scenario; the nearest has {'; '.join(parts)}; "
        "widen the bounds, or lower the torque"
    )


def _result(
    judge: Judge, places: np.ndarray, judged: Judged, ended: list[tuple[np.ndarray, Judged, bool]]
) -> DesignResult:
    problem, goal = judge.problem, judge.problem.objectives[0]
    optimality, multipliers = optimality_gap(judge, places)
    point = judge.point(places)
    violation = largest_violation(judged)
    feasible = violation <= FEASIBLE
    text = joint_file_text(
        problem.case,
        point,
        comment=(
            f"Designed by asperity from {Path(problem.joint_file).name}: {goal.text}, {problem.level} stiffness.\n"
            + ("All limits are met." if feasible else "NOT all limits are met: this is the least violation.")
        ),
    )
    nominal = nominal_quantities(text)
    if not np.all(judged.values["solved"]):
        raise NoSolutionError(
            "the force balance of the design found did not close in every scenario; narrow the bounds"
        )
    before = _objective_of_file(judge)
    return DesignResult(
        problem=problem,
        feasible=feasible,
        point=point,
        at_bound={
            variable.path: "lower" if place < 0.5 else "upper"
            for variable, place in zip(judge.variables, places, strict=True)
            if not 1e-7 < place < 1.0 - 1e-7
        },
        objective_before=before,
        objective_after=_as_value(goal.sign, goal.name, judged.objective[0]),
        limits=tuple(_limits(judge, judged, multipliers, violation)),
        violation=0.0 if feasible else violation,
        optimality=optimality,
        starts=tuple(
            StartReport(
                point=judge.point(end),
                objective=_as_value(goal.sign, goal.name, found.objective[0]),
                violation=largest_violation(found),
                converged=converged,
            )
            for end, found, converged in ended
        ),
        evaluations=judge.evaluations,
        joint_text=text,
        nominal=nominal,
    )


def _as_value(sign: float, name: str, objective: np.ndarray) -> float:
    worst = sign * float(objective.max())
    return float(np.exp(worst)) if QUANTITIES[name].ratio else worst


def _objective_of_file(judge: Judge) -> float:
    goal = judge.problem.objectives[0]
    name = at_level(goal.name, judge.problem.level)
    found, _ = quantities_and_slopes(judge.values, judge.states.changes({}), ())
    value = goal.sign * found[name][:, judge.judged]
    return float(goal.sign * value.max())


def nominal_quantities(joint_text: str) -> dict[str, np.ndarray]:
    """Quantities of a joint file as it stands.

    Parameters
    ----------
    joint_text : str
        TOML.

    Returns
    -------
    dict
        Name → shape (rows,) [SI].
    """
    values = si_values(parse_case(joint_text, source="the designed joint"))
    torque = np.array([values["load"]["output_torque"]])
    found, _ = quantities_and_slopes(values, {"load.output_torque": torque}, ())
    return {name: value[:, 0] for name, value in found.items()}


def _limits(judge: Judge, judged: Judged, multipliers: np.ndarray, violation: float) -> list[LimitReport]:
    reports = []
    for constraint in judge.problem.constraints:
        kind = QUANTITIES[constraint.name]
        mine = [index for index, row in enumerate(judge.rows) if row.constraint is constraint]
        worst = min(mine, key=lambda index: judged.margins[index])
        row = judge.rows[worst]
        reports.append(
            LimitReport(
                name=constraint.name,
                row=kind.row_names[row.row],
                at_most=constraint.at_most,
                limit=constraint.limit,
                value=float(
                    judged.values[at_level(constraint.name, judge.problem.level)][row.row, row.scenario]
                ),
                margin=float(judged.margins[worst]),
                active=bool(
                    judged.margins[worst] < ACTIVE - (violation if violation > FEASIBLE else 0.0)
                    or np.any((judged.margins + judge.room)[mine] < ACTIVE)
                ),
                multiplier=float(sum(multipliers[index] for index in mine)),
                implied=constraint.implied,
                output_torque=float(judge.states.torques[row.scenario]),
            )
        )
    return reports


def conflict(result: DesignResult) -> str:
    """Why a design is infeasible, in a sentence.

    Parameters
    ----------
    result : DesignResult
        An infeasible result.

    Returns
    -------
    str
        Which limits stand against each other, what is reached of each, and which bounds hold.
    """
    from asperity.units import format_quantity

    parts = []
    for limit in result.limits:
        if limit.active:
            kind = QUANTITIES[limit.name]
            where = f" at {limit.row}" if limit.row else ""
            sense = "at most" if limit.at_most else "at least"
            parts.append(
                f"{kind.label}{where} {sense} {format_quantity(limit.limit, kind.unit)} "
                f"(reached {format_quantity(limit.value, kind.unit)} at {format_quantity(limit.output_torque, 'N*m')})"
            )
    bounds = [f"{path} at its {side} bound" for path, side in result.at_bound.items()]
    held = f"; {', '.join(bounds)}" if bounds else ""
    against = " against " if len(parts) > 1 else ""
    listed = against.join([parts[0], ", ".join(parts[1:])]) if len(parts) > 1 else "".join(parts)
    return (
        f"no design meets all limits; at best they are missed by {100.0 * np.expm1(result.violation):.3g} %: "
        f"{listed}{held}; relax one of these, or widen the bounds"
    )
