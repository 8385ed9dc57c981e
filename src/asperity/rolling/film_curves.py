"""The oil in the contacts of a joint over the speed of its input: Stribeck curves, at one or more oil temperatures."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from asperity.engine.arrays import as_numbers, xp
from asperity.engine.control import at_once, vectorised
from asperity.joint.assembled import Pressed
from asperity.joint.description import Joint, without_duty
from asperity.joint.laws import rolling_speeds
from asperity.joint.machine import joint_machine
from asperity.rolling.curves import rolling_over_loads
from asperity.rolling.inlet_heat import joint_inlet_heat
from asperity.rolling.rolling import RollingResult
from asperity.types import Array


class FilmCurves(NamedTuple):
    """Film, asperities and creep of the contacts over the speed of the input at one temperature of the oil.

    ``temperature`` of the oil [K]; ``input_speed``, shape (points,) [rad/s]. Of each contact, shape (contacts, points):
    thickness of the film beside the asperities in the middle, and smallest thickness as if the film carried all [m];
    ratio of the latter to the roughness, share of the asperities in the load by the law in use and by the other one,
    largest T/N, T/N, creepage and Deborah number [-]; factor of heat at the inlet on the film, without steady rolling
    that under the forces without torque: where it is not above 0 no film is known [-]. Of the joint, shape (points,):
    drift per turn of the output [rad], efficiency [-], and whether it rolls steadily. nan where it does not, and where
    the joint lacks a number.
    """

    temperature: float
    input_speed: np.ndarray
    central_film: np.ndarray
    minimum_film: np.ndarray
    film_ratio: np.ndarray
    asperity_share: np.ndarray
    rival_asperity_share: np.ndarray
    traction_capacity: np.ndarray
    traction_coefficient: np.ndarray
    creepage: np.ndarray
    deborah_number: np.ndarray
    inlet_heat_factor: np.ndarray
    drift_per_output_turn: np.ndarray
    efficiency: np.ndarray
    rolls: np.ndarray


def film_curves(
    *,
    joint: Joint,
    without_torque: Pressed,
    input_speed: np.ndarray,
    temperatures: tuple[float, ...],
    report: Callable[[int, int], None] | None = None,
) -> list[FilmCurves]:
    """Film and asperities of one joint under its torque over speeds of its input [rad/s], one for each temperature [K].

    The oil alone has these temperatures; fits and preload stay those of the joint. ``report`` takes the number of
    temperatures done, and of all.
    """
    numbers: Joint = as_numbers(without_duty(joint))
    found = []
    for done, temperature in enumerate(temperatures, start=1):
        warmed = dataclasses.replace(numbers, rolling=numbers.rolling.with_oil_at(xp.asarray(temperature)))
        torque = np.full_like(input_speed, float(numbers.output_torque))
        rolling = at_once(rolling_over_loads, warmed, without_torque, torque, input_speed)
        heat = at_once(_inlet_heat, warmed, without_torque, rolling, input_speed)
        found.append(_curves(temperature, input_speed, rolling, heat))
        if report is not None:
            report(done, len(temperatures))
    return found


def _inlet_heat(joint: Joint, without_torque: Pressed, rolling: RollingResult, input_speed: Array) -> Array:
    """Factors of heat at the inlets on the films, points first [-]."""
    contacts = joint_machine(joint, without_torque.laws.rims).contacts
    lubricant, unit = joint.rolling.lubricant, dataclasses.replace(joint, input_speed=xp.asarray(1.0))
    assert lubricant is not None, "the oil has a traction"

    def at(speed: Array, normal: Array) -> Array:
        forces = xp.where(xp.isfinite(normal), normal, without_torque.rest.normal)
        rolls = {"rolling_speed": rolling_speeds(unit) * xp.abs(speed), "normal_force": forces}
        return joint_inlet_heat(lubricant=lubricant, contacts=contacts, **rolls)

    found: Array = vectorised(at)(input_speed, rolling.normal)
    return found


def _curves(
    temperature: float, input_speed: np.ndarray, rolling: RollingResult, heat: np.ndarray
) -> FilmCurves:
    """What a rolling joint has over speeds, points first, with the contacts first."""
    film, rolls = rolling.film, np.isfinite(np.asarray(rolling.residual))
    assert film is not None, "the oil has a traction"

    def shown(values: Array) -> np.ndarray:
        return np.where(rolls, np.asarray(values).T, np.nan)

    return FilmCurves(
        temperature=temperature,
        input_speed=input_speed,
        central_film=shown(film.central_film),
        minimum_film=shown(rolling.film_thickness),
        film_ratio=shown(rolling.film_ratio),
        asperity_share=shown(film.asperity_share),
        rival_asperity_share=shown(film.rival_share),
        traction_capacity=shown(film.traction_capacity),
        traction_coefficient=shown(rolling.traction_coefficient),
        creepage=shown(rolling.creepage),
        deborah_number=shown(film.deborah_number),
        inlet_heat_factor=np.asarray(heat).T,
        drift_per_output_turn=shown(rolling.drift_per_output_turn),
        efficiency=shown(rolling.power.efficiency),
        rolls=rolls,
    )
