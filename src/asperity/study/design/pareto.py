"""Pareto fronts of two or three objectives by NSGA-II (pymoo), all designs of a generation in one call."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from asperity.errors import InputError, NoSolutionError
from asperity.extras import optional_module
from asperity.precision import require_double_precision
from asperity.study.datasets import key_attributes, result_attributes
from asperity.study.design.design_evaluation import DesignEvaluator, exists
from asperity.study.design.design_problem import DesignProblem

if TYPE_CHECKING:
    import xarray


def require_pymoo() -> None:
    """Raise a ``MissingExtraError``, which says what to install, unless pymoo and xarray are installed."""
    for name in ("pymoo", "xarray"):
        optional_module(name, extra="study", needs="a Pareto front needs")


def pareto_front(
    problem: DesignProblem,
    *,
    population: int,
    generations: int,
    progress: Callable[[int, int], None] | None = None,
) -> xarray.Dataset:
    """Designs of which none is better than another in every one of two or three objectives.

    The dataset has the dimension ``design``, sorted by the first objective; the objectives at their worst scenario and
    the variables, in SI units (attributes ``units`` and ``long_name``), and ``margin``, the smallest margin of the
    limits. ``progress`` is called with the number of finished generations and of all. Raised are an ``InputError`` if
    there are not two or three objectives, a ``MissingExtraError`` without pymoo or xarray, and a ``NoSolutionError`` if
    no design meets all limits.

    An evolutionary method: the front is approached, not proven. Its ends can be compared with designs for one
    objective, which are. K. Deb, A. Pratap, S. Agarwal and T. Meyarivan, IEEE Trans. Evol. Comput. 6 (2002) 182; J.
    Blank and K. Deb, IEEE Access 8 (2020) 89497.
    """
    require_pymoo()
    require_double_precision()
    if not 2 <= len(problem.objectives) <= 3:
        raise InputError(f"a Pareto front has two or three objectives, got {len(problem.objectives)}")
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.core.callback import Callback
    from pymoo.core.problem import Problem
    from pymoo.optimize import minimize

    evaluator = DesignEvaluator(problem)
    scales = _scales(evaluator)

    class Vectorised(Problem):
        def __init__(self) -> None:
            limits = sum(len(constraint.rows) for constraint in problem.constraints)
            super().__init__(
                n_var=len(problem.variables),
                n_obj=len(problem.objectives),
                n_ieq_constr=limits,
                xl=0.0,
                xu=1.0,
            )

        def _evaluate(self, x: np.ndarray, out: dict, *args: object, **kwargs: object) -> None:
            objectives, margins = evaluator.many(x)
            out["F"] = objectives / scales
            out["G"] = -margins

    class Report(Callback):
        def notify(self, algorithm: object) -> None:
            if progress is not None:
                progress(int(algorithm.n_gen), generations)  # type: ignore[attr-defined]

    front = minimize(
        Vectorised(),
        NSGA2(pop_size=population),
        ("n_gen", generations),
        seed=problem.seed,
        callback=Report(),
        verbose=False,
    )
    if front.X is None:
        raise NoSolutionError(
            "no design meets all limits; use a single objective: the report then names the limits that conflict"
        )
    return _dataset(evaluator, np.atleast_2d(front.X))


def _dataset(evaluator: DesignEvaluator, scaled: np.ndarray) -> xarray.Dataset:
    """Designs by their scaled variables, sorted by the first objective."""
    import xarray

    problem = evaluator.problem
    objectives, margins = evaluator.many(scaled)
    values = objectives * np.array([goal.sign for goal in problem.objectives])
    order = np.argsort(values[:, 0])
    data = {}
    for index, goal in enumerate(problem.objectives):
        data[goal.name] = ("design", values[order, index], result_attributes(problem.table[goal.name]))
    for index, variable in enumerate(problem.variables):
        taken = variable.from_unit(scaled[order, index])
        data[variable.path] = ("design", taken, key_attributes(variable.path))
    data["margin"] = (
        "design",
        margins.min(axis=1)[order],
        {"units": "1", "long_name": "smallest margin of the limits"},
    )
    return xarray.Dataset(data, attrs={"level": problem.level, "joint_file": problem.joint_file})


def _scales(evaluator: DesignEvaluator) -> np.ndarray:
    """Sizes of the objectives at the joint of the file, so that crowding distances are comparable."""
    middle = np.full((1, len(evaluator.variables)), 0.5)
    sizes = np.abs(evaluator.many(middle)[0][0])
    return np.where((sizes > 0.0) & exists(sizes), sizes, 1.0)
