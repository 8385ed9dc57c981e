"""The content of a joint file that lists the rollers and contacts of its drive."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Annotated, ClassVar, Literal

from pydantic import Field

from asperity.drive.layout.drive import CARRIER
from asperity.drive.layout.drive_type import DriveType
from asperity.drive.layout.sizes import ISO_16281, LOGARITHMIC
from asperity.drive.types.listed import LISTED
from asperity.errors import nearest, quoted
from asperity.joint_file import limits
from asperity.joint_file.drive_sections import Bore, PartLengths, PartName, RingSupport, Wall
from asperity.joint_file.model import AxisCase
from asperity.joint_file.quantity_key import Quantity
from asperity.joint_file.section import Section
from asperity.joint_file.sections import BodyLength, CrownRadius, Deviation, Length, PushAngle

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
    [compliance] or the sizes in [housing]. A rigid housing if absent."""
    bore_diameter: Bore | None = None
    """Diameter of the bore of a hollow roller, at most 0.65 of that of the smaller track of a stepped one;
    solid if absent."""
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
    first_profile: Literal["logarithmic", "iso_16281"] | None = None
    """Profile of the first roller's track along its axis in place of a crown. logarithmic: Lundberg's, of a normal
    force first_profile_load. iso_16281: that of ISO/TS 16281, of 0.00035 times the diameter, for lines of at most 2.5
    diameters. A cylinder, or the crown, if absent. All contacts on a track state it."""
    first_profile_load: Annotated[Quantity, limits.PROFILE_LOAD] | None = None
    """Normal force that this profile alone spreads evenly over the line."""
    second_profile: Literal["logarithmic", "iso_16281"] | None = None
    """Profile of the second one's track; of a ring only logarithmic."""
    second_profile_load: Annotated[Quantity, limits.PROFILE_LOAD] | None = None
    """Normal force that this profile alone spreads evenly over the line."""
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
    drive_type: ClassVar[DriveType] = LISTED

    def ring_supports(self) -> tuple[str | None, ...]:
        """What the file says that holds the outer rim of each ring; None where it says nothing."""
        return tuple(roller.ring_support for roller in self.roller if roller.wall_thickness is not None)

    def without_housing(self) -> str:
        """What the file says where no housing holds a ring; empty where one does."""
        held = any(
            roller.wall_thickness is not None and roller.ring_support != "free" for roller in self.roller
        )
        return "" if held else 'a drive whose rings all have ring_support = "free"'

    def part_names(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Names of the contacts, and of the bodies in [bodies]."""
        return tuple(contact.name for contact in self.contact), tuple(roller.name for roller in self.roller)

    def places_of_bodies(self) -> dict[str, str]:
        """Name of each body of a sector → its place."""
        return {roller.name: roller.place for roller in self.roller}

    def input_name(self) -> str:
        """Name of the input."""
        return str(self.drive.input)

    def misnamed_parts(self) -> list[str]:
        """Messages about rollers, contacts and tables that do not fit together."""
        return [*_misdescribed(self), *super().misnamed_parts()]

    def roller_places(self) -> tuple[str, ...]:
        """Places of the rollers off the axis."""
        return tuple(roller.place for roller in self.roller if roller.place != "axis")


def _misdescribed(case: GeneralCase) -> Iterator[str]:
    """Messages about rollers and contacts that do not fit together."""
    rollers = [roller.name for roller in case.roller]
    for what, names in (("roller", rollers), ("contact", [contact.name for contact in case.contact])):
        yield from (
            f"{what}: there is more than one '{n}'" for n, count in Counter(names).items() if count > 1
        )
    if CARRIER in rollers:
        yield f"roller: '{CARRIER}' is the name of the member that carries the pins"
    for contact in case.contact:
        for side in ("first", "second"):
            name = getattr(contact, side)
            if name not in rollers:
                yield f"contact {contact.name}: {side}: there is no roller '{name}'{nearest(name, rollers)}"
    yield from _unlike_crowns(case)
    yield from _misassumed(case)
    rings = {contact.second for contact in case.contact if contact.internal}
    touched = {name for contact in case.contact for name in (contact.first, contact.second)}
    for roller in case.roller:
        if roller.name not in touched:
            yield f"roller {roller.name}: it has no contact"
        if (roller.orbit is None) != (roller.place == "axis"):
            verb = "must not have" if roller.place == "axis" else "needs"
            yield f"roller {roller.name}: place = '{roller.place}' {verb} an orbit"
        if (roller.name in rings) != (roller.wall_thickness is not None):
            verb = "needs" if roller.name in rings else "is no ring and must not have"
            yield f"roller {roller.name}: it {verb} a wall_thickness"
        if roller.push_angle is not None and roller.place != "pin":
            yield f"roller {roller.name}: push_angle is for rollers on a pin"
        if roller.ring_support is not None and roller.wall_thickness is None:
            yield f"roller {roller.name}: ring_support is for rings, which have a wall_thickness; leave it out"
        if roller.bore_diameter is not None:
            yield from _impossible_bore(roller, case.contact)
    sized = [roller.name for roller in case.roller if roller.place != "axis"]
    for number, branch in enumerate(case.branch or (), start=1):
        for name in branch.deviation or ():
            if name not in sized:
                has = "; a sector has " + ", ".join(sized)
                why = f"there is no such roller{nearest(name, sized) or has}"
                if name in rollers:
                    why = f"it is on the axis, common to all{has}"
                yield f"branch.{number}.deviation.{name}: {why}"
    members = [*(roller.name for roller in case.roller if roller.place == "axis"), CARRIER]
    roles = {role: getattr(case.drive, role) for role in ("input", "output", "grounded")}
    for role, name in roles.items():
        if name not in members:
            yield f"drive.{role}: '{name}' is neither a roller on the axis nor the carrier{nearest(name, members)}"
    if len(set(roles.values())) < len(roles):
        yield "drive: input, output and grounded must be three different members"
    if case.drive.grounded != CARRIER and not any(roller.place == "pin" for roller in case.roller):
        yield "drive.grounded: no roller is on a pin, so that nothing turns the carrier; ground it, or use a pin"


def _impossible_bore(roller: RollerEntry, contacts: tuple[ContactEntry, ...]) -> Iterator[str]:
    """Messages about a bore in a ring or in a roller with more than two tracks."""
    if roller.wall_thickness is not None:
        yield f"roller {roller.name}: bore_diameter: a ring is described by its wall_thickness; leave one of both out"
        return
    assert roller.bore_diameter is not None
    radii = [
        getattr(contact, f"{side}_radius")
        for contact in contacts
        for side in ("first", "second")
        if getattr(contact, side) == roller.name
    ]
    tracks = {f"{radius.value:.12g}": radius.text for radius in radii}
    if len(tracks) > 2:
        yield (
            f"roller {roller.name}: bore_diameter = {quoted(roller.bore_diameter.text)} in a roller with tracks of "
            f"{', '.join(tracks.values())}: what a bore adds depends on how more than two tracks lie along the axis, "
            "which a file does not state; leave it out: the roller counts as solid, stiffer and heavier than it is"
        )


def _misassumed(case: GeneralCase) -> Iterator[str]:
    """Assumptions in place of compatibility that cannot be made."""
    names = [contact.name for contact in case.contact]
    others = [contact.same_coefficient_as for contact in case.contact]
    for contact, other in zip(case.contact, others, strict=True):
        if other is None:
            continue
        key = f"contact {contact.name}: same_coefficient_as"
        if other == contact.name or other not in names:
            yield f"{key}: there is no other contact '{other}'{nearest(other, set(names) - {contact.name})}"
        elif others[names.index(other)] is not None:
            yield f"{key}: contact '{other}' has that of another contact itself; name the same one in both"
    for roller in case.roller:
        if roller.pin_force is not None and roller.place != "pin":
            yield f"roller {roller.name}: pin_force is for rollers on a pin"


def _unlike_crowns(case: GeneralCase) -> Iterator[str]:
    """Contacts that say of a track what another contact on it does not."""
    stated: dict[tuple[str, str], tuple[str, tuple[float | None, str | None, float | None]]] = {}
    for contact in case.contact:
        for side in ("first", "second"):
            radius, crown, load = (
                getattr(contact, f"{side}_{name}") for name in ("radius", "crown_radius", "profile_load")
            )
            profile = getattr(contact, f"{side}_profile")
            if contact.internal and side == "second" and profile == ISO_16281:
                yield (
                    f"contact {contact.name}: second_profile = '{profile}': ISO/TS 16281 has a profile for rollers, "
                    f'none for rings; choose "{LOGARITHMIC}", or profile the roller'
                )
            track = getattr(contact, side), f"{radius.value:.12g}"
            shape = (
                None if crown is None else crown.value,
                profile,
                None if load is None else load.value,
            )
            other = stated.setdefault(track, (contact.name, shape))
            if shape[0] != other[1][0]:
                yield (
                    f"contact {contact.name}: {side}_crown_radius: contact {other[0]} says something else of the same "
                    f"track of {track[0]}; a track has one crown: give it in every contact of the track, or in none"
                )
            elif shape != other[1]:
                yield (
                    f"contact {contact.name}: {side}_profile: contact {other[0]} says something else of the same track "
                    f"of {track[0]}; a track has one profile: give it in every contact of the track, or in none"
                )
