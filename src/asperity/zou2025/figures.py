"""Draw the panels of the paper from computed curves."""

from __future__ import annotations

import math
import textwrap
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from asperity.zou2025.criteria import peak
from asperity.zou2025.panels import Axis, Panel
from asperity.zou2025.style import ACCENT, CONTACT_LABELS, CONTACT_STYLES, MARK, MUTED, STYLE, torque_colors

_HEIGHT = 4.45  # inches
_AXES_BOX = (0.75, 0.85, 4.75, 2.90)  # left, bottom, width, height in inches
_LEGEND_WIDTH = {"single": 0.0, "torques": 1.15, "contacts": 1.75}
_SMALL = 0.25
_NOTE_CHARACTERS = 14.0  # per inch of the figure's width


def engineering_exponent(values: np.ndarray) -> int:
    """Power of ten, a multiple of three, that brings the largest value into 1 … 1000; 0 below ten thousand.

    Parameters
    ----------
    values : ndarray
        What is to be shown.

    Returns
    -------
    int
    """
    largest = float(np.max(np.abs(values)))
    return 3 * math.floor(math.log10(largest) / 3.0) if largest >= 1e4 else 0


def axis_label(axis: Axis, exponent: int) -> str:
    """Label with unit, and the power of ten that the ticks are divided by.

    Parameters
    ----------
    axis : Axis
        The axis.
    exponent : int
        0 for none.

    Returns
    -------
    str
    """
    power = f"10$^{{{exponent}}}$ " if exponent else ""
    return f"{axis.label} ({power}{axis.unit})" if axis.unit or exponent else axis.label


def _styles(panel: Panel) -> list[dict[str, Any]]:
    if panel.kind == "contacts":
        return [{**CONTACT_STYLES[s.label], "label": CONTACT_LABELS[s.label]} for s in panel.series]
    colors = [ACCENT] if panel.kind == "single" else torque_colors(len(panel.series))
    return [{"color": color, "label": s.label} for color, s in zip(colors, panel.series, strict=True)]


def _mark_peaks(axes: Axes, panel: Panel, scale: float) -> None:
    places = [peak(panel.abscissa, s.values) for s in panel.series]
    tops = [float(np.max(s.values)) / scale for s in panel.series]
    axes.plot(places, tops, "o", ms=4.5, mfc="white", mec=MARK, mew=1.3, zorder=5)
    top = int(np.argmax(tops))
    axes.annotate(
        f"peak at $D$ = {places[top]:.3f}",
        (places[top], tops[top]),
        xytext=(0, 8),
        textcoords="offset points",
        ha="center",
        color=MARK,
    )


def _inset(axes: Axes, panel: Panel, scale: float) -> None:
    """A second view: logarithmic where a linear axis hides the small values, magnified where a curve is flat."""
    logarithmic = panel.inset == "logarithmic"
    inset = axes.inset_axes((0.12, 0.47, 0.40, 0.40) if logarithmic else (0.33, 0.20, 0.56, 0.42))
    for series, style in zip(panel.series, _styles(panel), strict=True):
        inset.plot(
            panel.abscissa, series.values / (1.0 if logarithmic else scale), color=style["color"], lw=1.3
        )
    if logarithmic:
        inset.set_yscale("log")
    inset.set_xlim(panel.abscissa[0], panel.abscissa[-1])
    inset.set_title(panel.inset, fontsize=8, color=MUTED, fontweight="normal", pad=3)
    inset.tick_params(labelsize=7.5)
    inset.locator_params(axis="x", nbins=5)


def _y_limits(axes: Axes, panel: Panel, scale: float) -> None:
    """Start at zero wherever that does not hide the curves' shape."""
    low = min(float(np.min(s.values)) for s in panel.series) / scale
    high = max(float(np.max(s.values)) for s in panel.series) / scale
    if panel.kind == "single" or low < _SMALL * high:
        axes.set_ylim(0.0, (1.14 if panel.mark_peak else 1.06) * high)


def _mark_slip(axes: Axes, panel: Panel, scale: float) -> None:
    values = panel.series[0].values
    slip = float(panel.abscissa[np.argmax(values <= 0.0)])
    axes.axvline(slip, color=MARK, lw=1.0, ls=(0, (2, 2)))
    axes.annotate(
        f"gross slip\n$T = \\mu F_n$ = {slip:.0f} N",
        (slip, 0.92 * values[0] / scale),
        xytext=(-6, 0),
        textcoords="offset points",
        ha="right",
        va="center",
        color=MARK,
    )


def draw(axes: Axes, panel: Panel) -> None:
    """Draw one panel into given axes.

    Parameters
    ----------
    axes : Axes
        Where to draw; the settings of :data:`asperity.zou2025.style.STYLE` should be active.
    panel : Panel
        What to draw.
    """
    exponent = (
        0 if panel.y.logarithmic else engineering_exponent(np.concatenate([s.values for s in panel.series]))
    )
    scale = 10.0**exponent
    for series, style in zip(panel.series, _styles(panel), strict=True):
        axes.plot(panel.abscissa, series.values / scale, **style)
    axes.set_xlim(panel.abscissa[0], panel.abscissa[-1])
    if panel.x.logarithmic:
        axes.set_xscale("log")
    if panel.y.logarithmic:
        axes.set_yscale("log")
    else:
        _y_limits(axes, panel, scale)
    if panel.mark_peak:
        _mark_peaks(axes, panel, scale)
    if panel.inset:
        _inset(axes, panel, scale)
    if panel.x.column == "tangential_force_N":
        _mark_slip(axes, panel, scale)
    axes.set_xlabel(axis_label(panel.x, 0))
    axes.set_ylabel(axis_label(panel.y, exponent))
    if panel.legend:
        axes.legend(title=panel.legend, alignment="left", loc="upper left", bbox_to_anchor=(1.01, 1.02))


def panel_figure(panel: Panel) -> Figure:
    """One panel as a figure of its own, ready to save.

    Parameters
    ----------
    panel : Panel
        What to draw.

    Returns
    -------
    Figure
        With an Agg canvas; the axes have the same size and place in every figure.
    """
    left, bottom, width, height = _AXES_BOX
    total = left + width + 0.25 + _LEGEND_WIDTH[panel.kind]
    with rc_context(STYLE):
        figure = Figure(figsize=(total, _HEIGHT))
        FigureCanvasAgg(figure)
        axes = figure.add_axes((left / total, bottom / _HEIGHT, width / total, height / _HEIGHT))
        draw(axes, panel)
        axes.set_title(f"Fig. {panel.name}   {panel.title}", pad=24)
        axes.annotate(
            panel.conditions,
            (0, 1),
            xycoords="axes fraction",
            xytext=(0, 9),
            textcoords="offset points",
            fontsize=8.5,
            color=MUTED,
        )
        if panel.note:
            note = textwrap.fill(panel.note, round(_NOTE_CHARACTERS * total))
            figure.text(left / total, 0.02, note, fontsize=7.5, color=MUTED, va="bottom")
    return figure
