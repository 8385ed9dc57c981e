"""Draw the panels of the paper from computed curves, and an overview with the joint to scale."""

from __future__ import annotations

import math
import textwrap

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, StrMethodFormatter

from asperity.show.style import ACCENT, CONTACT_LABELS, CONTACT_STYLES, MARK, MUTED, STYLE, torque_colors
from asperity.types import Document
from asperity.zou2025 import preset
from asperity.zou2025.criteria import peak
from asperity.zou2025.curves import Curves
from asperity.zou2025.drive_drawing import draw_drive
from asperity.zou2025.panels import Axis, Panel, joint_panels

_HEIGHT = 4.45  # inches
_AXES_BOX = (0.75, 0.85, 4.75, 2.90)  # left, bottom, width, height in inches
_LEGEND_WIDTH = {"single": 0.0, "torques": 1.15, "contacts": 1.75}
_LEGEND_TITLE = {"torques": "output torque", "contacts": "contact"}
_FLAT = 0.1  # a single curve that varies by less than this share of its maximum is shown magnified as well
# A family whose minimum is above this share of its maximum has an axis of its own range.
_FAR_FROM_ZERO = 0.25
_FEW_DECADES = 2.0  # a logarithmic axis of no more than these also has ticks at 2 and 5
_NOTE_CHARACTERS = 14.0  # per inch of the figure's width


def engineering_exponent(values: np.ndarray) -> int:
    """Power of ten, a multiple of three, that brings the largest value into 1 … 1000; 0 below ten thousand."""
    largest = float(np.max(np.abs(values)))
    return 3 * math.floor(math.log10(largest) / 3.0) if largest >= 1e4 else 0


def axis_label(axis: Axis, exponent: int) -> str:
    """Label of an axis with its unit and the power of ten by which the ticks are divided (exponent 0: none)."""
    power = f"10$^{{{exponent}}}$ " if exponent else ""
    return f"{axis.label} ({power}{axis.unit})" if axis.unit or exponent else axis.label


def _styles(panel: Panel) -> list[Document]:
    if panel.kind == "contacts":
        return [{**CONTACT_STYLES[name], "label": CONTACT_LABELS[name]} for name in panel.curves]
    if panel.kind == "single":
        return [{"color": ACCENT}]
    colors = torque_colors(len(panel.curves))
    return [{"color": c, "label": f"{name} N·m"} for c, name in zip(colors, panel.curves, strict=True)]


def _marks_peaks(panel: Panel) -> bool:
    return panel.x.column == "fractal_dimension" and panel.kind != "contacts"


def _mark_peaks(axes: Axes, panel: Panel, scale: float) -> None:
    places = [peak(panel.abscissa, values) for values in panel.curves.values()]
    tops = [float(np.max(values)) / scale for values in panel.curves.values()]
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


def _mark_slip(axes: Axes, panel: Panel, scale: float) -> None:
    values = panel.curves[""]
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


def _inset(axes: Axes, panel: Panel, scale: float, *, logarithmic: bool) -> None:
    """A second view: logarithmic if a linear axis hides the small values, magnified if a curve is flat."""
    axes.grid(False)  # its lines would cross the tick labels of the inset
    inset = axes.inset_axes((0.13, 0.47, 0.39, 0.40) if logarithmic else (0.33, 0.20, 0.56, 0.42))
    for values, style in zip(panel.curves.values(), _styles(panel), strict=True):
        inset.plot(panel.abscissa, values / (1.0 if logarithmic else scale), color=style["color"], lw=1.3)
    if logarithmic:
        inset.set_yscale("log")
    inset.set_xlim(panel.abscissa[0], panel.abscissa[-1])
    unit = panel.y.unit if logarithmic else "same units"
    title = f"{'logarithmic' if logarithmic else 'magnified'} ({unit})"
    inset.set_title(title, fontsize=8, color=MUTED, fontweight="normal", pad=3)
    inset.tick_params(labelsize=7.5)
    inset.locator_params(axis="x", nbins=5)


def draw(axes: Axes, panel: Panel) -> None:
    """Draw one panel."""
    values = np.array(list(panel.curves.values()))
    few_decades = panel.y.logarithmic and np.max(values) / np.min(values) < 10.0**_FEW_DECADES
    exponent = engineering_exponent(values) if few_decades or not panel.y.logarithmic else 0
    scale = 10.0**exponent
    for curve, style in zip(values, _styles(panel), strict=True):
        axes.plot(panel.abscissa, curve / scale, **style)
    axes.set_xlim(panel.abscissa[0], panel.abscissa[-1])
    if panel.y.logarithmic:
        axes.set_yscale("log")
        if few_decades:
            axes.yaxis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
            axes.yaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    elif panel.kind == "single" or np.min(values) < _FAR_FROM_ZERO * np.max(values):
        axes.set_ylim(0.0, (1.14 if _marks_peaks(panel) else 1.06) * np.max(values) / scale)
    if panel.x.logarithmic:
        axes.set_xscale("log")
    if _marks_peaks(panel):
        _mark_peaks(axes, panel, scale)
        _inset(axes, panel, scale, logarithmic=True)
    elif panel.kind == "single" and np.ptp(values) < _FLAT * np.max(values):
        _inset(axes, panel, scale, logarithmic=False)
    if panel.x.column == "tangential_force_N":
        _mark_slip(axes, panel, scale)
    axes.set_xlabel(axis_label(panel.x, 0))
    axes.set_ylabel(axis_label(panel.y, exponent))
    if panel.kind != "single":
        title = _LEGEND_TITLE[panel.kind]
        axes.legend(title=title, alignment="left", loc="upper left", bbox_to_anchor=(1.01, 1.02))


def panel_figure(panel: Panel) -> Figure:
    """One panel as a figure of its own, ready to save."""
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
        note = textwrap.fill(panel.note, round(_NOTE_CHARACTERS * total))
        figure.text(left / total, 0.34 / _HEIGHT, note, fontsize=7.5, color=MUTED, va="top")
    return figure


def overview_figure(curves: Curves) -> Figure:
    """The drive to scale beside panel 7a, with the design window of the paper."""
    joint = preset.table_2_joint(preset.operating_grid())
    panel = joint_panels(curves)[0]
    with rc_context(STYLE):
        figure = Figure(figsize=(11.0, 4.8), layout="constrained")
        FigureCanvasAgg(figure)
        drive, stiffness = figure.subplots(1, 2, width_ratios=(1.0, 1.3))
        draw_drive(drive, joint.geometry, ring_wall_thickness=joint.ring_wall_thickness)
        drive.set_title("Planetary traction drive, to scale")
        draw(stiffness, panel)
        stiffness.set_title("Its stiffness, from the asperities alone")
        stiffness.axvspan(*preset.DESIGN_WINDOW, color="#eef4f8", lw=0, zorder=0)
        stiffness.text(
            float(np.mean(preset.DESIGN_WINDOW)),
            0.03,
            "window advised\nby the paper",
            transform=stiffness.get_xaxis_transform(),
            ha="center",
            fontsize=8.5,
            color=MUTED,
        )
    return figure
