"""Plots of sweeps: curves for one axis, a map for two, small multiples for more."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.errors import InputError
from asperity.joint_file.si_tables import key_at
from asperity.results import RESULTS
from asperity.show.style import mark_few_decades
from asperity.study.datasets import result_words, row_dimensions, rows_of
from asperity.study.parameters import long_name
from asperity.study.sweep.sweep_map import MapLimit, draw_map, limits_of_the_model
from asperity.study.sweep.sweep_plan import PLAN
from asperity.units import from_si

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: What is drawn if it is there, in this order; otherwise the first result.
_PREFERRED = (
    "assembly_stiffness_output",
    "series_with_bulk_stiffness_output",
    "published_stiffness_output",
    "torque_capacity",
    "standing_torque_capacity",
    "slip_ratio",
)
_CURVES = 6
_PANELS = 6
_LOG_RATIO = 30.0
_FINEST = 400  # values along an axis of a plot; more cannot be seen


def sweep_figure(
    dataset: xarray.Dataset, *, result: str | None = None, limits: Sequence[MapLimit] = ()
) -> Figure:
    """Draw a sweep: one result, by default the fullest model's stiffness at the output among those there.

    Curves over one axis, with all three levels of stiffness; a map over two, with contours, the lines of ``limits``, by
    default those of the model, hatched regions without a solution, and the joint of the file where it lies within;
    curves in panels over three and more, at values that the titles and the legend state. Failed points are counted. An
    ``InputError`` if the dataset has no such result.
    """
    from matplotlib.figure import Figure

    name = result or next(
        (str(n) for n in (*_PREFERRED, *dataset.data_vars) if n in dataset and n != "status"), "status"
    )
    if name not in dataset or name not in RESULTS:
        raise InputError(f"the sweep has no result '{name}'; it has {', '.join(map(str, dataset.data_vars))}")
    axes = [str(dim) for dim in dataset["status"].dims]
    thin = {dim: _spread(dataset.sizes[dim], _FINEST) for dim in axes[:2]}
    data = dataset.isel(thin)
    figure = Figure(figsize=(8.0, 5.0), layout="constrained")
    if len(axes) == 1:
        _curves(figure.subplots(), data, axes[0], name)
    elif len(axes) == 2 and min(data.sizes[dim] for dim in axes) > _CURVES and len(rows_of(data, name)) == 1:
        _map(figure, data, axes, name, limits)
    else:
        _panels(figure, data, axes, name)
    failed, count = int((dataset["status"] != 0).sum()), dataset["status"].size
    told = f"{count} points" + (f", {failed} not solved" if failed else "")
    heading = told if len(axes) == 1 and name in _PREFERRED[:3] else f"{_words(dataset, name)}\n{told}"
    figure.suptitle(heading, fontsize=10)
    return figure


def _spread(count: int, most: int) -> np.ndarray:
    """Up to so many indices, evenly spread, first and last among them."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(int))


def _words(data: xarray.Dataset, name: str) -> str:
    return f"{result_words(data, name)} [{_shown(RESULTS[name].si_unit)}]"


def shade(axes: Axes, x: np.ndarray, where: np.ndarray) -> None:
    """Grey where nothing exists, from point to point."""
    edges = np.concatenate([x[:1], 0.5 * (x[1:] + x[:-1]), x[-1:]])
    for place in np.flatnonzero(where):
        axes.axvspan(edges[place], edges[place + 1], color="0.9", linewidth=0.0, zorder=0)


def _shown(unit: str) -> str:
    return "-" if unit == "1" else unit.replace("*", "·")


def _in_unit(path: str, values: np.ndarray) -> np.ndarray:
    unit = key_at(path).unit
    return np.array([from_si(float(value), unit) for value in values])


def _label(path: str) -> str:
    return f"{long_name(path)} [{_shown(key_at(path).unit)}]"


def _is_log(values: np.ndarray) -> bool:
    """Whether an axis is evenly spaced in its logarithm rather than in its value."""
    return bool(
        values.size > 2 and values.min() > 0.0 and np.ptp(np.diff(np.log(values))) < 1e-9 * values.size
    )


def _scale(axes: Axes, path: str, values: np.ndarray, *, vertical: bool = False) -> None:
    if vertical:
        axes.set_ylabel(_label(path))
        axes.set_yscale("log" if _is_log(values) else "linear")
    else:
        axes.set_xlabel(_label(path))
        axes.set_xscale("log" if _is_log(values) else "linear")


def _curves(axes: Axes, data: xarray.Dataset, path: str, name: str) -> None:
    x = _in_unit(path, data[path].values)
    levels = [n for n in _PREFERRED[:3] if n in data] if name in _PREFERRED[:3] else [name]
    drawn = []
    for level in levels:
        for row, curve in rows_of(data, level).items():
            drawn.append(curve.values)
            label = row or level.replace("_stiffness_output", "")
            axes.plot(x, drawn[-1], marker=".", label=label.replace("_", " "))
    _scale(axes, path, x)
    axes.set_ylabel(_label_of_result(data, name))
    axes.set_xlim(*_with_margin(x, log=_is_log(x)))
    failed = np.all(np.isnan(drawn), axis=0)  # some results, such as the capacity, exist where others do not
    shade(axes, x, failed)
    if failed.any():
        axes.fill_between([], [], color="0.9", label="no result")
    _log_if_wide(axes, np.concatenate(drawn))
    axes.grid(alpha=0.3)
    if len(drawn) > 1 or failed.any():
        axes.legend()


