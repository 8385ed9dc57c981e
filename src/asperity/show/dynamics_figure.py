"""The frequency response of a joint as a picture."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.results.dynamics_document import response_columns
from asperity.standing.dynamics import Dynamics

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def dynamics_figure(dynamics: Dynamics, *, title: str) -> Figure:
    """Amplitude and phase over frequency, standing and turning; natural frequencies over torque."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(12.0, 6.4), layout="constrained")
    grid = figure.add_gridspec(2, 2, width_ratios=(1.5, 1.0))
    amplitude = figure.add_subplot(grid[0, 0])
    phase = figure.add_subplot(grid[1, 0], sharex=amplitude)
    columns = response_columns(dynamics)
    frequency = columns["frequency_Hz"]
    turns = bool(np.isfinite(dynamics.at_torque.creep_damping))
    for state, style in (("standing", "-"), ("turning", "--")):
        if state == "turning" and not turns:
            continue
        for side, color in (("motor", "tab:blue"), ("load", "tab:orange")):
            look = {"color": color, "linestyle": style, "label": f"{side} side, {state}"}
            amplitude.loglog(frequency, columns[f"{state}_{side}_rad_per_Nm"], **look)
            phase.semilogx(frequency, columns[f"{state}_{side}_phase_deg"], **look)
    amplitude.set(ylabel="angle per torque at the input,\nboth at the output [rad/(N·m)]")
    phase.set(xlabel="frequency [Hz]", ylabel="phase [deg]")
    amplitude.legend(frameon=False, fontsize="small")
    over, working = dynamics.over_torque, dynamics.at_torque
    torques = figure.add_subplot(grid[0, 1])
    corner = figure.add_subplot(grid[1, 1], sharex=torques)
    for values, at, color, label in (
        (over.free_frequency, working.free_frequency, "tab:red", "both sides free (resonance)"),
        (over.locked_frequency, working.locked_frequency, "black", "motor locked (antiresonance)"),
    ):
        torques.plot(over.output_torque, values, color=color, label=label)
        torques.plot(working.output_torque, at, "o", color=color)
    torques.set(ylabel="natural frequency [Hz]")
    torques.set_ylim(bottom=0.0)
    torques.legend(frameon=False, fontsize="small")
    corner.set(xlabel="torque at the output [N·m]", ylabel="creep corner frequency [Hz]")
    if turns:
        corner.plot(over.output_torque, over.corner_frequency, color="tab:purple")
        corner.plot(working.output_torque, working.corner_frequency, "o", color="tab:purple")
        corner.set_ylim(bottom=0.0)
    else:
        corner.text(0.5, 0.5, "the input stands: no creep", ha="center", transform=corner.transAxes)
    figure.suptitle(title)
    return figure
