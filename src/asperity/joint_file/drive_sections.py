"""Sections ``[drive]`` of joint files of other drives than the paper's, and the entries that may differ by contact."""

from __future__ import annotations

from typing import Annotated, Any, Literal, NamedTuple

from pydantic import BeforeValidator, Discriminator, StringConstraints, Tag

from asperity.joint_file import limits
from asperity.joint_file.material_entries import SurfaceEntry
from asperity.joint_file.quantity_key import Entered, Quantity
from asperity.joint_file.section import ONE_FOR_ALL, ONE_FOR_EACH, Section
from asperity.joint_file.sections import BodyLength, ContactLength, CrownRadius, Friction, Length, Skew
from asperity.units import format_quantity

#: The name of a roller or a contact.
PartName = Annotated[str, StringConstraints(pattern=r"^[A-Za-z][A-Za-z0-9_-]{0,59}$")]


def _number_or_table(written: Any) -> str:
    return ONE_FOR_EACH if isinstance(written, dict) else ONE_FOR_ALL


def _table_or_tables(written: Any) -> str:
    tables = isinstance(written, dict) and any(
        isinstance(value, dict | SurfaceEntry) for value in written.values()
    )
    return ONE_FOR_EACH if tables else ONE_FOR_ALL


PartLengths = Annotated[
    Annotated[ContactLength, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, ContactLength], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
PartFriction = Annotated[
    Annotated[Friction, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, Friction], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
PartSurfaces = Annotated[
    Annotated[SurfaceEntry, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, SurfaceEntry], Tag(ONE_FOR_EACH)],
    Discriminator(_table_or_tables),
]
PartSkews = Annotated[
    Annotated[Skew, Tag(ONE_FOR_ALL)] | Annotated[dict[PartName, Skew], Tag(ONE_FOR_EACH)],
    Discriminator(_number_or_table),
]
Wall = Annotated[Quantity, limits.WALL_THICKNESS]
Bore = Annotated[Quantity, limits.BORE_DIAMETER]
RingSupport = Literal["rigid_housing", "free", "elastic_housing"]
#: Supports in which a ring bends.
BENT = ("free", "elastic_housing")


def _ratio(written: Any) -> float:
    return limits.RATIO.read(written).value


class OpenRadius(NamedTuple):
    """A radius of the section [drive] that follows from the speed ratio of the file [m], and that ratio."""

    name: str
    radius: float
    ratio: float

    @property
    def words(self) -> str:
        """What was found."""
        found = format_quantity(self.radius, "mm", 6)
        return f"drive.ratio = {self.ratio:g}: {self.name} = {found} follows from it"


class RollerDrive(Section):
    """What the sections [drive] of all types have in common that state radii."""

    ratio: (
        Annotated[float, BeforeValidator(_ratio, json_schema_input_type=float), Entered(limits.RATIO)] | None
    ) = None
    """Speed ratio without its sign, in place of exactly one of the radii, which then follows from it."""


class PlanetaryDrive(RollerDrive):
    """Plain planetary drive: planets between a sun and a ring, which presses them together."""

    planets: Annotated[Quantity, limits.PLANETS]
    """Number of planets, equally spaced."""
    sun_radius: Length
    """Radius R_s of the sun roller, the input."""
    planet_radius: Length
    """Radius R_p of the planets; the ring's inner radius is R_s + 2 R_p, less the interference."""
    ring_wall_thickness: Wall
    """Wall of the ring."""
    contact_length: PartLengths
    """Length B of the contact lines: one for all, or a table with sp, pr."""
    output: Literal["carrier", "ring"] | None = None
    """Which member is the output, the other one being grounded: the carrier if absent."""
    ring_support: RingSupport | None = None
    """What holds the outer rim of the ring: a rigid housing, nothing, so that it bends, or a housing with the
    ring_housing_stiffness of [compliance] or the sizes in [housing]. A rigid housing if absent."""
    planet_bore_diameter: Bore | None = None
    """Diameter of the bore of hollow planets; solid if absent."""
    planet_length: BodyLength | None = None
    """Length of a planet, for its mass and its pin; if absent, the longest contact line on it."""
    sun_crown_radius: CrownRadius | None = None
    """Radius of the sun's crown along its axis, highest in the middle of the contact line; a cylinder if absent."""
    planet_crown_radius: CrownRadius | None = None
    """Radius of the planets' crown along their axes; cylinders if absent."""
    ring_crown_radius: CrownRadius | None = None
    """Radius of the ring's crown along its axis; a cylinder if absent."""


class MultirollerDrive(RollerDrive):
    """Multiroller drive: two rows of stepped rollers between sun and ring, the carrier of the second row grounded."""

    rollers_per_row: Annotated[Quantity, limits.PLANETS]
    """Number of rollers in each row, equally spaced."""
    sun_radius: Length
    """Radius s of the sun roller, the input."""
    first_row_radius: Length
    """Large radius x_1 of the first row's rollers, which touches the sun."""
    first_row_small_radius: Length
    """Small radius y_1 of the first row's rollers, which touches two rollers of the second row."""
    second_row_radius: Length
    """Large radius x_2 of the second row's rollers, which touches two rollers of the first row."""
    second_row_small_radius: Length
    """Small radius y_2 of the second row's rollers, which touches the ring, the output."""
    ring_wall_thickness: Wall
    """Wall of the ring."""
    contact_length: PartLengths
    """Length B of the contact lines: one for all, or a table with sf, fsl, fsr, sr."""
    ring_support: RingSupport | None = None
    """What holds the outer rim of the ring: a rigid housing, nothing, so that it bends, or a housing with the
    ring_housing_stiffness of [compliance] or the sizes in [housing]. A rigid housing if absent."""
    first_row_bore_diameter: Bore | None = None
    """Diameter of the bore of the first row's rollers, at most 0.65 of that of the smaller track; solid if absent."""
    second_row_bore_diameter: Bore | None = None
    """Diameter of the bore of the second row's rollers, at most 0.65 of that of the smaller track; solid if absent."""
    sun_crown_radius: CrownRadius | None = None
    """Radius of the sun's crown along its axis, highest in the middle of the contact line; a cylinder if absent."""
    first_row_crown_radius: CrownRadius | None = None
    """Radius of the crown of the first row's large tracks, along their axes; cylinders if absent."""
    first_row_small_crown_radius: CrownRadius | None = None
    """Radius of the crown of the first row's small tracks; cylinders if absent."""
    second_row_crown_radius: CrownRadius | None = None
    """Radius of the crown of the second row's large tracks; cylinders if absent."""
    second_row_small_crown_radius: CrownRadius | None = None
    """Radius of the crown of the second row's small tracks; cylinders if absent."""
    ring_crown_radius: CrownRadius | None = None
    """Radius of the ring's crown along its axis; a cylinder if absent."""


class SteppedPlanetDrive(RollerDrive):
    """Drive of high ratio: stepped planets roll in a grounded ring and in a driven ring; the carrier is a free cage."""

    planets: Annotated[Quantity, limits.PLANETS]
    """Number of planets, equally spaced."""
    sun_radius: Length
    """Radius s of the sun roller, the input."""
    planet_radius: Length
    """Radius p_1 of the track that touches the sun and the grounded ring."""
    planet_second_radius: Length
    """Radius p_2 of the track that touches the driven ring, the output."""
    ring_wall_thickness: Wall
    """Wall of the grounded ring."""
    driven_ring_wall_thickness: Wall
    """Wall of the driven ring, which carries itself."""
    contact_length: PartLengths
    """Length B of the contact lines: one for all, or a table with sp, pr1, pr2."""
    ring_support: RingSupport | None = None
    """What holds the outer rim of the grounded ring: a rigid housing, nothing, or a housing with the
    ring_housing_stiffness of [compliance] or the sizes in [housing]. A rigid housing if absent."""
    planet_bore_diameter: Bore | None = None
    """Diameter of the bore of hollow planets, at most 0.65 of that of the smaller track; solid if absent."""
    sun_crown_radius: CrownRadius | None = None
    """Radius of the sun's crown along its axis, highest in the middle of the contact line; a cylinder if absent."""
    planet_crown_radius: CrownRadius | None = None
    """Radius of the crown of the planets' first track, along their axes; cylinders if absent."""
    planet_second_crown_radius: CrownRadius | None = None
    """Radius of the crown of the planets' second track; cylinders if absent."""
    ring_crown_radius: CrownRadius | None = None
    """Radius of the grounded ring's crown along its axis; a cylinder if absent."""
    driven_ring_crown_radius: CrownRadius | None = None
    """Radius of the driven ring's crown along its axis; a cylinder if absent."""
