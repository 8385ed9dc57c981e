"""Map of two variables of a design: where all limits are met, the line of each limit, and the design."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

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


def design_map(result: DesignResult, *, over: tuple[str, str] | None = None) -> Figure:
    """Draw the map: the others of the variables stay as in the design."""
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    problem, (first, second) = result.problem, mapped_variables(result.problem, over)
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
    unit = problem.table[goal.name].display_unit
    values = np.full(count * count, np.nan)
    shown = joint.ravel()
    values[shown] = in_unit(goal.sign * objectives[shown, 0], unit)
    least = np.where(joint, margins.min(axis=1).reshape(count, count), np.nan)
    splits = np.cumsum([len(constraint.rows) for constraint in problem.constraints])[:-1]
    by_limit = [columns.min(axis=1).reshape(count, count) for columns in np.split(margins, splits, axis=1)]

    figure = Figure(figsize=(8.0, 7.4), layout="constrained")
    axes = figure.subplots()
    axes.set_facecolor("0.85")
    if joint.any():
        axes.contourf(x, y, np.where(joint, 1.0, np.nan), levels=[0.0, 2.0], colors=["white"])
    keys: list[Line2D | Patch] = [Patch(facecolor="0.85", edgecolor="0.5", label="no joint exists")]
    if (least >= -FEASIBLE).any():
        axes.contourf(x, y, np.where(joint, 1.0, np.nan), levels=[0.0, 2.0], colors=["#cfe3f1"])
        # one limit at a time: the smallest of all margins has kinks between the points
        for margin in by_limit:
            outside = np.where(joint, margin, np.nan)
            if np.nanmin(outside, initial=np.inf) < -FEASIBLE:
                axes.contourf(x, y, outside, levels=[-np.inf, -FEASIBLE], colors=["white"])
        keys.append(Patch(facecolor="#cfe3f1", edgecolor="0.5", label="limits of the design met"))
    if np.nanmin(values, initial=np.inf) < np.nanmax(values, initial=-np.inf):
        lines = axes.contour(x, y, values.reshape(count, count), levels=8, colors="0.55", linewidths=0.8)
        axes.clabel(lines, fmt=plain_number, fontsize="x-small")
        label = f"{problem.table[goal.name].said} [{shown_unit(unit)}]"
        keys.append(Line2D([], [], color="0.55", linewidth=0.8, label=label))
    drawn = 0
    for constraint, margin in zip(problem.constraints, by_limit, strict=True):
        field = margin if constraint.implied else np.where(joint, margin, np.nan)
        if not np.nanmin(field, initial=np.inf) < 0.0 < np.nanmax(field, initial=-np.inf):
            continue
        colour, line = _LINES[drawn % len(_LINES)]
        drawn += 1
        keys.append(draw_limit(axes, x, y, field, colour, line, label=limit_text(constraint, problem.table)))
    judged = "limits of the design met" if result.feasible else "a limit is violated"
    keys.append(
        Line2D([], [], color="C3", marker="o", markersize=8, linestyle="none", label=f"design: {judged}")
    )
    chosen = [problem.variables[place].path for place in (first, second)]
    here = [from_si(result.point[path], key_at(path).unit) for path in chosen]
    axes.plot(*here, "o", color="C3", markersize=8, markeredgecolor="white", clip_on=False, zorder=5)
    for variable, axis, values_along in (
        (problem.variables[first], axes.xaxis, x),
        (problem.variables[second], axes.yaxis, y),
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


def limit_text(constraint: Constraint, table: Mapping[str, Result]) -> str:
    """A limit in words."""
    shown = table[constraint.name]
    sign = "≤" if constraint.at_most else "≥"
    return f"{shown.label} {sign} {format_quantity(constraint.limit, shown.display_unit)}"
