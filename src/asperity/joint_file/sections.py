"""The content of a joint file: a class for each section, a field for each key."""

from __future__ import annotations

import itertools
import math
from collections.abc import Collection, Iterable, Mapping
from typing import Annotated, Literal, Self

from pydantic import BeforeValidator, Field, StringConstraints, model_validator

from asperity.contact.film_thickness import FilmLaw
from asperity.contact.load_sharing import SharingLaw
from asperity.errors import InputError, quoted
from asperity.joint_file import limits
from asperity.joint_file.material_entries import MaterialEntry
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import Section

Length = Annotated[Quantity, limits.ROLLER_RADIUS]
ContactLength = Annotated[Quantity, limits.CONTACT_LENGTH]
BodyLength = Annotated[Quantity, limits.BODY_LENGTH]
PushAngle = Annotated[Quantity, limits.PUSH_ANGLE]
Friction = Annotated[Quantity, limits.FRICTION_COEFFICIENT]
BearingTorque = Annotated[Quantity, limits.BEARING_TORQUE]
CrownRadius = Annotated[Quantity, limits.CROWN_RADIUS]
Skew = Annotated[Quantity, limits.SKEW]


class BoundaryPoint(Section):
    """Friction of asperities at one speed of slip; [speed, coefficient] in the file."""

    slip_speed: Annotated[Quantity, limits.SLIP_SPEED]
    """Speed at which the surfaces slip."""
    coefficient: Friction
    """Friction coefficient of the asperities there."""

    @model_validator(mode="before")
    @classmethod
    def _of_a_pair(cls, written: object) -> object:
        """The table of a pair."""
        if isinstance(written, list | tuple):
            if len(written) != 2:
                raise InputError(f"expected [slip speed, coefficient], e.g. {_PAIR}, got {quoted(written)}")
            return dict(zip(("slip_speed", "coefficient"), written, strict=True))
        return written


_PAIR = '["0.01 m/s", 0.11]'


class Lubrication(Section):
    """The oil; without it the contacts are dry."""

    fluid: Annotated[str, StringConstraints(min_length=1, max_length=60)] | None = None
    """The oil by its name in the library (`asperity materials`) or in a section [fluids.NAME]: its viscosity at
    temperature.working, and with its traction the friction of the contacts. Either this or viscosity."""
    viscosity: Annotated[Quantity, limits.VISCOSITY] | None = None
    """Viscosity of the oil at the inlet of the contacts; makes the rolling loss of the oil."""
    pressure_coefficient: Annotated[Quantity, limits.PRESSURE_COEFFICIENT] | None = None
    """Pressure coefficient of the viscosity; makes the thickness of the oil film, which is left out without it."""
    roughness: Annotated[Quantity, limits.ROUGHNESS] | None = None
    """Root mean square of the heights of both surfaces together, sqrt(Rq1^2 + Rq2^2); makes the ratio lambda of the oil
    film to it. From the Ra of [surface], where all contacts have one, if absent: 1.2533 times the Ra of both."""
    supply: Annotated[Quantity, limits.SUPPLY] | None = None
    """Thickness of the film over that of a flooded contact, less than 1 for grease or little oil; 1 if absent."""
    load_sharing: SharingLaw | None = None
    """How asperities and film share the load: persson, by one equation of film and asperities, or its rival erf, by the
    heights above the film of the whole load; persson if absent."""
    film_law: FilmLaw | None = None
    """Law of the central film; moes, which alone stays right where asperities take load off the film, if absent."""
    creep_limit: Annotated[Quantity, limits.CREEP_LIMIT] | None = None
    """Largest creepage at which a traction counts as one that a contact carries; 0.02 if absent."""
    boundary_friction: Annotated[tuple[BoundaryPoint, ...], Field(min_length=2)] | None = None
    """Friction coefficient of the asperities over the speed of slip, a list of pairs [speed, coefficient] with rising
    speeds, between which it goes with the logarithm of the speed; load.friction_coefficient if absent."""

    @model_validator(mode="after")
    def _one_oil(self) -> Self:
        if self.fluid is None and self.viscosity is None:
            raise InputError(".viscosity: this key is missing, or fluid in its place")
        if self.fluid is not None and self.viscosity is not None:
            raise InputError("fluid and viscosity: a fluid has a viscosity of its own; leave one of them out")
        if self.fluid is not None and self.pressure_coefficient is not None:
            raise InputError(
                "pressure_coefficient: a fluid has one of its own; leave it out, or state it in the section "
                f"[fluids.NAME] of {quoted(self.fluid)}"
            )
        of_fluid = ("supply", "load_sharing", "film_law", "creep_limit", "boundary_friction")
        lonely = [name for name in of_fluid if getattr(self, name) is not None]
        if self.fluid is None and lonely:
            raise InputError(
                f"{', '.join(lonely)}: only with lubrication.fluid, whose film carries a part of the load; give the "
                "fluid in place of viscosity, or leave it out"
            )
        speeds = [point.slip_speed.value for point in self.boundary_friction or ()]
        if any(later <= earlier for earlier, later in itertools.pairwise(speeds)):
            raise InputError("boundary_friction: the speeds must rise from pair to pair; sort them")
        return self


