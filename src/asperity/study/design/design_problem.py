"""A design task: free numbers, objectives, limits, and the scenarios in which they must hold."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Literal

from asperity.joint_file.any_joint import results_of
from asperity.joint_file.si_tables import AnyCase, si_values
from asperity.results import Result
from asperity.standing.windup import StiffnessLevel


@dataclass(frozen=True)
class Variable:
    """A number that a design may choose, by its dotted path in the joint file, between bounds [SI].

    ``logarithmic`` ones are searched by their logarithm; ``step`` are standard sizes: the design is rounded to a
    multiple of it [SI].
    """

    path: str
    lower: float
    upper: float
    logarithmic: bool
    step: float | None = None

    def to_unit(self, value: float) -> float:
        """A value scaled to 0 at the lower and 1 at the upper bound."""
        if self.logarithmic:
            return math.log(value / self.lower) / math.log(self.upper / self.lower)
        return (value - self.lower) / (self.upper - self.lower)

    def from_unit(self, place: Any) -> Any:
        """Value [SI] of a scaled variable, or of an array of them."""
        if self.logarithmic:
            return self.lower * (self.upper / self.lower) ** place
        return self.lower + (self.upper - self.lower) * place

    def slope(self, value: Any) -> Any:
        """Derivative of the value [SI] by the scaled variable."""
        if self.logarithmic:
            return value * math.log(self.upper / self.lower)
        return self.upper - self.lower


#: What holds for every joint that exists, stated or not: a result and whether its limit is an upper one → the limit.
EXISTENCE: dict[tuple[str, bool], float] = {
    ("slip_ratio", True): 1.0,
    ("clearance", False): 0.0,
    ("normal_force_over_preload", False): 0.0,
}


@dataclass(frozen=True)
class Objective:
    """A result that a design makes as large (``sign`` −1) or as small (+1) as possible.

    The worst of its ``rows`` counts; None: of all.
    """

    name: str
    sign: float
    rows: tuple[int, ...] | None = None

    def of(self, results: Mapping[str, Any]) -> Any:
        """Its rows [SI], shape (rows, ...), from all results."""
        return results[self.name] if self.rows is None else results[self.name][list(self.rows)]


@dataclass(frozen=True)
class Constraint:
    """A limit [SI] of a result, a name of :attr:`DesignProblem.table`, for some of its rows (contacts, clearances).

    ``implied`` are the limits that every design has, stated or not.
    """

    name: str
    at_most: bool
    limit: float
    rows: tuple[int, ...]
    implied: bool = False


@dataclass(frozen=True)
class WorstCase:
    """Where the limits must hold and the objective is taken at its worst.

    At output torques [N·m], none for that of the joint file alone; ``tolerances``: whether, and how, those of the joint
    file are tried: "none", "corners" or "samples", by number and seed.
    """

    torques: tuple[float, ...]
    tolerances: str
    samples: int
    seed: int


@dataclass(frozen=True)
class DesignProblem:
    """A design task, checked. ``starts`` and ``seed`` control the search."""

    case: AnyCase
    joint_file: str
    level: StiffnessLevel
    variables: tuple[Variable, ...]
    objectives: tuple[Objective, ...]
    constraints: tuple[Constraint, ...]
    worst_case: WorstCase
    starts: int
    seed: int

    @property
    def table(self) -> dict[str, Result]:
        """The table of results of the drive."""
        return results_of(si_values(self.case))

    @property
    def goal(self) -> str:
        """The first objective in words."""
        first = self.objectives[0]
        return f"{'smallest' if first.sign > 0 else 'largest'} {self.table[first.name].said}"


#: What a report shows of every design beside objective and limits: at the joint's own torque, or at its largest or
#: smallest over all scenarios and contacts.
SUMMARY: dict[str, Literal["nominal", "largest", "smallest"]] = {
    "speed_ratio": "nominal",
    "envelope_diameter": "nominal",
    "envelope_length": "nominal",
    "mass": "nominal",
    "preload": "nominal",
    "hertz_pressure": "largest",
    "slip_ratio": "largest",
    "assembly_stiffness_output": "smallest",
}


def design_results(problem: DesignProblem) -> tuple[str, ...]:
    """The results that the search computes: few, because a program of all of them takes a minute to compile."""
    asked = {goal.name for goal in problem.objectives} | {limit.name for limit in problem.constraints}
    return tuple(name for name in problem.table if name in asked or name in SUMMARY)
