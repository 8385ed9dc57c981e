"""Designs that can be made: variables with a step rounded to it, all others to the fewest digits that do."""

from __future__ import annotations

import itertools
import math

import numpy as np

from asperity.joint_file.part_names import type_of
from asperity.joint_file.quantity_key import Key
from asperity.joint_file.si_tables import key_at
from asperity.results import RESULTS
from asperity.study.design.design_evaluation import DesignEvaluator
from asperity.study.design.design_problem import Variable
from asperity.study.design.design_search import FEASIBLE, SearchProgress, local_optimum, violation_rank
from asperity.units import from_si, parse_quantity

#: Variables that may have a step: each doubles the number of combinations.
MOST_STEPPED = 6

#: Significant digits with which the rounding of the other variables begins, in the unit of the joint file.
FEWEST_DIGITS = 4

#: Relative change of the objective that their rounding may cause.
_SAME = 1e-3

#: Variables that are rounded up and down in every combination; of more, one after the other.
_COMBINED = 6

#: Combinations of rounded values for which the other variables are optimised again: the most promising ones.
_REFINED = 8


def neighbours(variable: Variable, value: float) -> tuple[float, ...]:
    """The one or two multiples of a variable's step next to a value, within its bounds [SI].

    Examples
    --------
    >>> length = Variable("drive.contact_length", 1.0, 9.5, False, step=2.0)
    >>> neighbours(length, 5.1), neighbours(length, 9.3), neighbours(length, 4.0)
    ((4.0, 6.0), (8.0,), (4.0,))
    """
    assert variable.step is not None
    steps = value / variable.step
    nearest = round(steps)
    near = {nearest} if math.isclose(steps, nearest, rel_tol=1e-9) else {math.floor(steps), math.ceil(steps)}
    low, high = (
        math.ceil(variable.lower / variable.step - 1e-9),
        math.floor(variable.upper / variable.step + 1e-9),
    )
    return tuple(
        sorted(min(max(count, low), high) * variable.step for count in {min(max(n, low), high) for n in near})
    )


def rounded_design(
    evaluator: DesignEvaluator, scaled: np.ndarray, count: SearchProgress
) -> tuple[np.ndarray, np.ndarray]:
    """The best design next to a given one whose stepped variables are multiples of their steps.

    Shape (n,).
    """
    fixed = np.array([variable.step is not None for variable in evaluator.variables])
    point = evaluator.point(scaled)
    choices = [
        [variable.to_unit(value) for value in neighbours(variable, point[variable.path])]
        if variable.step is not None
        else [place]
        for variable, place in zip(evaluator.variables, scaled, strict=True)
    ]
    combinations = np.clip(np.array(list(itertools.product(*choices))), 0.0, 1.0)
    objectives, margins = evaluator.many(combinations)
    order = np.lexsort((objectives[:, 0], np.maximum(-margins.min(axis=1), FEASIBLE)))
    tried = [combinations[k] for k in order]
    if not fixed.all():
        promising = tried[:_REFINED]
        count.expect(len(promising))
        for design in promising:
            tried.append(local_optimum(evaluator, design, fixed=fixed)[0])
            count.step()

    return min(tried, key=lambda design: _rank(evaluator, design)), fixed


def shortened_design(
    evaluator: DesignEvaluator, scaled: np.ndarray, fixed: np.ndarray
) -> tuple[dict[str, float], np.ndarray]:
    """The same design with as few digits as keep its limits, each number rounded up or down, shape (n,) [SI].

    Four digits or more, so that the objective changes by no more than a thousandth; so may the violation of a design
    that misses a limit, which exists before and after.
    """
    exact = evaluator(scaled)
    allowed = FEASIBLE if exact.violation <= FEASIBLE else exact.violation + _SAME
    objectives = np.array([np.max(goal) for goal in exact.objective])
    positive = np.array([RESULTS[goal.name].positive for goal in evaluator.problem.objectives])
    size = np.where(positive, 1.0, np.abs(objectives))  # of positive results it is the logarithm
    for digits in range(FEWEST_DIGITS, 16):
        places = _rounded_places(evaluator, scaled, fixed, digits)
        for place in sorted(places, key=lambda place: _rank(evaluator, place)):
            rounded = evaluator(place)
            changed = np.array([np.max(goal) for goal in rounded.objective]) - objectives
            lack = evaluator.nonexistence(rounded) - evaluator.nonexistence(exact)
            if rounded.violation <= allowed and lack <= FEASIBLE and np.all(changed <= _SAME * size):
                return _stated(evaluator, place, fixed, digits), place
    return evaluator.point(scaled), scaled


