"""The result of a design: the joint, its values at the limits, and the evidence that it is a local optimum."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case
from asperity.results import RESULTS
from asperity.study.datasets import number_or_null
from asperity.study.design.design_problem import DesignProblem
from asperity.units import format_quantity

if TYPE_CHECKING:
    import xarray


#: Largest optimality residual of a local optimum.
OPTIMAL = 1e-3
#: Limits that keep the pressure from yield.
_OF_YIELD = {
    "pressure_over_first_yield",
    "hertz_pressure",
    "yield_safety",
    "shakedown_ratio",
    "rolling_hertz_pressure",
}
Diagnostics = dict[str, Any]


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
            return "no value: not met"
        return f"{100.0 * self.missed_by:.3g} % off" if not self.met else "active" * self.active

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
                "none of any design"
                if math.isnan(self.nearest)
                else f"the nearest of any design was {nearest}"
            )
            why = f": there is none {result.has_none}" if result.has_none and math.isnan(self.nearest) else ""
            reached = f"no value there, {reached}{why}"
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

    ``feasible``: whether all limits are met; if not, the point is the one of the smallest violation. ``at_bound``:
    dotted path → "lower" or "upper" for the variables that lie on a bound. ``objective_before`` and
    ``objective_after``: the objective at its worst scenario, of the joint file and of the design [SI];
    ``objective_unrounded``, before variables were rounded to their steps, None where none has a step.
    ``summary_before`` and ``summary_after``: name → value [SI] of :data:`asperity.study.design.design_problem.SUMMARY`;
    nan where the joint has none.

    All ``limits`` and ``starts``; ``optimality_residual``: what is left of the objective's gradient after those of the
    active limits, relative to it [-], 0 at a local optimum; ``evaluations`` of all scenarios. ``joint_text``: the
    designed joint as a joint file; ``nominal``: objectives, limits and the summary of that file at its own torque [SI],
    shape (rows,).
    """

    problem: DesignProblem
    feasible: bool
    point: dict[str, float]
    at_bound: dict[str, str]
    objective_before: float
    objective_after: float
    objective_unrounded: float | None
    summary_before: dict[str, float]
    summary_after: dict[str, float]
    limits: tuple[LimitReport, ...]
    optimality_residual: float
    starts: tuple[StartReport, ...]
    evaluations: int
    joint_text: str
    nominal: dict[str, np.ndarray] = field(repr=False)

    @property
    def violation(self) -> float:
        """Largest share by which a limit is missed [-]; 0 for a feasible design, nan where a result has no value."""
        return 0.0 if self.feasible else float(np.max([limit.missed_by for limit in self.limits]))

    @property
    def converged(self) -> bool:
        """Whether a search ended in a local optimum, or the design is one."""
        return self.optimality_residual < OPTIMAL or any(start.converged for start in self.starts)


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


def conflict(result: DesignResult) -> str:
    """Why a design is infeasible, in a sentence."""
    unknown = math.isnan(result.violation)
    parts = [limit.text for limit in result.limits if limit.active or (unknown and not limit.met)]
    missed = [limit.text for limit in result.limits if not limit.met and limit.text not in parts]
    bounds = [f"{path} is at its {side} bound" for path, side in result.at_bound.items()]
    conflicting = "These limits conflict: " if len(parts) > 1 else ""
    by = "has no value of a limit" if unknown else f"misses a limit by {100.0 * result.violation:.3g} %"
    also = f"It also misses: {'; '.join(missed)}. " if missed else ""
    return (
        f"no design meets all limits; the best one {by}. "
        f"{conflicting}{'; '.join([*parts, *bounds])}. {also}Relax one of these, or widen the bounds"
    )


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


def not_limited(result: DesignResult, diagnostics: Diagnostics) -> str:
    """What a design reaches beyond first yield, and its life, where no limit of them was asked for; else empty."""
    limited = {limit.name for limit in result.limits}
    found = {}
    over_yield = [
        entry["value"]
        for entry in diagnostics["diagnostics"] or ()
        if entry["name"] == "pressure_over_first_yield" and not entry["ok"] and entry["value"] is not None
    ]
    if over_yield and not limited & _OF_YIELD:
        pressure = format_quantity(result.summary_after["hertz_pressure"], "MPa")
        found["yield"] = f"a pressure of {pressure}, up to {max(over_yield):.3g} times that of first yield"
    if diagnostics.get("life_hours") is not None and not any(
        RESULTS[name].group == "life" for name in limited
    ):
        found["life"] = f"a life of {diagnostics['life_hours']:.4g} h"
    if not found:
        return ""
    return f"No limit of {' and '.join(found)} was asked for: the design has {' and '.join(found.values())}."


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


def design_document(result: DesignResult) -> dict[str, Any]:
    """A design as plain data in SI units: objective before and after, variables, limits, starts, results of the joint.

    Its ``diagnostics`` are as in the document of ``asperity joint``.
    """

    def plain(node: Any) -> Any:
        if isinstance(node, dict):
            return {key: plain(value) for key, value in node.items()}
        if isinstance(node, list | tuple):
            return [plain(child) for child in node]
        return number_or_null(node) if isinstance(node, float) else node

    goal, diagnostics = result.problem.objectives[0], joint_diagnostics(result.joint_text)
    return plain(
        {
            "objective": {
                "result": goal.name,
                "label": result.problem.table[goal.name].label,
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
            "at_bound": result.at_bound,
            "before": result.summary_before,
            "after": result.summary_after,
            "limits": [asdict(limit) | {"met": limit.met} for limit in result.limits],
            "starts": [asdict(start) for start in result.starts],
            "nominal": {name: value.tolist() for name, value in result.nominal.items()},
            "evaluations": result.evaluations,
            **diagnostics,
            "not_limited": not_limited(result, diagnostics) or None,
        }
    )
