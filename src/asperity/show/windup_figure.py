"""The wind-up of a joint as a picture."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from asperity.rolling.onset import RollingOnset
from asperity.standing.windup import Windup

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ARCMINUTES, _DEGREES = 10800.0 / np.pi, 180.0 / np.pi
_Rows = tuple[tuple[tuple[int, int], ...], ...]
#: Columns of the panels out of 6, row by row; the last row is that of the joint that turns.
_NARROW: _Rows = (((0, 1), (1, 2)), ((0, 2),), ((0, 1), (1, 2)))
_WIDE: _Rows = (((0, 2), (2, 4), (4, 6)), ((0, 3), (3, 6)))
_NEAR = 1.25  # capacity over the end of the axis up to which it is in the picture
_LEGEND_LINE = 0.11  # height of a line of a legend over that of a narrow panel


def windup_figure(
    curve: Windup,
    onset: RollingOnset | None = None,
    *,
    title: str,
    stacked: bool = False,
    capacities: tuple[float, float] = (math.inf, math.inf),
) -> Figure:
    """Torque–angle loop, its deviation from a straight line, and stiffness; below them the joint that turns.

    ``stacked`` has at most two panels beside each other, for a narrow page; ``capacities`` of positive and of negative
    torques, as positive torques [N·m], are infinite where there are none.
    """
    from matplotlib.figure import Figure

    rows = _NARROW if stacked else _WIDE
    rows = rows if onset is not None else rows[:-1]
    width, height = (7.0, 2.8) if stacked else (14.0, 4.2)
    figure = Figure(figsize=(width, height * len(rows)), layout="constrained")
    grid = figure.add_gridspec(len(rows), rows[-1][-1][1])
    loop, deviation, stiffness, *turning = (
        figure.add_subplot(grid[row, slice(*columns)])
        for row, places in enumerate(rows)
        for columns in places
    )
    straight = curve.torque * ((curve.angle[-1] - curve.angle[0]) / (curve.torque[-1] - curve.torque[0]))
    for angle, color, line, label in (
        (curve.angle, "black", "-", "first loading, either way"),
        (curve.unloading_angle, "tab:blue", "--", "unloading"),
        (curve.reloading_angle, "tab:orange", "-.", "reloading"),
    ):
        loop.plot(_ARCMINUTES * angle, curve.torque, color=color, linestyle=line, label=label)
        difference = 60.0 * _ARCMINUTES * (angle - straight)
        deviation.plot(curve.torque, difference, color=color, linestyle=line, label=label)
    deviation.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    deviation.set(xlabel="torque at the output [N·m]", ylabel="angle less a straight line\n[arcsec]")
    loop.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.axvline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.locator_params(axis="x", nbins=4)
    loop.set(xlabel="angle at the output [arcmin]", ylabel="torque at the output\n[N·m]")
    _legend_above(loop)
    stiffness.plot(curve.torque, curve.stiffness / _ARCMINUTES, color="black", label="incremental")
    for values, bounds, label in (
        (curve.stage_stiffness, curve.stage_torque, "K1, K2, K3 (secant)"),
        (curve.reverse_stage_stiffness[::-1], -curve.stage_torque[::-1], "_nolegend_"),
    ):
        stiffness.stairs(values / _ARCMINUTES, bounds, color="tab:red", baseline=None, label=label)
    stiffness.set(xlabel="torque at the output [N·m]", ylabel="stiffness at the output\n[N·m/arcmin]")
    _shade_beyond(deviation, capacities)
    _shade_beyond(stiffness, capacities)
    _legend_above(stiffness)
    if onset is not None:
        _draw_beyond(turning[0], onset, torque=float(curve.torque[-1]))
        _draw_swings(turning[1], onset)
    figure.suptitle(title)
    return figure


def _shade_beyond(panel: Axes, capacities: tuple[float, float]) -> None:
    """What the joint does not carry, as far as it is near; a legend says where it begins."""
    ends = panel.get_xlim()
    reach = _NEAR * max(map(abs, ends))
    label = "beyond the standing torque capacity"
    for sign, limit in zip((1.0, -1.0), capacities, strict=True):
        if limit < reach:
            panel.axvspan(
                sign * limit, sign * reach, color="tab:orange", alpha=0.25, linewidth=0.0, label=label
            )
            label = "_nolegend_"
    if label.startswith("_"):
        panel.set_xlim(-reach, reach)
    elif math.isfinite(min(capacities)):
        panel.plot([], [], " ", label=f"standing torque capacity {min(capacities):.4g} N·m")


def _draw_beyond(panel: Axes, onset: RollingOnset, *, torque: float) -> None:
    """Angle behind over the angle that the input has turned since the torque was applied."""
    contacts = onset.contacts
    entry = _DEGREES * float(contacts.input_angle)
    windup = _ARCMINUTES * float(onset.windup)
    slope = float(contacts.drift_per_output_turn) / (2.0 * np.pi)
    line = onset.windup - onset.missing_angle + slope * onset.angle
    panel.axhline(windup, color="black", linestyle="--", linewidth=1.0, label="static curve: wind-up")
    panel.plot(
        entry * onset.angle,
        _ARCMINUTES * line,
        color="tab:red",
        linestyle=":",
        label="drift of steady rolling",
    )
    panel.plot(entry * onset.angle, _ARCMINUTES * onset.lag, color="tab:blue", label="angle behind")
    panel.axvspan(0.0, entry * float(onset.static_angle), color="0.93", zorder=0)
    panel.axvline(
        entry * float(onset.steady_angle), color="0.6", linewidth=0.8, label="all contacts rolled 2a"
    )
    panel.set(
        xlabel="angle turned by the input [°]",
        ylabel="angle behind at the output\n[arcmin]",
        title=f"turning under {torque:.4g} N·m\nshaded: creep below {100.0 * float(onset.creep_share):.3g} %",
        xlim=(0.0, entry * float(onset.angle[-1])),
    )
    panel.title.set_fontsize("medium")
    _legend_above(panel)


def _draw_swings(panel: Axes, onset: RollingOnset) -> None:
    """Angle lost in each swing to and fro over the stroke of the input."""
    entry = _DEGREES * float(onset.contacts.input_angle)
    steady = 2.0 * onset.angle * float(onset.contacts.drift_per_output_turn) / (2.0 * np.pi)
    panel.plot(
        entry * onset.angle,
        _ARCMINUTES * steady,
        color="tab:red",
        linestyle=":",
        label="steady drift, both ways",
    )
    panel.plot(entry * onset.angle, _ARCMINUTES * onset.swing_drift, color="tab:blue", label="lost per swing")
    panel.axvline(entry * float(onset.still_angle), color="0.6", linewidth=0.8, label="no drift up to here")
    panel.set(
        xlabel="stroke of the input, to and fro [°]",
        ylabel="angle lost per swing\nat the output [arcmin]",
        title="swinging under the same torque",
        xlim=(0.0, entry * float(onset.angle[-1])),
    )
    panel.title.set_fontsize("medium")
    _legend_above(panel)


def _legend_above(panel: Axes) -> None:
    """The legend in a strip above the highest curve, where it covers none."""
    entries = len(panel.get_legend_handles_labels()[0])
    low, high = panel.get_ylim()
    panel.set_ylim(low, high + (high - low) * _LEGEND_LINE * entries / (1.0 - _LEGEND_LINE * entries))
    panel.legend(fontsize="small", loc="upper left", facecolor="white", edgecolor="none", framealpha=1.0)
