"""Plots of influences: tornado of elasticities, histograms and Sobol indices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.study.tolerances.sensitivity import ranking

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

_BARS = 14
_PANELS = ("assembly_stiffness_output", "published_stiffness_output", "torque_capacity")
_POSITIVE, _NEGATIVE = "#2f6fb0", "#c8553d"


def _shown(unit: str) -> str:
    return "-" if unit == "1" else unit.replace("*", "·")


def tornado_figure(sensitivities: xarray.Dataset, *, result: str) -> Figure:
    """Elasticities as bars, the largest on top.

    Parameters
    ----------
    sensitivities : xarray.Dataset
        What :func:`asperity.study.tolerances.sensitivity.sensitivity` returns.
    result : str
        Which result orders the inputs; others stand beside it in the same order.

    Returns
    -------
    matplotlib.figure.Figure
        One panel per result, one bar per input: change of the result in per cent for one per cent more of the input.

    Raises
    ------
    InputError
        If there is no such result.
    """
    from matplotlib.figure import Figure

    ranked = ranking(sensitivities, result)
    order = ranked["input"].values[:_BARS]
    panels = [result, *(name for name in _PANELS if name != result)]
    figure = Figure(figsize=(4.5 + 3.0 * len(panels), 1.6 + 0.32 * len(order)), layout="constrained")
    for panel, name in zip(figure.subplots(1, len(panels), sharey=True), panels, strict=True):
        one = sensitivities.sel(result=name, input=order)
        lengths = np.nan_to_num(one["elasticity"].values)
        colours = [_POSITIVE if length > 0.0 else _NEGATIVE for length in lengths]
        panel.barh(np.arange(len(order)), lengths, color=colours)
        panel.axvline(0.0, color="black", linewidth=0.8)
        panel.set_xscale("symlog", linthresh=0.1)
        reach = max(1.0, 2.0 * float(np.abs(lengths).max(initial=0.0)))
        ticks = [t for t in (0.1, 1.0, 10.0, 100.0) if t <= reach]
        panel.set_xlim(-reach, reach)
        panel.set_xticks([-t for t in reversed(ticks)] + [0.0, *ticks])
        panel.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        panel.xaxis.set_minor_locator(_none())
        value, unit = float(one["result_value"]), _shown(str(one["result_unit"].item()))
        panel.set_title(f"{name.replace('_', ' ')}\n{value:.4g} {unit}", fontsize=9)
        panel.set_xlabel("% of result per % of input [-]", fontsize=9)
        panel.grid(axis="x", alpha=0.3)
        panel.set_yticks(np.arange(len(order)), one["input_name"].values)
    panel.invert_yaxis()
    return figure


def _none() -> object:
    from matplotlib.ticker import NullLocator

    return NullLocator()


def uncertainty_figure(spread: xarray.Dataset, *, result: str) -> Figure:
    """Histogram of one result with its interval, and what its variance is made of.

    Parameters
    ----------
    spread : xarray.Dataset
        What :func:`asperity.study.tolerances.uncertainty.uncertainty` returns.
    result : str
        Which result.

    Returns
    -------
    matplotlib.figure.Figure
        Two panels.
    """
    from matplotlib.figure import Figure

    one = spread.sel(result=result)
    figure = Figure(figsize=(10.0, 4.2), layout="constrained")
    left, right = figure.subplots(1, 2)
    solved = one["samples"].values[spread["status"].values == 0]
    left.hist(solved, bins=80, color=_POSITIVE, alpha=0.6)
    low, _, high = one["quantiles"].values
    for value, told in ((low, "2.5 %"), (high, "97.5 %")):
        left.axvline(value, color="black", linestyle="--", linewidth=1.0, label=f"{told}: {value:.5g}")
    left.axvline(float(one["nominal"]), color=_NEGATIVE, label=f"nominal: {float(one['nominal']):.5g}")
    left.set_xlabel(f"{result.replace('_', ' ')} [{_shown(str(one['unit'].item()))}]")
    left.set_ylabel(f"samples [-] (of {solved.size})")
    left.legend(fontsize=8)
    order = np.argsort(-np.nan_to_num(one["total_order"].values))[:_BARS]
    place = np.arange(len(order))
    for shift, name, told, colour in (
        (-0.2, "first_order", "first order", _POSITIVE),
        (0.2, "total_order", "total", _NEGATIVE),
    ):
        right.barh(
            place + shift,
            np.nan_to_num(one[name].values[order]),
            height=0.38,
            xerr=np.nan_to_num(one[f"{name}_half_width"].values[order]),
            color=colour,
            label=told,
        )
    labels = [
        f"{n}\n({d})" for n, d in zip(one["input_name"].values, one["distribution"].values, strict=True)
    ]
    right.set_yticks(place, np.array(labels)[order])
    right.invert_yaxis()
    right.set_xlabel("Sobol index: share of the variance [-]")
    right.set_xlim(left=0.0)
    right.legend(fontsize=8)
    return figure