class LifeEntry(Section):
    """What the oil does to the life; without it lives have no factor for the film."""

    cleanliness: Annotated[Quantity, limits.CLEANLINESS]
    """Contamination factor e_C of ISO 281, which makes the factor a_ISO of the rating life from the oil film of every
    contact. For parts below 100 mm: 1 in a laboratory, 0.8 to 0.6 with a very fine filter or sealed for life, 0.6 to
    0.5 with a fine filter, 0.5 to 0.3 slightly contaminated, 0.3 to 0.1 without seals, below 0.1 severely; larger parts
    up to 0.2 more. Needs the film ratio: an oil with a pressure coefficient or by name, and its roughness."""


def refuse_cleanliness(
    life: LifeEntry | None, oil: Lubrication | None, surfaces: Iterable[Collection[str]]
) -> None:
    """Refuse a cleanliness without the film ratio that it needs.

    ``surfaces``: keys that each surface states.
    """
    if life is None:
        return
    stated = f"life.cleanliness = {life.cleanliness.text!r}"
    if oil is None or (oil.fluid is None and oil.pressure_coefficient is None):
        raise InputError(
            f"{stated} needs the oil film of the contacts: give [lubrication] fluid with temperature.working, or "
            "viscosity and pressure_coefficient; or leave [life] out"
        )
    if oil.roughness is None and not all("roughness_average" in keys for keys in surfaces):
        raise InputError(
            f"{stated} needs the ratio of the oil film to the roughness: give lubrication.roughness, e.g. "
            '"0.2 um", or state every surface by its Ra; or leave [life] out'
        )


#: Highest temperature of an oil where a file states none [degC].
OIL_LIMIT = 120.0

_Share = Annotated[float, Field(gt=0.0, le=1.0)] | str


def _share(written: object) -> float:
    """A share of the time, as a number or as text in per cent."""
    share = limits.SHARE.read(written)
    if share.tolerance:
        raise InputError(f"a share of the time has no tolerance, got {written!r}")
    return share.value


class DutyLoad(Section):
    """One load of the duty; write [[duty]] above each."""

    output_torque: Annotated[Quantity, limits.DUTY_TORQUE]
    """Torque at the output; negative where it drives the rotation."""
    sun_speed: Annotated[Quantity, limits.SUN_SPEED]
    """Speed of the sun, or of the input, whatever its name."""
    share: Annotated[float, BeforeValidator(_share, json_schema_input_type=_Share), Entered(limits.SHARE)]
    """Share of the time, as 0.4 or "40 %"; the shares of all loads add up to 1."""


Duty = Annotated[tuple[DutyLoad, ...], Field(min_length=1)]


def refuse_part_of_a_duty(duty: tuple[DutyLoad, ...] | None) -> None:
    """Refuse a duty whose loads do not share the whole time."""
    total = math.fsum(load.share for load in duty or ())
    if duty is not None and abs(total - 1.0) > 1e-9:
        raise InputError(f"the shares of [[duty]] must add up to 1, they add up to {total:.10g}")


WearCoefficient = Annotated[Quantity, limits.WEAR_COEFFICIENT]


class DynamicsEntry(Section):
    """What is coupled to the joint, for its natural frequencies."""

    input_inertia: Annotated[Quantity, limits.INPUT_INERTIA]
    """Moment of inertia of motor and coupling at the sun."""
    output_inertia: Annotated[Quantity, limits.OUTPUT_INERTIA]
    """Moment of inertia of the load at the carrier, the carrier included."""
    loss_factor: Annotated[Quantity, limits.LOSS_FACTOR] | None = None
    """Loss factor of the joint's spring; without it the spring loses no work."""


class PlayEntry(Section):
    """Play at the output; a joint file without this section has none."""

    angle: Annotated[Quantity, limits.PLAY_ANGLE]
    """Angle that the output turns freely on passing zero torque, from one side to the other."""
    take_up_torque: Annotated[Quantity, limits.TAKE_UP_TORQUE]
    """Torque T_p over which the play is taken up, angle/2 tanh(T/T_p); 0 for all at once."""


