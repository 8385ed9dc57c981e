"""The wind-up of a joint as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.joint.windup import Windup

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_ARCMINUTES = 10800.0 / np.pi


def windup_figure(curve: Windup, *, title: str) -> Figure:
    """Torque–angle loop and incremental stiffness side by side.

    Parameters
    ----------
    curve : Windup
        What to draw.
    title : str
        Title of the picture.

    Returns
    -------
    Figure
        A matplotlib figure; call its ``savefig``.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 4.2), layout="constrained")
    loop, stiffness = figure.subplots(1, 2)
    loop.plot(_ARCMINUTES * curve.angle, curve.torque, color="black", label="first loading")
    loop.plot(_ARCMINUTES * curve.unloading_angle, curve.loop_torque, color="tab:blue", label="unloading")
    loop.plot(_ARCMINUTES * curve.reloading_angle, curve.loop_torque, color="tab:orange", label="reloading")
    loop.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.axvline(0.0, color="0.8", linewidth=0.8, zorder=0)
    loop.set(xlabel="angle at the output [arcmin]", ylabel="torque at the output [N·m]")
    loop.legend(frameon=False)
    stiffness.plot(curve.torque, curve.stiffness / _ARCMINUTES, color="black", label="incremental")
    stiffness.stairs(
        curve.stage_stiffness / _ARCMINUTES,
        curve.stage_torque,
        color="tab:red",
        baseline=None,
        label="K1, K2, K3",
    )
    stiffness.set(xlabel="torque at the output [N·m]", ylabel="stiffness at the output [N·m/arcmin]")
    stiffness.legend(frameon=False)
    figure.suptitle(title)
    return figure
