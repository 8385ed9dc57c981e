"""What sections of joint files mean that are alike for every type of drive; materials and surfaces."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Any

from asperity.contact.asperity import AsperityBase
from asperity.contact.laws.law import ContactLaw
from asperity.contact.laws.registry import LAWS
from asperity.drive.structure.bearing_life import RatedBearing
from asperity.errors import InputError
from asperity.joint.play import NO_PLAY, Play
from asperity.joint_file.law_keys import ABSENT, LAWS_OF_KEY, RIVALS, refuse_halves
from asperity.joint_file.lubricant import lubricant_of
from asperity.joint_file.material_entries import OF_AVERAGE, ContactLawName
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import contacts_of
from asperity.joint_file.si_tables import Values, si_values
from asperity.materials import Material, hardness
from asperity.rolling.conditions import PLAIN_ROLLING, DutyPoint, RollingConditions
from asperity.standing.dynamics import Inertias
from asperity.surface.roughness_average import (
    RMS_OVER_RA,
    fractal_roughness_from_average,
    pair_average,
    standard_cut_off,
)
from asperity.types import Real


def play_of(values: Values) -> Play:
    """The play that the tables of a joint file state; :data:`asperity.joint.play.NO_PLAY` where they state none."""
    play = values.get("play", {})
    return Play(**{name: play.get(name, none) for name, none in vars(NO_PLAY).items()})


def inertias_from_case(case: Case) -> Inertias:
    """What a file couples to its joint; an ``InputError`` if it has no section ``[dynamics]``.

    Without a loss factor the spring loses no work.
    """
    if case.dynamics is None:
        raise InputError(
            "the joint file has no section [dynamics]: give dynamics.input_inertia of the motor at the sun and "
            'dynamics.output_inertia of the load, e.g. "2e-6 kg*m^2" and "0.05 kg*m^2"'
        )
    values = si_values(case)["dynamics"]
    return Inertias(
        input=values["input_inertia"],
        output=values["output_inertia"],
        loss_factor=values.get("loss_factor", 0.0),
    )


def rated_bearing(entry: Values | None) -> RatedBearing | None:
    """A rolling bearing as a section of a joint file rates it."""
    if entry is None:
        return None
    return RatedBearing(
        dynamic_rating=entry["dynamic_rating"],
        static_rating=entry["static_rating"],
        count=entry.get("count", 1.0),
        outside_force=entry.get("outside_force", 0.0),
        kind=entry["type"],
    )


def rolling_conditions(values: Values, temperature: Real | None) -> RollingConditions:
    """What the tables of a joint file say about rolling: numbers by the names of their keys, others as stated here.

    ``temperature`` of the oil [degC]; None where nothing gives one.
    """
    rolling, oil, plain = values.get("rolling", {}), values.get("lubrication", {}), PLAIN_ROLLING
    same = {key: value for key, value in {**oil, **rolling}.items() if key in RollingConditions.number_fields}
    other = {
        "skew": entries(rolling["skew"], contacts_of(values)) if "skew" in rolling else plain.skew,
        "hysteresis_loss_factor": rolling.get("hysteresis_factor", plain.hysteresis_loss_factor),
        "pressure_viscosity_coefficient": oil.get(
            "pressure_coefficient", plain.pressure_viscosity_coefficient
        ),
        "roughness": film_roughness(values),
        "cleanliness": values.get("life", {}).get("cleanliness", plain.cleanliness),
        "duty": tuple(
            DutyPoint(load["output_torque"], load["sun_speed"], load["share"])
            for load in values.get("duty", {}).values()
        ),
    }
    conditions = dataclasses.replace(plain, **(same | other), lubricant=lubricant_of(values, temperature))
    oil = conditions.lubricant
    return conditions if oil is None else conditions.with_oil_at(oil.temperature)


def film_roughness(values: Values) -> tuple[Any, ...] | None:
    """Roughness of a contact [m] that the oil film is compared with, from the file or Ra; None without either."""
    oil = values.get("lubrication", {})
    if "roughness" in oil:
        return (oil["roughness"],)
    if "pressure_coefficient" not in oil and "fluid" not in oil:
        return None
    surfaces = entries(values["surface"], contacts_of(values))
    if not all("roughness_average" in entry for entry in surfaces):
        return None
    return tuple(rms_height_of_average(entry) for entry in surfaces)


def rms_height_of_average(entry: Values) -> Any:
    r"""The rms of the heights [m] of both bodies together, of normally distributed heights with the Ra of a surface.

    .. math:: \sigma = \sqrt{\pi/2}\,\sqrt{R_{a1}^2 + R_{a2}^2}

    References
    ----------
    Normally distributed heights: :data:`asperity.surface.roughness_average.RMS_OVER_RA`.
    """
    return RMS_OVER_RA * _average_of_both(entry)


def _average_of_both(entry: Values) -> Any:
    """Ra of both bodies together [m]; a partner that is not stated is alike."""
    first = entry["roughness_average"]
    return pair_average(first=first, second=entry.get("partner_roughness_average", first))


def entries(entry: Any, contacts: tuple[str, ...]) -> tuple[Any, ...]:
    """One entry for all contacts, or one each."""
    if isinstance(entry, dict) and contacts[0] in entry:
        return tuple(entry[name] for name in contacts)
    return (entry,)


def surface_of(entry: Values, *, asperity_base: AsperityBase, contact_law: ContactLawName) -> ContactLaw:
    """The equivalent surface of both bodies of a contact, as the law of its asperities takes it."""
    law = LAWS[contact_law]
    refuse_halves(entry)
    numbers = {key: entry[key] if key in entry else _OF_AVERAGE[key](entry) for key in law.needs}
    numbers |= {key: entry[key] for key in ABSENT if key in entry and law in LAWS_OF_KEY[key]}
    return law.of_surface(numbers, asperity_base=asperity_base)


def alike(surfaces: Iterable[Values]) -> tuple[Values, ...]:
    """Surfaces of which each states what one of them does of the keys that may be left out."""
    found = tuple(surfaces)
    some = {key: absent for key, absent in ABSENT.items() if any(key in entry for entry in found)}
    return tuple(
        {key: absent for key, absent in some.items() if not RIVALS.get(key, set()) & entry.keys()} | entry
        for entry in found
    )


def _roughness_of_average(entry: Values) -> Any:
    """G [m] of a surface by its D and Ra."""
    average = entry["roughness_average"]
    return fractal_roughness_from_average(
        roughness_average=_average_of_both(entry),
        cut_off=entry["cut_off"] if "cut_off" in entry else standard_cut_off(roughness_average=average),
        fractal_dimension=entry["fractal_dimension"],
    )


#: Number of a surface → what it is where the file states its Ra.
_OF_AVERAGE = dict(zip(OF_AVERAGE, (_roughness_of_average, rms_height_of_average), strict=True))


def material_of(entry: Values) -> Material:
    """A material from its table."""
    elastic = {name: entry[name] for name in ("youngs_modulus", "poisson_ratio", "density", "yield_strength")}
    return Material(
        **elastic,
        hardness=_hardness(entry),
        thermal_conductivity=entry.get("thermal_conductivity"),
        specific_heat_capacity=entry.get("specific_heat_capacity"),
        thermal_expansion=entry.get("thermal_expansion"),
        fatigue_strength=entry.get("fatigue_strength"),
        tensile_strength=entry.get("tensile_strength"),
    )


def _hardness(entry: Values) -> Real:
    if "hardness" in entry:
        return entry["hardness"]
    return hardness(hardness_factor=entry["hardness_factor"], yield_strength=entry["yield_strength"])