class _RatedBearing(Section):
    """What the bearings of pins and of the axis have in common."""

    type: Literal["ball", "roller"]
    """Rolling elements; needle bearings are roller bearings."""
    dynamic_rating: Annotated[Quantity, limits.LOAD_RATING]
    """Basic dynamic radial load rating C of one bearing, from its catalogue."""
    static_rating: Annotated[Quantity, limits.LOAD_RATING]
    """Basic static radial load rating C_0 of one bearing, from its catalogue."""


class PinEntry(Section):
    """The pins of the carrier, and where their friction acts."""

    pin_friction_diameter: Annotated[Quantity, limits.PIN_DIAMETER] | None = None
    """Diameter at which the friction coefficient of pins acts, such as that of the journals of a solid roller, or the
    mean one of rolling bearings; it makes no bore. If absent, pin_diameter."""
    pin_diameter: Annotated[Quantity, limits.PIN_DIAMETER] | None = None
    """Diameter d of pins that press in the bores of their rollers; a roller without a bore diameter has a bore as wide.
    If absent, or 0, the force of a pin is spread over the rim of its roller."""
    pin_radial_clearance: Annotated[Quantity, limits.PIN_CLEARANCE] | None = None
    """Radial clearance of these pins in the bores: half the difference of the diameters, all round in the assembled
    drive. It narrows the arc of contact, and mostly makes the joint softer; none if absent."""
    pin_length: Annotated[Quantity, limits.PIN_LENGTH] | None = None
    """Free length of a pin, with its roller in the middle: between its two supports, or from its only support to its
    end. Makes the bending moment of the pin; with pin_diameter also its bending stress, and its stiffness unless
    compliance.pin_stiffness states one."""
    pin_support: Literal["both_ends", "one_end"] | None = None
    """How the carrier holds a pin of this length; at both ends, which may turn, if absent."""

    @model_validator(mode="after")
    def _of_a_diameter(self) -> Self:
        """Refuse friction that acts at no diameter, and the clearance of no pin."""
        friction = getattr(self, "pin_friction_coefficient", None)
        stated = {name: key is not None for name, key in self}
        if friction is not None and not (stated["pin_friction_diameter"] or stated["pin_diameter"]):
            raise InputError(
                "pin_friction_coefficient acts at a diameter, which is missing: give pin_friction_diameter, or the "
                "pin_diameter of pins that press in bores"
            )
        if self.pin_radial_clearance is not None and not (
            self.pin_diameter and self.pin_diameter.value > 0.0
        ):
            raise InputError(
                f"pin_radial_clearance = {self.pin_radial_clearance.text!r}: only pins of a pin_diameter above 0 press "
                "in bores; give it, or leave the clearance out"
            )
        return self


class PinBearing(_RatedBearing):
    """Rolling bearings between a roller and its carrier pin, for their life; none if the section is absent."""

    count: Annotated[Quantity, limits.BEARING_COUNT]
    """Bearings of one roller, which share its pin force equally."""


class HeldBearing(_RatedBearing):
    """A bearing on the axis of the drive, which equal branches do not load."""

    outside_force: Annotated[Quantity, limits.OUTSIDE_FORCE]
    """Radial force on the most loaded bearing from outside the drive: weights, belts, couplings, the arm."""


class TemperatureEntry(Section):
    """Temperature of the whole drive: where the preload is made by interference, it changes with it."""

    assembly: Annotated[Quantity, limits.TEMPERATURE]
    """Temperature at which load.interference is measured."""
    working: Annotated[Quantity, limits.TEMPERATURE] | None = None
    """Temperature for which all results hold; the same in all bodies. Left out with [heat], which gives it."""
    housing_expansion: Annotated[Quantity, limits.THERMAL_EXPANSION] | None = None
    """Coefficient of linear thermal expansion of the housing that holds the ring's outer rim; that of the ring if
    absent."""


