"""Traction of a film as it was measured: a curve over the slide-roll ratio, or values over conditions."""

from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np

from asperity.contact.creep_bounds import bounded_stress, elliptic_stress
from asperity.engine.arrays import xp
from asperity.engine.module import Module
from asperity.types import Array, Real

if TYPE_CHECKING:
    from asperity.contact.fluid import Film
    from asperity.contact.viscosity import Viscosity

#: Rounds in which the exponents of a curve settle, and how far they still move then.
_MOST_ROUNDS, _SETTLED = 400, 1e-10


class TractionConditions(Module):
    """Conditions under which traction was measured, all combinations of them, in rising order. SI units.

    Parameters
    ----------
    pressures, temperatures, speeds : tuple of Real
        Peak pressures [Pa], temperatures of the oil [K] and mean speeds of the surfaces [m/s]; one or none of what did
        not vary.
    """

    pressures: tuple[Real, ...] = ()
    temperatures: tuple[Real, ...] = ()
    speeds: tuple[Real, ...] = ()

    def shares(self, pressure: Real, temperature: Real, speed: Real) -> list[Array]:
        """What each combination counts at given conditions, the speed varying fastest; together 1.

        Linear between the conditions, in the logarithm of the speed, and held beyond them.
        """
        speeds = tuple(xp.log(xp.asarray(value)) for value in self.speeds)
        axes = (
            _hats(pressure, self.pressures),
            _hats(temperature, self.temperatures),
            _hats(xp.log(xp.asarray(speed)) if len(speeds) > 1 else 0.0, speeds),
        )
        return [one * two * three for one, two, three in itertools.product(*axes)]


def _hats(value: Real, nodes: tuple[Real, ...]) -> list[Array]:
    """What each of rising nodes counts at a value between them, held beyond them."""
    one = xp.asarray(1.0)
    steps = [xp.clip((value - low) / (high - low), 0.0, 1.0) for low, high in itertools.pairwise(nodes)]
    bounds = [one, *steps, xp.asarray(0.0)]
    return [before - after for before, after in itertools.pairwise(bounds)]


class TractionTable(Module):
    """A number of a data sheet over the conditions under which it holds.

    Parameters
    ----------
    conditions : TractionConditions
        Where it was measured.
    values : tuple of Real
        The number at each combination of them [-].
    """

    conditions: TractionConditions
    values: tuple[Real, ...]

    def at(self, pressure: Real, temperature: Real, speed: Real) -> Array:
        """The number at a peak pressure [Pa], a temperature [K] and a speed [m/s], [-]."""
        shares = self.conditions.shares(pressure, temperature, speed)
        return xp.asarray(sum(share * value for share, value in zip(shares, self.values, strict=True)))


class TractionCurve(Module):
    """Traction coefficient of surfaces that slip evenly over the creepage, smooth between its points.

    Parameters
    ----------
    logarithms : tuple of Real
        Logarithms of the creepages in rising order [-].
    heights, slopes : tuple of Real
        Logarithms of the coefficients there, and their slopes over those of the creepage [-].
    """

    logarithms: tuple[Real, ...]
    heights: tuple[Real, ...]
    slopes: tuple[Real, ...]

    def at(self, logarithm: Array) -> tuple[Array, Array]:
        """Logarithm of the coefficient at the logarithm of a creepage, and its slope over that, [-].

        Below the first point with its slope, from 0 to 1; beyond the last one constant.
        """
        x, y, m = (_column(numbers, logarithm) for numbers in (self.logarithms, self.heights, self.slopes))
        width, rise = x[1:] - x[:-1], y[1:] - y[:-1]
        inside = xp.clip((logarithm - x[:-1]) / width, 0.0, 1.0)
        linear, last = width * m[:-1], width * m[1:]
        square, cube = 3.0 * rise - 2.0 * linear - last, linear + last - 2.0 * rise
        climbed = inside * (linear + inside * (square + inside * cube))
        steep = (linear + inside * (2.0 * square + 3.0 * inside * cube)) / width
        here = (logarithm >= x[:-1]) & (logarithm < x[1:])
        first, start = xp.clip(m[0], 0.0, 1.0), x[0]
        height = y[0] + climbed.sum(axis=0) + first * xp.minimum(logarithm - start, 0.0)
        return height, xp.where(here, steep, 0.0).sum(axis=0) + xp.where(logarithm < start, first, 0.0)


def _column(numbers: tuple[Real, ...], of: Array) -> Array:
    """Numbers before the axes of an array."""
    column: Array = xp.stack([xp.asarray(number) for number in numbers])
    return column.reshape(-1, *(1 for _ in xp.shape(of)))


class MeasuredTraction(Module):
    r"""Traction of a film by curves that were measured, :math:`\tau_f(x) = \mu(\xi; p_0, T, V)\,p(x)`.

    What the film yields elastically is in the curves: in steady rolling it grows with the traction as slow flow does,
    and no curve tells one from the other.

    Parameters
    ----------
    conditions : TractionConditions
        Where they were measured.
    curves : tuple of TractionCurve
        The curve at each combination of them.

    References
    ----------
    Equation (F4) of :doc:`/equations`.
    """

    conditions: TractionConditions
    curves: tuple[TractionCurve, ...]

    def stress(self, viscosity: Viscosity, film: Film) -> tuple[Array, Array]:
        """Shear stress at the places [Pa], and the slope of its logarithm over that of the slip [-].

        The temperature is that of the oil: the curves have the heat of their rig in them.
        """
        creepage = xp.log(xp.asarray(film.slip_speed / film.rolling_speed))
        shares = self.conditions.shares(film.peak_pressure, film.oil_temperature, film.rolling_speed)
        coefficient, rise = xp.zeros_like(creepage), xp.zeros_like(creepage)
        for share, curve in zip(shares, self.curves, strict=True):
            height, slope = curve.at(creepage)
            part = share * xp.exp(height)
            coefficient, rise = coefficient + part, rise + part * slope
        stress = xp.asarray(coefficient * film.pressure)
        return stress, rise / coefficient + 0.0 * stress


