"""Plots of influences: tornado of elasticities, histograms and Sobol indices."""

from __future__ import annotations

import functools
import textwrap
from typing import TYPE_CHECKING

import numpy as np

from asperity.results import display_unit
from asperity.study.tolerances.sensitivity import ranking
from asperity.units import format_quantity, from_si

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_BARS = 14
_TITLE = 30  # characters in a line above a panel
_PANELS = ("assembly_stiffness_output", "published_stiffness_output", "standing_torque_capacity")
_POSITIVE, _NEGATIVE = "#2f6fb0", "#c8553d"


def _shown(unit: str) -> str:
    return "-" if unit == "1" else unit.replace("*", "·")


def tornado_figure(
    sensitivities: xarray.Dataset,
    *,
    result: str,
    panels: tuple[str, ...] = _PANELS,
    width: float | None = None,
) -> Figure:
    """Elasticities as bars, the largest on top: change in per cent for one per cent more of the input.

    ``result`` orders the inputs; ``panels`` are results that stand beside it in the same order, where they are known;
    the ``width`` of the figure [in] grows with their number if it is not stated. An ``InputError`` if there is no such
    result.
    """
    from matplotlib.figure import Figure

    ranked = ranking(sensitivities, result)
    order = ranked["input"].values[:_BARS]
    known = sensitivities["result"].values.tolist()
    shown = [result, *(name for name in panels if name != result and name in known)]
    bar = 0.32 if width is None else 0.22
    figure = Figure(figsize=(width or 4.5 + 3.0 * len(shown), 1.6 + bar * len(order)), layout="constrained")
    drawn = figure.subplots(1, len(shown), sharey=True, squeeze=False)[0]
    for panel, name in zip(drawn, shown, strict=True):
        one = sensitivities.sel(result=name, input=order)
        lengths = one["elasticity"].values
        colours = [_POSITIVE if length > 0.0 else _NEGATIVE for length in lengths]
        panel.barh(np.arange(len(order)), lengths, color=colours)
        _mark_unknown(panel, lengths)
        panel.axvline(0.0, color="black", linewidth=0.8)
        panel.set_xscale("symlog", linthresh=0.1)
        reach = max(1.0, 2.0 * float(np.nanmax(np.abs(lengths), initial=0.0)))
        ticks = [t for t in (0.1, 1.0, 10.0, 100.0) if t <= reach]
        if len(ticks) == 4:  # both sides together would run into each other
            ticks = [1.0, 100.0]
        panel.set_xlim(-reach, reach)
        panel.set_xticks([-t for t in reversed(ticks)] + [0.0, *ticks])
        panel.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        panel.xaxis.set_minor_locator(_none())
        unit = display_unit(name)
        value = from_si(float(one["result_value"]), unit)
        panel.set_title(
            f"{textwrap.fill(str(one['result_name'].item()), _TITLE)}\n{format_quantity(value, '1')} {_shown(unit)}",
            fontsize=9,
        )
        panel.set_xlabel("% of result per % of input [-]", fontsize=9)
        panel.grid(axis="x", alpha=0.3)
        panel.set_yticks(np.arange(len(order)), one["input_name"].values)
    panel.invert_yaxis()
    return figure


def _mark_unknown(panel: Axes, lengths: np.ndarray) -> None:
    """Say where there is no number, which is not the same as a bar of length zero."""
    for place in np.flatnonzero(np.isnan(lengths)):
        panel.text(0.0, float(place), " not known", va="center", fontsize=7)


def _none() -> object:
    from matplotlib.ticker import NullLocator

    return NullLocator()


def uncertainty_figure(spread: xarray.Dataset, *, result: str, width: float | None = None) -> Figure:
    """Histogram of a result with its interval, and what its variance is made of; above each other at a width [in]."""
    from matplotlib.figure import Figure

    one = spread.sel(result=result)
    figure = Figure(figsize=(10.0, 4.2) if width is None else (width, 0.7 * width), layout="constrained")
    left, right = figure.subplots(*((1, 2) if width is None else (2, 1)))
    unit = display_unit(result)
    factor = from_si(1.0, unit)
    sampled = factor * one["samples"].values
    solved = sampled[np.isfinite(sampled)]
    left.hist(solved, bins=80, color=_POSITIVE, alpha=0.6)
    low, _, high = factor * one["quantiles"].values
    nominal = factor * float(one["nominal"])
    shown = functools.partial(format_quantity, unit="1")
    for value, told in ((low, "2.5 %"), (high, "97.5 %")):
        if np.isfinite(value):
            left.axvline(value, color="black", linestyle="--", linewidth=1.0, label=f"{told}: {shown(value)}")
        else:
            left.plot([], [], color="black", linestyle="--", linewidth=1.0, label=f"{told}: fails")
    left.axvline(nominal, color=_NEGATIVE, label=f"nominal: {shown(nominal)}")
    left.set_xlabel(f"{one['result_name'].item()} [{_shown(unit)}]")
    left.set_ylabel(f"samples [-] (of {solved.size}, {sampled.size - solved.size} fail)")
    above = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "frameon": False, "fontsize": 8}
    left.legend(ncols=3, **above)
    order = np.argsort(-np.nan_to_num(one["total_order"].values))[:_BARS]
    place = np.arange(len(order))
    for shift, name, told, colour in (
        (-0.2, "first_order", "first order", _POSITIVE),
        (0.2, "total_order", "total", _NEGATIVE),
    ):
        right.barh(
            place + shift,
            one[name].values[order],
            height=0.38,
            xerr=one[f"{name}_half_width"].values[order],
            color=colour,
            label=told,
        )
    _mark_unknown(right, one["total_order"].values[order])
    labels = [
        f"{n}\n({d})" for n, d in zip(one["input_name"].values, one["distribution"].values, strict=True)
    ]
    right.set_yticks(place, np.array(labels)[order])
    right.invert_yaxis()
    right.set_xlabel("Sobol index: share of the variance [-]")
    right.set_xlim(left=0.0)
    right.legend(ncols=2, **above)
    return figure
