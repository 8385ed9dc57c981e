"""The content of a joint file: what the files of all types of drives have in common, a field for each key."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, Self

from pydantic import AfterValidator, Field, PrivateAttr, model_validator

from asperity.contact.laws.registry import LAWS
from asperity.drive.layout.drive_type import DriveType
from asperity.errors import InputError, closest, nearest
from asperity.joint_file import limits
from asperity.joint_file.drive_sections import (
    BENT,
    OpenRadius,
    PartFriction,
    PartName,
    PartSkews,
    PartSurfaces,
    PartWear,
)
from asperity.joint_file.fluid_entries import FluidEntry, FluidName
from asperity.joint_file.form_entries import FormEntry
from asperity.joint_file.heat_refusals import refuse_heat_of_nothing
from asperity.joint_file.law_keys import refuse_keys_of_others
from asperity.joint_file.lubricant import refuse_oil
from asperity.joint_file.material_entries import (
    ContactLawName,
    MaterialEntry,
    MaterialName,
    contact_law_of,
    law_words,
    one_kind_of_roughness,
    unknown_materials,
)
from asperity.joint_file.part_names import HOUSING
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.roller_profiles import misstated_profiles, shaped_contacts
from asperity.joint_file.section import Section, WholeFile
from asperity.joint_file.sections import (
    BearingTorque,
    Duty,
    DynamicsEntry,
    HeatEntry,
    HeldBearing,
    HousingEntry,
    LifeEntry,
    Lubrication,
    PinBearing,
    PinEntry,
    PlayEntry,
    TemperatureEntry,
    refuse_branches,
    refuse_cleanliness,
    refuse_part_of_a_duty,
    refuse_temperature,
    refuse_temperatures,
)
from asperity.joint_file.tilt_entries import TiltEntry, misnamed_tilts


class Load(Section):
    """What acts on the drive."""

    preload: Annotated[Quantity, limits.PRELOAD] | None = None
    """Normal force of the first contact, that of the sun, without torque; either this or interference."""
    interference: Annotated[Quantity, limits.INTERFERENCE] | None = None
    """Interference that makes the preload: by how much the inner radius of every ring lies below that at which all
    contacts just touch."""
    cam_force_per_torque: Annotated[Quantity, limits.CAM_FORCE] | None = None
    """Loading cam: what each N*m of output torque, in either direction, adds to the normal force of the first contact;
    the preload or interference above is then the least one, without torque. No cam if absent."""
    output_torque: Annotated[Quantity, limits.OUTPUT_TORQUE]
    """Torque at the output; negative where it drives the rotation."""
    sun_speed: Annotated[Quantity, limits.SUN_SPEED] | None = None
    """Speed of the sun, or of the input, whatever its name; the friction of the bearings opposes it. Either this or
    output_speed."""
    output_speed: Annotated[Quantity, limits.OUTPUT_SPEED] | None = None
    """Speed of the output without its sign, from which that of the input follows by the speed ratio without slip."""
    friction_coefficient: PartFriction
    """Friction coefficient mu of the contacts: one for all, or a table with their names."""

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        for one, other in (("preload", "interference"), ("sun_speed", "output_speed")):
            if (getattr(self, one) is None) == (getattr(self, other) is None):
                given = "neither" if getattr(self, one) is None else "both"
                raise InputError(f"exactly one of '{one}' and '{other}' is needed, got {given}")
        return self


class BearingFriction(PinEntry):
    """Friction of the bearings, and the pins of the carrier; an absent key is no friction."""

    input_torque: BearingTorque | None = None
    """Friction torque of one of the two bearings of the input shaft."""
    output_torque: BearingTorque | None = None
    """Friction torque of one of the two bearings of the output shaft."""
    roller_torque: BearingTorque | None = None
    """Constant friction torque of one of the two bearings of a roller on a pin of the carrier."""
    pin_friction_coefficient: Annotated[Quantity, limits.PIN_FRICTION_COEFFICIENT] | None = None
    """Friction coefficient mu_b of these bearings: friction force over the force of the pin, at pin_friction_diameter,
    or at pin_diameter; it needs one of them."""


class Compliance(Section):
    """Springs of the structure around the rollers; an absent key is the ideal its description names."""

    pin_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of one carrier pin along its push, without its contact in the bore; rigid if absent, or that of a beam
    where [bearings] states pin_diameter and pin_length."""
    pin_transverse_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of one carrier pin across its push, relaxed in the assembled drive; free if absent."""
    planet_support_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of the bearing on the carrier of every roller without a pin, relaxed in the assembled drive; such
    rollers float if absent."""
    ring_bending_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Spring in series with each contact of a ring, for its bending, in addition to a ring in a rigid housing; rigid if
    absent. ring_support = "free" computes the bending instead."""
    ring_housing_stiffness: Annotated[Quantity, limits.HOUSING] | None = None
    """Radial stiffness of the housing around rings, per area of their outer surface; needed for, and only for,
    ring_support = "elastic_housing" without [housing]."""
    input_shaft_stiffness: Annotated[Quantity, limits.TORSION_SPRING] | None = None
    """Torsional stiffness of the shaft to the sun; rigid if absent."""
    output_shaft_stiffness: Annotated[Quantity, limits.TORSION_SPRING] | None = None
    """Torsional stiffness of the shaft from the output; rigid if absent."""
    sun_support_stiffness: Annotated[Quantity, limits.SUPPORT] | None = None
    """Radial stiffness of the bearings of the sun together, or of the input, whatever its name, for branches of their
    own sizes, [[branch]], and form errors, [[form]]; 0 for a floating one, rigid if absent."""


class Rolling(Section):
    """The joint that turns; every key may be absent."""

    skew: PartSkews | None = None
    """Angle by which the axes of a contact are out of parallel: one for all, or a table with the names of the contacts;
    parallel if absent."""
    hysteresis_factor: Annotated[Quantity, limits.HYSTERESIS_FACTOR] | None = None
    """Share of the elastic work that the bodies lose as they roll; 0.005 to 0.05 for hardened steel. Without it this
    loss is left out."""
    reliability: Annotated[Quantity, limits.RELIABILITY] | None = None
    """Share of all drives that reach the stated life; 0.9 if absent."""
    required_life: Annotated[Quantity, limits.REQUIRED_LIFE] | None = None
    """Hours of work that the drive and its rolling bearings have to reach, under the duty if there is one; a limit of
    the joint, which moves no result."""
    allowed_transmission_error: Annotated[Quantity, limits.TRANSMISSION_ERROR] | None = None
    """Largest deviation of the output from even rotation that the form errors of [[form]] may make, worst over all
    phases; a limit of the joint, which moves no result."""


class Wear(Section):
    """Wear of the tracks, for `asperity wear`; without it times are products with the wear coefficient."""

    coefficient: PartWear
    """Wear coefficient k, worn volume over normal force and way of slip: one for all parts, or a table with the names
    of [bodies]. There is no usual one: it spans ten orders of magnitude."""


class ModelChoice(Section):
    """Which variants of the model to use."""

    contact_factor: Literal["printed", "hertz_area", "unity"]
    """Model of the contact factor lambda."""
    asperity_base: Literal["majumdar_bhushan_1991", "circular_spot"]
    """Base length of an asperity."""
    bodies: Literal["exact", "springs"] | None = None
    """Bodies: by plane elasticity, or one spring for each contact; exact if absent. Stepped rollers are springs, with
    what their bores add."""
    plane_state: Literal["plane_strain", "plane_stress"] | None = None
    """Exact bodies: long, plane strain, or thin, plane stress; plane strain if absent."""
    contact_law: Annotated[ContactLawName | None, Field(description=law_words())] = None
    closure_springs: Literal["bulk", "bulk_and_asperities"] | None = None
    """Normal springs of the force balance under load, one for each contact, between rigid pins: the bodies alone, or
    with their asperities. Those of the assembly if absent."""


def stated_texts(section: Section) -> dict[str, str]:
    """What a section states of its own keys, as the file writes it; without tables below it."""
    return {
        name: value.text if isinstance(value, Quantity) else str(value)
        for name, value in section
        if isinstance(value, Quantity | str)
    }


class Case(WholeFile):
    """What joint files of all drives have in common."""

    type: str
    """Type of the drive."""
    if TYPE_CHECKING:  # a field of every kind of file, each with its own keys
        drive: Any
        branch: tuple[Any, ...] | None
        bearings: Any
    load: Load
    """Preload, torque, speed, friction."""
    temperature: TemperatureEntry | None = None
    """Temperature of the drive; that of the assembly if the section is absent."""
    heat: HeatEntry | None = None
    """How heat leaves the drive, which gives its temperature; temperature.working does if the section is absent."""
    housing: HousingEntry | None = None
    """The housing into which rings are pressed, for their seats; not described if the section is absent."""
    pin_bearing: PinBearing | None = None
    """Rolling bearings of the rollers on pins, for their life: one section, whose ratings hold for every row of rollers
    on pins; try rows with different bearings one after the other."""
    compliance: Compliance | None = None
    """Springs of pins, supports, rings and shafts; ideal if the section is absent."""
    rolling: Rolling | None = None
    """Skew, hysteresis, reliability and required life of the joint that turns."""
    wear: Wear | None = None
    """Wear of the tracks; its times have no hours if the section is absent."""
    tilt: Annotated[dict[PartName, TiltEntry], Field(min_length=1)] | None = None
    """Axes out of parallel, for `asperity loads`: a section [tilt.NAME_axis] for each; parallel if absent."""
    lubrication: Lubrication | None = None
    """The oil; dry if the section is absent."""
    fluids: dict[FluidName, FluidEntry] | None = None
    """Oils by name, for lubrication.fluid."""
    life: LifeEntry | None = None
    """Cleanliness of the oil, for lives with a factor for the film; without one if the section is absent."""
    form: Annotated[tuple[FormEntry, ...], Field(min_length=1)] | None = None
    """Runout and roundness of parts, for `asperity accuracy`: a section [[form]] for each; perfect if absent."""
    duty: Duty | None = None
    """Loads and their shares of the time, for the life under a duty: a section [[duty]] for each."""
    dynamics: DynamicsEntry | None = None
    """Inertias of motor and load, for `asperity dynamics`."""
    play: PlayEntry | None = None
    """Play at the output; none if the section is absent."""
    model: ModelChoice
    """Variants of the model."""
    materials: Annotated[dict[MaterialName, MaterialEntry], Field(min_length=1)]
    """Materials by name."""
    bodies: dict[PartName, MaterialName]
    """Which material each body is made of."""
    surface: Annotated[PartSurfaces, AfterValidator(one_kind_of_roughness)]
    """Roughness: one table for all contacts, or tables surface.NAME for each."""

    #: The type of drive that it describes.
    drive_type: ClassVar[DriveType]

    _open_radius: OpenRadius | None = PrivateAttr(default=None)
    _measured: Any = PrivateAttr(default=None)

    @property
    def measured(self) -> Any:
        """Its :class:`~asperity.joint_file.measured_surface.MeasuredSurface`; None where its surfaces are stated."""
        return self._measured

    def with_measured(self, measured: Any) -> Self:
        """A copy of the case, which remembers where its surfaces are from."""
        copy = self.model_copy()
        copy._measured = measured
        return copy

    @property
    def open_radius(self) -> OpenRadius | None:
        """The radius that the file leaves open for its ``drive.ratio``."""
        return self._open_radius

    def with_open_radius(self, radius: OpenRadius | None) -> Self:
        """A copy of the case, which remembers the radius that it was given."""
        copy = self.model_copy()
        copy._open_radius = radius
        return copy

    @model_validator(mode="after")
    def _known_materials(self) -> Self:
        unknown = unknown_materials(self.bodies, self.materials)
        if unknown:
            raise InputError("\n  ".join(unknown))
        return self

    @model_validator(mode="after")
    def _law_of_every_surface(self) -> Self:
        stated = self.model.contact_law
        measured = stated is not None and LAWS[stated].from_measurement == "decay_length"
        if not measured:  # a measured surface takes the place of the file's
            stated = self.contact_law()
        assert stated is not None
        refuse_keys_of_others(self._surface_keys(), stated)
        return self

    def contact_law(self) -> ContactLawName:
        """The law of the asperities of all contacts, stated or not."""
        return contact_law_of(self._surface_keys(), stated=self.model.contact_law)

    def _surface_keys(self) -> list[set[str]]:
        """Keys that the surfaces state, one set for all contacts or for each."""
        surface: Any = self.surface
        entries = surface.values() if isinstance(surface, dict) else [surface]
        return [entry.stated_keys() for entry in entries]

    @model_validator(mode="after")
    def _exact_where_needed(self) -> Self:
        drive: Any = self.drive
        if self.model.bodies == "springs":
            exact = [
                f"roller {roller.name}"
                for roller in getattr(self, "roller", ())
                if roller.ring_support in BENT or roller.bore_diameter is not None
            ]
            exact += [f"drive.{name}" for name in self._support_keys() if getattr(drive, name) in BENT]
            exact += [
                f"drive.{name}" for name in self.drive_type.exact_keys if getattr(drive, name) is not None
            ]
            exact += ["model.plane_state"] if self.model.plane_state == "plane_stress" else []
            if exact:
                raise InputError(
                    f'{", ".join(exact)}: only for model.bodies = "exact"; the springs are those of solid rollers and '
                    "of rings in a rigid housing, in plane strain"
                )
        return self

    @model_validator(mode="after")
    def _housing_of_rings(self) -> Self:
        compliance = self.compliance or Compliance()
        supports = self.ring_supports()
        stated = compliance.ring_housing_stiffness is not None
        if self.housing is not None:
            self._described_housing(stated)
        elif ("elastic_housing" in supports) != stated and not self.in_frame():
            raise InputError(
                f'{self._ring_key()} = "elastic_housing" and compliance.ring_housing_stiffness belong together: give '
                "both or neither, or describe the housing in [housing]"
            )
        bent = [support for support in supports if support in BENT]
        if bent and compliance.ring_bending_stiffness is not None:
            raise InputError(
                f'{self._ring_key()} = "{bent[0]}" computes the bending of the ring: leave out '
                "compliance.ring_bending_stiffness, which would count it twice"
            )
        return self

    def _described_housing(self, stiffness: bool) -> None:
        """Refuse a housing that no ring needs, and what is known of it already."""
        if self.without_housing():
            raise InputError(f"[housing]: {self.without_housing()} has no housing: leave out the section")
        if stiffness:
            raise InputError(
                "[housing] gives the stiffness of the housing: leave out compliance.ring_housing_stiffness"
            )
        if self.temperature is not None and self.temperature.housing_expansion is not None:
            raise InputError(
                "[housing]: the material of the housing, bodies.housing, gives its expansion: leave out "
                "temperature.housing_expansion"
            )

    def _support_keys(self) -> tuple[str, ...]:
        """Keys of [drive] that say what holds a ring."""
        kind = self.drive_type
        names = [f"{ring.size_key}_support" for ring in kind.rings]
        return tuple(name for name in names if kind.has(name))

    def _ring_key(self) -> str:
        """The key that says what holds a ring."""
        return next((f"drive.{name}" for name in self._support_keys()), "ring_support")

    def ring_supports(self) -> tuple[str | None, ...]:
        """What the file says that holds the outer rim of each ring; None where it says nothing."""
        return tuple(getattr(self.drive, name) for name in self._support_keys())

    @model_validator(mode="after")
    def _complete_duty(self) -> Self:
        refuse_part_of_a_duty(self.duty)
        return self

    @model_validator(mode="after")
    def _form_that_errs(self) -> Self:
        allowed = None if self.rolling is None else self.rolling.allowed_transmission_error
        if allowed is not None and self.form is None:
            raise InputError(
                f"rolling.allowed_transmission_error = '{allowed.text}': the file states no form errors that make one; "
                "give sections [[form]], or leave it out"
            )
        return self

    @model_validator(mode="after")
    def _known_expansion(self) -> Self:
        by_interference = self.load.interference is not None or self.housing is not None
        refuse_temperatures(self.temperature, self.heat, by_interference=by_interference)
        if self.heat is not None:
            refuse_heat_of_nothing(self.heat, duty=self.duty is not None)
        refuse_temperature(
            self.temperature,
            by_interference=by_interference,
            bodies=self.bodies,
            materials=self.materials,
            without_housing="" if self.in_frame() else self.without_housing(),
        )
        return self

    @model_validator(mode="after")
    def _known_oil(self) -> Self:
        refuse_oil(
            self.lubrication,
            self.fluids or {},
            temperature=not (self.temperature is None and self.heat is None),
        )
        refuse_cleanliness(self.life, self.lubrication, self._surface_keys())
        return self

    @model_validator(mode="after")
    def _one_section_for_each_branch(self) -> Self:
        branches, sectors = self.branch, self.drive_type.sectors
        if branches is not None and sectors is not None:
            refuse_branches(
                len(branches),
                count=round(getattr(self.drive, sectors.key).value),
                what=sectors.words,
                by_interference=self.load.interference is not None,
            )
        return self

    def without_housing(self) -> str:
        """What the file says where no housing holds a ring; empty where one does."""
        supports = self.ring_supports()
        if not supports:
            return "a drive without a ring"
        return f'{self._ring_key()} = "free"' if all(support == "free" for support in supports) else ""

    @model_validator(mode="after")
    def _possible_for_the_type(self) -> Self:
        if self.drive_type.refuse is not None:
            sections: dict[str, Section] = {"drive": self.drive, "load": self.load}
            self.drive_type.refuse({name: stated_texts(section) for name, section in sections.items()})
        return self

    @model_validator(mode="after")
    def _known_parts(self) -> Self:
        misnamed = self.misnamed_parts()
        if misnamed:
            raise InputError("\n  ".join(misnamed))
        return self

    def part_names(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Names of the contacts, and of the bodies in [bodies]."""
        return self.drive_type.contact_names({}), self.drive_type.material_keys

    def places_of_bodies(self) -> dict[str, str]:
        """Name of each body of a sector → its place."""
        return {part.name: part.place for part in self.drive_type.parts}

    def input_name(self) -> str:
        """Name of the input."""
        return self.drive_type.input

    def _misnamed_tilts(self) -> Iterator[str]:
        """Messages about tilts of axes that the drive does not have, or that nothing holds."""
        support = None if self.compliance is None else self.compliance.sun_support_stiffness
        floats = support is not None and support.value == 0.0
        return misnamed_tilts(
            self.tilt or {}, self.places_of_bodies(), (self.input_name(),) if floats else ()
        )

    def worn_parts(self) -> tuple[str, ...]:
        """Names of the bodies in a table of wear coefficients: those of [bodies] without the housing."""
        return self.part_names()[1]

    def misnamed_parts(self) -> list[str]:
        """Messages about tables whose entries are not the bodies or contacts of the drive."""
        messages = [*self._without_effect(), *self._misnamed_tilts()]
        messages += misstated_profiles(
            shaped_contacts(self.drive_type, self.drive, getattr(self, "contact", ()))
        )
        contacts, bodies = self.part_names()
        if self.housing is not None:
            if HOUSING in bodies:
                messages.append("[housing]: no roller may have its name; rename the roller 'housing'")
            bodies = (*bodies, HOUSING)
        for path, table, known in (
            ("bodies", self.bodies, bodies),
            ("drive.contact_length", self.drive.contact_length, contacts),
            ("load.friction_coefficient", self.load.friction_coefficient, contacts),
            ("rolling.skew", None if self.rolling is None else self.rolling.skew, contacts),
            ("wear.coefficient", None if self.wear is None else self.wear.coefficient, self.worn_parts()),
            ("surface", self.surface, contacts),
        ):
            if not isinstance(table, dict):
                continue
            unknown = [name for name in table if name not in known]
            if path == "bodies" and HOUSING in unknown:
                unknown.remove(HOUSING)
                messages.append(
                    "bodies.housing: there is no section [housing]; give one, or leave the material out"
                )
            messages += [
                f"{path}.{name}: a {self.type} drive has no such {'contact' if known == contacts else 'body'}"
                f"{nearest(name, known) or '; it has ' + ', '.join(known)}"
                for name in unknown
            ]
            meant = {closest(name, known) for name in unknown}
            missing = [name for name in known if name not in table and name not in meant]
            if path == "bodies" and HOUSING in missing:
                missing.remove(HOUSING)
                messages.append("bodies.housing is missing: the material of the section [housing]")
            if missing:
                instead = "; write one [surface] for all contacts, or a section for each"
                messages.append(
                    f"{path}: {', '.join(missing)} {'is' if len(missing) == 1 else 'are'} missing"
                    + (instead if path == "surface" else "")
                )
        return messages

    def roller_places(self) -> tuple[str, ...]:
        """Places of the rollers off the axis."""
        return self.drive_type.places

    def _without_effect(self) -> Iterator[str]:
        """Messages about what a file says of pins, or of rollers without one, that its drive does not have."""
        for place, (keys, why) in _AT_PLACES.items():
            if place not in self.roller_places():
                yield from self._useless(keys, _NO_PLANETS if place == "free" and self.in_frame() else why)
        for keys, why in self._of_others():
            yield from self._useless(keys, why)
        if self.bearings is not None and self.bearings.pin_support and self.bearings.pin_length is None:
            yield (
                f"bearings.pin_support = '{self.bearings.pin_support}': without pin_length the bending of the pins is "
                "not computed; give pin_length, or leave pin_support out"
            )

    def _of_others(self) -> Iterator[tuple[tuple[str, ...], str]]:
        """Keys that need a ring or sectors, which this drive does not have, and why."""
        kind = self.drive_type
        if kind.parts and not any(contact.internal for contact in kind.contacts):
            yield _OF_RINGS, "this drive has no ring; leave it out"
        if kind.parts and kind.sectors is None:
            yield _OF_SECTORS, "this drive has no sectors that differ; leave it out"

    def keys_without_effect(self) -> set[str]:
        """Keys that a file of this drive cannot state, because nothing of it needs them."""
        absent = {place for place in _AT_PLACES if place not in self.roller_places()}
        keys = {key for place in absent for key in _AT_PLACES[place][0]}
        return keys.union(*(of for of, _ in self._of_others()))

    def in_frame(self) -> bool:
        """Whether bearings in the frame hold the bodies of the drive."""
        return self.drive_type.in_frame

    def _useless(self, keys: tuple[str, ...], why: str) -> Iterator[str]:
        """A message about each of these keys that the file states."""
        for path in keys:
            section, _, key = path.partition(".")
            stated = getattr(self, section)
            if (getattr(stated, key, None) if key else stated) is not None:
                yield f"{path}: {why}"


