"""The oil in the contacts of a joint file over speed: at which temperatures, between which speeds, what is refused."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from asperity.contact.fluid import RheologicalTraction
from asperity.engine.control import at_once
from asperity.errors import InputError, NoSolutionError
from asperity.joint.description import Joint
from asperity.joint.evaluation import assembled_joint
from asperity.joint.solve import (
    joint_state,
    refuse_impossible_joint,
    refuse_not_pressed,
    refuse_short_contacts,
)
from asperity.joint_file.own_branches import joint_with_branches
from asperity.joint_file.si_tables import AnyCase, key_at, si_values
from asperity.results.film_document import FilmOverSpeed
from asperity.rolling.conditions import ZERO_CELSIUS, Lubricant
from asperity.rolling.film_curves import film_curves
from asperity.rolling.inlet_heat import FILM_REMEDY, film_unknown_because
from asperity.units import format_quantity

#: Speeds unless others are asked for, and the most that are allowed; the most temperatures.
POINTS, MOST_POINTS, MOST_TEMPERATURES = 25, 500, 6
#: Ends of the axis over the speed of the file.
_LOWEST, _HIGHEST = 1e-3, 2.0
_SPEED, _TEMPERATURE = "load.sun_speed", "temperature.working"


def joint_film(
    case: AnyCase,
    *,
    temperatures: Sequence[float] = (),
    start: float | None = None,
    stop: float | None = None,
    points: int = POINTS,
    report: Callable[[int, int], None] | None = None,
) -> FilmOverSpeed:
    """The oil in the contacts of a joint file over the speed of its input, under its torque.

    ``temperatures`` of the oil [degC], none for that of the file; ``start`` and ``stop`` of the axis [rad/s], None for
    a thousandth of and twice the speed of the file. An ``InputError`` if the file has no oil whose traction is known,
    an end, a temperature or a number is not allowed, or the bodies do not fit; a ``NoSolutionError`` if the joint rolls
    at none of the speeds.
    """
    joint = refuse_impossible_joint(at_once(lambda: joint_with_branches(si_values(case))))
    lubricant = _refuse_no_film(joint)
    own = float(joint.input_speed)
    speeds = _speeds(own, start, stop, points)
    asked = _kelvins(temperatures, float(lubricant.temperature))
    result, without_torque = joint_state(joint), at_once(assembled_joint, joint)
    refuse_not_pressed(joint, result.rest, result.pressed)
    refuse_short_contacts(result)
    given = {"joint": joint, "without_torque": without_torque}
    curves = film_curves(**given, input_speed=speeds, temperatures=asked, report=report)
    (here,) = film_curves(**given, input_speed=np.array([own]), temperatures=(float(lubricant.temperature),))
    if not here.rolls.any() and not any(each.rolls.any() for each in curves):
        no_film = film_unknown_because(tuple(joint.contact_names), here.inlet_heat_factor[:, 0])
        if no_film is not None and all(
            np.any(each.inlet_heat_factor <= 0.0, axis=0).all() for each in curves
        ):
            raise NoSolutionError(f"no steady rolling at any of these speeds: {no_film}; {FILM_REMEDY}")
        torque = format_quantity(float(joint.output_torque), "N*m")
        raise NoSolutionError(
            f"no steady rolling under {torque} at any of these speeds: a contact slips or lifts off; lower the torque "
            "(load.output_torque), or raise the preload or the interference; 'asperity roll' says up to which torque "
            "the joint rolls"
        )
    lowest, traction = lubricant.lowest_temperature, lubricant.fluid.traction
    return FilmOverSpeed(
        contact_names=tuple(joint.contact_names),
        output_torque=float(joint.output_torque),
        lowest_temperature=None if lowest is None else float(lowest),
        housing_temperature=float(lubricant.temperature)
        if joint.heat is None
        else float(joint.heat.housing_temperature) + ZERO_CELSIUS,
        unsteady_because="" if joint.heat is None else joint.heat.unsteady_because,
        here=here,
        curves=tuple(curves),
        shear_law=traction.shear_law if isinstance(traction, RheologicalTraction) else None,
    )


def _refuse_no_film(joint: Joint) -> Lubricant:
    """The oil of a joint, of which the traction is known."""
    lubricant = joint.rolling.lubricant
    if lubricant is None:
        raise InputError(
            "the joint file names no oil whose traction is known, so that there is no film to show; give [lubrication] "
            "fluid, such as fluid = \"Santotrac 50\", and [temperature]; 'asperity materials' lists the oils"
        )
    if lubricant.fluid.traction is None:
        raise InputError(
            "of the oil of [lubrication] fluid no traction is known, so that friction stays as stated; give it in "
            "[fluids], by limiting_traction, maximum_traction with traction_slope or a traction_curve, or choose one "
            "of 'asperity materials'"
        )
    return lubricant


def _speeds(own: float, start: float | None, stop: float | None, points: int) -> np.ndarray:
    """Speeds of the input, evenly over their logarithm, with that of the file if it lies between the ends [rad/s]."""
    if not 2 <= points <= MOST_POINTS:
        raise InputError(
            f"the number of points must be from 2 to {MOST_POINTS}, got {points}", options=["points"]
        )
    if own == 0.0 and (start is None or stop is None):
        raise InputError(
            f"the input of the file stands ({_SPEED} is 0 or missing), where there is no film; give it a speed, or the "
            "ends of the axis",
            options=["from", "to"],
        )
    low, high = _LOWEST * own if start is None else start, _HIGHEST * own if stop is None else stop
    for option, end in (("from", low), ("to", high)):
        try:
            key_at(_SPEED).check(end)
        except InputError as error:
            raise InputError(f"{_SPEED}: {error}", options=[option]) from None
    if not 0.0 < low < high:
        raise InputError(
            f"the speeds must rise from above 0: from {format_quantity(low, 'rpm')} to {format_quantity(high, 'rpm')} "
            "they do not; choose a start below the end",
            options=["from", "to"],
        )
    speeds = np.geomspace(low, high, points)
    between = low < own < high and not np.isclose(speeds, own, rtol=1e-9).any()
    return np.sort(np.append(speeds, own)) if between else speeds


def _kelvins(temperatures: Sequence[float], own: float) -> tuple[float, ...]:
    """Temperatures of the oil, each once, that of the file if none is asked for [K]."""
    if len(temperatures) > MOST_TEMPERATURES:
        raise InputError(
            f"at most {MOST_TEMPERATURES} temperatures are compared, got {len(temperatures)}",
            options=["temperature"],
        )
    for temperature in temperatures:
        try:
            key_at(_TEMPERATURE).check(temperature)
        except InputError as error:
            raise InputError(f"temperature of the oil: {error}", options=["temperature"]) from None
    return tuple(dict.fromkeys(each + ZERO_CELSIUS for each in temperatures)) or (own,)
