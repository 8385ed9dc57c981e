"""The content of a joint file: a class for each section, a field for each key."""

from __future__ import annotations

import math
from typing import Annotated, ClassVar, Literal

from pydantic import BeforeValidator, Discriminator, Field, Tag, model_validator

from asperity.errors import InputError
from asperity.joint_file import limits
from asperity.joint_file.bearing_entries import HeldBearing, PinBearing
from asperity.joint_file.branch_sections import BranchEntry, refuse_branches
from asperity.joint_file.material_entries import BodyMaterials, MaterialEntry, MaterialName, Surfaces
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import (
    ONE_FOR_ALL,
    ONE_FOR_EACH,
    EachContact,
    Section,
    WholeFile,
    number_or_table,
)
from asperity.joint_file.temperature_section import TemperatureEntry, refuse_temperature

Length = Annotated[Quantity, limits.ROLLER_RADIUS]
ContactLength = Annotated[Quantity, limits.CONTACT_LENGTH]
BodyLength = Annotated[Quantity, limits.BODY_LENGTH]
PushAngle = Annotated[Quantity, limits.PUSH_ANGLE]
Friction = Annotated[Quantity, limits.FRICTION_COEFFICIENT]
BearingTorque = Annotated[Quantity, limits.BEARING_TORQUE]
ContactLengths = Annotated[
    Annotated[ContactLength, Tag(ONE_FOR_ALL)] | Annotated[EachContact[ContactLength], Tag(ONE_FOR_EACH)],
    Discriminator(number_or_table),
]
FrictionCoefficients = Annotated[
    Annotated[Friction, Tag(ONE_FOR_ALL)] | Annotated[EachContact[Friction], Tag(ONE_FOR_EACH)],
    Discriminator(number_or_table),
]
CrownRadius = Annotated[Quantity, limits.CROWN_RADIUS]
Skew = Annotated[Quantity, limits.SKEW]
Skews = Annotated[
    Annotated[Skew, Tag(ONE_FOR_ALL)] | Annotated[EachContact[Skew], Tag(ONE_FOR_EACH)],
    Discriminator(number_or_table),
]


class Drive(Section):
    """Radii and arrangement of the drive."""

    planets: Annotated[Quantity, limits.PLANETS]
    """Number of planets, equally spaced."""
    sun_radius: Length
    """Radius R_s of the sun roller."""
    planet_radius: Length
    """Radius R_p of the planets."""
    loading_roller_radius: Length
    """Radius R_w of the loading rollers, two to a planet."""
    ring_radius: Length
    """Inner radius R_o of the fixed outer ring."""
    ring_wall_thickness: Annotated[Quantity, limits.WALL_THICKNESS]
    """Wall of the outer ring."""
    contact_length: ContactLengths
    """Length B of the contact lines: one for all, or a table with sp, pwr, pwl, wro, wlo."""
    left_push_angle: PushAngle
    """Direction gamma_l of the carrier's push on the left loading roller, from the tangent."""
    right_push_angle: PushAngle
    """Direction gamma_r of the carrier's push on the right loading roller, from the tangent."""
    planet_length: BodyLength | None = None
    """Length of a planet, for its mass; if absent, the longest contact line on it."""
    loading_roller_length: BodyLength | None = None
    """Length of a loading roller, for its mass; if absent, the longest contact line on it."""
    planet_bore_diameter: Annotated[Quantity, limits.BORE_DIAMETER] | None = None
    """Diameter of the bore of hollow planets; solid if absent."""
    loading_roller_bore_diameter: Annotated[Quantity, limits.BORE_DIAMETER] | None = None
    """Diameter of the bore of hollow loading rollers; solid if absent."""
    sun_crown_radius: CrownRadius | None = None
    """Radius of the sun's crown along its axis, highest in the middle of the contact line; over a length B it drops by
    B^2/8 over this radius at the ends. A cylinder if absent."""
    planet_crown_radius: CrownRadius | None = None
    """Radius of the planets' crown along their axes; cylinders if absent."""
    loading_roller_crown_radius: CrownRadius | None = None
    """Radius of the loading rollers' crown along their axes; cylinders if absent."""
    ring_crown_radius: CrownRadius | None = None
    """Radius of the ring's crown along its axis; a cylinder if absent."""
    ring_support: Literal["rigid_housing", "free", "elastic_housing"] | None = None
    """What holds the outer rim of the ring: a rigid housing into which it is shrunk, nothing, so that it bends, or a
    housing with the ring_housing_stiffness of [compliance]. A rigid housing if absent."""


