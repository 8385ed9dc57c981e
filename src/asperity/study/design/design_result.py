"""The result of a design: the joint, its values at the limits, and the evidence that it is a local optimum."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case
from asperity.results import RESULTS
from asperity.results.torque_capacity import JUDGED
from asperity.study.datasets import number_or_null
from asperity.study.design.design_problem import DesignProblem
from asperity.types import Document
from asperity.units import format_quantity

if TYPE_CHECKING:
    import xarray


#: Largest optimality residual of a local optimum.
OPTIMAL = 1e-3
Diagnostics = Document


@dataclass(frozen=True)
class LimitReport:
    """How a design stands to one limit, at its worst scenario and contact.

    ``row``: which of several rows is closest to the limit; ``value``, that of it [SI]. ``missed_by``: share of the
    limit by which it is missed, 0 where it is kept, nan where the design has no value. ``active``: whether the limit
    restricts the design. ``multiplier``, the shadow price: relative gain of the objective (or of the smallest
    violation) per relative relaxation of the limit [-]. ``implied``: whether it holds for every design, without being
    stated. ``output_torque`` of the worst scenario [N·m]. ``nearest``: the value closest to the limit, or furthest
    inside it, of all designs that the search looked at [SI]; nan where none had a value.
    """

    name: str
    label: str
    row: str
    at_most: bool
    limit: float
    value: float
    missed_by: float
    active: bool
    multiplier: float
    implied: bool
    output_torque: float
    nearest: float = math.nan

    @property
    def met(self) -> bool:
        """Whether the limit is kept; what has no value keeps none."""
        return self.missed_by == 0.0

    @property
    def state(self) -> str:
        """How the design stands to the limit, for a cell of a table; empty where the limit is far."""
        if math.isnan(self.missed_by):
            return "no value, not met"
        return f"{100.0 * self.missed_by:.3g} % off" if not self.met else "active" * self.active

    @property
    def reached(self) -> str:
        """That the limit is reached, in words."""
        where = f" at {self.row.replace('_', ' ')}" if self.row else ""
        sense = "largest" if self.at_most else "smallest"
        return f"{self.label}{where} at its {sense}, {format_quantity(self.limit, RESULTS[self.name].display_unit)}"

    @property
    def text(self) -> str:
        """The limit in words, with what was reached."""
        result = RESULTS[self.name]
        where = f" at {self.row.replace('_', ' ')}" if self.row else ""
        sense = "at most" if self.at_most else "at least"
        unit, at = result.display_unit, f"at {format_quantity(self.output_torque, 'N*m')}"
        if math.isnan(self.missed_by):
            nearest = format_quantity(self.nearest, unit)
            reached = (
                "no design has one"
                if math.isnan(self.nearest)
                else f"the nearest of any design was {nearest}"
            )
            why = f": there is none {result.has_none}" if result.has_none and math.isnan(self.nearest) else ""
            reached = f"no value there; {reached}{why}"
        else:
            missed = "" if self.met else f", {100.0 * self.missed_by:.3g} % off"
            reached = f"reached {format_quantity(self.value, unit)}{missed}"
        return f"{self.label}{where} {sense} {format_quantity(self.limit, unit)} ({reached}, {at})"


@dataclass(frozen=True)
class StartReport:
    """One start of the search: where it ended, and the largest violation there in the measure of the margins."""

    point: dict[str, float]
    objective: float
    violation: float
    converged: bool


@dataclass(frozen=True)
class DesignResult:
    """The outcome of a design: of a ``problem`` the ``point``, dotted path → value of the variables [SI].

    ``feasible``: whether all limits are met; if not, the point is the one of the smallest violation. ``crossed``,
    ``allowed`` and ``unknown``: of :class:`CrossedLimits`, under the torque of the file. ``optimum``: the variables
    before they were rounded to few digits [SI]. ``at_bound``: dotted path → "lower" or "upper" for the variables that
    lie on a bound.

    ``objective_before`` and ``objective_after``: the objective at its worst scenario, of the joint file and of the
    design [SI]; ``objective_unrounded``, before variables were rounded to their steps, None where none has a step.
    ``missed_before``: the limits that the joint of the file misses. ``summary_before`` and ``summary_after``: name →
    value [SI] of :data:`asperity.study.design.design_problem.SUMMARY`; nan where the joint has none.

    All ``limits`` and ``starts``; ``optimality_residual``: what is left of the objective's gradient after those of the
    active limits, relative to it [-], 0 at a local optimum; ``evaluations`` of all scenarios. ``joint_text``: the
    designed joint as a joint file; ``diagnostics``, of :func:`joint_diagnostics`; ``nominal``: objectives, limits and
    the summary of that file at its own torque [SI], shape (rows,).
    """

    problem: DesignProblem
    feasible: bool
    crossed: tuple[Diagnostics, ...]
    allowed: tuple[Diagnostics, ...]
    unknown: tuple[Diagnostics, ...]
    point: dict[str, float]
    optimum: dict[str, float]
    at_bound: dict[str, str]
    objective_before: float
    objective_after: float
    objective_unrounded: float | None
    missed_before: tuple[LimitReport, ...]
    summary_before: dict[str, float]
    summary_after: dict[str, float]
    limits: tuple[LimitReport, ...]
    optimality_residual: float
    starts: tuple[StartReport, ...]
    evaluations: int
    joint_text: str
    diagnostics: Diagnostics = field(repr=False)
    nominal: dict[str, np.ndarray] = field(repr=False)

    @property
    def violation(self) -> float:
        """Largest share by which a limit of the search is missed [-]; 0 for none, nan where a result has no value."""
        return 0.0 if self.feasible else float(np.max([limit.missed_by for limit in self.limits]))

    @property
    def met_words(self) -> str:
        """Whether it meets its limits, in words."""
        return met_words(feasible=self.feasible, allowed=self.allowed, unknown=self.unknown)

    @property
    def converged(self) -> bool:
        """Whether a search ended in a local optimum, or the design is one."""
        return self.optimality_residual < OPTIMAL or any(start.converged for start in self.starts)


def met_words(*, feasible: bool, allowed: Sequence[Diagnostics], unknown: Sequence[Diagnostics] = ()) -> str:
    """Whether a design meets its limits, which of the model its file allows to be crossed, and which are not known."""
    if not feasible:
        return "NOT all limits are met"
    beyond = f", which allows: {'; '.join(map(_crossed_words, allowed))}" if allowed else ""
    if unknown:
        open_ones = "; ".join(f"{_where(entry)} ({entry['meaning']})" for entry in unknown)
        return f"No limit{' of the design file' * bool(allowed)} is crossed{beyond}; not known: {open_ones}"
    return f"All limits{' of the design file' * bool(allowed)} are met{beyond}"


def _crossed_words(entry: Diagnostics) -> str:
    where = f" at {entry['contact'].replace('_', ' ')}" if entry["contact"] else ""
    return f"{entry['label']} {entry['shown']}{where}, limit {entry['limit_shown']}"


def _where(entry: Diagnostics) -> str:
    return (
        f"{entry['label']} at {entry['contact'].replace('_', ' ')}"
        if entry["contact"]
        else str(entry["label"])
    )


class CrossedLimits(NamedTuple):
    """Limits of function and damage that a designed joint does not keep, as in the document of a joint.

    ``crossed`` although its design file allows none of it; ``allowed`` by a wider limit of that file; ``unknown``, of
    which it is not known whether they are kept.
    """

    crossed: tuple[Diagnostics, ...]
    allowed: tuple[Diagnostics, ...]
    unknown: tuple[Diagnostics, ...]


def crossed_limits(problem: DesignProblem, diagnostics: Diagnostics) -> CrossedLimits:
    """Limits of function and damage that a designed joint does not keep."""
    stated = {limit.name for limit in problem.constraints if not limit.implied}
    crossed, allowed, unknown = list[Diagnostics](), list[Diagnostics](), list[Diagnostics]()
    for entry in diagnostics["diagnostics"] or ():
        if entry["ok"] or entry["severity"] not in JUDGED:
            continue
        by_leave = entry["name"].removeprefix("required_") in stated
        (unknown if not entry["known"] else allowed if by_leave else crossed).append(entry)
    return CrossedLimits(tuple(crossed), tuple(allowed), tuple(unknown))


def shortcoming(result: DesignResult) -> str:
    """Why a design is not what was asked for: the limits that conflict, or that no search converged; else empty."""
    if not result.feasible:
        return conflict(result)
    if not result.converged:
        return (
            f"no search converged, of {len(result.starts)}: the design meets all limits, but is no optimum (residual "
            f"{result.optimality_residual:.2g}); take more starts in [search], or narrow the bounds"
        )
    return ""


def bounds_words(result: DesignResult) -> str:
    """What holds a design back: the variables at a bound and the limits that it has reached; else empty."""
    bounds = [f"{path} at its {side} bound" for path, side in result.at_bound.items()]
    limits = [limit.reached for limit in result.limits if limit.active and limit.met]
    return "; ".join([*bounds, *limits])


def conflict(result: DesignResult) -> str:
    """Why a design is infeasible, in a sentence."""
    unknown = math.isnan(result.violation)
    parts = [limit.text for limit in result.limits if limit.active or (unknown and not limit.met)]
    missed = [limit.text for limit in result.limits if not limit.met and limit.text not in parts]
    bounds = [f"{path} is at its {side} bound" for path, side in result.at_bound.items()]
    crossed = [_crossed_words(entry) for entry in result.crossed if entry["name"] not in _names(result)]
    if not missed and result.violation == 0.0:
        return (
            "the design found keeps all limits that the search follows, and crosses one that it does not: "
            f"{'; '.join(crossed)}. Change what it depends on in the joint file, such as its duty"
        )
    conflicting = "These limits conflict: " if len(parts) > 1 else ""
    by = "has no value for a limit" if unknown else f"misses a limit by {100.0 * result.violation:.3g} %"
    missed += crossed
    also = f"It also misses: {'; '.join(missed)}. " if missed else ""
    return (
        f"no design meets all limits; the best one {by}. "
        f"{conflicting}{'; '.join([*parts, *bounds])}. {also}Relax one of these, or widen the bounds"
    )


def _names(result: DesignResult) -> set[str]:
    """Names of the limits that the search follows, as the diagnostics of a joint call them too."""
    return {name for limit in result.limits for name in (limit.name, f"required_{limit.name}")}


def joint_diagnostics(joint_text: str) -> Diagnostics:
    """Every limit of a designed joint file, kept or crossed, under the torque of the file, and its life.

    ``diagnostics``, as in the document of :func:`asperity.results.document.joint_document`, is None where the joint has
    no result under that torque, with the reason in ``no_result_because``; ``life_hours`` is there if it has a life.
    """
    try:
        document = solve_case(parse_case(joint_text, source="the designed joint")).document
    except (InputError, NoSolutionError) as error:
        return {"diagnostics": None, "no_result_because": str(error)}
    return {
        "diagnostics": document["diagnostics"],
        "life_hours": document["life_hours"],
        "no_result_because": None,
    }


def not_limited(result: DesignResult) -> str:
    """How long a design lives where no limit of its life was asked for; else empty."""
    life = result.diagnostics.get("life_hours")
    if life is None or any(RESULTS[limit.name].group == "life" for limit in result.limits):
        return ""
    shown = format_quantity(3600.0 * life, "h")
    return f"The design file sets no limit for life: the design has a rating life of {shown}."


def front_diagnostics(
    problem: DesignProblem, front: xarray.Dataset, *, progress: Callable[[int, int], None] | None = None
) -> Diagnostics:
    """The limits that the joints of a Pareto front cross."""
    count = int(front.sizes["design"])
    told: Diagnostics = {"diagnostics": [], "no_result_because": []}
    for index in range(count):
        point = {variable.path: float(front[variable.path].values[index]) for variable in problem.variables}
        diagnostics = joint_diagnostics(joint_file_text(problem.case, point, comment=""))
        entries = diagnostics["diagnostics"]
        told["diagnostics"].append(
            None if entries is None else [entry for entry in entries if not entry["ok"]]
        )
        told["no_result_because"].append(diagnostics["no_result_because"])
        if progress is not None:
            progress(index + 1, count)
    return told


def design_document(result: DesignResult) -> Document:
    """A design as plain data in SI units: objective before and after, variables, limits, starts, results of the joint.

    Its ``diagnostics`` are as in the document of ``asperity joint``.
    """

    def plain(node: Any) -> Any:
        if isinstance(node, dict):
            return {key: plain(value) for key, value in node.items()}
        if isinstance(node, list | tuple):
            return [plain(child) for child in node]
        return number_or_null(node) if isinstance(node, float) else node

    goal = result.problem.objectives[0]
    return plain(
        {
            "objective": {
                "result": goal.name,
                "label": result.problem.table[goal.name].said,
                "sense": "minimise" if goal.sign > 0 else "maximise",
                "before": result.objective_before,
                "after": result.objective_after,
                "unrounded": result.objective_unrounded,
            },
            "feasible": result.feasible,
            "converged": result.converged,
            "violation": result.violation,
            "optimality_residual": result.optimality_residual,
            "variables": result.point,
            "variables_unrounded": result.optimum,
            "at_bound": result.at_bound,
            "crossed": list(result.crossed),
            "allowed": list(result.allowed),
            "unknown": list(result.unknown),
            "missed_before": [asdict(limit) for limit in result.missed_before],
            "before": result.summary_before,
            "after": result.summary_after,
            "limits": [asdict(limit) | {"met": limit.met} for limit in result.limits],
            "starts": [asdict(start) for start in result.starts],
            "nominal": {name: value.tolist() for name, value in result.nominal.items()},
            "evaluations": result.evaluations,
            **result.diagnostics,
            "not_limited": not_limited(result) or None,
        }
    )
