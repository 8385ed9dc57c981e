"""Plots of designs: how objective and margins change around the design, and Pareto fronts."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.joint_file.si_tables import key_at
from asperity.results import RESULTS
from asperity.show.style import mark_few_decades
from asperity.study.design.design_evaluation import DesignEvaluator, exists
from asperity.study.design.design_result import DesignResult
from asperity.study.design.design_search import FEASIBLE
from asperity.study.sweep.sweep_plot import shade
from asperity.units import from_si

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

_POINTS = 31


def design_figure(result: DesignResult, *, width: float | None = None) -> Figure:
    """The objective along each variable through the design, a panel each: where limits are met, where no joint exists.

    With a ``width`` [in] two panels stand in a row.
    """
    from matplotlib.figure import Figure

    problem = result.problem
    evaluator = DesignEvaluator(problem)
    goal, count = problem.objectives[0], len(problem.variables)
    objective = problem.table[goal.name]
    columns = min(4 if width is None else 2, count)
    lines = -(-count // columns)
    line_height = 4.6 if width is None else 3.8
    figure = Figure(figsize=(width or 3.4 * columns + 1.0, line_height * lines + 0.5), layout="constrained")
    grid = figure.add_gridspec(2 * lines, columns, height_ratios=[3.0, 1.6] * lines)
    centre = evaluator.scaled(result.point)
    for index, variable in enumerate(problem.variables):
        line, column = divmod(index, columns)
        axes = figure.add_subplot(grid[2 * line, column])
        below = figure.add_subplot(grid[2 * line + 1, column], sharex=axes)
        scaled = np.tile(centre, (_POINTS, 1))
        scaled[:, index] = np.sort(np.append(np.linspace(0.0, 1.0, _POINTS - 1), centre[index]))
        objectives, margins = evaluator.many(scaled)
        key = key_at(variable.path)
        x = in_unit(variable.from_unit(scaled[:, index]), key.unit)
        raw = goal.sign * objectives[:, 0]
        joint = exists(objectives[:, 0]) & evaluator.existing(margins)
        y = np.full(_POINTS, np.nan)
        y[joint] = in_unit(raw[joint], objective.display_unit)
        least = margins.min(axis=1)
        place = int(np.flatnonzero(scaled[:, index] == centre[index])[0])
        fine = joint & (least >= -FEASIBLE)
        fine[place] = result.feasible  # as the search has judged it
        here = from_si(result.point[variable.path], key.unit)
        judged = "limits of the design met" if result.feasible else "a limit is violated"
        axes.plot(x, y, color="0.65", lw=1.5, label="a limit is violated")
        axes.plot(x, np.where(fine, y, np.nan), color="C0", lw=2.5, label="limits of the design met")
        axes.plot(
            here,
            from_si(result.objective_after, objective.display_unit),
            "o",
            color="C3",
            markersize=9,
            markeredgewidth=2.5,
            markeredgecolor="C0" if result.feasible else "0.65",
            label=f"design: {judged}",
        )
        below.plot(x, 100.0 * np.where(joint, least, np.nan), color="0.65", lw=1.5)
        below.plot(x, np.where(fine, 100.0 * least, np.nan), color="C0", lw=2.5)
        below.axhline(0.0, color="k", lw=0.7)
        below.axvline(here, color="C3", lw=0.8)
        shown = least[joint] if joint.any() else np.zeros(1)
        below.set_ylim(max(-60.0, 100.0 * shown.min() - 5.0), max(10.0, 100.0 * shown.max() + 5.0))
        for panel in (axes, below):
            shade(panel, x, ~joint)
        if variable.logarithmic:
            axes.set_xscale("log")
            mark_few_decades(axes.xaxis, float(x.min()), float(x.max()))
        axes.tick_params(labelbottom=False)
        below.set_xlabel(f"{variable.path} [{shown_unit(key.unit)}]", fontsize="small")
        if column == 0:
            axes.set_ylabel(f"{objective.said}\n[{shown_unit(objective.display_unit)}]", fontsize="small")
            below.set_ylabel("smallest margin\nof the limits [%]", fontsize="small")
        for panel in (axes, below):
            panel.grid(alpha=0.3)
        if index == 0:
            axes.fill_between([], [], color="0.9", label="no joint exists")
            axes.legend(fontsize="small")
    figure.suptitle(f"{problem.goal}, at its worst scenario", fontsize="medium")
    return figure


def pareto_figure(front: xarray.Dataset, objectives: tuple[str, ...]) -> Figure:
    """A Pareto front: the second objective over the first, the third as colour; below it the variables."""
    from matplotlib.figure import Figure

    shown = {name: in_unit(front[name].values, RESULTS[name].display_unit) for name in objectives}
    labels = {
        name: f"{front[name].attrs['long_name']} [{shown_unit(RESULTS[name].display_unit)}]"
        for name in objectives
    }
    variables = [str(name) for name in front.data_vars if name not in (*objectives, "margin")]
    figure = Figure(figsize=(9.0, 4.2 + 1.3 * len(variables)), layout="constrained")
    grid = figure.add_gridspec(1 + len(variables), 1, height_ratios=[3.0] + [1.0] * len(variables))
    axes = figure.add_subplot(grid[0])
    colour = shown[objectives[2]] if len(objectives) == 3 else None
    points = axes.scatter(shown[objectives[0]], shown[objectives[1]], c=colour, s=18)
    if colour is not None:
        figure.colorbar(points, ax=axes, label=labels[objectives[2]])
    axes.set_ylabel(labels[objectives[1]])
    axes.grid(alpha=0.3)
    axes.set_title(f"Pareto front of {front.sizes['design']} designs", fontsize="medium")
    for index, path in enumerate(variables):
        below = figure.add_subplot(grid[index + 1], sharex=axes)
        unit = key_at(path).unit
        below.plot(shown[objectives[0]], in_unit(front[path].values, unit), ".", ms=4)
        below.set_ylabel(
            f"{path.rsplit('.', 1)[-1].replace('_', chr(10))}\n[{shown_unit(unit)}]", fontsize="small"
        )
        if path.endswith(("fractal_roughness", "stiffness")):
            below.set_yscale("log")
        below.grid(alpha=0.3)
    figure.axes[-1].set_xlabel(labels[objectives[0]])
    return figure


def in_unit(values: np.ndarray, unit: str) -> np.ndarray:
    """SI values in another unit."""
    return np.array([from_si(float(value), unit) for value in values])


def shown_unit(unit: str) -> str:
    """A unit in the label of an axis."""
    return "–" if unit == "1" else unit.replace("*", "·").replace("^3", "³")
