"""The content of a joint file that lists the rollers and contacts of its drive."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from asperity.joint_file import limits
from asperity.joint_file.branch_sections import Deviation
from asperity.joint_file.drive_sections import Bore, PartLengths, PartName, RingSupport, Wall
from asperity.joint_file.model import AxisCase
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section
from asperity.joint_file.sections import BodyLength, CrownRadius, Length, PushAngle

Orbit = Annotated[Quantity, limits.ROLLER_RADIUS]
Angle = Annotated[Quantity, limits.POLAR_ANGLE]


class GeneralDrive(Section):
    """Any drive: rollers and rings, their contacts, and which members turn."""

    sectors: Annotated[Quantity, limits.PLANETS]
    """Number of equal sectors; the file describes one of them."""
    input: PartName
    """Member that drives: a roller on the axis, or carrier."""
    output: PartName
    """Member that is driven."""
    grounded: PartName
    """Member that stands."""
    contact_length: PartLengths
    """Length B of the contact lines: one for all, or a table with the names of the contacts."""


class RollerEntry(Section):
    """One roller or ring of a sector; write [[roller]] above each."""

    name: PartName
    """Its name."""
    place: Literal["axis", "free", "pin"]
    """On the axis of the drive; supported by its contacts only; or on a pin of the carrier, which supports it along its
    push and leaves it free across."""
    orbit: Orbit | None = None
    """Distance of its centre from the axis, approximately: the contacts decide. Not for rollers on the axis."""
    angle: Angle | None = None
    """Direction of its centre, counter-clockwise; 90 deg if absent."""
    push_angle: PushAngle | None = None
    """Direction of the pin's push, outward from the clockwise tangent; 0 if absent."""
    pin_force: Literal["constant"] | None = None
    """The pin keeps its force without torque, because a soft spring moves it; fixed on the carrier if absent."""
    wall_thickness: Wall | None = None
    """Wall of a ring; every roller that is around another one needs it."""
    ring_support: RingSupport | None = None
    """What holds the outer rim of a ring: a rigid housing, nothing, or a housing with the ring_housing_stiffness of
    [compliance]. A rigid housing if absent."""
    bore_diameter: Bore | None = None
    """Diameter of the bore of a hollow roller; solid if absent."""
    length: BodyLength | None = None
    """Length of a roller, for its mass and its pin; if absent, that of its contact lines, those of the tracks of a
    stepped roller side by side."""


class ContactEntry(Section):
    """Where two rollers touch; write [[contact]] above each."""

    name: PartName
    """Its name."""
    first: PartName
    """A roller; the inner one of an internal contact."""
    second: PartName
    """The other roller, or the ring."""
    first_radius: Length
    """Radius of the track of the first roller; a stepped roller has several."""
    second_radius: Length
    """Radius of the track of the second one."""
    first_crown_radius: CrownRadius | None = None
    """Radius of the crown of the first roller's track along its axis, highest in the middle of the contact line; a
    cylinder if absent. All contacts on a track state it."""
    second_crown_radius: CrownRadius | None = None
    """Radius of the crown of the second one's track; a cylinder if absent."""
    internal: bool = False
    """Whether the first lies inside the second."""
    sector: Annotated[int, Field(strict=True, ge=-1, le=1)] = 0
    """Sector of the second roller, counted counter-clockwise from that of the first: 0, or -1 or 1 for a neighbour."""
    same_coefficient_as: PartName | None = None
    """A contact whose traction coefficient T/N it has while the drive stands, as published closures assume, instead of
    the one that slip of its springs determines; springs if absent."""


class SectorEntry(Section):
    """One sector; write [[branch]] above each, as many as sectors, counter-clockwise."""

    deviation: dict[PartName, Deviation] | None = None
    """Names of its rollers and by how much their radii, all of a stepped one, are larger than stated; 0 for those that
    are not named."""


class GeneralCase(AxisCase):
    """A joint file."""

    type: Literal["planar"]
    """Type of the drive."""
    drive: GeneralDrive
    """Members and arrangement."""
    roller: Annotated[tuple[RollerEntry, ...], Field(min_length=2)]
    """Rollers and rings of one sector."""
    contact: Annotated[tuple[ContactEntry, ...], Field(min_length=1)]
    """Contacts of one sector; the internal ones have the interference."""
    branch: tuple[SectorEntry, ...] | None = None
    """Sizes of the rollers of each sector, where they differ: a section [[branch]] for each."""
    branches_are: ClassVar[tuple[str, str]] = ("sectors", "sectors")
    ring_key: ClassVar[str] = "ring_support"

    def ring_supports(self) -> tuple[str | None, ...]:
        """What the file says that holds the outer rim of each ring; None where it says nothing."""
        return tuple(roller.ring_support for roller in self.roller if roller.wall_thickness is not None)

    def without_housing(self) -> str:
        """What the file says where no housing holds a ring; empty where one does."""
        held = any(
            roller.wall_thickness is not None and roller.ring_support != "free" for roller in self.roller
        )
        return "" if held else 'a drive whose rings all have ring_support = "free"'
