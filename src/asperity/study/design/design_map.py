"""Map of two variables of a design: where all limits are met, the line of each limit, and the design."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from asperity.errors import InputError
from asperity.joint_file.si_tables import key_at
from asperity.results import Result
from asperity.show.style import mark_few_decades, plain_number
from asperity.study.design.design_evaluation import DesignEvaluator, exists
from asperity.study.design.design_plot import in_unit, shown_unit
from asperity.study.design.design_problem import Constraint, DesignProblem
from asperity.study.design.design_result import DesignResult
from asperity.study.design.design_search import FEASIBLE
from asperity.study.sweep.sweep_map import draw_limit
from asperity.units import format_quantity, from_si

if TYPE_CHECKING:
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FINEST, _COARSEST = 61, 15  # points along a variable
_MOST_STATES = 60_000  # joints that are evaluated for a map: points times scenarios
#: Colour and line of the limits, told apart without colours too.
_LINES = (
    ("#1b6ca8", "-"),
    ("#c2410c", "--"),
    ("#2f7d32", "-."),
    ("#6a3d9a", ":"),
    ("#22303c", (0, (6, 1, 1, 1, 1, 1))),
    ("#b8860b", (0, (1, 3))),
)


def mapped_variables(problem: DesignProblem, over: tuple[str, str] | None) -> tuple[int, int]:
    """Which variables of a design a map is drawn over."""
    paths = [variable.path for variable in problem.variables]
    if len(paths) < 2:
        raise InputError("a map needs two variables, and the design file has one")
    first, second = over or (paths[0], paths[1])
    for path in (first, second):
        if path not in paths:
            raise InputError(
                f"'{path}' is not a variable of the design; its variables are {', '.join(paths)}"
            )
    if first == second:
        raise InputError(f"a map needs two different variables, got '{first}' twice")
    return paths.index(first), paths.index(second)


class _Field(NamedTuple):
    """A design over two variables: points along both, and of each point, shape (points, points), what is drawn.

    ``across`` and ``up`` in the units of their keys; ``joint``: whether one exists; ``values`` of the first objective,
    nan without a joint; ``least``: the smallest margin; ``by_limit``: that of each limit.
    """

    across: np.ndarray
    up: np.ndarray
    joint: np.ndarray
    values: np.ndarray
    least: np.ndarray
    by_limit: list[np.ndarray]


def _field(result: DesignResult, first: int, second: int) -> _Field:
    """The joints over two variables; the others stay as in the design."""
    problem = result.problem
    evaluator = DesignEvaluator(problem)
    count = int(np.clip((_MOST_STATES / evaluator.scenarios.torques.size) ** 0.5, _COARSEST, _FINEST))
    places = np.linspace(0.0, 1.0, count)
    scaled = np.tile(evaluator.scaled(result.point), (count * count, 1))
    across, up = np.meshgrid(places, places)
    scaled[:, first], scaled[:, second] = across.ravel(), up.ravel()
    objectives, margins = evaluator.many(scaled)
    joint = (exists(objectives[:, 0]) & evaluator.existing(margins)).reshape(count, count)
    x, y = (
        in_unit(variable.from_unit(places), key_at(variable.path).unit)
        for variable in (problem.variables[first], problem.variables[second])
    )
    goal = problem.objectives[0]
    values = np.full(count * count, np.nan)
    shown = joint.ravel()
    values[shown] = in_unit(goal.sign * objectives[shown, 0], problem.table[goal.name].display_unit)
    least = np.where(joint, margins.min(axis=1).reshape(count, count), np.nan)
    splits = np.cumsum([len(constraint.rows) for constraint in problem.constraints])[:-1]
    by_limit = [columns.min(axis=1).reshape(count, count) for columns in np.split(margins, splits, axis=1)]
    return _Field(x, y, joint, values.reshape(count, count), least, by_limit)


def design_map(result: DesignResult, *, over: tuple[str, str] | None = None) -> Figure:
    """Draw the map: the others of the variables stay as in the design."""
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

    problem, (first, second) = result.problem, mapped_variables(result.problem, over)
    field = _field(result, first, second)
    figure = Figure(figsize=(8.0, 7.4), layout="constrained")
    axes = figure.subplots()
    keys = [
        *_draw_areas(axes, field),
        *_draw_objective(axes, field, problem),
        *_draw_limits(axes, field, problem),
    ]
    judged = "limits of the design met" if result.feasible else "a limit is violated"
    keys.append(
        Line2D([], [], color="C3", marker="o", markersize=8, linestyle="none", label=f"design: {judged}")
    )
    chosen = [problem.variables[place].path for place in (first, second)]
    here = [from_si(result.point[path], key_at(path).unit) for path in chosen]
    axes.plot(*here, "o", color="C3", markersize=8, markeredgecolor="white", clip_on=False, zorder=5)
    for variable, axis, values_along in (
        (problem.variables[first], axes.xaxis, field.across),
        (problem.variables[second], axes.yaxis, field.up),
    ):
        axis.set_label_text(f"{variable.path} [{shown_unit(key_at(variable.path).unit)}]")
        if variable.logarithmic:
            (axes.set_xscale if axis is axes.xaxis else axes.set_yscale)("log")
            mark_few_decades(axis, float(values_along.min()), float(values_along.max()))
    figure.legend(handles=keys, loc="outside lower center", ncols=2, fontsize="small", frameon=False)
    figure.suptitle(
        f"{problem.goal}, other variables as designed; ticks point where a limit is violated",
        fontsize="medium",
    )
    return figure


def _draw_areas(axes: Axes, field: _Field) -> list[Artist]:
    """Where no joint exists, and where all limits are met, with their entries of the legend."""
    from matplotlib.patches import Patch

    x, y, joint = field.across, field.up, field.joint
    axes.set_facecolor("0.85")
    if joint.any():
        axes.contourf(x, y, np.where(joint, 1.0, np.nan), levels=[0.0, 2.0], colors=["white"])
    keys: list[Artist] = [Patch(facecolor="0.85", edgecolor="0.5", label="no joint exists")]
    if (field.least >= -FEASIBLE).any():
        axes.contourf(x, y, np.where(joint, 1.0, np.nan), levels=[0.0, 2.0], colors=["#cfe3f1"])
        # one limit at a time: the smallest of all margins has kinks between the points
        for margin in field.by_limit:
            outside = np.where(joint, margin, np.nan)
            if np.nanmin(outside, initial=np.inf) < -FEASIBLE:
                axes.contourf(x, y, outside, levels=[-np.inf, -FEASIBLE], colors=["white"])
        keys.append(Patch(facecolor="#cfe3f1", edgecolor="0.5", label="limits of the design met"))
    return keys


def _draw_objective(axes: Axes, field: _Field, problem: DesignProblem) -> list[Artist]:
    """Lines of equal values of the first objective, with their entry of the legend if there are any."""
    from matplotlib.lines import Line2D

    if not np.nanmin(field.values, initial=np.inf) < np.nanmax(field.values, initial=-np.inf):
        return []
    lines = axes.contour(field.across, field.up, field.values, levels=8, colors="0.55", linewidths=0.8)
    axes.clabel(lines, fmt=plain_number, fontsize="x-small")
    shown = problem.table[problem.objectives[0].name]
    label = f"{shown.said} [{shown_unit(shown.display_unit)}]"
    return [Line2D([], [], color="0.55", linewidth=0.8, label=label)]


def _draw_limits(axes: Axes, field: _Field, problem: DesignProblem) -> list[Artist]:
    """The line of each limit that crosses the map, with its entry of the legend."""
    keys: list[Artist] = []
    for constraint, margin in zip(problem.constraints, field.by_limit, strict=True):
        shown = margin if constraint.implied else np.where(field.joint, margin, np.nan)
        if not np.nanmin(shown, initial=np.inf) < 0.0 < np.nanmax(shown, initial=-np.inf):
            continue
        colour, line = _LINES[len(keys) % len(_LINES)]
        label = limit_text(constraint, problem.table)
        keys.append(draw_limit(axes, field.across, field.up, shown, colour, line, label=label))
    return keys


def limit_text(constraint: Constraint, table: Mapping[str, Result]) -> str:
    """A limit in words."""
    shown = table[constraint.name]
    sign = "≤" if constraint.at_most else "≥"
    return f"{shown.label} {sign} {format_quantity(constraint.limit, shown.display_unit)}"
