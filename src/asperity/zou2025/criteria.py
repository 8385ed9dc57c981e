"""What the paper's words mean here: one number for each, and the measures that are held against them.

The paper says "slightly", "significantly", "nearly the same" without numbers. The numbers below are ours; they are
printed with every verdict, beside the measured value, so that whoever reads them otherwise can judge for himself.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Criterion:
    """A word of the paper made a number.

    Parameters
    ----------
    name : str
        Name of the criterion.
    limit : float
        The number.
    unit : str
        Its unit, ``-`` for none.
    meaning : str
        The rule, for people.
    """

    name: str
    limit: float
    unit: str
    meaning: str


NONLINEAR = Criterion(
    "nonlinear", 0.01, "-", "the curve leaves the chord of its end points by at least 1 % of its total change"
)
SLIGHT = Criterion(
    "slightly, weakly, limited",
    0.20,
    "-",
    "the whole range changes the value by less than 20 % of where it starts",
)
SIGNIFICANT = Criterion(
    "significantly", 0.20, "-", "the whole range changes the value by at least 20 % of where it starts"
)
NEARLY_SAME = Criterion("nearly the same", 0.10, "-", "two values differ by at most 10 % of the larger")
PEAK_NEAR = Criterion(
    "peak near D", 0.02, "-", "the maximum lies within 0.02 of the stated fractal dimension"
)
TENDENCY = Criterion("tends to", 0.80, "-", "it does so over at least 80 % of the range")
SATURATED = Criterion(
    "saturates", 0.10, "-", "the slope at the end is at most 10 % of the slope at the start of the range"
)
OPTIMAL = Criterion("optimal", 0.90, "-", "everywhere at least 90 % of the maximum")

#: Every criterion, in the order in which it is shown.
CRITERIA = (NONLINEAR, SLIGHT, SIGNIFICANT, NEARLY_SAME, PEAK_NEAR, TENDENCY, SATURATED, OPTIMAL)


def rises(values: np.ndarray) -> bool:
    """Whether every step along the last axis goes up.

    Parameters
    ----------
    values : ndarray
        Curves, shape (..., n).

    Returns
    -------
    bool
    """
    return bool(np.all(np.diff(values, axis=-1) > 0.0))


def falls(values: np.ndarray) -> bool:
    """Whether every step along the last axis goes down.

    Parameters
    ----------
    values : ndarray
        Curves, shape (..., n).

    Returns
    -------
    bool
    """
    return bool(np.all(np.diff(values, axis=-1) < 0.0))


def relative_change(values: np.ndarray) -> np.ndarray:
    """Change along the last axis from its first to its last value, relative to the first.

    Parameters
    ----------
    values : ndarray
        Curves, shape (..., n).

    Returns
    -------
    ndarray
        Shape (...) [-].
    """
    first, last = values[..., 0], values[..., -1]
    return np.asarray((last - first) / first)


def departure_from_chord(abscissa: np.ndarray, values: np.ndarray) -> float:
    """Largest distance of a curve from the chord of its end points, relative to its total change.

    Parameters
    ----------
    abscissa, values : ndarray
        The curve, shape (n,).

    Returns
    -------
    float
        0 for a straight line [-].

    Examples
    --------
    >>> departure_from_chord(np.array([0.0, 1.0, 2.0]), np.array([0.0, 1.0, 4.0]))
    0.25
    """
    chord = np.interp(abscissa, abscissa[[0, -1]], values[[0, -1]])
    return float(np.max(np.abs(values - chord)) / abs(values[-1] - values[0]))


def peak(abscissa: np.ndarray, values: np.ndarray) -> float:
    """Where a curve has its maximum: the vertex of the parabola through the highest sample and its neighbours.

    Parameters
    ----------
    abscissa, values : ndarray
        The curve, shape (n,), evenly spaced.

    Returns
    -------
    float
        The place; an end of the range, exactly, where the curve is highest there.

    Examples
    --------
    >>> round(peak(np.array([1.0, 2.0, 3.0]), np.array([0.0, 1.0, 0.5])), 4)
    2.1667
    """
    top = int(np.argmax(values))
    if top in (0, values.size - 1):
        return float(abscissa[top])
    below, at, above = values[top - 1 : top + 2]
    step = abscissa[top + 1] - abscissa[top]
    return float(abscissa[top] + 0.5 * step * (below - above) / (below - 2.0 * at + above))


def relative_difference(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Difference of two positive quantities over the larger.

    Parameters
    ----------
    one, other : ndarray
        Values of one shape.

    Returns
    -------
    ndarray
        [-].
    """
    return np.asarray(np.abs(one - other) / np.maximum(one, other))


def rising_share(values: np.ndarray) -> np.ndarray:
    """Share of the steps along the last axis that go up.

    Parameters
    ----------
    values : ndarray
        Curves, shape (..., n).

    Returns
    -------
    ndarray
        Shape (...) [-].
    """
    return np.asarray(np.mean(np.diff(values, axis=-1) > 0.0, axis=-1))


def slope_ratio(abscissa: np.ndarray, values: np.ndarray) -> float:
    """Slope at the end of a curve over the slope at its start, each over a tenth of the range.

    Parameters
    ----------
    abscissa, values : ndarray
        The curve, shape (n,).

    Returns
    -------
    float
        Below 1 where the curve levels off [-].
    """
    tenth = 0.1 * (abscissa[-1] - abscissa[0])
    start, stop = np.interp([abscissa[0] + tenth, abscissa[-1] - tenth], abscissa, values)
    return float((values[-1] - stop) / (start - values[0]))


def interval_above(abscissa: np.ndarray, values: np.ndarray, share: float) -> tuple[float, float]:
    """The interval around the maximum where a curve is at least a share of it.

    Parameters
    ----------
    abscissa, values : ndarray
        The curve, shape (n,), with one maximum.
    share : float
        The share [-].

    Returns
    -------
    tuple of float
        Lower and upper end, linearly interpolated; the end of the range where the curve stays above.
    """
    level = share * float(np.max(values))
    top = int(np.argmax(values))
    low, high = float(abscissa[0]), float(abscissa[-1])
    under = np.flatnonzero(values[:top] < level)
    if under.size:
        i = under[-1]
        low = float(np.interp(level, values[i : i + 2], abscissa[i : i + 2]))
    under = np.flatnonzero(values[top:] < level)
    if under.size:
        i = top + under[0]
        high = float(np.interp(level, values[[i, i - 1]], abscissa[[i, i - 1]]))
    return low, high