class HeatEntry(Section):
    """How the heat of the losses leaves the drive; all results then hold at the temperatures that it settles at."""

    ambient: Annotated[Quantity, limits.TEMPERATURE]
    """Temperature around the housing."""
    resistance: Annotated[Quantity, limits.THERMAL_RESISTANCE] | None = None
    """Thermal resistance of the housing to its surroundings, measured: how much warmer than them a watt makes it.
    Either this or area and coefficient."""
    area: Annotated[Quantity, limits.COOLED_AREA] | None = None
    """Outer area of the housing that air cools."""
    coefficient: Annotated[Quantity, limits.HEAT_TRANSFER] | None = None
    """Heat transfer coefficient of this area: 5 to 10 W/m^2/K in still air, 20 to 50 W/m^2/K in moving air."""
    roller_resistance: Annotated[Quantity, limits.ROLLER_RESISTANCE] | None = None
    """Thermal resistance of the rollers to the housing: how much warmer than it a watt makes them; 0 if absent."""
    heat_capacity: Annotated[Quantity, limits.HEAT_CAPACITY] | None = None
    """Heat capacity of the housing with its rings, for the time in which the drive warms up and for peaks of a duty;
    neither is computed if absent."""
    duty_time: Annotated[Quantity, limits.DUTY_TIME] | None = None
    """Time of one pass through the loads of [[duty]], in their order and repeated, for its highest temperature; without
    it only the mean one is known."""
    oil_limit: Annotated[Quantity, limits.TEMPERATURE] | None = None
    """Highest temperature of the oil, up to which a steady temperature counts; 120 degC if absent."""
    cold_start: Annotated[Quantity, limits.TEMPERATURE] | None = None
    """Lowest temperature at which the drive has to start: capacities and torque of the input there."""

    @model_validator(mode="after")
    def _one_way_out(self) -> Self:
        by_area = [name for name in ("area", "coefficient") if getattr(self, name) is not None]
        if (self.resistance is None) == (not by_area):
            given = "neither" if self.resistance is None else "both"
            raise InputError(f"exactly one of resistance and area with coefficient is needed, got {given}")
        if len(by_area) == 1:
            missing = "coefficient" if by_area == ["area"] else "area"
            raise InputError(f".{missing}: this key is missing: {by_area[0]} alone cools nothing")
        limit = OIL_LIMIT if self.oil_limit is None else self.oil_limit.value
        for name in ("ambient", "cold_start"):
            stated = getattr(self, name)
            if stated is not None and not stated.value < limit:
                raise InputError(
                    f"{name} = {quoted(stated.text)} must be below oil_limit, {limit:g} degC; lower it, or raise "
                    "oil_limit"
                )
        return self


def refuse_temperatures(
    temperature: TemperatureEntry | None, heat: HeatEntry | None, *, by_interference: bool
) -> None:
    """Refuse a working temperature that nothing gives, or that two sections give."""
    if heat is None:
        if temperature is not None and temperature.working is None:
            raise InputError("temperature.working: this key is missing, or a section [heat] in its place")
        return
    if temperature is not None and temperature.working is not None:
        raise InputError(
            "[heat] and temperature.working: the losses and what cools the drive give its temperature; leave one of "
            "both out"
        )
    if temperature is None and by_interference:
        raise InputError(
            "[heat] with load.interference or [housing] needs the temperature at which these are measured: give "
            'temperature.assembly, e.g. "20 degC"'
        )


def refuse_temperature(
    temperature: TemperatureEntry | None,
    *,
    by_interference: bool,
    bodies: Mapping[str, str],
    materials: Mapping[str, MaterialEntry],
    without_housing: str,
) -> None:
    """Refuse temperatures for which something is not known, or is known of nothing."""
    if temperature is None:
        return
    unknown = without_expansion(bodies, materials)
    if by_interference and unknown:
        raise InputError(
            f"[temperature] with load.interference or [housing] needs the thermal_expansion of every material: give it "
            f'for {", ".join(unknown)}, e.g. thermal_expansion = "11.5e-6 1/K", or take a material of the library'
        )
    if temperature.housing_expansion is not None and without_housing:
        raise InputError(f"{without_housing} has no housing: leave out temperature.housing_expansion")


def without_expansion(bodies: Mapping[str, str], materials: Mapping[str, MaterialEntry]) -> list[str]:
    """Names of the materials of bodies whose thermal expansion is not known.

    From body → material and material → entry.
    """
    used = dict.fromkeys(bodies.values())
    return [name for name in used if name in materials and materials[name].thermal_expansion is None]


class HousingEntry(Section):
    """The housing into which every ring is pressed that is not free; bodies.housing is its material."""

    outer_diameter: Annotated[Quantity, limits.HOUSING_DIAMETER]
    """Outer diameter of the housing, a thick-walled cylinder as long as the ring."""
    interference: Annotated[Quantity, limits.HOUSING_INTERFERENCE]
    """By how much the outer diameter of a ring exceeds the bore at the assembly, less what pressing smooths the seats.
    On the diameter, as fits are given, while load.interference is one on the radius."""
    friction_coefficient: Friction
    """Friction coefficient of the seat; by DIN 7190-1 0.12 to 0.2 of steel in steel, 0.1 to 0.15 in light alloy."""


Deviation = Annotated[Quantity, limits.DEVIATION]


def refuse_branches(section_count: int, *, count: int, what: str, by_interference: bool) -> None:
    """Refuse sections ``[[branch]]`` that do not belong to their drive."""
    if section_count != count:
        raise InputError(f"the drive has {count} {what}, but there are {section_count} sections [[branch]]")
    if not by_interference:
        raise InputError(
            "[[branch]] needs load.interference in place of load.preload: sizes make no preload that a spring holds"
        )