def _label_of_result(data: xarray.Dataset, name: str) -> str:
    if name not in _PREFERRED[:3]:
        return _words(data, name)
    return f"torsional stiffness at the output [{_shown(RESULTS[name].si_unit)}]"


def _with_margin(x: np.ndarray, *, log: bool) -> tuple[float, float]:
    low, high = float(x.min()), float(x.max())
    if low == high:
        return low - 0.5 * abs(low) - 1e-300, high + 0.5 * abs(high) + 1e-300
    if log:
        return low * (low / high) ** 0.02, high * (high / low) ** 0.02
    return low - 0.02 * (high - low), high + 0.02 * (high - low)


def _log_if_wide(axes: Axes, values: np.ndarray) -> None:
    known = values[np.isfinite(values)]
    if known.size and known.min() > 0.0 and known.max() > _LOG_RATIO * known.min():
        axes.set_yscale("log")


def _map(
    figure: Figure, data: xarray.Dataset, axes: list[str], name: str, limits: Sequence[MapLimit]
) -> None:
    x, y = (_in_unit(path, data[path].values) for path in axes)
    figure.set_size_inches(8.0, 6.4)
    panel = draw_map(
        figure,
        data.transpose(*axes, ...),
        x=x,
        y=y,
        values=data[name].transpose(axes[1], axes[0]).values,
        label=_label_of_result(data, name),
        limits=limits or limits_of_the_model(data),
        here=_working_point(data, axes),
    )
    _scale(panel, axes[0], x)
    _scale(panel, axes[1], y, vertical=True)
    for path_values, axis in ((x, panel.xaxis), (y, panel.yaxis)):
        if _is_log(path_values):
            mark_few_decades(axis, float(path_values.min()), float(path_values.max()))


def _working_point(data: xarray.Dataset, axes: list[str]) -> tuple[float, float] | None:
    """Point of the joint file in the units of the labels; None outside of the axes or without a number on both."""
    joint = json.loads(data.attrs.get(PLAN, "{}")).get("joint")
    here = {}
    for path in axes:
        value = joint
        for step in path.split("."):
            value = value.get(step) if isinstance(value, dict) else None
        if not isinstance(value, float) or not data[path].min() <= value <= data[path].max():
            return None
        here[path] = float(_in_unit(path, np.array([value]))[0])
    x, y = here.values()
    return x, y


def _panels(figure: Figure, data: xarray.Dataset, axes: list[str], name: str) -> None:
    """Curves over the first axis, one for each value of the second, panels for values of the third."""
    others = {dim: data.sizes[dim] // 2 for dim in axes[3:]}
    data = data.isel(others)
    thirds = _spread(data.sizes[axes[2]], _PANELS) if len(axes) > 2 else np.array([0])
    columns = min(len(thirds), 3)
    grid: Any = figure.subplots(-(-len(thirds) // columns), columns, squeeze=False, sharex=True, sharey=True)
    figure.set_size_inches(max(8.0, 4.0 * columns), 1.0 + 3.5 * grid.shape[0])
    x = _in_unit(axes[0], data[axes[0]].values)
    seconds = _spread(data.sizes[axes[1]], _CURVES)
    values = data[name].isel({axes[1]: seconds})
    for panel, third in zip(grid.flat, thirds, strict=False):
        chosen = data.isel({axes[2]: third}) if len(axes) > 2 else data
        for second in seconds:
            curve = chosen[name].isel({axes[1]: second})
            told = f"{_in_unit(axes[1], chosen[axes[1]].values[[second]])[0]:.4g}"
            if RESULTS[name].axis != "one":
                curve = curve.max(row_dimensions(RESULTS[name]))
                told += f" (largest of the {RESULTS[name].axis}s)"
            panel.plot(x, curve.values, marker=".", label=told)
        if len(axes) > 2:
            value = _in_unit(axes[2], data[axes[2]].values[[third]])[0]
            panel.set_title(f"{_label(axes[2])}: {value:.4g}", fontsize=9)
        panel.grid(alpha=0.3)
    for panel in grid[-1]:
        _scale(panel, axes[0], x)
    for panel in grid[:, 0]:
        panel.set_ylabel(_label_of_result(data, name))
        _log_if_wide(panel, np.asarray(values).ravel())
    for panel in list(grid.flat)[len(thirds) :]:
        panel.set_axis_off()
    fixed = "; ".join(f"{_label(d)} = {_in_unit(d, np.array([data[d].item()]))[0]:.4g}" for d in others)
    grid.flat[0].legend(title=_label(axes[1]), fontsize=8, title_fontsize=8)
    if fixed:
        figure.supxlabel(f"at {fixed}", fontsize=8)
