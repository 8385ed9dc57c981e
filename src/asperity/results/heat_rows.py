"""Rows of the table of results: the temperatures at which a joint settles, and the joint at a cold start."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from asperity.engine.arrays import xp
from asperity.results.result import Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.rolling.power import rolling_input_torque
from asperity.unit_table import Dimension

_heat = functools.partial(
    Result,
    group="heat",
    positive=False,
    present=lambda solved: (solved.joint.heat is not None,),
    only="only a joint whose file says in [heat] what cools it has it",
)
_cold = functools.partial(
    _heat,
    present=lambda solved: (solved.joint.heat is not None and solved.joint.heat.flow.cold_start is not None,),
    only="only a joint whose file states heat.cold_start has it",
)
_TEMPERATURE, _RISE = (Dimension.TEMPERATURE, "degC"), (Dimension.TEMPERATURE_RISE, "K")


def _of_balance(name: str) -> Callable[[SolvedJoint], Any]:
    """A number of the steady temperatures; nan without any."""

    def value(solved: SolvedJoint) -> Any:
        heat = solved.joint.heat
        return xp.nan if heat is None else xp.asarray(getattr(heat, name))

    return value


def _steady(name: str) -> Callable[[SolvedJoint], Any]:
    """The same, nan where no temperature is steady."""

    def value(solved: SolvedJoint) -> Any:
        heat = solved.joint.heat
        return xp.nan if heat is None else xp.where(heat.is_steady, getattr(heat, name), xp.nan)

    return value


def _of_cold_start(value: Callable[[SolvedJoint], Any]) -> Callable[[SolvedJoint], Any]:
    """A number of the joint at its cold start; nan without one."""
    return lambda solved: xp.nan if solved.cold is None else value(solved.cold)


def _input_torque(solved: SolvedJoint) -> Any:
    """Torque that the input needs in rolling [N·m]."""
    joint, rolling = solved.joint, solved.result.rolling
    return rolling_input_torque(
        power=rolling.power,
        output_torque=joint.output_torque,
        output_speed=rolling.output_speed,
        input_speed=joint.input_speed,
    )


def _in_rolling(solved: SolvedJoint) -> Any:
    """Torque capacity of slip alone in rolling, in the direction of the torque [N·m]."""
    backwards = xp.asarray(solved.joint.output_torque) < 0.0
    return xp.where(backwards, solved.reverse_rolling_capacity, solved.rolling_capacity)


ROWS = (
    _heat(
        "roller_temperature",
        "steady temperature of the rollers and their oil",
        *_TEMPERATURE,
        _steady("roller_temperature"),
        note="nan without a section [heat]; nan where no temperature up to heat.oil_limit is steady",
        place="heat.roller_temperature_degC",
    ),
    _heat(
        "housing_temperature",
        "steady temperature of housing and rings",
        *_TEMPERATURE,
        _steady("housing_temperature"),
        note="as that of the rollers, less their resistance to the housing times the losses",
        place="heat.housing_temperature_degC",
    ),
    _heat(
        "thermal_gain",
        "thermal gain",
        Dimension.DIMENSIONLESS,
        "1",
        _of_balance("gain"),
        differentiable=False,
        note="by how many kelvins more the losses would warm rollers that are a kelvin warmer; negative where warmth "
        "lowers the losses",
        place="heat.gain",
    ),
    _heat(
        "ambient_reserve",
        "reserve against thermal runaway, of the ambient",
        *_RISE,
        _of_balance("ambient_reserve"),
        needs="geometry",
        differentiable=False,
        limit=Limit(
            "function",
            "the drive settles at a temperature below heat.oil_limit",
            "thermal runaway: at no temperature up to heat.oil_limit does as much heat leave as the losses make; all "
            "numbers are those before it warms",
            "cool the drive better (a smaller heat.resistance), lower the torque or the speed, or choose an oil of "
            "more traction or less drag",
            lowest=0.0,
            unknown="no value: the drive does not roll at any temperature between heat.ambient and heat.oil_limit",
        ),
        note="by how much warmer the surroundings may become before the drive has no steady temperature up to "
        "heat.oil_limit",
        place="heat.ambient_reserve_K",
    ),
    _cold(
        "cold_rolling_torque_capacity",
        "torque capacity in rolling at a cold start, of slip alone",
        Dimension.TORQUE,
        "N*m",
        _of_cold_start(_in_rolling),
        note="at heat.cold_start everywhere, in the direction of the torque",
        place="heat.cold_start.rolling_torque_capacity_Nm",
    ),
    _cold(
        "cold_standing_torque_capacity",
        "torque capacity standing at a cold start, of slip alone",
        Dimension.TORQUE,
        "N*m",
        _of_cold_start(lambda cold: cold.standing_capacity_of_direction.output_torque),
        note="at heat.cold_start everywhere, in the direction of the torque",
        place="heat.cold_start.standing_torque_capacity_Nm",
    ),
    _cold(
        "starting_torque",
        "torque of the input at a cold start, at full speed",
        Dimension.TORQUE,
        "N*m",
        _of_cold_start(_input_torque),
        note="under the output torque, with all losses at heat.cold_start; nan where the joint does not roll there",
        place="heat.cold_start.input_torque_Nm",
    ),
    _cold(
        "cold_efficiency",
        "efficiency at a cold start",
        Dimension.DIMENSIONLESS,
        "1",
        _of_cold_start(lambda cold: cold.result.rolling.power.efficiency),
        note="at heat.cold_start everywhere; nan where the joint does not roll there",
        place="heat.cold_start.efficiency",
    ),
)
