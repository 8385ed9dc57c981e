"""Plots of calibrations: data and fit, residuals, and the posterior."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.study.calibration.calibrate import Calibration
from asperity.study.calibration.fitted_curve import FittedCurve
from asperity.study.calibration.posterior import Posterior
from asperity.study.calibration.unknowns import unit_of
from asperity.units import from_si

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure


def calibration_figure(calibration: Calibration) -> Figure:
    """Measured and fitted curve above their difference, over the torque and in the order of time."""
    from matplotlib.figure import Figure

    count = len(calibration.curves)
    figure = Figure(figsize=(9.0, 7.0 * count), layout="constrained")
    for part, curve in zip(figure.subfigures(count, 1, squeeze=False)[:, 0], calibration.curves, strict=True):
        _draw_curve(part, curve)
    return figure


def _draw_curve(figure: SubFigure, fitted: FittedCurve) -> None:
    data = fitted.measurement
    unit, small = data.quantity.unit, data.quantity.fine_unit
    factor = from_si(1.0, unit)
    fine = from_si(1.0, small)
    label = unit.replace("*", "·")
    grid = figure.add_gridspec(2, 2, height_ratios=[2.0, 1.0])
    curve = figure.add_subplot(grid[0, :])
    order = np.arange(data.torque.size) if data.angle is not None else np.argsort(data.torque)
    for index, repetition in enumerate(np.unique(data.repetition)):
        mine = data.repetition == repetition
        text = f"measured, repetition {repetition:g}" if np.unique(data.repetition).size > 1 else "measured"
        curve.plot(data.torque[mine], data.measured[mine] * factor, ".", ms=3, color=f"C{index}", label=text)
    curve.plot(data.torque[order], fitted.prediction[order] * factor, "-", color="k", lw=0.9, label="fit")
    curve.set_xlabel("output torque [N·m]")
    curve.set_ylabel(f"{data.quantity.name} [{label}]")
    curve.legend(fontsize="small")
    curve.grid(alpha=0.3)
    curve.set_title(
        f"residual {fitted.standard_deviation * fine:.3g} {small.replace('*', '·')} (standard deviation), "
        f"Durbin–Watson {fitted.durbin_watson:.2f}",
        fontsize="medium",
    )
    against = figure.add_subplot(grid[1, 0])
    against.plot(data.torque, fitted.residual * fine, ".", ms=3)
    against.set_xlabel("output torque [N·m]")
    in_time = figure.add_subplot(grid[1, 1], sharey=against)
    when = data.time - data.time[0] if data.time is not None else np.arange(data.torque.size)
    in_time.plot(when, fitted.residual * fine, ".", ms=3)
    in_time.set_xlabel("time [s]" if data.time is not None else "row of the file")
    for axes in (against, in_time):
        axes.axhline(0.0, color="k", lw=0.7)
        axes.grid(alpha=0.3)
    against.set_ylabel(f"residual [{small.replace('*', '·')}]")


def posterior_figure(calibration: Calibration, posterior: Posterior) -> Figure:
    """Draws of each unknown with the least-squares interval, of all pairs, and their correlations."""
    from matplotlib.colors import TwoSlopeNorm
    from matplotlib.figure import Figure
    from matplotlib.ticker import MaxNLocator
    from scipy.stats import rankdata

    unknowns = calibration.unknowns
    count = len(unknowns)
    factors = [from_si(1.0, unit_of(u.path)) for u in unknowns]
    values = [u.from_unit(posterior.scaled_values[:, i]) * factors[i] for i, u in enumerate(unknowns)]
    correlations = np.atleast_2d(np.corrcoef([rankdata(draws) for draws in values]))
    limits = [
        _limits(v, np.array([e.value, e.lower, e.upper]) * f)
        for v, e, f in zip(values, calibration.estimates, factors, strict=True)
    ]
    figure = Figure(figsize=(2.1 * count + 1.6, 2.0 * count + 1.2), layout="constrained")
    panels = figure.subplots(count, count, squeeze=False, sharex="col")
    shades = TwoSlopeNorm(0.0, -1.0, 1.0)
    for row in range(count):
        for column in range(count):
            axes = panels[row, column]
            if row == column:
                _marginal(axes, calibration, row, values[row], factors[row], posterior.note(row))
            elif row > column:
                axes.plot(
                    values[column], values[row], ".", ms=1.5, mew=0.0, color="C0", alpha=0.4, rasterized=True
                )
                axes.plot(
                    calibration.estimates[column].value * factors[column],
                    calibration.estimates[row].value * factors[row],
                    "+",
                    color="C3",
                )
                axes.set_ylim(*limits[row])
                axes.yaxis.set_major_locator(MaxNLocator(4))
            else:
                value = float(correlations[row, column])
                axes.set_facecolor(_colour(shades(value)))
                axes.text(
                    0.5,
                    0.5,
                    f"{value:+.2f}".replace("-", "−"),
                    ha="center",
                    va="center",
                    transform=axes.transAxes,
                )
                axes.set_yticks([])
            axes.set_xlim(*limits[column])
            axes.xaxis.set_major_locator(MaxNLocator(3))
            axes.tick_params(labelsize="x-small")
            axes.tick_params(axis="x", labelrotation=30.0, bottom=row >= column)
            if column and row != column:
                axes.tick_params(labelleft=False)
            if row == count - 1:
                axes.set_xlabel(_label(unknowns[column].path), fontsize="small")
            if column == 0 and row:
                axes.set_ylabel(_label(unknowns[row].path), fontsize="small")
    figure.align_ylabels()
    figure.suptitle(
        f"posterior, {len(posterior.scaled_values)} draws: 95 % shaded; red: least squares with its 95 % interval; "
        "above the diagonal: rank correlation",
        fontsize="medium" if count > 3 else "x-small",
        wrap=True,
    )
    return figure


def _marginal(
    axes: Axes, calibration: Calibration, index: int, values: np.ndarray, factor: float, note: str
) -> None:
    """Histogram with the middle 95 % shaded, the least-squares estimate, and its interval as a bar above."""
    estimate = calibration.estimates[index]
    low, high = np.quantile(values, (0.025, 0.975))
    axes.hist(values, bins=40, range=(values.min(), values.max()), density=True, color="C0", alpha=0.35)
    inside = values[(values >= low) & (values <= high)]
    weights = np.full(inside.size, 40.0 / (np.ptp(values) * values.size)) if np.ptp(values) else None
    axes.hist(inside, bins=40, range=(values.min(), values.max()), weights=weights, color="C0")
    top = axes.get_ylim()[1]
    axes.set_ylim(0.0, 1.25 * top)
    if estimate.determined:
        axes.plot([estimate.lower * factor, estimate.upper * factor], [1.1 * top] * 2, "|-", color="C3")
    else:
        axes.text(0.97, 0.8, "no interval by\nleast squares", ha="right", va="top", color="C3",
                  fontsize="xx-small", transform=axes.transAxes)  # fmt: skip
    axes.plot(estimate.value * factor, 1.1 * top, "o", ms=4, color="C3")
    if note:
        axes.text(0.97, 0.82, note, ha="right", va="top", fontsize="xx-small", transform=axes.transAxes)
    axes.set_yticks([])


def _limits(values: np.ndarray, squares: np.ndarray) -> tuple[float, float]:
    """Range of the draws and of the least-squares interval, of which no more than as much again on each side."""
    low, high = float(values.min()), float(values.max())
    width = (high - low) or 1e-3 * max(abs(low), 1e-30)
    low, high = max(np.nanmin([low, *squares]), low - width), min(np.nanmax([high, *squares]), high + width)
    return low - 0.04 * (high - low), high + 0.04 * (high - low)


def _colour(shade: float) -> tuple[float, float, float, float]:
    from matplotlib import colormaps

    red, green, blue, _ = colormaps["RdBu_r"](shade)
    return (0.5 + 0.5 * red, 0.5 + 0.5 * green, 0.5 + 0.5 * blue, 1.0)


def _label(path: str) -> str:
    """Full name of an unknown and its unit, on two lines."""
    unit = unit_of(path)
    words = path.replace(".", ",\n").replace("_", " ")
    return f"{words} [{'–' if unit == '1' else unit.replace('*', '·')}]"
