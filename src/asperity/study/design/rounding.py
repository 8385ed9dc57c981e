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
FEWEST_DIGITS = 7

#: Relative change of the objective that their rounding may cause.
_SAME = 1e-6

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

    def rank(design: np.ndarray) -> tuple[float, float, float]:
        lack, violation = violation_rank(evaluator, design)
        return lack, max(violation, FEASIBLE), float(evaluator(design).objective[0].max())

    return min(tried, key=rank), fixed


def shortened_design(
    evaluator: DesignEvaluator, scaled: np.ndarray, fixed: np.ndarray
) -> tuple[dict[str, float], np.ndarray]:
    """The same design with as few digits as it needs, shape (n,) [SI]."""
    exact, point = evaluator(scaled), evaluator.point(scaled)
    kind = type_of(evaluator.values)
    keys = [key_at(variable.path, kind) for variable in evaluator.variables]
    positive = np.array([RESULTS[goal.name].positive for goal in evaluator.problem.objectives])[:, None]
    size = np.where(positive, 1.0, np.abs(exact.objective))  # of positive results it is the logarithm
    for digits in range(FEWEST_DIGITS, 16):
        shorter = {
            variable.path: point[variable.path]
            if keep
            else min(max(_rounded(point[variable.path], key, digits), variable.lower), variable.upper)
            for variable, key, keep in zip(evaluator.variables, keys, fixed, strict=True)
        }
        place = evaluator.scaled(shorter)
        rounded = evaluator(place)
        if rounded.violation <= max(FEASIBLE, exact.violation) and np.all(
            np.abs(rounded.objective - exact.objective) <= _SAME * size
        ):
            return shorter, place
    return point, scaled


def _rounded(value: float, key: Key, digits: int) -> float:
    """A value [SI] that has few digits in the unit of its key."""
    return parse_quantity(
        f"{from_si(value, key.unit):.{digits}g} {key.unit}".removesuffix(" 1"), key.dimension
    )