_OF_RINGS = ("compliance.ring_bending_stiffness", "compliance.ring_housing_stiffness")
_OF_SECTORS = ("compliance.sun_support_stiffness",)
_NO_PLANETS = "no roller of this drive is free, the bearings of the frame hold them; leave it out"
#: What needs rollers at a place, and what to say where the drive has none there.
_AT_PLACES = {
    "pin": (
        (
            "pin_bearing",
            "bearings.roller_torque",
            "bearings.pin_friction_coefficient",
            "bearings.pin_friction_diameter",
            "bearings.pin_diameter",
            "bearings.pin_radial_clearance",
            "bearings.pin_length",
            "compliance.pin_stiffness",
            "compliance.pin_transverse_stiffness",
        ),
        "no roller of this drive is on a pin of the carrier; leave it out, or in a listed drive give a [[roller]] "
        'place = "pin"',
    ),
    "free": (
        ("compliance.planet_support_stiffness",),
        "every roller of this drive is on a pin, and it holds those without one; leave it out, or give "
        "compliance.pin_transverse_stiffness, which holds rollers across the push of their pins",
    ),
}


class AxisCase(Case):
    """What files have in common that call the members on the axis input and output."""

    bearings: BearingFriction | None = None
    """Friction of the bearings in rolling; none if the section is absent."""
    input_bearing: HeldBearing | None = None
    """Rolling bearings of the input, for their life under forces from outside."""
    output_bearing: HeldBearing | None = None
    """Rolling bearings of the output, for their life under forces from outside."""
