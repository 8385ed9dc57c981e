"""The heat that a joint makes: its losses at its temperatures, and what it may pass and when it is warm."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, vectorised
from asperity.joint.assembled import assembled
from asperity.joint.description import Joint, body_masses, without_duty
from asperity.joint.machine import joint_machine
from asperity.joint.temperature import at_temperatures
from asperity.rolling.duty_heat import DutyHeat, duty_heat
from asperity.rolling.heat import HeatFlow, heat_balance
from asperity.rolling.turning import rolling_at
from asperity.types import Array

#: Temperatures that are looked at side by side, and the share to which a torque is searched.
_TEMPERATURES, _TORQUE = 24, 0.005


def heat_made(joint: Joint) -> Array:
    """Losses of a joint under its torque at its speed [W]; 0 where the input stands, nan where it does not roll."""
    machine = joint_machine(joint)
    speed = xp.asarray(joint.input_speed)
    rolling = rolling_at(machine, assembled(machine))(xp.asarray(joint.output_torque), speed)
    return xp.where(speed == 0.0, 0.0, rolling.power.loss)


def _flow(joint: Joint) -> HeatFlow:
    """What cools a joint."""
    assert joint.heat is not None, "the joint knows what cools it"
    return joint.heat.flow


def _over_temperature(joint: Joint, torque: np.ndarray, speed: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Temperatures of the rollers up to the limit of the oil [degC], and losses under loads there [W].

    Shape (loads, temperatures).
    """
    numbers: Joint = as_numbers(without_duty(joint))
    flow = _flow(numbers)

    def one(torque: Array, speed: Array, rollers: Array) -> Array:
        warm = at_temperatures(numbers, housing=flow.housing_at(rollers), rollers=rollers)
        return heat_made(dataclasses.replace(warm, output_torque=torque, input_speed=speed))

    rollers = np.linspace(float(flow.ambient), float(flow.oil_limit), _TEMPERATURES)
    loads = np.repeat(np.arange(torque.size), rollers.size)
    found = at_once(vectorised(one), torque[loads], speed[loads], np.tile(rollers, torque.size))
    return rollers, np.asarray(found).reshape(torque.size, rollers.size)


def steady_torque(joint: Joint, largest: float) -> float:
    """Largest output torque of one joint, in the direction of its own, that has a steady temperature [N·m].

    At the joint's speed, without its sign, to half a per cent of the ``largest``, which has none; nan where none has.
    """
    numbers: Joint = as_numbers(without_duty(joint))
    flow, way = _flow(numbers), -1.0 if float(joint.output_torque) < 0.0 else 1.0

    def settles(torque: float) -> bool:
        loaded = dataclasses.replace(numbers, output_torque=way * torque)

        def losses(_: tuple[()], housing: Array, rollers: Array) -> Array:
            return heat_made(at_temperatures(loaded, housing=housing, rollers=rollers))

        return bool(at_once(lambda: heat_balance(flow, losses, ()).is_steady))

    if not settles(0.0):
        return math.nan
    low, high = 0.0, largest
    while high - low > _TORQUE * largest:
        middle = 0.5 * (low + high)
        low, high = (middle, high) if settles(middle) else (low, middle)
    return low


def rollers_heat_capacity(joint: Joint) -> float:
    """Heat capacity of all bodies of one joint but its rings, all sectors together [J/K]; nan where one is unknown."""
    capacity = 0.0
    for body, mass, shape, material in zip(
        joint.drive.bodies, body_masses(joint), joint.shapes, joint.materials, strict=True
    ):
        if shape.kind == "ring":
            continue
        if material.specific_heat_capacity is None:
            return math.nan
        count = 1.0 if body.on_axis or joint.unlike is not None else float(joint.drive.sectors)
        capacity += count * float(mass) * float(material.specific_heat_capacity)
    return capacity


def time_constant(joint: Joint) -> float:
    r"""Time in which all but a share 1/e of a small departure from the steady temperature has gone [s].

    .. math::
        \tau = \tfrac12\left(s + \sqrt{s^2 - 4p}\right), \qquad
        s = \frac{C_r (R_h + R_r) + C_h R_h \left(1 - g\,\frac{R_r}{R_h + R_r}\right)}{1 - g}, \qquad
        p = \frac{C_h C_r R_h R_r}{1 - g}

    Of one joint with a steady temperature; nan where a heat capacity is not known. The slower one of both nodes, whose
    time constants have the sum s and the product p; as in a duty, losses are those at the temperature of the rollers.
    """
    heat = joint.heat
    housing = None if heat is None else heat.flow.heat_capacity
    if heat is None or housing is None:
        return math.nan
    flow, rollers, gain = heat.flow, rollers_heat_capacity(joint), float(heat.gain)
    outward, inward, both = (
        float(each) for each in (flow.resistance, flow.roller_resistance, flow.to_rollers)
    )
    of_housing = float(housing) * outward
    added = (rollers * both + of_housing * (1.0 - gain * inward / both)) / (1.0 - gain)
    multiplied = of_housing * rollers * inward / (1.0 - gain)
    return 0.5 * (added + math.sqrt(added**2 - 4.0 * multiplied))  # (H2)


def duty_temperatures(joint: Joint) -> DutyHeat | None:
    """Temperatures of one joint under its duty; None without one, or without what cools it."""
    duty = joint.rolling.duty
    if joint.heat is None or not duty:
        return None
    torque, speed, share = (
        np.array([float(getattr(load, name)) for load in duty])
        for name in ("output_torque", "input_speed", "share")
    )
    rollers, losses = _over_temperature(joint, torque, speed)
    return duty_heat(_flow(joint), rollers, losses, share, rollers_heat_capacity(joint))