class Load(Section):
    """What acts on the drive."""

    preload: Annotated[Quantity, limits.PRELOAD] | None = None
    """Normal force N_0 between sun and planet without torque; either this or interference."""
    interference: Annotated[Quantity, limits.INTERFERENCE] | None = None
    """Interference that makes the preload: by how much the ring's inner radius lies below the radius at which all
    contacts just touch."""
    cam_force_per_torque: Annotated[Quantity, limits.CAM_FORCE] | None = None
    """Loading cam: what each N*m of output torque, in either direction, adds to the preload between sun and planet; the
    preload or interference above is then the least one, without torque. No cam if absent."""
    output_torque: Annotated[Quantity, limits.OUTPUT_TORQUE]
    """Torque at the carrier; negative in the other direction, where it brakes a drive that turns."""
    sun_speed: Annotated[Quantity, limits.SUN_SPEED]
    """Speed of the sun; makes the centrifugal forces and decides which way bearing friction acts."""
    friction_coefficient: FrictionCoefficients
    """Friction coefficient mu of the contacts: one for all, or a table with sp, pwr, pwl, wro, wlo."""

    @model_validator(mode="after")
    def _one_preload(self) -> Load:
        if (self.preload is None) == (self.interference is None):
            found = "neither" if self.preload is None else "both"
            raise InputError(f"exactly one of 'preload' and 'interference' is needed, got {found}")
        return self


class BearingFriction(Section):
    """Friction of the bearings; a joint file without this section has none."""

    sun_torque: BearingTorque
    """Friction torque of one of the two sun bearings."""
    loading_roller_torque: BearingTorque
    """Constant friction torque of one of the two bearings of a loading roller."""
    carrier_torque: BearingTorque
    """Friction torque of one of the two carrier bearings."""
    pin_friction_coefficient: Annotated[Quantity, limits.PIN_FRICTION_COEFFICIENT]
    """Friction coefficient mu_b of the loading rollers' pins: friction force over pin force, at the pin's diameter."""
    pin_diameter: Annotated[Quantity, limits.PIN_DIAMETER]
    """Diameter d of the loading rollers' pins."""
    pin_length: Annotated[Quantity, limits.PIN_LENGTH] | None = None
    """Free length of a pin, with the loading roller in its middle: between its two supports, or from its only support
    to its end. Makes the bending moment of the pin, and with pin_diameter its bending stress."""
    pin_support: Literal["both_ends", "one_end"] | None = None
    """How the carrier holds a pin of this length; at both ends, which may turn, if absent."""


class Compliance(Section):
    """Springs of the structure around the rollers; an absent key is the ideal its description names."""

    pin_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of one carrier pin along its push; rigid if absent."""
    pin_transverse_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of one carrier pin across its push; free if absent."""
    planet_support_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Stiffness of a planet's bearing on the carrier; the planet floats if absent."""
    ring_bending_stiffness: Annotated[Quantity, limits.SPRING] | None = None
    """Spring under each loading roller for the bending of the ring, in addition to a ring in a rigid housing; rigid if
    absent. ring_support = "free" computes the bending instead."""
    ring_housing_stiffness: Annotated[Quantity, limits.HOUSING] | None = None
    """Radial stiffness of the housing around the ring, per area of the ring's outer surface; needed for, and only for,
    ring_support = "elastic_housing"."""
    input_shaft_stiffness: Annotated[Quantity, limits.TORSION_SPRING] | None = None
    """Torsional stiffness of the shaft to the sun; rigid if absent."""
    output_shaft_stiffness: Annotated[Quantity, limits.TORSION_SPRING] | None = None
    """Torsional stiffness of the shaft from the carrier; rigid if absent."""
    sun_support_stiffness: Annotated[Quantity, limits.SUPPORT] | None = None
    """Radial stiffness of the sun's bearings together, for branches of their own sizes, [[branch]]; 0 for a floating
    sun, rigid if absent."""


