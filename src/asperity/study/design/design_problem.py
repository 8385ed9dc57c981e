"""What a design task is: free numbers, objectives, limits, and the states in which they count."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from asperity.joint.windup import StiffnessLevel
from asperity.joint_file.model import Case
from asperity.study.quantities import QUANTITIES


@dataclass(frozen=True)
class Variable:
    """A number that a design may choose.

    Parameters
    ----------
    path : str
        Its dotted path in the joint file.
    lower, upper : float
        Bounds [SI].
    logarithmic : bool
        Whether it is searched by its logarithm.
    """

    path: str
    lower: float
    upper: float
    logarithmic: bool

    def to_unit(self, value: float) -> float:
        """Place of a value between the bounds, 0 to 1."""
        if self.logarithmic:
            return math.log(value / self.lower) / math.log(self.upper / self.lower)
        return (value - self.lower) / (self.upper - self.lower)

    def from_unit(self, place: Any) -> Any:
        """Value [SI] at a place, 0 to 1; arrays are welcome."""
        if self.logarithmic:
            return self.lower * (self.upper / self.lower) ** place
        return self.lower + (self.upper - self.lower) * place

    def slope(self, value: Any) -> Any:
        """Derivative of the value [SI] by the place."""
        if self.logarithmic:
            return value * math.log(self.upper / self.lower)
        return self.upper - self.lower


@dataclass(frozen=True)
class Objective:
    """What a design makes as large or as small as possible: a quantity, and +1 to minimise or −1 to maximise it."""

    name: str
    sign: float

    @property
    def text(self) -> str:
        """In words."""
        return f"{'smallest' if self.sign > 0 else 'largest'} {QUANTITIES[self.name].label}"


@dataclass(frozen=True)
class Constraint:
    """A limit of a quantity.

    Parameters
    ----------
    name : str
        The quantity.
    at_most : bool
        Whether the limit is an upper one.
    limit : float
        The limit [SI].
    rows : tuple of int
        Which rows of the quantity (contacts, clearances) it holds for.
    implied : bool
        True for the limits every design has, stated or not.
    """

    name: str
    at_most: bool
    limit: float
    rows: tuple[int, ...]
    implied: bool = False


@dataclass(frozen=True)
class WorstCase:
    """Where the limits must hold and the objective is taken at its worst.

    Parameters
    ----------
    torques : tuple of float
        Output torques [N·m]; empty for the torque of the joint file alone.
    tolerances : {"none", "corners", "samples"}
        Whether, and how, the tolerances of the joint file are tried.
    samples, seed : int
        Number of samples and seed of their random numbers.
    """

    torques: tuple[float, ...]
    tolerances: str
    samples: int
    seed: int


@dataclass(frozen=True)
class DesignProblem:
    """A design task, checked. ``starts`` and ``seed`` steer the search."""

    case: Case
    joint_file: str
    level: StiffnessLevel
    variables: tuple[Variable, ...]
    objectives: tuple[Objective, ...]
    constraints: tuple[Constraint, ...]
    worst_case: WorstCase
    starts: int
    seed: int
