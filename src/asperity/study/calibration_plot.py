"""Plots of calibrations: data and fit, residuals, and the posterior."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.study.calibrate import Calibration
from asperity.study.posterior import Posterior
from asperity.study.unknowns import CURVE_UNKNOWNS
from asperity.units import from_si

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def calibration_figure(calibration: Calibration) -> Figure:
    """Measured and fitted curve above their difference, over the torque and in the order of time.

    Parameters
    ----------
    calibration : Calibration
        What :func:`asperity.study.calibrate.calibrate` returns.

    Returns
    -------
    Figure
        Three panels.
    """
    from matplotlib.figure import Figure

    data = calibration.model.measurement
    is_angle = data.angle is not None
    unit, name = ("arcmin", "angle") if is_angle else ("N*m/arcmin", "stiffness")
    factor = from_si(1.0, unit)
    small = "arcsec" if is_angle else unit
    fine = from_si(1.0, small)
    label = unit.replace("*", "·")
    figure = Figure(figsize=(9.0, 7.0), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=[2.0, 1.0])
    curve = figure.add_subplot(grid[0, :])
    order = np.arange(data.torque.size) if is_angle else np.argsort(data.torque)
    for index, repetition in enumerate(np.unique(data.repetition)):
        mine = data.repetition == repetition
        text = f"measured, repetition {repetition:g}" if np.unique(data.repetition).size > 1 else "measured"
        curve.plot(data.torque[mine], data.measured[mine] * factor, ".", ms=3, color=f"C{index}", label=text)
    curve.plot(
        data.torque[order], calibration.prediction[order] * factor, "-", color="k", lw=0.9, label="fit"
    )
    curve.set_xlabel("output torque [N·m]")
    curve.set_ylabel(f"{name} [{label}]")
    curve.legend(fontsize="small")
    curve.grid(alpha=0.3)
    curve.set_title(
        f"residual {calibration.standard_deviation * fine:.3g} {small.replace('*', '·')} (standard deviation), "
        f"Durbin–Watson {calibration.durbin_watson:.2f}",
        fontsize="medium",
    )
    against = figure.add_subplot(grid[1, 0])
    against.plot(data.torque, calibration.residual * fine, ".", ms=3)
    against.set_xlabel("output torque [N·m]")
    in_time = figure.add_subplot(grid[1, 1], sharey=against)
    when = data.time - data.time[0] if data.time is not None else np.arange(data.torque.size)
    in_time.plot(when, calibration.residual * fine, ".", ms=3)
    in_time.set_xlabel("time [s]" if data.time is not None else "row of the file")
    for axes in (against, in_time):
        axes.axhline(0.0, color="k", lw=0.7)
        axes.grid(alpha=0.3)
    against.set_ylabel(f"residual [{small.replace('*', '·')}]")
    return figure


def posterior_figure(calibration: Calibration, posterior: Posterior) -> Figure:
    """Draws of all pairs of unknowns, with the least-squares estimate.

    Parameters
    ----------
    calibration : Calibration
        The least-squares fit.
    posterior : Posterior
        Draws.

    Returns
    -------
    Figure
        A triangle of panels.
    """
    from matplotlib.figure import Figure

    unknowns = calibration.model.unknowns
    count = len(unknowns)
    values = [
        np.array([from_si(float(v), unit_of(u.path)) for v in u.from_unit(posterior.places[:, i])])
        for i, u in enumerate(unknowns)
    ]
    figure = Figure(figsize=(2.4 * count + 1.0, 2.2 * count + 0.6), layout="constrained")
    for row in range(count):
        for column in range(row + 1):
            axes = figure.add_subplot(count, count, row * count + column + 1)
            if row == column:
                axes.hist(values[row], bins=40, color="C0")
                axes.axvline(
                    from_si(calibration.estimates[row].value, unit_of(unknowns[row].path)), color="C3"
                )
                axes.set_yticks([])
            else:
                axes.plot(values[column], values[row], ",", color="C0", alpha=0.5)
            if row == count - 1:
                axes.set_xlabel(_label(unknowns[column].path), fontsize="small")
            if column == 0 and row:
                axes.set_ylabel(_label(unknowns[row].path), fontsize="small")
            axes.tick_params(labelsize="x-small")
    figure.suptitle("posterior (line: least squares)", fontsize="medium")
    return figure


def unit_of(path: str) -> str:
    """Unit in which an unknown is shown.

    Parameters
    ----------
    path : str
        Its name.

    Returns
    -------
    str
        A unit of :mod:`asperity.units`.
    """
    from asperity.case.values import key_at

    kind = path.partition(" ")[0]
    shown = {"play": "arcmin", "offset": "arcmin", "drift": "arcmin/min", "play_torque": "N*m"}
    return shown[kind] if kind in CURVE_UNKNOWNS else key_at(path).unit


def _label(path: str) -> str:
    unit = unit_of(path)
    tail = path.rsplit(".", 1)[-1].replace("_", " ")
    return f"{tail} [{'–' if unit == '1' else unit.replace('*', '·')}]"
