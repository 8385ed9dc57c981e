"""A joint that turns as pictures: creep of its contacts, efficiency, drift and life."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, Literal

import numpy as np

from asperity.joint.description import Joint
from asperity.rolling.curves import RollingCurves
from asperity.rolling.rolling import RollingResult
from asperity.types import Document

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ARCMINUTES = 10800.0 / math.pi
_RPM = 30.0 / math.pi
#: Colour, line and symbol of each contact, told apart without colours too.
_STYLES = (
    ("black", "-", "o"),
    ("tab:blue", "-", "^"),
    ("tab:blue", "--", "v"),
    ("tab:red", "-", "s"),
    ("tab:red", "--", "D"),
)
_TORQUE = "torque at the output [N·m]"


def rolling_figure(
    curves: RollingCurves, rolling: RollingResult, *, joint: Joint, title: str, width: float
) -> Figure:
    """Four pictures of a joint that turns on one sheet so wide [in], legible from 6.5 on."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, 0.78 * width), layout="constrained")
    (creep, efficiency), (drift, life) = figure.subplots(2, 2)
    draw_creep(creep, curves, rolling, joint=joint)
    draw_efficiency(efficiency, curves, joint=joint)
    draw_drift(drift, curves, rolling, joint=joint)
    draw_life(life, curves, rolling, joint=joint)
    figure.suptitle(title)
    return figure


def draw_creep(axes: Axes, curves: RollingCurves, rolling: RollingResult, *, joint: Joint) -> None:
    """Traction over creepage of each contact, with its working point and the friction limit."""
    from matplotlib.lines import Line2D

    keys = []
    for index, (name, (colour, line, symbol)) in enumerate(
        zip(joint.contact_names, itertools.cycle(_STYLES))
    ):
        creepage, traction = curves.contact_creepage[index], curves.contact_traction[index]
        point: Document = {
            "marker": symbol,
            "markersize": 6,
            "markeredgecolor": "white",
            "color": colour,
        }
        axes.plot(1e3 * np.asarray(creepage), np.asarray(traction), color=colour, linestyle=line, label=name)
        axes.plot(
            1e3 * float(rolling.creepage[index]),
            float(rolling.traction_coefficient[index]),
            linestyle="none",
            zorder=4,
            **point,
        )
        keys.append(Line2D([], [], linestyle=line, label=name, **point))
    limits = sorted({float(coefficient) for coefficient in joint.friction_coefficients})
    for limit in limits:
        axes.axhline(limit, color="0.4", linestyle=":", linewidth=1.2)
        axes.annotate(
            f"gross slip at T/N = {limit:g}",
            (0.02, limit),
            xycoords=("axes fraction", "data"),
            xytext=(0, 3),
            textcoords="offset points",
            fontsize="small",
        )
    axes.set(
        title="Creep curves; symbols: this joint",
        xlabel="creepage [10⁻³]",
        ylabel="traction T/N [-]",
        ylim=(0.0, 1.15 * limits[-1]),
    )
    axes.set_xlim(left=0.0)
    axes.legend(handles=keys, frameon=False, loc="lower right", fontsize="small", labelspacing=0.3)
    _finish(axes)


def draw_efficiency(axes: Axes, curves: RollingCurves, *, joint: Joint) -> None:
    """Map of the efficiency over torque and speed, with the joint's own point; a note where the input stands."""
    axes.set_title("Efficiency; white: this joint")
    values = np.ma.masked_invalid(100.0 * np.asarray(curves.efficiency))
    if values.count() == 0:
        axes.set_axis_off()
        axes.set_title("Efficiency")
        axes.text(
            0.5,
            0.5,
            "no map: the input stands,\nno power is passed",
            horizontalalignment="center",
            transform=axes.transAxes,
        )
        _finish(axes, ticks=())
        return
    from matplotlib.ticker import MaxNLocator

    speed = _RPM * np.asarray(curves.map_speed)
    ticks = MaxNLocator(nbins=8, steps=(1, 2, 5, 10)).tick_values(float(values.min()), float(values.max()))
    levels = np.unique(np.minimum(ticks, 100.0))
    filled = axes.contourf(np.asarray(curves.map_torque), speed, values, levels=levels, cmap="viridis")
    bar = axes.figure.colorbar(filled, ax=axes, label="efficiency [%]")
    bar.ax.tick_params(labelsize="small")
    axes.plot(
        float(joint.output_torque),
        _RPM * float(joint.input_speed),
        "o",
        color="white",
        markeredgecolor="black",
    )
    axes.set(xlabel=_TORQUE, ylabel="speed of the input [rpm]")
    _finish(axes)


def draw_drift(axes: Axes, curves: RollingCurves, rolling: RollingResult, *, joint: Joint) -> None:
    """Drift in one turn of the output over torque."""
    axes.set(title="Drift; dot: this joint", ylabel="drift [arcmin per output turn]")
    here = _ARCMINUTES * float(rolling.drift_per_output_turn)
    _over_torque(axes, curves, _ARCMINUTES * np.asarray(curves.drift_per_output_turn), here, joint)
    axes.set_ylim(bottom=0.0)
    _finish(axes)


def draw_life(axes: Axes, curves: RollingCurves, rolling: RollingResult, *, joint: Joint) -> None:
    """Life of the drive over torque: hours at the joint's speed, turns of the output where the input stands."""
    hours = bool(np.any(np.isfinite(curves.life_hours)))
    over = np.asarray(curves.life_hours if hours else 1e-6 * curves.life_turns)
    here = float(rolling.life_hours.drive) if hours else 1e-6 * float(rolling.life_turns.drive)
    axes.set(
        title="Rating life; dot: this joint", ylabel="life [h]" if hours else "life [million output turns]"
    )
    _over_torque(axes, curves, over, here, joint)
    finite = over[np.isfinite(over)]
    if finite.size and finite.max() > 100.0 * finite.min():
        axes.set_yscale("log")
        axes.set_ylim(10.0 ** np.floor(np.log10(finite.min())), 10.0 ** np.ceil(np.log10(finite.max())))
        _finish(axes, ticks=("x",))
        return
    axes.set_ylim(0.0, 1.2 * (finite.max() if finite.size else 1.0))
    axes.ticklabel_format(axis="y", style="plain", useOffset=False)
    _finish(axes)


def _over_torque(axes: Axes, curves: RollingCurves, values: np.ndarray, here: float, joint: Joint) -> None:
    """A curve over torque with the joint's own point, and where friction ends it."""
    axes.plot(np.asarray(curves.torque), values, color="black")
    axes.plot(float(joint.output_torque), here, "o", color="black")
    capacity = float(curves.torque_capacity)
    if math.isfinite(capacity):
        axes.axvline(capacity, color="0.4", linestyle=":", linewidth=1.2)
        axes.annotate(
            "gross slip",
            (capacity, 0.04),
            xycoords=("data", "axes fraction"),
            xytext=(-3, 0),
            textcoords="offset points",
            rotation=90.0,
            fontsize="small",
            horizontalalignment="right",
        )
    axes.set_xlabel(_TORQUE)
    axes.set_xlim(0.0, 1.04 * float(curves.torque[-1]))


def _finish(axes: Axes, *, ticks: tuple[Literal["x", "y"], ...] = ("x", "y")) -> None:
    for axis in ticks:
        axes.locator_params(axis=axis, nbins=6, min_n_ticks=3)
    axes.tick_params(labelsize="small")
    axes.title.set_fontsize("medium")
