"""The wind-up of a joint as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.joint.windup import Windup

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ARCMINUTES = 10800.0 / np.pi


def windup_figure(curve: Windup, *, title: str, stacked: bool = False) -> Figure:
    """Torque–angle loop, its deviation from a straight line and incremental stiffness side by side.

    Parameters
    ----------
    curve : Windup
        What to draw.
    title : str
        Title of the picture.
    stacked : bool, optional
        Whether the panels are below each other, for a narrow page.

    Returns
    -------
    Figure
        A matplotlib figure; call its ``savefig``.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.0, 6.8) if stacked else (14.0, 4.2), layout="constrained")
    loop, deviation, stiffness = figure.subplots(3, 1) if stacked else figure.subplots(1, 3)
    straight = curve.torque * ((curve.angle[-1] - curve.angle[0]) / (curve.torque[-1] - curve.torque[0]))
    for angle, color, line, label in (
        (curve.angle, "black", "-", "first loading, either direction"),
        (curve.unloading_angle, "tab:blue", "--", "unloading"),
        (curve.reloading_angle, "tab:orange", "-.", "reloading"),
    ):
        loop.plot(_ARCMINUTES * angle, curve.torque, color=color, linestyle=line, label=label)
        apart = 60.0 * _ARCMINUTES * (angle - straight)
        deviation.plot(curve.torque, apart, color=color, linestyle=line, label=label)
    deviation.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    deviation.set(
        xlabel="torque at the output [N·m]",
        ylabel="angle less a straight line [arcsec]",
    )
    loop.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.axvline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.set(xlabel="angle at the output [arcmin]", ylabel="torque at the output [N·m]")
    loop.legend(frameon=False)
    stiffness.plot(curve.torque, curve.stiffness / _ARCMINUTES, color="black", label="incremental")
    for values, bounds, label in (
        (curve.stage_stiffness, curve.stage_torque, "K1, K2, K3 (secant)"),
        (curve.reverse_stage_stiffness[::-1], -curve.stage_torque[::-1], "_nolegend_"),
    ):
        stiffness.stairs(values / _ARCMINUTES, bounds, color="tab:red", baseline=None, label=label)
    stiffness.set(xlabel="torque at the output [N·m]", ylabel="stiffness at the output [N·m/arcmin]")
    stiffness.legend(frameon=False)
    for axes in (loop, deviation, stiffness):
        axes.yaxis.label.set_fontsize("small" if stacked else "medium")
    figure.suptitle(title)
    return figure