def traction_curve(*, creepage: np.ndarray, coefficient: np.ndarray) -> TractionCurve:
    r"""The smooth curve through points of the traction of surfaces that slip evenly.

    Monotone between the points, by cubics of :math:`\ln\mu` over :math:`\ln\xi`.

    Parameters
    ----------
    creepage : np.ndarray
        Rising creepages, shape (n,), at least two [-].
    coefficient : np.ndarray
        Positive traction coefficients there [-].

    Returns
    -------
    TractionCurve
        The curve.

    References
    ----------
    F. N. Fritsch and R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238; equation (F4) of :doc:`/equations`.
    """
    x, y = np.log(creepage), np.log(coefficient)
    return TractionCurve(*(tuple(map(float, numbers)) for numbers in (x, y, _monotone_slopes(x, y))))


def _monotone_slopes(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Slopes at points by which cubics between them are monotone where the points are."""
    chords = np.diff(y) / np.diff(x)
    slopes = np.concatenate([chords[:1], np.zeros(len(x) - 2), chords[-1:]])
    before, after, low, high = chords[:-1], chords[1:], np.diff(x)[:-1], np.diff(x)[1:]
    same = before * after > 0.0
    ones = np.where(same, before, 1.0), np.where(same, after, 1.0)
    weights = 2.0 * high + low, high + 2.0 * low
    mean = (weights[0] + weights[1]) / (weights[0] / ones[0] + weights[1] / ones[1])
    slopes[1:-1] = np.where(same, mean, 0.0)
    return slopes


def even_slip_coefficients(
    *, creepage: np.ndarray, coefficient: np.ndarray, rig_modulus: float, rig_peak_pressure: float
) -> np.ndarray:
    r"""Traction coefficients of a film between rigid discs, from those measured on elastic ones.

    .. math:: \mu(\xi) = (1 - v)\,\mu_{up} + v\,\mu_{low}, \qquad
              \mu_{up} = s\left(1 - \frac{s}{4\mu_0}\right), \qquad
              \mu_{low} = \frac{s}{\pi} \int_{-1}^{1} \arctan\frac{2\mu_0\sqrt{1-u^2}}{s}\,du, \qquad
              s = \frac{E^*}{p_0}\,\xi

    with :math:`\mu_{up} = \mu_0` for :math:`s > 2\mu_0` and :math:`v = 4n/(1 + 3n)`, :math:`n = d\ln\mu_0/d\ln\xi` in
    0..1: the law of creep of a line contact without asperities, solved for :math:`\mu_0`.

    Parameters
    ----------
    creepage : np.ndarray
        Rising slide-roll ratios of the measurement, shape (n,) [-].
    coefficient : np.ndarray
        Measured traction coefficients, each below that of the discs that stick, E* xi/p_0 [-].
    rig_modulus, rig_peak_pressure : float
        E* of the discs, and p_0 [Pa].

    Returns
    -------
    np.ndarray
        Coefficients, not below the measured ones, shape (n,) [-]; nan where they do not settle.

    References
    ----------
    Equation (F5) of :doc:`/equations`.
    """
    stick = rig_modulus / rig_peak_pressure * creepage
    even = coefficient.copy()
    for _ in range(_MOST_ROUNDS):
        found = _solved(stick, coefficient, _monotone_slopes(np.log(creepage), np.log(even)))
        moved = np.max(np.abs(np.log(found / even)))
        even = np.sqrt(even * found)
        if moved < _SETTLED:
            return found
    return np.full_like(even, np.nan)


def _solved(stick: np.ndarray, wanted: np.ndarray, exponent: np.ndarray) -> np.ndarray:
    """Even-slip coefficients by which the law of creep gives the wanted ones, all below the stick line."""
    low, high = np.log(wanted), np.log(wanted)
    while np.any(short := _of_law(stick, np.exp(high), exponent) < wanted):
        high = high + np.where(short, 1.0, 0.0)
        if np.any(high > 40.0):
            return np.full_like(wanted, np.nan)
    for _ in range(60):
        middle = 0.5 * (low + high)
        below = _of_law(stick, np.exp(middle), exponent) < wanted
        low, high = np.where(below, middle, low), np.where(below, high, middle)
    solved: np.ndarray = np.exp(0.5 * (low + high))
    return solved


def _of_law(stick: np.ndarray, even: np.ndarray, exponent: np.ndarray) -> np.ndarray:
    """Traction coefficients of elastic discs by the law of creep, from those of rigid ones.

    Stresses over the mean pressure, of which the peak is 4/pi.
    """
    mean, bodies, slope = (xp.asarray(numbers) for numbers in (even, 2.0 / math.pi * stick, exponent))
    stress = elliptic_stress(4.0 / math.pi * mean)
    return np.asarray(bounded_stress(stress=stress, mean=mean, bodies=bodies, exponent=slope).mean)
