"""Steady temperatures of a joint that turns: its losses warm it until as much heat leaves as they make."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from asperity.engine import trees
from asperity.engine.arrays import uses_jax, xp
from asperity.engine.control import scan, vectorised
from asperity.engine.derivatives import without_slopes
from asperity.engine.dual import highest_level
from asperity.engine.module import Module
from asperity.implicit import implicit_root
from asperity.types import Array, Real, Tree

#: Temperatures that are looked at, first up to the limit of the oil, then around the root.
_POINTS, _ROUNDS = 24, 2
#: Newton's steps on the cubic through four excesses around the root, from the line through the two beside it.
_STEPS = 6


class HeatFlow(Module):
    """How heat leaves a joint, and between which temperatures.

    Parameters
    ----------
    ambient : Real
        Temperature around the housing, from which the joint warms up [degC].
    resistance : Real
        Of the housing to its surroundings: how much warmer a watt makes it [K/W].
    roller_resistance : Real
        Of the rollers to the housing [K/W]; 0 where both have one temperature.
    oil_limit : Real
        Highest temperature that the oil may have [degC].
    cold_start : Real or None
        Lowest temperature at which the joint has to start [degC]; None for none.
    heat_capacity : Real or None
        Of the housing with its rings [J/K]; None where it is not known.
    duty_time : Real or None
        Time of one pass through the loads of the duty, in their order [s]; None where it is not known.
    """

    ambient: Real
    resistance: Real
    roller_resistance: Real
    oil_limit: Real
    cold_start: Real | None = None
    heat_capacity: Real | None = None
    duty_time: Real | None = None

    @property
    def to_rollers(self) -> Real:
        """Of the rollers to the surroundings [K/W]."""
        return self.resistance + self.roller_resistance

    def housing_at(self, rollers: Real) -> Real:
        """Temperature of the housing where that of the rollers is steady [degC]."""
        return self.ambient + (rollers - self.ambient) * self.resistance / self.to_rollers


class HeatBalance(Module):
    r"""Steady temperatures of a joint; of one that has none those of its surroundings.

    Parameters
    ----------
    flow : HeatFlow
        How heat leaves the joint.
    roller_temperature, housing_temperature : Real
        Of the rollers and the oil in their contacts, and of the housing and its rings [degC].
    gain : Real
        By how much more the losses would warm rollers that are a kelvin warmer, :math:`g = R\,\mathrm dP/\mathrm dT`
        [-], below 1 where the temperature is stable; nan where none is steady.
    ambient_reserve : Real
        By how much warmer the surroundings may become before no temperature of the rollers is steady [K]; negative: by
        how much colder they would have to be; nan where the joint rolls at no temperature.
    temperatures, losses : Array
        Temperatures of the rollers up to the limit of the oil [degC], and the losses of the joint there, nan where it
        does not roll steadily [W].
    """

    flow: HeatFlow
    roller_temperature: Real
    housing_temperature: Real
    gain: Real
    ambient_reserve: Real
    temperatures: Array
    losses: Array

    @property
    def is_steady(self) -> Array:
        """Whether the joint has a steady temperature."""
        return xp.isfinite(xp.asarray(self.gain))

    @property
    def loss(self) -> Array:
        """What leaves the joint at its steady temperature [W]; nan without one."""
        rise = (self.roller_temperature - self.flow.ambient) / self.flow.to_rollers
        return xp.where(self.is_steady, rise, xp.nan)

    @property
    def unsteady_because(self) -> str:
        """Of one joint: why it has no steady temperature, in a few words; empty where it has one.

        It is too hot where the losses still come nearer to what leaves at the limit of the oil.
        """
        if bool(self.is_steady):
            return ""
        excess, flow = self._excess(), self.flow
        nearer = bool(excess[-1] < excess[-2]) and bool(np.all(np.isfinite(excess)))
        return (
            f"too hot: it would settle above {float(flow.oil_limit):g} degC" if nearer else "thermal runaway"
        )

    def _excess(self) -> np.ndarray:
        """By how many kelvins the losses of one joint exceed what leaves at the temperatures."""
        rise = np.asarray(self.temperatures) - float(self.flow.ambient)
        return float(self.flow.to_rollers) * np.asarray(self.losses) - rise

    def other_states(self) -> list[tuple[float, bool]]:
        """Of one joint: its other steady temperatures [degC], and whether they are stable, to about half a kelvin."""
        excess, warm = self._excess(), np.asarray(self.temperatures)
        found = []
        for k in range(warm.size - 1):
            one, two = excess[k : k + 2]
            if not (np.isfinite(one) and np.isfinite(two)) or one * two > 0.0 or one == two:
                continue
            at = warm[k] + (warm[k + 1] - warm[k]) * one / (one - two)
            if not (bool(self.is_steady) and warm[k] <= float(self.roller_temperature) <= warm[k + 1]):
                found.append((float(at), bool(two < one)))
        return found


class _Scan(NamedTuple):
    """Temperatures [degC], and excess of the losses over what leaves there [K], inf where the joint does not roll."""

    temperature: Array
    excess: Array


def heat_balance(flow: HeatFlow, losses: Callable[[Tree, Array, Array], Array], numbers: Tree) -> HeatBalance:
    r"""The lowest stable temperature of the rollers of a joint, and that of its housing.

    .. math::
        T_r = T_h + R_r P(T_h, T_r), \qquad T_h = T_a + R_h P(T_h, T_r)

    Parameters
    ----------
    flow : HeatFlow
        How heat leaves the joint.
    losses : callable
        Losses of the joint, of numbers that may be differentiated and of temperatures of housing and rollers [degC];
        nan where it does not roll steadily [W].
    numbers : module of numbers
        What the losses take, beside the temperatures.

    Returns
    -------
    HeatBalance
        Where no temperature up to the limit of the oil is steady, ``gain`` is nan and the temperatures are those of the
        surroundings: thermal runaway.

    Notes
    -----
    The losses are followed from the surroundings to the limit of the oil, or to where the joint does not roll, at 24
    temperatures, then at 24 around the first one at which they fall below what leaves, or where they come nearest to
    it; a cubic gives the root, with the derivative of the implicit function. Surroundings that are warmer by a kelvin
    move what leaves by a kelvin: the reserve is the least distance between both.

    References
    ----------
    Equation (H1) of :doc:`/equations`.
    """

    def excess(numbers: Tree, flow: HeatFlow, rollers: Array) -> Array:
        return flow.to_rollers * losses(numbers, xp.asarray(flow.housing_at(rollers)), rollers) - (
            rollers - flow.ambient
        )

    given = (numbers, flow)
    fixed, fixed_flow = without_slopes(given)
    wide, near = _scanned(
        lambda rollers: excess(fixed, fixed_flow, rollers), fixed_flow.ambient, fixed_flow.oil_limit
    )
    found, gain = _lowest_stable(near)
    steady = xp.isfinite(found)
    rollers = xp.where(steady, found, xp.asarray(fixed_flow.ambient))
    if uses_jax(given) or highest_level(trees.leaves(given)):
        live = implicit_root(
            lambda at: excess(numbers, flow, at),
            rollers,
            lambda _, start: start,
            lambda slope, change: change / slope(xp.ones_like(change)),
        )
        rollers = xp.where(steady, live, xp.asarray(flow.ambient))
    housing = xp.where(steady, flow.housing_at(rollers), xp.asarray(flow.ambient))
    return HeatBalance(
        flow=flow,
        roller_temperature=rollers,
        housing_temperature=housing,
        gain=xp.where(steady, gain, xp.nan),
        ambient_reserve=-_least(wide, near),
        temperatures=wide.temperature,
        losses=xp.where(
            xp.isfinite(wide.excess),
            (wide.excess + wide.temperature - fixed_flow.ambient) / fixed_flow.to_rollers,
            xp.nan,
        ),
    )


def _scanned(excess: Callable[[Array], Array], low: Real, high: Real) -> tuple[_Scan, _Scan]:
    """The excess between two temperatures, and anew around where it first falls below 0, or comes nearest to it."""
    steps = np.linspace(0.0, 1.0, _POINTS)

    def looked(ends: tuple[Array, Array], _: None) -> tuple[tuple[Array, Array], _Scan]:
        low, high = ends
        at = low + (high - low) * steps
        found = vectorised(excess)(at)
        found = _reached(found)
        falls = _falls(found)
        first, nearest = xp.argmax(falls), xp.argmin(found)
        below = xp.where(xp.any(falls), first, xp.maximum(nearest - 1, 0))
        above = xp.where(xp.any(falls), first + 1, xp.minimum(nearest + 1, _POINTS - 1))
        return (at[below], at[above]), _Scan(at, found)

    ends = tuple(xp.asarray(end) + 0.0 * (low + high) for end in (low, high))
    _, both = scan(looked, ends, length=_ROUNDS)
    return trees.map(lambda leaf: leaf[0], both), trees.map(lambda leaf: leaf[-1], both)


def _reached(excess: Array) -> Array:
    """An excess over rising temperatures, infinite from the first one at which the joint does not roll.

    No drive warms up beyond a temperature at which its contacts slip.
    """
    return xp.where(xp.cumsum(~xp.isfinite(excess)) == 0, excess, xp.inf)


def _falls(excess: Array) -> Array:
    """Between which neighbours an excess falls to 0 or below, shape (points - 1,)."""
    return (excess[:-1] >= 0.0) & (excess[1:] <= 0.0) & (excess[:-1] > excess[1:])


def _lowest_stable(near: _Scan) -> tuple[Array, Array]:
    """The first root with a falling excess [degC], and the gain there [-]; nan where there is none."""
    falls = _falls(near.excess)
    first = xp.argmax(falls)
    start = xp.clip(first - 1, 0, _POINTS - 4)
    four = near.excess[start + np.arange(4)]
    width = near.temperature[1] - near.temperature[0]
    differences = [four]
    for _ in range(3):
        differences.append(differences[-1][1:] - differences[-1][:-1])
    f, d, dd, ddd = (each[0] for each in differences)
    above, below = near.excess[first], near.excess[first + 1]
    place = xp.asarray(first - start, dtype=float) + above / (above - below)
    slope = below - above
    smooth = xp.all(xp.isfinite(four))  # else the line between both neighbours
    for _ in range(_STEPS):
        value = f + place * (d + 0.5 * (place - 1.0) * (dd + (place - 2.0) * ddd / 3.0))
        rise = d + 0.5 * (2.0 * place - 1.0) * dd + (3.0 * place * (place - 2.0) + 2.0) * ddd / 6.0
        place = xp.where(smooth, place - value / rise, place)
        slope = xp.where(smooth, rise, slope)
    known = xp.any(falls) & xp.isfinite(above)
    return (
        xp.where(known, near.temperature[start] + width * place, xp.nan),
        xp.where(known, 1.0 + slope / width, xp.nan),
    )


def _least(wide: _Scan, near: _Scan) -> Array:
    """The least excess of both scans [K], between the points of the first one by the parabola through three.

    nan where nothing rolls at any temperature.
    """
    middle = xp.clip(xp.argmin(wide.excess), 1, _POINTS - 2)
    before, at, after = (wide.excess[middle + step] for step in (-1, 0, 1))
    bend = before - 2.0 * at + after
    dips = xp.isfinite(bend) & (bend > 0.0) & (at <= before) & (at <= after)
    vertex = at - 0.125 * (after - before) ** 2 / xp.where(dips, bend, 1.0)
    seen = xp.minimum(xp.min(wide.excess), xp.min(near.excess))
    least = xp.where(dips, xp.minimum(vertex, seen), seen)
    return xp.where(xp.isfinite(least), least, xp.nan)