class Rolling(Section):
    """The joint that turns; every key may be absent."""

    skew: Skews | None = None
    """Angle by which the axes of a contact are out of parallel: one for all, or a table with sp, pwr, pwl, wro, wlo;
    parallel if absent."""
    hysteresis_factor: Annotated[Quantity, limits.HYSTERESIS_FACTOR] | None = None
    """Share of the elastic work that the bodies lose as they roll; 0.005 to 0.05 for hardened steel. Without it this
    loss is left out."""
    reliability: Annotated[Quantity, limits.RELIABILITY] | None = None
    """Share of all drives that reach the stated life; 0.9 if absent."""
    required_life: Annotated[Quantity, limits.REQUIRED_LIFE] | None = None
    """Hours of work that the drive and its rolling bearings have to reach, under the duty if there is one; a limit of
    the joint, which moves no result."""


class Lubrication(Section):
    """The oil; without it the contacts are dry."""

    viscosity: Annotated[Quantity, limits.VISCOSITY]
    """Viscosity of the oil at the inlet of the contacts; makes the rolling loss of the oil."""
    pressure_coefficient: Annotated[Quantity, limits.PRESSURE_COEFFICIENT] | None = None
    """Pressure coefficient of the viscosity; makes the thickness of the oil film, which is left out without it."""
    roughness: Annotated[Quantity, limits.ROUGHNESS] | None = None
    """Root mean square of the heights of both surfaces together, sqrt(Rq1^2 + Rq2^2); makes the ratio lambda of the oil
    film to it."""


_Share = Annotated[float, Field(gt=0.0, le=1.0)] | str


def _share(written: object) -> float:
    """A share of the time, as a number or as text in per cent."""
    found = limits.SHARE.read(written)
    if found.tolerance:
        raise InputError(f"a share of the time has no tolerance, got {written!r}")
    return found.value


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
    """Refuse a duty whose loads do not share the whole time.

    Parameters
    ----------
    duty : tuple of DutyLoad or None
        Its loads.

    Raises
    ------
    InputError
        With the sum of the shares.
    """
    total = math.fsum(load.share for load in duty or ())
    if duty is not None and abs(total - 1.0) > 1e-9:
        raise InputError(f"the shares of [[duty]] must add up to 1, they add up to {total:.10g}")


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


class ModelChoice(Section):
    """Which variants of the model to use."""

    closure: Literal["elastic", "constant_pin_force"]
    """How the forces of the statically indeterminate branch are found."""
    closure_springs: Literal["bulk", "bulk_and_asperities"]
    """Normal springs of the elastic closure: the bodies alone, or with their asperities."""
    contact_factor: Literal["printed", "hertz_area", "unity"]
    """Model of the contact factor lambda."""
    asperity_base: Literal["majumdar_bhushan_1991", "circular_spot"]
    """Base length of an asperity."""
    bodies: Literal["exact", "springs"] | None = None
    """Bodies of the assembly: by plane elasticity, or one spring for each contact; exact if absent."""
    plane_state: Literal["plane_strain", "plane_stress"] | None = None
    """Exact bodies: long, plane strain, or thin, plane stress; plane strain if absent."""


