"""A joint that turns as pictures: creep of its contacts, efficiency, life and drift."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from asperity.drive.geometry import CONTACT_NAMES
from asperity.joint.rolling import RollingResult
from asperity.joint.rolling_curves import RollingCurves

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ARCMINUTES = 10800.0 / math.pi
_RPM = 30.0 / math.pi
_COLOURS = ("black", "tab:blue", "tab:cyan", "tab:red", "tab:orange")
_MARKERS = ("o", "^", "v", "s", "D")
_HERE = {"color": "black", "linestyle": "none", "marker": "o", "markersize": 6, "zorder": 4}


def rolling_figure(
    curves: RollingCurves,
    rolling: RollingResult,
    *,
    friction_coefficients: tuple[float, ...],
    output_torque: float,
    sun_speed: float,
    title: str,
    width: float = 10.0,
) -> Figure:
    """Four pictures of a joint that turns on one sheet.

    Parameters
    ----------
    curves : RollingCurves
        What to draw.
    rolling : RollingResult
        The joint under its own torque and speed.
    friction_coefficients : tuple of float
        One, or one for each contact [-].
    output_torque, sun_speed : float
        Its torque [N·m] and speed [rad/s].
    title : str
        Title of the sheet.
    width : float
        Width of the sheet [in].

    Returns
    -------
    Figure
        A matplotlib figure; call its ``savefig``.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, 0.76 * width), layout="constrained")
    (creep, efficiency), (drift, life) = figure.subplots(2, 2)
    draw_creep(creep, curves, rolling, friction_coefficients=friction_coefficients)
    draw_efficiency(efficiency, curves, output_torque=output_torque, sun_speed=sun_speed)
    draw_drift(drift, curves, rolling, output_torque=output_torque)
    draw_life(life, curves, rolling, output_torque=output_torque)
    figure.suptitle(title)
    return figure


def draw_creep(
    axes: Axes, curves: RollingCurves, rolling: RollingResult, *, friction_coefficients: tuple[float, ...]
) -> None:
    """Traction over creepage of each contact, with its working point and the friction limit.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    curves : RollingCurves
        The creep curves.
    rolling : RollingResult
        The working points.
    friction_coefficients : tuple of float
        One, or one for each contact [-].
    """
    for index, name in enumerate(CONTACT_NAMES):
        axes.plot(
            1e3 * np.asarray(curves.contact_creepage[index]),
            np.asarray(curves.contact_traction[index]),
            color=_COLOURS[index],
            linewidth=1.4,
            marker=_MARKERS[index],
            markevery=(int(3 + 2 * index), 15),
            markersize=3,
            label=name,
        )
        axes.plot(
            1e3 * float(rolling.creepage[index]),
            float(rolling.traction_coefficient[index]),
            linestyle="none",
            marker=_MARKERS[index],
            markersize=8,
            markerfacecolor=_COLOURS[index],
            markeredgecolor="white",
            zorder=4,
        )
    for limit in dict.fromkeys(friction_coefficients):
        axes.axhline(limit, color="0.4", linestyle="--", linewidth=1.0)
        axes.annotate(
            f"gross slip, T/N = {limit:g}",
            (0.02, limit),
            xycoords=("axes fraction", "data"),
            xytext=(0, 3),
            textcoords="offset points",
            fontsize="small",
        )
    axes.set(
        title="Creep of the contacts; large symbols: this joint",
        xlabel="creepage [10⁻³]",
        ylabel="traction coefficient T/N [-]",
        ylim=(0.0, 1.15 * max(friction_coefficients)),
    )
    axes.set_xlim(left=0.0)
    axes.legend(frameon=False, loc="lower right")
    _ticks(axes)


