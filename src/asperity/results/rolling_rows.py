"""Rows of the table of results: the joint that turns, its creep, losses and life."""

from __future__ import annotations

import functools
from collections.abc import Callable
from typing import Any

from asperity.engine.arrays import xp
from asperity.results.result import Column, Limit, Result
from asperity.results.solved import SolvedJoint
from asperity.unit_table import Dimension

_roll = functools.partial(Result, group="rolling")
_per_contact = functools.partial(_roll, axis="contact")
_ratio = functools.partial(_roll, dimension=Dimension.DIMENSIONLESS, display_unit="1")
_contact_ratio = functools.partial(_ratio, axis="contact")
_contact_force = functools.partial(_per_contact, dimension=Dimension.FORCE, display_unit="N")
_loss = functools.partial(Result, group="losses", dimension=Dimension.POWER, display_unit="W")
_hours = functools.partial(Result, group="life", dimension=Dimension.TIME, display_unit="h")
_life = functools.partial(Result, group="life", dimension=Dimension.DIMENSIONLESS, display_unit="1")
_STANDING = "nan where the input stands"


def _crown_factor(solved: SolvedJoint) -> Any:
    rolling = solved.result.rolling
    factor = rolling.crown_creepage_factor
    return xp.full_like(rolling.normal, xp.nan) if factor is None else factor


def _inlet_heat_factor(solved: SolvedJoint) -> Any:
    """Factor of heat at the inlet on the films, nan for a joint without an oil whose traction is known."""
    heat = solved.result.inlet_heat_factor
    return xp.full_like(solved.result.rolling.normal, xp.nan) if heat is None else heat


def _of_film(name: str) -> Callable[[SolvedJoint], Any]:
    """A number of the film in the contacts, nan for a joint without an oil whose traction is known."""

    def value(solved: SolvedJoint) -> Any:
        rolling = solved.result.rolling
        return xp.full_like(rolling.normal, xp.nan) if rolling.film is None else getattr(rolling.film, name)

    return value


_NO_FILM = "nan without an oil whose traction is known"

