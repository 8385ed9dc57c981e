"""Rows of the table of results: the joint that turns, its creep, losses and life."""

from __future__ import annotations

import functools
from typing import Any

import jax.numpy as jnp

from asperity.results.result import Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

_roll = functools.partial(Result, group="rolling")
_per_contact = functools.partial(_roll, axis="contact")
_loss = functools.partial(Result, group="losses", dimension=Dimension.POWER, display_unit="W")
_life = functools.partial(Result, group="life", dimension=Dimension.DIMENSIONLESS, display_unit="1")
_NUMBER, _TIME = Dimension.DIMENSIONLESS, Dimension.TIME
_STANDING = "nan where the input stands"


def _crown_factor(solved: SolvedJoint) -> Any:
    rolling = solved.result.rolling
    factor = rolling.crown_creepage_factor
    return jnp.full_like(rolling.normal, jnp.nan) if factor is None else factor


ROWS = (
    _per_contact(
        "creepage",
        "creepage",
        _NUMBER,
        "1",
        "result.rolling.creepage",
        positive=False,
        note="difference of the surface speeds over their mean, in steady rolling",
    ),
    _per_contact(
        "traction_coefficient",
        "traction coefficient T/N in rolling",
        _NUMBER,
        "1",
        "result.rolling.traction_coefficient",
        positive=False,
    ),
    _per_contact(
        "rolling_slip_ratio",
        "slip ratio T/(mu N) in rolling",
        _NUMBER,
        "1",
        "result.rolling.slip_ratio",
        note="the share of the friction that skew takes is counted as not available",
    ),
    _per_contact(
        "stick_fraction",
        "share of the contact width that sticks in rolling",
        _NUMBER,
        "1",
        "result.rolling.stick_fraction",
    ),
    _per_contact(
        "rolling_normal_force",
        "normal force of the contact in rolling",
        Dimension.FORCE,
        "N",
        "result.rolling.normal",
    ),
    _per_contact(
        "rolling_tangential_force",
        "tangential force of the contact in rolling",
        Dimension.FORCE,
        "N",
        "result.rolling.tangential",
        positive=False,
        note="the split that the creepages decide",
    ),
    _per_contact(
        "oil_drag",
        "drag of the oil on each surface of the contact in rolling",
        Dimension.FORCE,
        "N",
        "result.rolling.drag",
        positive=False,
        note="besides the tangential force; 0 without lubrication.viscosity, and where the input stands",
    ),
    _per_contact(
        "layer_ratio",
        "yield of the asperities over that of the bodies",
        _NUMBER,
        "1",
        "result.rolling.layer_ratio",
        note="u_0 R/a^2 with u_0 = N/K_n of the contact law; in the middle of crowned contacts",
    ),
    _per_contact(
        "layer_creepage_factor",
        "creepage with asperities over that of smooth bodies",
        _NUMBER,
        "1",
        "result.rolling.layer_creepage_factor",
    ),
    _per_contact(
        "rough_half_width",
        "half-width of the contact with asperities in rolling",
        Dimension.LENGTH,
        "mm",
        "result.rolling.rough_half_width",
        note="of the ellipse whose root mean square the load's places have",
    ),
    _per_contact(
        "rolling_hertz_pressure",
        "peak pressure of smooth bodies in rolling",
        Dimension.PRESSURE,
        "MPa",
        "result.rolling.hertz_pressure",
        note="of Hertz under the rolling forces; shakedown and life are judged by it",
    ),
    _per_contact(
        "rough_peak_pressure",
        "peak pressure of the contact with asperities in rolling",
        Dimension.PRESSURE,
        "MPa",
        "result.rolling.rough_peak_pressure",
        note="nominal; life and shakedown take the higher one of smooth bodies, as the standards do",
    ),
    _per_contact(
        "crown_creepage_factor",
        "creepage of smooth crowned rollers over that of cylinders",
        _NUMBER,
        "1",
        _crown_factor,
        note="nan where no roller of the joint is crowned",
    ),
    _per_contact(
        "skew_creepage_factor",
        "creepage with skew over that without",
        _NUMBER,
        "1",
        "result.rolling.skew_creepage_factor",
    ),
    _per_contact(
        "capacity_loss",
        "share of the contact's tangential capacity that skew takes",
        _NUMBER,
        "1",
        "result.rolling.capacity_loss",
        positive=False,
    ),
    _per_contact(
        "axial_force",
        "axial force of the skewed contact",
        Dimension.FORCE,
        "N",
        "result.rolling.axial_force",
        positive=False,
    ),
    _roll(
        "axial_thrust",
        "net axial force on the body",
        Dimension.FORCE,
        "N",
        "result.rolling.axial_thrust",
        axis="body",
        positive=False,
        note="on bodies on the axis from all branches",
    ),
    _roll(
        "speed_loss",
        "share of the output speed that creep takes",
        _NUMBER,
        "1",
        "result.rolling.speed_loss",
        positive=False,
    ),
    _roll(
        "drift",
        "drift of the output in one turn of its own",
        Dimension.ANGLE,
        "arcmin",
        "result.rolling.drift_per_output_turn",
        positive=False,
        note="angle by which creep lets the output fall behind; it adds up turn by turn",
    ),
    _roll(
        "drift_rate",
        "drift of the output per time",
        Dimension.ANGULAR_VELOCITY,
        "deg/h",
        "result.rolling.drift_rate",
        positive=False,
        note=_STANDING,
    ),
    _roll(
        "rolling_output_speed",
        "angular velocity of the output less creep",
        Dimension.ANGULAR_VELOCITY,
        "rpm",
        "result.rolling.output_speed",
        positive=False,
        note="without its sign",
    ),
    _roll(
        "rolling_residual",
        "residual of the rolling state",
        _NUMBER,
        "1",
        "result.rolling.residual",
        differentiable=False,
    ),
    _per_contact(
        "shakedown_ratio",
        "Hertz pressure over shakedown limit",
        _NUMBER,
        "1",
        "result.rolling.shakedown_ratio",
        limit=Limit(
            "damage",
            "plastic flow stops after the first turns, if there is any",
            "the Hertz pressure exceeds the shakedown limit: the surface flows a little further at every passage",
            "choose a material of higher yield strength, longer contact lines, less preload or less traction",
            highest=1.0,
        ),
    ),
    _per_contact(
        "flash_temperature",
        "flash temperature of the contact",
        Dimension.TEMPERATURE_RISE,
        "K",
        "result.rolling.flash_temperature",
        note=f"largest rise of the surfaces above the temperature of the bodies; nan without thermal_conductivity and "
        f"specific_heat_capacity of both materials; {_STANDING}",
    ),
    _per_contact(
        "film_thickness",
        "smallest thickness of the oil film",
        Dimension.LENGTH,
        "um",
        "result.rolling.film_thickness",
        note=f"as if it carried the whole load; nan without lubrication.pressure_coefficient; {_STANDING}",
    ),
    _per_contact(
        "film_ratio",
        "oil film over roughness lambda",
        _NUMBER,
        "1",
        "result.rolling.film_ratio",
        note=f"below 1 boundary, to 3 mixed, above full lubrication; nan without lubrication.roughness or the "
        f"Ra of every surface; {_STANDING}",
    ),
    _roll(
        "efficiency",
        "efficiency",
        _NUMBER,
        "1",
        "result.rolling.power.efficiency",
        highest_limit=1.0,
        note=f"{_STANDING}; only the losses for which the file has the numbers",
    ),
    _loss("input_power", "power that enters the drive", value="result.rolling.power.input", note=_STANDING),
    _loss("output_power", "power that leaves the drive", value="result.rolling.power.output", note=_STANDING),
    _loss("total_loss", "power lost", value="result.rolling.power.loss", note=_STANDING),
    _loss("contact_loss", "power lost in the contact", value="result.rolling.power.contact", axis="contact"),
    _loss("creep_loss", "power lost by creep", value="result.rolling.power.creep", axis="contact"),
    _loss("skew_loss", "power lost by skew", value="result.rolling.power.skew", axis="contact"),
    _loss(
        "hysteresis_loss",
        "power lost by elastic hysteresis",
        value="result.rolling.power.hysteresis",
        axis="contact",
        note="nan without rolling.hysteresis_factor",
    ),
    _loss(
        "oil_loss",
        "power lost by the oil at the inlet",
        value="result.rolling.power.oil",
        axis="contact",
        note="nan without lubrication.viscosity",
    ),
    _loss(
        "bearing_loss",
        "power lost in bearings and pins",
        value="result.rolling.power.bearings",
        positive=False,
    ),
    Result(
        "drive_life",
        "fatigue life of the drive",
        _TIME,
        "h",
        lambda solved: 3600.0 * solved.result.rolling.life_hours.drive,
        group="life",
        note=f"rolling-contact fatigue at the file's load, speed and reliability; {_STANDING}",
    ),
    _life(
        "life_turns",
        "fatigue life of the drive in turns of the output",
        value="result.rolling.life_turns.drive",
    ),
    Result(
        "contact_life",
        "fatigue life of both tracks of the contact, all branches",
        _TIME,
        "h",
        lambda solved: 3600.0 * solved.result.rolling.life_hours.contact,
        axis="contact",
        group="life",
        note=_STANDING,
    ),
    _life(
        "contact_life_turns",
        "fatigue life of both tracks of the contact, all branches, in turns of the output",
        value="result.rolling.life_turns.contact",
        axis="contact",
    ),
    _life(
        "body_life_turns",
        "fatigue life of one body in turns of the output",
        value="result.rolling.life_turns.body",
        axis="body",
    ),
    Result(
        "body_life",
        "fatigue life of one body",
        _TIME,
        "h",
        lambda solved: 3600.0 * solved.result.rolling.life_hours.body,
        axis="body",
        group="life",
        note=_STANDING,
    ),
    Result(
        "duty_life",
        "fatigue life of the drive under its duty",
        _TIME,
        "h",
        lambda solved: 3600.0 * solved.result.rolling.duty_life_hours,
        group="life",
        note="nan without a duty",
    ),
    _life(
        "duty_life_turns",
        "fatigue life of the drive under its duty in turns of the output",
        value="result.rolling.duty_life_turns",
        note="nan without a duty",
    ),
)