def draw_efficiency(axes: Axes, curves: RollingCurves, *, output_torque: float, sun_speed: float) -> None:
    """Map of the efficiency over torque and speed, with the joint's own point; a note where the sun stands.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    curves : RollingCurves
        The map.
    output_torque, sun_speed : float
        The joint's point [N·m], [rad/s].
    """
    values = 100.0 * np.asarray(curves.efficiency)
    if not np.any(np.isfinite(values)):
        axes.set_axis_off()
        axes.set_title("Efficiency")
        axes.text(
            0.5,
            0.5,
            "no map: the sun stands,\nno power is passed",
            ha="center",
            va="center",
            transform=axes.transAxes,
        )
        return
    from matplotlib.ticker import MaxNLocator

    torque, speed = np.asarray(curves.map_torque), _RPM * np.asarray(curves.map_speed)
    shown = np.ma.masked_invalid(values)
    levels = MaxNLocator(nbins=9).tick_values(float(shown.min()), float(shown.max()))
    filled = axes.contourf(torque, speed, shown, levels=levels, cmap="viridis")
    axes.figure.colorbar(filled, ax=axes, label="efficiency [%]")
    axes.plot(output_torque, _RPM * sun_speed, **{**_HERE, "color": "white", "markeredgecolor": "black"})
    axes.set(
        title="Efficiency; white: this joint",
        xlabel="torque at the output [N·m]",
        ylabel="speed of the sun [rpm]",
    )
    _ticks(axes)


def draw_drift(axes: Axes, curves: RollingCurves, rolling: RollingResult, *, output_torque: float) -> None:
    """Drift in one turn of the output over torque.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    curves : RollingCurves
        The curve.
    rolling : RollingResult
        The joint's own drift.
    output_torque : float
        The joint's own torque [N·m].
    """
    axes.plot(curves.torque, _ARCMINUTES * np.asarray(curves.drift_per_output_turn), color="black")
    axes.plot(output_torque, _ARCMINUTES * float(rolling.drift_per_output_turn), **_HERE)
    axes.set(
        title="Drift; dot: this joint",
        xlabel="torque at the output [N·m]",
        ylabel="drift per output turn [arcmin]",
    )
    axes.set_xlim(left=0.0)
    axes.set_ylim(bottom=0.0)
    _ticks(axes)


def draw_life(axes: Axes, curves: RollingCurves, rolling: RollingResult, *, output_torque: float) -> None:
    """Life of the drive over torque: hours at the joint's speed, turns of the output where the sun stands.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    curves : RollingCurves
        The curve.
    rolling : RollingResult
        The joint's own life.
    output_torque : float
        The joint's own torque [N·m].
    """
    hours = bool(np.any(np.isfinite(curves.life_hours)))
    over = np.asarray(curves.life_hours if hours else curves.life_turns)
    here = (rolling.life_hours if hours else rolling.life_turns).drive
    axes.semilogy(curves.torque, over, color="black")
    axes.semilogy(output_torque, float(here), **_HERE)
    axes.set(
        title="Fatigue life; dot: this joint",
        xlabel="torque at the output [N·m]",
        ylabel="life of the drive [h]" if hours else "life of the drive [turns of the output]",
    )
    axes.set_xlim(left=0.0)
    low, high = np.nanmin(over), np.nanmax(over)
    if np.isfinite(low) and np.isfinite(high):
        _decades(axes, low, high)
    _ticks(axes, vertical=False)


def _decades(axes: Axes, low: float, high: float) -> None:
    """Three labelled ticks at least on a logarithmic axis: whole decades, or 1, 2, 5 of each where the range is small."""
    from matplotlib.ticker import LogFormatterSciNotation, LogLocator, NullFormatter

    bottom, top = math.floor(math.log10(low)), math.ceil(math.log10(high))
    if top - bottom >= 3:
        axes.set_ylim(10.0**bottom, 10.0**top)
        axes.yaxis.set_minor_formatter(NullFormatter())
        return
    steps = (1.0, 2.0, 5.0)
    ticks = [s * 10.0**d for d in range(bottom - 1, top + 1) for s in steps]
    inside = [i for i, tick in enumerate(ticks) if low <= tick <= high] or [
        next(i for i, tick in enumerate(ticks) if tick > low)
    ]
    axes.set_ylim(ticks[inside[0] - 1], ticks[inside[-1] + 1])
    axes.yaxis.set_major_locator(LogLocator(subs=steps))
    axes.yaxis.set_major_formatter(LogFormatterSciNotation(labelOnlyBase=False, minor_thresholds=(9.0, 9.0)))
    axes.yaxis.set_minor_formatter(NullFormatter())


def _ticks(axes: Axes, *, vertical: bool = True) -> None:
    axes.locator_params(axis="x", nbins=6, min_n_ticks=3)
    if vertical:
        axes.locator_params(axis="y", nbins=6, min_n_ticks=3)
    axes.tick_params(labelsize="small")
    axes.title.set_fontsize("medium")
