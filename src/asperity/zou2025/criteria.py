"""The paper's qualitative terms as numbers, the measures that are compared with them, and verdicts.

The paper says "slightly", "significantly", "nearly the same" without numbers. The numbers here are ours. Every verdict
is printed with its number and the measured value, so that a reader can apply a different limit.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass

import numpy as np

from asperity.types import Document


@dataclass(frozen=True)
class Criterion:
    """A qualitative term of the paper as a number in its unit, ``-`` for none, and the rule in words."""

    name: str
    limit: float
    meaning: str
    unit: str = "-"


NONLINEAR = Criterion(
    "nonlinear",
    0.20,
    "the mean slopes over the first and the last tenth of the range differ by at least 20 % of the steeper slope",
)
SLIGHT = Criterion(
    "slightly, weakly, limited",
    0.20,
    "over the whole range the value changes by less than 20 % of its first value",
)
SIGNIFICANT = Criterion(
    "significantly", 0.20, "over the whole range the value changes by at least 20 % of its first value"
)
NEARLY_SAME = Criterion("nearly the same", 0.10, "two values differ by at most 10 % of the larger value")
PEAK_NEAR = Criterion("peak near D", 0.02, "the maximum lies within 0.02 of the stated fractal dimension")
TENDENCY = Criterion("tends to", 0.80, "the trend holds over at least 80 % of the range")
SATURATED = Criterion(
    "saturates",
    0.75,
    "beyond the range of the figure, each doubling of the abscissa adds at most 75 % of what the previous doubling "
    "added (a limit approached as 1/x: 50 %; a logarithm: 100 %; any power law: more)",
)
OPTIMAL = Criterion("optimal", 0.90, "at least 90 % of the maximum everywhere")

#: All criteria in the order in which they are printed.
CRITERIA = (NONLINEAR, SLIGHT, SIGNIFICANT, NEARLY_SAME, PEAK_NEAR, TENDENCY, SATURATED, OPTIMAL)


def rises(values: np.ndarray) -> bool:
    """Whether curves of shape (..., n) increase at every step along the last axis."""
    return bool(np.all(np.diff(values, axis=-1) > 0.0))


def falls(values: np.ndarray) -> bool:
    """Whether curves of shape (..., n) decrease at every step along the last axis."""
    return bool(np.all(np.diff(values, axis=-1) < 0.0))


def rising_share(values: np.ndarray) -> np.ndarray:
    """Share of the steps along the last axis at which curves of shape (..., n) increase [-]."""
    return np.asarray(np.mean(np.diff(values, axis=-1) > 0.0, axis=-1))


def relative_change(values: np.ndarray) -> np.ndarray:
    """Last minus first value of curves of shape (..., n), relative to the first [-]."""
    first, last = values[..., 0], values[..., -1]
    return np.asarray((last - first) / first)


def relative_difference(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Difference of two positive quantities, relative to the larger [-]."""
    return np.asarray(np.abs(one - other) / np.maximum(one, other))


def slope_change(abscissa: np.ndarray, values: np.ndarray) -> float:
    """Difference between the mean slopes over the first and the last tenth of a range, relative to the steeper [-].

    0 for a straight line, 1 if one end is flat, above 1 if the slope changes sign.

    Examples
    --------
    >>> x = np.linspace(0.0, 1.0, 11)
    >>> round(slope_change(x, x**2), 4)  # slopes 0.1 and 1.9
    0.9474
    """
    tenth = 0.1 * (abscissa[-1] - abscissa[0])
    start, stop = np.interp([abscissa[0] + tenth, abscissa[-1] - tenth], abscissa, values)
    first, last = start - values[0], values[-1] - stop
    return float(abs(last - first) / max(abs(first), abs(last)))


def peak(abscissa: np.ndarray, values: np.ndarray) -> float:
    """Abscissa of the maximum of an evenly spaced curve, of the parabola through its highest sample and neighbours.

    Exactly an end of the range if the curve is highest there.

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


def growth_per_doubling(values: np.ndarray) -> np.ndarray:
    """Growth from 2x to 4x (the last axis has x, 2x and 4x) over the growth from x to 2x [-].

    0.5 for an approach to a limit as 1/x, 1 for a logarithm, :math:`2^p` for a power p.

    Examples
    --------
    >>> [round(float(growth_per_doubling(f)), 6) for f in (1 - 1 / np.array([1, 2, 4]), np.log([1, 2, 4]))]
    [0.5, 1.0]
    """
    first, second = values[..., 1] - values[..., 0], values[..., 2] - values[..., 1]
    return np.asarray(second / first)


def interval_above(abscissa: np.ndarray, values: np.ndarray, share: float) -> tuple[float, float]:
    """Interval around the maximum in which a curve is at least a given share of the maximum."""
    level = share * float(np.max(values))
    top = int(np.argmax(values))
    low, high = float(abscissa[0]), float(abscissa[-1])
    below = np.flatnonzero(values < level)
    if np.any(below < top):
        i = below[below < top][-1]
        low = float(np.interp(level, values[[i, i + 1]], abscissa[[i, i + 1]]))
    if np.any(below > top):
        i = below[below > top][0]
        high = float(np.interp(level, values[[i, i - 1]], abscissa[[i, i - 1]]))
    return low, high


@dataclass(frozen=True)
class Statement:
    """One statement of a claim in our words, compared with computed numbers.

    ``met``: whether the equations confirm it; ``evidence``: the computed numbers in a sentence, with units;
    ``numbers``, for programs: name with unit → value.
    """

    says: str
    met: bool
    evidence: str
    numbers: dict[str, float]


@dataclass(frozen=True)
class Claim:
    """A claim of the paper; it is met if every one of its statements is met.

    Its name is C1 … C13, or ``window``; ``panels`` are those of the figures that show it.
    """

    name: str
    title: str
    panels: tuple[str, ...]
    statements: tuple[Statement, ...]

    @property
    def met(self) -> bool:
        """True if every statement is met."""
        return all(statement.met for statement in self.statements)

    def as_dict(self) -> Document:
        """``name``, ``title``, ``panels``, ``met`` and ``statements`` of the claim as plain data for JSON."""
        return {
            "name": self.name,
            "title": self.title,
            "panels": list(self.panels),
            "met": self.met,
            "statements": [asdict(statement) for statement in self.statements],
        }
