"""The temperatures of a joint file: as it states them, or those at which what cools the drive lets it settle."""

from __future__ import annotations

import functools
import json
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.joint.description import Joint
from asperity.joint.heat import heat_made
from asperity.joint_file.sections import OIL_LIMIT
from asperity.joint_file.si_tables import Values, numbers, with_numbers
from asperity.rolling.heat import HeatBalance, HeatFlow, heat_balance
from asperity.types import Array, Real

#: Where the section [heat] of tables has the steady temperatures of the drive.
_BALANCE = "balance"
#: Where [temperature] has by how much the rollers are warmer, if what cools the drive gave its temperatures [K].
_RISE = "roller_rise"
#: Joints whose temperatures are remembered: commands ask for those of one file several times.
_REMEMBERED = 16


class Temperatures(NamedTuple):
    """Temperatures of a joint file [degC].

    That of the assembly is None where nothing depends on it; ``apart``, whether rollers and housing may differ, because
    what cools the drive decides.
    """

    assembly: Real | None
    housing: Real
    rollers: Real
    apart: bool


def temperatures_of(values: Values) -> Temperatures | None:
    """The temperatures of tables in SI units; None where they have none.

    Of a drive that is cooled those of its balance, or of its surroundings where that is not known.
    """
    stated, heat = values.get("temperature"), values.get("heat")
    if heat is not None:
        assembly, balance = (stated or {}).get("assembly"), balance_of(values)
        if balance is None:
            return Temperatures(assembly, heat["ambient"], heat["ambient"], True)
        return Temperatures(assembly, balance.housing_temperature, balance.roller_temperature, True)
    if stated is None:
        return None
    working, rise = stated["working"], stated.get(_RISE)
    return Temperatures(
        stated.get("assembly"), working, working + (0.0 if rise is None else rise), rise is not None
    )


def balance_of(values: Values) -> HeatBalance | None:
    """The steady temperatures that tables have; None where they have none."""
    balance: HeatBalance | None = values.get("heat", {}).get(_BALANCE)
    return balance


def heat_flow(values: Values) -> HeatFlow:
    """How heat leaves a drive, of tables with a section [heat]."""
    heat = values["heat"]
    resistance = heat.get("resistance")
    return HeatFlow(
        ambient=heat["ambient"],
        resistance=1.0 / (heat["area"] * heat["coefficient"]) if resistance is None else resistance,
        roller_resistance=heat.get("roller_resistance", 0.0),
        oil_limit=heat.get("oil_limit", OIL_LIMIT),
        cold_start=heat.get("cold_start"),
        heat_capacity=heat.get("heat_capacity"),
        duty_time=heat.get("duty_time"),
    )


def with_steady_temperatures(values: Values, joint_of: Callable[[Values], Joint]) -> Values:
    """Tables in SI units with the temperatures at which the drive settles; as they are where these are stated.

    ``joint_of`` makes the joint of tables at known temperatures. Pure; equation (H1) of :doc:`/equations`.
    """
    if "heat" not in values or balance_of(values) is not None:
        return values
    given = numbers(values)
    if all(isinstance(number, float | int | np.number) for number in given):
        key = json.dumps(with_numbers(values, map(float, given)), sort_keys=True)
        return _balanced(values, _remembered(key, joint_of))
    return _balanced(values, _balance(values, joint_of))


@functools.lru_cache(maxsize=_REMEMBERED)
def _remembered(key: str, joint_of: Callable[[Values], Joint]) -> HeatBalance:
    """The balance of tables of plain numbers, as JSON."""
    balance: HeatBalance = at_once(lambda: _balance(json.loads(key), joint_of))
    return balance


def _balance(values: Values, joint_of: Callable[[Values], Joint]) -> HeatBalance:
    """The steady temperatures of the drive of tables."""

    def losses(given: tuple[Real, ...], housing: Array, rollers: Array) -> Array:
        tables = with_numbers(values, given)
        nothing = xp.asarray(np.nan)
        at = HeatBalance(heat_flow(tables), rollers, housing, nothing, nothing, nothing, nothing)
        return heat_made(joint_of(_balanced(tables, at)))

    return heat_balance(heat_flow(values), losses, tuple(xp.asarray(number) for number in numbers(values)))


def at_one_temperature(values: Values, joint_of: Callable[[Values], Joint]) -> Values:
    """Tables that state the temperatures at which the drive settles, in place of what cools it.

    So that they may vary; as they are where they state them already.
    """
    if "heat" not in values:
        return values
    balance = balance_of(with_steady_temperatures(values, joint_of))
    assert balance is not None
    stated = {name: section for name, section in values.items() if name != "heat"}
    housing, rise = balance.housing_temperature, balance.roller_temperature - balance.housing_temperature
    temperature = values.get("temperature", {}) | {"working": float(housing), _RISE: float(rise)}
    return stated | {"temperature": temperature}


def _balanced(values: Values, balance: HeatBalance) -> Values:
    """The tables with a balance."""
    return values | {"heat": values["heat"] | {_BALANCE: balance}}
