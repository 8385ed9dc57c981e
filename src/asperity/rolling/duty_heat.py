"""Temperatures of a joint under a duty: of its mean losses, of each load alone, and the highest one of its course."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from asperity.rolling.heat import HeatFlow

#: Places between which a steady temperature is looked for, and samples of the temperature under each load.
_PLACES, _SAMPLES = 2000, 60
_TOLERANCE = 1e-8
#: Temperature that stands for one beyond every limit [degC].
_HOT = 1e6

Losses = Callable[[float], float]


@dataclass(frozen=True)
class DutyHeat:
    """Temperatures of the rollers of one joint under its duty [degC].

    ``mean``: that at which the mean losses leave; ``alone``: the steady one of each load if it lasted; nan where none
    is steady. ``peak``: the highest one of the duty that repeats, infinite where it passes the limit of the oil, nan
    where heat capacities or the time of the duty are not known.
    """

    mean: float
    alone: tuple[float, ...]
    peak: float


def duty_heat(
    flow: HeatFlow, rollers: np.ndarray, losses: np.ndarray, shares: np.ndarray, rollers_capacity: float
) -> DutyHeat:
    """Temperatures under a duty.

    Parameters
    ----------
    flow : HeatFlow
        How heat leaves the joint; of numbers.
    rollers : ndarray
        Temperatures of the rollers from the surroundings to the limit of the oil, shape (n,) [degC].
    losses : ndarray
        Losses under each load at them, shape (loads, n), nan where the joint does not roll [W].
    shares : ndarray
        Shares of the time, shape (loads,) [-].
    rollers_capacity : float
        Heat capacity of the rollers [J/K]; nan where it is not known.

    Returns
    -------
    DutyHeat
        Temperatures.

    Notes
    -----
    In the course of the duty the losses are those at the temperature of the rollers, with a housing as warm as in a
    steady state; between the temperatures given by a cubic spline.

    References
    ----------
    Equation (H2) of :doc:`/equations`.
    """
    each = [_curve(rollers, one) for one in losses]
    mean = _steady(flow, _curve(rollers, shares @ losses))
    alone = tuple(_steady(flow, one) for one in each)
    known = flow.duty_time is not None and flow.heat_capacity is not None and math.isfinite(rollers_capacity)
    peak = math.nan
    if known and math.isfinite(mean):
        peak = _peak(flow, each, shares * float(flow.duty_time), rollers_capacity, mean)  # type: ignore[arg-type]
    return DutyHeat(mean, alone, peak)


def _curve(rollers: np.ndarray, losses: np.ndarray) -> Losses:
    """Losses over the temperature up to the first one at which they are not known; nan beyond it."""
    from scipy.interpolate import CubicSpline  # a joint without a duty starts sooner

    known = np.flatnonzero(~np.isfinite(losses))
    count = int(known[0]) if known.size else rollers.size
    if count < 2:
        return lambda _: math.nan
    spline = CubicSpline(rollers[:count], losses[:count])
    end = float(rollers[count - 1])
    return lambda at: float(spline(at)) if at <= end else math.nan


def _steady(flow: HeatFlow, losses: Losses) -> float:
    """The lowest stable temperature of losses; nan where there is none."""
    from scipy.optimize import brentq

    def excess(at: float) -> float:
        return float(flow.to_rollers) * losses(at) - (at - float(flow.ambient))

    places = np.linspace(float(flow.ambient), float(flow.oil_limit), _PLACES)
    found = np.array([excess(at) for at in places])
    falls = np.flatnonzero((found[:-1] >= 0.0) & (found[1:] <= 0.0) & (found[:-1] > found[1:]))
    if not falls.size:
        return math.nan
    return float(brentq(excess, places[falls[0]], places[falls[0] + 1]))


def _peak(
    flow: HeatFlow, losses: list[Losses], times: np.ndarray, rollers_capacity: float, start: float
) -> float:
    """The highest temperature of the rollers under loads that repeat; infinite beyond the limit of the oil."""
    from scipy.integrate import solve_ivp
    from scipy.optimize import root

    ambient, to_housing = float(flow.ambient), float(flow.roller_resistance)
    outward, housing_capacity = float(flow.resistance), float(flow.heat_capacity or 0.0)
    one_node = to_housing == 0.0

    def change(losses: Losses, state: np.ndarray) -> list[float]:
        """How fast the temperatures of rollers and housing rise [K/s]."""
        if one_node:
            lost = losses(state[0]) - (state[0] - ambient) / outward
            return [lost / (housing_capacity + rollers_capacity)]
        between = (state[0] - state[1]) / to_housing
        return [
            (losses(state[0]) - between) / rollers_capacity,
            (between - (state[1] - ambient) / outward) / housing_capacity,
        ]

    def course(state: np.ndarray) -> tuple[np.ndarray, float]:
        """State after one pass, and the highest temperature of the rollers on the way; hot where that has no end."""
        if not np.all(np.isfinite(state)):
            return np.full_like(first, _HOT), math.inf
        highest = float(state[0])
        for curve, time in zip(losses, times, strict=True):
            done = solve_ivp(
                lambda _, at, curve=curve: change(curve, at),
                (0.0, time),
                state,
                method="LSODA",
                t_eval=np.linspace(0.0, time, _SAMPLES),
                rtol=_TOLERANCE,
                atol=1e-6,
            )
            if not done.success or not np.all(np.isfinite(done.y)):
                return np.full_like(first, _HOT), math.inf
            highest = max(highest, float(done.y[0].max()))
            state = done.y[:, -1]
        return state, highest

    first = np.array([start] if one_node else [start, float(flow.housing_at(start))])
    found = root(lambda state: course(state)[0] - state, first, tol=1e-9)
    if not found.success:
        return math.inf
    highest = course(found.x)[1]
    return highest if highest <= float(flow.oil_limit) else math.inf
