"""What a measured curve says against itself: an angle of the wrong sign, a turn too much, how much it scatters."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.study.calibration.measurement import Measurement
from asperity.study.calibration.torque_history import History
from asperity.units import format_quantity

#: Standard errors by which a curve must fall before its sign counts as wrong.
CERTAIN_FALL = 3.0
#: Jump of the angle between neighbouring rows that no joint makes: half a turn [rad].
LARGEST_JUMP = math.pi
#: Fewest pseudo-residuals from which a scatter is told.
FEWEST = 4
# share of the largest angle below which a fall is rounding
_ROUNDING = 1e-9


@dataclass(frozen=True)
class Scatter:
    """How much a curve scatters about any smooth one: standard ``deviation``, and the degrees of ``freedom`` of it."""

    deviation: float
    freedom: float


def refuse_curves(measurements: tuple[Measurement, ...], *, unknown_count: int, history: History) -> None:
    """Raise an ``InputError`` if curves cannot be fitted: too few rows, wrong signs, or a history that they lack."""
    if all(measurement.drift is not None for measurement in measurements) and history != "virgin":
        raise InputError(
            "a drift curve has no history, because each torque is held while the joint turns; use 'virgin', the default"
        )
    for measurement in measurements:
        refuse_turns(measurement)
        refuse_wrong_signs(measurement)
    rows = sum(measurement.torque.size for measurement in measurements)
    few = min(measurements, key=lambda measurement: measurement.torque.size)
    if len(measurements) > 1 and few.torque.size <= unknown_count:
        raise InputError(
            f"{few.source}: {few.torque.size} rows beside {unknown_count} unknowns: how much such a curve scatters "
            "cannot be told from what the fit leaves of it; each of several curves needs more rows than there are "
            "unknowns"
        )
    if rows <= unknown_count:
        raise InputError(
            f"{rows} rows cannot determine {unknown_count} unknowns; more rows than unknowns are needed"
        )


def refuse_wrong_signs(measurement: Measurement) -> None:
    """Raise an ``InputError`` if the angle or the drift of a curve falls as the torque rises.

    Its slope over the torque, beside an offset of each repetition and a drift over time, must not be negative by more
    than :data:`CERTAIN_FALL` standard errors.
    """
    if measurement.stiffness is not None:
        return
    slope, error = _slope(measurement)
    fall = -slope * float(np.ptp(measurement.torque))
    rounding = _ROUNDING * float(np.max(np.abs(measurement.measured)))
    if slope < -CERTAIN_FALL * error and fall > rounding:
        low, high = (format_quantity(end, "N*m", 3) for end in _ends(measurement.torque))
        by = format_quantity(fall, measurement.quantity.unit, 3)
        raise InputError(
            f"{measurement.source}: the {'drift' if measurement.drift is not None else 'angle'} falls as the torque "
            f"rises, by {by} from {low} to {high}; change the sign of one column"
        )


def _ends(torque: NDArray[np.float64]) -> tuple[float, float]:
    return float(np.min(torque)), float(np.max(torque))


def _slope(measurement: Measurement) -> tuple[float, float]:
    """Slope of a curve over its torque with its standard error; the error is 0 of two rows [rad/(N·m)]."""
    torque, angle = measurement.torque, measurement.measured
    offsets = (measurement.repetition[:, None] == np.unique(measurement.repetition)).astype(float)
    design = np.column_stack([torque / max(float(np.max(np.abs(torque))), 1e-300), offsets])
    if measurement.time is not None and np.ptp(measurement.time) > 0.0:
        time = (measurement.time - measurement.time[0]) / np.ptp(measurement.time)
        longer = np.column_stack([design, time])
        if np.linalg.matrix_rank(longer) == longer.shape[1] < torque.size:
            design = longer
    if np.linalg.matrix_rank(design) < design.shape[1]:
        return 0.0, 0.0  # the same torque within every repetition
    solution, *_ = np.linalg.lstsq(design, angle)
    freedom = torque.size - design.shape[1]
    left = angle - design @ solution
    variance = float(left @ left) / freedom if freedom > 0 else 0.0
    error = math.sqrt(variance * float(np.linalg.inv(design.T @ design)[0, 0]))
    unit = max(float(np.max(np.abs(torque))), 1e-300)
    return float(solution[0]) / unit, error / unit


def refuse_turns(measurement: Measurement) -> None:
    """Raise an ``InputError`` if the angle jumps by half a turn or more between neighbouring rows of a repetition."""
    if measurement.angle is None:
        return
    steps = np.where(np.diff(measurement.repetition) == 0.0, np.diff(measurement.angle), 0.0)
    if not np.any(np.abs(steps) > LARGEST_JUMP):
        return
    row = int(np.argmax(np.abs(steps) > LARGEST_JUMP))
    turns = round(abs(steps[row]) / (2.0 * math.pi))
    near = turns > 0 and abs(abs(steps[row]) - 2.0 * math.pi * turns) < 0.1 * math.pi
    count = "a turn" if turns == 1 else f"{turns} turns"
    raise InputError(
        f"{measurement.source}: from {measurement.place(row)} to {measurement.place(row + 1)} the angle jumps by "
        f"{format_quantity(float(steps[row]), 'deg', 5)}"
        + (
            f", {count}: the sensor counts anew there; {'add' if steps[row] < 0.0 else 'take'} "
            f"{360 * turns} deg {'to' if steps[row] < 0.0 else 'from'} the rows from there on"
            if near
            else ", which no joint does; check these rows and the unit of the column"
        )
    )


def own_scatter(
    *,
    values: NDArray[np.float64],
    torque: NDArray[np.float64],
    repetition: NDArray[np.float64],
    in_order: bool,
) -> Scatter | None:
    r"""The scatter of a curve from its second differences, in which any smooth course cancels.

    .. math::
        s^2 = \frac1m \sum_i \frac{(a_i y_{i-1} + b_i y_{i+1} - y_i)^2}{a_i^2 + b_i^2 + 1}, \qquad
        a_i = \frac{T_{i+1} - T_i}{T_{i+1} - T_{i-1}}, \quad b_i = 1 - a_i

    Parameters
    ----------
    values : ndarray
        y: the curve, or what a fit leaves of it, shape (points,).
    torque : ndarray
        T, shape (points,) [N·m].
    repetition : ndarray
        Number of the repetition of each row, shape (points,).
    in_order : bool
        Whether the order of the rows counts, as it does where there is hysteresis; otherwise neighbours are those in
        torque.

    Returns
    -------
    Scatter or None
        The standard deviation s, in the unit of y, with 18 m/35 degrees of freedom, since neighbouring terms share
        points; None where fewer than :data:`FEWEST` rows lie between two of their branch.

    Notes
    -----
    The rows of a term are of one repetition and on one branch of the torque. What curves within two rows adds to s, so
    that s is rather too large; errors that are alike in neighbouring rows do not count.

    References
    ----------
    T. Gasser, L. Sroka and C. Jennen-Steinmetz, Biometrika 73 (1986) 625.
    """
    order = np.arange(torque.size) if in_order else np.lexsort((torque, repetition))
    y, t, r = values[order], torque[order], repetition[order]
    before, after = np.diff(t)[:-1], np.diff(t)[1:]
    alike = (r[:-2] == r[2:]) & (r[:-2] == r[1:-1])
    inside = alike & (before * after >= 0.0)
    width = before + after
    b = np.where(width == 0.0, 0.5, before / np.where(width == 0.0, 1.0, width))
    a = 1.0 - b
    squares = (a * y[:-2] + b * y[2:] - y[1:-1]) ** 2 / (a**2 + b**2 + 1.0)
    count = int(np.count_nonzero(inside))
    if count < FEWEST:
        return None
    return Scatter(math.sqrt(float(np.mean(squares[inside]))), 18.0 * count / 35.0)