class Case(WholeFile):
    """A joint file: a planetary traction drive under load."""

    type: Literal["zou2025"] | None = None
    """Type of the drive: the paper's, with two loading rollers in the wedges between each planet and the ring, if
    absent."""
    drive: Drive
    """Radii and arrangement."""
    load: Load
    """Preload, torque, speed, friction."""
    temperature: TemperatureEntry | None = None
    """Temperature of the drive; that of the assembly if the section is absent."""
    bearings: BearingFriction | None = None
    """Friction of the bearings; none if the section is absent."""
    pin_bearing: PinBearing | None = None
    """Rolling bearings of the loading rollers on their pins, for their life."""
    sun_bearing: HeldBearing | None = None
    """Rolling bearings of the sun's shaft, for their life under forces from outside."""
    carrier_bearing: HeldBearing | None = None
    """Rolling bearings of the carrier, for their life under forces from outside."""
    compliance: Compliance | None = None
    """Springs of pins, planet supports, ring and shafts; ideal if the section is absent."""
    rolling: Rolling | None = None
    """Skew, hysteresis, reliability and required life of the joint that turns."""
    lubrication: Lubrication | None = None
    """The oil; dry if the section is absent."""
    duty: Duty | None = None
    """Loads and their shares of the time, for the life under a duty: a section [[duty]] for each."""
    branch: tuple[BranchEntry, ...] | None = None
    """Sizes of each planet and its loading rollers, where they differ: a section [[branch]] for each planet."""
    dynamics: DynamicsEntry | None = None
    """Inertias of motor and load, for `asperity dynamics`."""
    play: PlayEntry | None = None
    """Play at the output; none if the section is absent."""
    model: ModelChoice
    """Variants of the model."""
    materials: Annotated[dict[MaterialName, MaterialEntry], Field(min_length=1)]
    """Materials by name."""
    bodies: BodyMaterials
    """Which material each body is made of."""
    surface: Surfaces
    """Roughness: one table for all contacts, or tables surface.sp, .pwr, .pwl, .wro, .wlo."""

    #: Number of the branches in [drive], and their name.
    branches_are: ClassVar[tuple[str, str]] = ("planets", "planets")

    @model_validator(mode="after")
    def _whole_duty(self) -> Case:
        refuse_part_of_a_duty(self.duty)
        return self

    @model_validator(mode="after")
    def _one_branch_for_each_planet(self) -> Case:
        if self.branch is None:
            return self
        refuse_branches(
            len(self.branch),
            count=round(getattr(self.drive, self.branches_are[0]).value),
            what=self.branches_are[1],
            by_interference=self.load.interference is not None,
            cam=self.load.cam_force_per_torque is not None,
        )
        return self

    @model_validator(mode="after")
    def _one_ring(self) -> Case:
        compliance = self.compliance or Compliance()
        support, housing = self.drive.ring_support, compliance.ring_housing_stiffness
        if (support == "elastic_housing") != (housing is not None):
            raise InputError(
                'drive.ring_support = "elastic_housing" and compliance.ring_housing_stiffness belong together: give '
                "both or neither"
            )
        bends = support in ("free", "elastic_housing")
        if bends and compliance.ring_bending_stiffness is not None:
            raise InputError(
                f'drive.ring_support = "{support}" computes the bending of the ring: leave out '
                "compliance.ring_bending_stiffness, which would count it twice"
            )
        if self.model.bodies == "springs":
            bores = ("planet_bore_diameter", "loading_roller_bore_diameter")
            exact = [f"drive.{name}" for name in bores if getattr(self.drive, name) is not None]
            exact += ["drive.ring_support"] if bends else []
            exact += ["model.plane_state"] if self.model.plane_state == "plane_stress" else []
            if exact:
                raise InputError(
                    f'{", ".join(exact)}: only for model.bodies = "exact"; the springs are those of solid rollers and '
                    "of a ring in a rigid housing, in plane strain"
                )
        return self

    @model_validator(mode="after")
    def _known_expansion(self) -> Case:
        refuse_temperature(
            self.temperature,
            by_interference=self.load.interference is not None,
            bodies=dict(self.bodies),
            materials=self.materials,
            without_housing='drive.ring_support = "free"' if self.drive.ring_support == "free" else "",
        )
        return self

    @model_validator(mode="after")
    def _known_materials(self) -> Case:
        from asperity.joint_file.messages import unknown_materials

        unknown = unknown_materials(dict(self.bodies), list(self.materials))
        if unknown:
            raise InputError("\n  ".join(unknown))
        return self