ROWS = (
    _contact_ratio(
        "creepage",
        "creepage",
        value="result.rolling.creepage",
        positive=False,
        column=Column("rolling", "creepage", factor=1e3, unit_shown="10⁻³"),
        note="difference of the surface speeds over their mean, in steady rolling",
    ),
    _contact_ratio(
        "traction_coefficient",
        "traction coefficient T/N in rolling",
        value="result.rolling.traction_coefficient",
        positive=False,
        column=Column("rolling", "traction T/N"),
    ),
    _contact_ratio(
        "rolling_slip_ratio",
        "slip ratio in rolling",
        value="result.rolling.slip_ratio",
        note="T over mu N less what skew uses; with an oil whose traction is known, over what its film and the "
        "asperities bear",
        column=Column("rolling", "slip ratio"),
        place="rolling.contacts.*.slip_ratio",
    ),
    _contact_ratio(
        "stick_fraction",
        "sticking share of the contact width in rolling",
        value="result.rolling.stick_fraction",
    ),
    _contact_force(
        "rolling_normal_force",
        "normal force of the contact in rolling",
        value="result.rolling.normal",
        place="rolling.contacts.*.normal_N",
    ),
    _contact_force(
        "rolling_tangential_force",
        "tangential force of the contact in rolling",
        value="result.rolling.tangential",
        positive=False,
        note="as the creepages share the torque",
        place="rolling.contacts.*.tangential_N",
    ),
    _contact_force(
        "oil_drag",
        "drag of the oil on each surface of the contact in rolling",
        value="result.rolling.drag",
        positive=False,
        note="besides the tangential force; 0 without lubrication.viscosity or a fluid, and where the input stands",
    ),
    _per_contact(
        "hysteresis_moment",
        "moment of elastic hysteresis on both bodies of the contact in rolling",
        Dimension.TORQUE,
        "N*m",
        "result.rolling.hysteresis_moment",
        positive=False,
        note="0 without rolling.hysteresis_factor, and where the input stands",
    ),
    _contact_force(
        "skew_drag",
        "drag of the axial friction on each surface of the contact in rolling",
        value="result.rolling.skew_drag",
        positive=False,
        note="half of its work over the path; 0 without rolling.skew, and where the input stands",
    ),
    _contact_ratio(
        "layer_ratio",
        "yield of the asperities over that of the bodies",
        value="result.rolling.layer_ratio",
        note="u_0 R/a^2 with u_0 = N/K_n of the contact law; in the middle of crowned contacts",
    ),
    _contact_ratio(
        "layer_creepage_factor",
        "creepage with asperities over that of smooth bodies",
        value="result.rolling.layer_creepage_factor",
        column=Column("rolling", "creepage over smooth", unit_shown="times"),
    ),
    _per_contact(
        "rough_half_width",
        "half-width of the contact with asperities in rolling",
        Dimension.LENGTH,
        "mm",
        "result.rolling.rough_half_width",
        note="of the ellipse with the same root mean square of the places of the load",
    ),
    _per_contact(
        "rolling_hertz_pressure",
        "peak pressure of smooth bodies in rolling",
        Dimension.PRESSURE,
        "MPa",
        "result.rolling.hertz_pressure",
        note="of Hertz under the rolling forces; shakedown and life are judged by it",
        column=Column("rolling", "Hertz pressure"),
        place="rolling.contacts.*.hertz_pressure_Pa",
    ),
    _per_contact(
        "rough_peak_pressure",
        "peak pressure of the contact with asperities in rolling",
        Dimension.PRESSURE,
        "MPa",
        "result.rolling.rough_peak_pressure",
        note="nominal; life and shakedown take the higher one of smooth bodies, as the standards do",
        column=Column("rolling", "rough pressure"),
    ),
    _contact_ratio(
        "crown_creepage_factor",
        "creepage of smooth crowned rollers over that of cylinders",
        value=_crown_factor,
        note="nan where no roller of the joint is crowned",
    ),
    _contact_ratio(
        "skew_creepage_factor",
        "creepage with skew over that without",
        value="result.rolling.skew_creepage_factor",
    ),
    _contact_ratio(
        "capacity_loss",
        "share of the contact's friction used by skew",
        value="result.rolling.capacity_loss",
        positive=False,
    ),
    _contact_force(
        "axial_force", "axial force of the skewed contact", value="result.rolling.axial_force", positive=False
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
    _ratio(
        "speed_loss",
        "share of the output speed lost to creep",
        value="result.rolling.speed_loss",
        positive=False,
    ),
    _roll(
        "drift",
        "drift per output turn",
        Dimension.ANGLE,
        "arcmin",
        "result.rolling.drift_per_output_turn",
        positive=False,
        note="angle by which creep makes the output lag; it accumulates turn by turn",
        place="rolling.drift_rad_per_output_turn",
    ),
    _roll(
        "drift_rate",
        "drift per time",
        Dimension.ANGULAR_VELOCITY,
        "deg/h",
        "result.rolling.drift_rate",
        positive=False,
        note=_STANDING,
        place="rolling.drift_rad_per_hour",
    ),
    _roll(
        "rolling_output_speed",
        "angular velocity of the output less creep",
        Dimension.ANGULAR_VELOCITY,
        "rpm",
        "result.rolling.output_speed",
        positive=False,
        note="without its sign",
        place="rolling.output_speed_rad_per_s",
    ),
    _ratio(
        "rolling_residual",
        "residual of the rolling state",
        value="result.rolling.residual",
        differentiable=False,
        place="rolling.residual",
    ),
    _contact_ratio(
        "shakedown_ratio",
        "Hertz pressure over shakedown limit",
        value="result.rolling.shakedown_ratio",
        column=Column("rolling", "over shakedown limit"),
        limit=Limit(
            "damage",
            "plastic flow, if any, stops after the first turns",
            "the Hertz pressure exceeds the shakedown limit: the surface flows further at every passage",
            "choose a material of higher yield strength, longer contact lines, less preload or less traction",
            highest=1.0,
            beyond="above its shakedown limit",
        ),
        place="rolling.contacts.*.shakedown_ratio",
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
        note=f"as if it carried the whole load; nan without lubrication.pressure_coefficient or a fluid; {_STANDING}",
    ),
    _contact_ratio(
        "film_ratio",
        "film ratio λ (oil film over roughness)",
        value="result.rolling.film_ratio",
        note=f"below 1 boundary, to 3 mixed, above full lubrication; nan without lubrication.roughness or the "
        f"Ra of every surface; {_STANDING}",
    ),
    _contact_ratio(
        "life_factor",
        "film factor a_ISO of the life",
        value="result.rolling.life_factor",
        note=f"life of both tracks with the oil film over that without, ISO 281 with κ = λ^1.3; nan without "
        f"life.cleanliness or for κ below 0.1; {_STANDING}",
    ),
    _per_contact(
        "central_film",
        "central thickness of the oil film beside the asperities",
        Dimension.LENGTH,
        "um",
        _of_film("central_film"),
        note=f"of the film that carries its share; {_NO_FILM}; {_STANDING}",
        column=Column("film", "central film"),
    ),
    _contact_ratio(
        "inlet_heat_factor",
        "factor of heat at the inlet on the oil film",
        value=_inlet_heat_factor,
        positive=False,
        note=f"not above 0 beyond the range of its fit, where no film is known and nothing rolls; {_NO_FILM}; "
        f"{_STANDING}",
    ),
    _contact_ratio(
        "asperity_share",
        "share of the load that the asperities carry",
        value=_of_film("asperity_share"),
        note=f"uncertain by a factor of 1.6 in both directions; {_NO_FILM}; {_STANDING}",
        column=Column("film", "asperities carry"),
    ),
    _contact_ratio(
        "rival_asperity_share",
        "share that the asperities carry by the other law",
        value=_of_film("rival_share"),
        note=f"1 - erf of the film over the roughness, or the balance of film and separation; {_NO_FILM}; {_STANDING}",
        column=Column("film", "by the other law"),
    ),
    _contact_ratio(
        "traction_capacity",
        "largest traction coefficient of the contact in rolling",
        value=_of_film("traction_capacity"),
        note=f"up to lubrication.creep_limit, film and asperities together; {_NO_FILM}; {_STANDING}",
        column=Column("film", "largest T/N"),
    ),
    _contact_ratio(
        "film_creepage_factor",
        "creepage with film and asperities as elastic layers over that of the bodies",
        value=_of_film("elastic_factor"),
        note=f"{_NO_FILM}; {_STANDING}",
        column=Column("film", "elastic layers"),
    ),
    _per_contact(
        "film_warming",
        "warming of the oil film by slip",
        Dimension.TEMPERATURE_RISE,
        "K",
        _of_film("film_warming"),
        note=f"mean over the width, above the oil's temperature; {_NO_FILM}; {_STANDING}",
        column=Column("film", "film warms"),
    ),
    _contact_ratio(
        "deborah_number",
        "Deborah number of the oil film",
        value=_of_film("deborah_number"),
        note=f"above 1 the film is elastic before it flows; {_NO_FILM}, of a data sheet or a curve; {_STANDING}",
        column=Column("film", "Deborah"),
    ),
    _ratio(
        "efficiency",
        "efficiency",
        value="result.rolling.power.efficiency",
        highest_limit=1.0,
        note=f"{_STANDING}; only the losses for which the file has the numbers",
    ),
    _loss("input_power", "input power", value="result.rolling.power.input", note=_STANDING),
    _loss("output_power", "output power", value="result.rolling.power.output", note=_STANDING),
    _loss(
        "total_loss",
        "total power loss",
        value="result.rolling.power.loss",
        note=_STANDING,
        place="",
    ),
    _loss(
        "contact_loss",
        "power loss of the contact",
        value="result.rolling.power.contact",
        axis="contact",
        place="rolling.contacts.*.losses_W.total",
    ),
    _loss(
        "creep_loss",
        "power loss by creep",
        value="result.rolling.power.creep",
        axis="contact",
        place="rolling.contacts.*.losses_W.creep",
    ),
    _loss(
        "skew_loss",
        "power loss by skew",
        value="result.rolling.power.skew",
        axis="contact",
        place="rolling.contacts.*.losses_W.skew",
    ),
    _loss(
        "hysteresis_loss",
        "power loss by elastic hysteresis",
        value="result.rolling.power.hysteresis",
        axis="contact",
        note="nan without rolling.hysteresis_factor",
        place="rolling.contacts.*.losses_W.hysteresis",
    ),
    _loss(
        "oil_loss",
        "power loss by the oil at the inlet",
        value="result.rolling.power.oil",
        axis="contact",
        note="nan without lubrication.viscosity or a fluid",
        place="rolling.contacts.*.losses_W.oil",
    ),
    _loss(
        "bearing_loss",
        "power loss in bearings and pins",
        value="result.rolling.power.bearings",
        positive=False,
        place="",
    ),
    _hours(
        "drive_life",
        "rating life of the drive",
        value=lambda solved: 3600.0 * solved.result.rolling.life_hours.drive,
        note=f"rolling-contact fatigue at the file's load, speed and reliability; {_STANDING}",
        place="rolling.life_hours",
    ),
    _life(
        "life_turns",
        "rating life of the drive, in turns of the output",
        value="result.rolling.life_turns.drive",
        place="rolling.life_output_turns",
    ),
    _hours(
        "contact_life",
        "rating life of one contact of one branch (both tracks)",
        value=lambda solved: 3600.0 * solved.result.rolling.life_hours.contact,
        axis="contact",
        note=f"of a track that all branches share, the part of this one; {_STANDING}",
        place="rolling.contacts.*.life_hours",
    ),
    _life(
        "contact_life_turns",
        "rating life of one contact of one branch (both tracks), in turns of the output",
        value="result.rolling.life_turns.contact",
        axis="contact",
        column=Column("rolling", "life", unit_shown="output turns"),
        place="rolling.contacts.*.life_output_turns",
    ),
    _life(
        "body_life_turns",
        "rating life of one body, in turns of the output",
        value="result.rolling.life_turns.body",
        axis="body",
        place="rolling.body_life_output_turns.*",
    ),
    _hours(
        "body_life",
        "rating life of one body",
        value=lambda solved: 3600.0 * solved.result.rolling.life_hours.body,
        axis="body",
        note=_STANDING,
        place="rolling.body_life_hours.*",
    ),
    _hours(
        "duty_life",
        "rating life of the drive under the duty",
        value=lambda solved: 3600.0 * solved.result.rolling.duty_life_hours,
        note="nan without a duty",
        place="rolling.duty_life_hours",
    ),
    _life(
        "duty_life_turns",
        "rating life of the drive under the duty, in turns of the output",
        value="result.rolling.duty_life_turns",
        note="nan without a duty",
        place="rolling.duty_life_output_turns",
    ),
)