def _rounded_places(
    evaluator: DesignEvaluator, scaled: np.ndarray, fixed: np.ndarray, digits: int
) -> list[np.ndarray]:
    """The most promising designs whose free variables are rounded up or down to so many digits."""
    point, kind = evaluator.point(scaled), type_of(evaluator.values)
    choices = []
    for variable, place, keep in zip(evaluator.variables, scaled, fixed, strict=True):
        ways = _both_ways(point[variable.path], key_at(variable.path, kind), digits)
        within = [variable.to_unit(min(max(value, variable.lower), variable.upper)) for value in ways]
        if abs(within[1] - place) < abs(within[0] - place):
            within.reverse()
        choices.append([float(place)] if keep else list(dict.fromkeys(within)))
    if len(choices) > _COMBINED:
        return [_one_by_one(evaluator, choices)]
    combinations = np.clip(np.array(list(itertools.product(*choices))), 0.0, 1.0)
    worst, margins = evaluator.many(combinations)
    order = np.lexsort((worst[:, 0], np.maximum(-margins.min(axis=1), FEASIBLE)))
    return [combinations[k] for k in order[:3]]


def _one_by_one(evaluator: DesignEvaluator, choices: list[list[float]]) -> np.ndarray:
    """All variables rounded to the nearest, then those the other way that lessens the violation."""
    place = np.clip(np.array([nearest[0] for nearest in choices]), 0.0, 1.0)
    for index, ways in enumerate(choices):
        for way in ways[1:]:
            other = place.copy()
            other[index] = np.clip(way, 0.0, 1.0)
            place = min(place, other, key=lambda design: _rank(evaluator, design))
    return place


def _rank(evaluator: DesignEvaluator, place: np.ndarray) -> tuple[float, float, float]:
    """Lack of existence, violation, objective, to be compared."""
    lack, violation = violation_rank(evaluator, place)
    return lack, max(violation, FEASIBLE), float(evaluator(place).objective[0].max())


def _stated(
    evaluator: DesignEvaluator, place: np.ndarray, fixed: np.ndarray, digits: int
) -> dict[str, float]:
    """Values of a rounded design, exactly those of the texts with so many digits [SI]."""
    point, kind = evaluator.point(place), type_of(evaluator.values)
    return {
        variable.path: point[variable.path]
        if keep or point[variable.path] in (variable.lower, variable.upper)
        else _nearest(point[variable.path], key_at(variable.path, kind), digits)
        for variable, keep in zip(evaluator.variables, fixed, strict=True)
    }


def _both_ways(value: float, key: Key, digits: int) -> tuple[float, float]:
    """The values [SI] below and above, or the value itself, that have so few digits in the unit of a key."""
    shown = from_si(value, key.unit)
    if shown == 0.0:
        return value, value
    step = 10.0 ** (math.floor(math.log10(abs(shown))) - digits + 1)
    low, high = (way(round(shown / step, 6)) * step for way in (math.floor, math.ceil))
    return _read(low, key, digits), _read(high, key, digits)


def _nearest(value: float, key: Key, digits: int) -> float:
    """The value [SI] that has so few digits in the unit of a key."""
    return _read(from_si(value, key.unit), key, digits)


def _read(shown: float, key: Key, digits: int) -> float:
    return parse_quantity(f"{shown:.{digits}g} {key.unit}".removesuffix(" 1"), key.dimension)
