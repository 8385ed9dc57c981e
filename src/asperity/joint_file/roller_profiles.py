"""Crowns and profiles of the tracks of a joint file: what is refused of them, and the gap that both make."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from asperity.contact.roller_profiles import (
    ISO_16281_LENGTH,
    iso_16281_coefficient,
    lundberg_coefficient,
)
from asperity.drive.layout.drive import Drive
from asperity.drive.layout.drive_type import SIDES, DriveType
from asperity.drive.layout.sizes import ISO_16281, LOGARITHMIC
from asperity.joint.contacts import elastic_material
from asperity.joint_file.quantity_key import Quantity
from asperity.materials import Material, pair
from asperity.types import Real
from asperity.units import format_quantity


class SideOfContact(NamedTuple):
    """What a file states of one track of a contact: the start of its keys, and their values, None where absent."""

    keys: str
    radius: Quantity | None
    crown: Quantity | None
    profile: str | None
    load: Quantity | None

    @property
    def shaped(self) -> str:
        """The key that gives it a shape; empty for a cylinder."""
        return (
            f"{self.keys}_{'crown_radius' if self.crown is not None else 'profile'}" if self.has_shape else ""
        )

    @property
    def has_shape(self) -> bool:
        """Whether it is no cylinder."""
        return self.crown is not None or self.profile is not None


def side_of_contact(section: Any, keys: str, name: str) -> SideOfContact:
    """The track of NAME_radius in a section; ``keys``, the start of its keys in messages."""
    found = (
        getattr(section, f"{name}_{key}", None)
        for key in ("radius", "crown_radius", "profile", "profile_load")
    )
    return SideOfContact(keys, *found)


class ShapedContact(NamedTuple):
    """A contact with what a file states of both its tracks, and the length of its line."""

    name: str
    length: Quantity | None
    sides: tuple[SideOfContact, SideOfContact]


def shaped_contacts(kind: DriveType, drive: Any, entries: Iterable[Any]) -> Iterator[ShapedContact]:
    """The contacts of a section [drive], or of sections [[contact]]."""
    lengths = drive.contact_length

    def length(name: str) -> Quantity | None:
        found = lengths.get(name) if isinstance(lengths, Mapping) else lengths
        return found if isinstance(found, Quantity) else None

    for contact in kind.contacts:
        first, second = (side_of_contact(drive, f"drive.{name}", name) for name in kind.tracks(contact))
        yield ShapedContact(contact.name, length(contact.name), (first, second))
    for entry in entries:
        first, second = (side_of_contact(entry, f"contact {entry.name}: {side}", side) for side in SIDES)
        yield ShapedContact(entry.name, length(entry.name), (first, second))


def misstated_profiles(contacts: Iterable[ShapedContact]) -> Iterator[str]:
    """Messages about profiles of which a part is missing, that contradict a crown, or that are not known."""
    told: set[str] = set()
    for contact in contacts:
        messages = [message for side in contact.sides for message in _misstated(side, contact)]
        one, other = contact.sides
        if one.has_shape and other.has_shape and (one.profile is None) != (other.profile is None):
            messages.append(
                f"{one.shaped}, {other.shaped}: a circle meets a logarithmic profile in contact {contact.name}, which "
                "is not computed; give both a profile, or both a crown, or leave one of them a cylinder"
            )
        yield from (message for message in messages if message not in told)
        told.update(messages)


def _misstated(side: SideOfContact, contact: ShapedContact) -> Iterator[str]:
    """Messages about one track."""
    stated = f"{side.keys}_profile = '{side.profile}'"
    if side.profile is not None and side.crown is not None:
        yield f"{stated}: {side.keys}_crown_radius is stated too; a track has one shape, leave one of them out"
    if side.profile == LOGARITHMIC and side.load is None:
        yield (
            f"{stated}: {side.keys}_profile_load is missing; give the normal force for which the profile is made, e.g. "
            '"1000 N"'
        )
    if side.load is not None and side.profile != LOGARITHMIC:
        yield (
            f"{side.keys}_profile_load = '{side.load.text}': only for {side.keys}_profile = \"{LOGARITHMIC}\"; leave "
            "it out, or state that profile"
        )
    if side.profile == ISO_16281 and side.radius is not None and contact.length is not None:
        longest = 2.0 * ISO_16281_LENGTH * side.radius.value
        if contact.length.value > longest * (1.0 + 1e-12):
            yield (
                f"{stated}: contact {contact.name} is {contact.length.text} long, more than {ISO_16281_LENGTH:g} times "
                f"the diameter of the roller, {format_quantity(longest, 'mm')}, up to which this profile is known; "
                f'choose a shorter line, or "{LOGARITHMIC}"'
            )


class Crowns(NamedTuple):
    """Of each contact: curvature of both crowns in its middle [1/m], and whether it has a logarithmic profile.

    None where all tracks are cylinders, and where none has a profile.
    """

    curvatures: tuple[Real, ...] | None
    logarithmic: tuple[bool, ...] | None


def crowns_of(
    kind: DriveType,
    values: Mapping[str, Any],
    drive: Drive,
    materials: tuple[Material, ...],
    lengths: tuple[Real, ...],
) -> Crowns:
    """The crowns of the contacts of tables in SI units; ``lengths`` of all contacts or of each [m]."""
    radii, profiles = kind.crown_radii(values), kind.profiles(values)
    if all(radius is None for both in radii for radius in both) and not any(
        word for both in profiles for word, _ in both
    ):
        return Crowns(None, None)
    curvatures: list[Real] = []
    layout, count = drive.layout, len(drive.contacts)
    for k, (crowns, shapes) in enumerate(zip(radii, profiles, strict=True)):
        curvature: Real = sum((1.0 / radius for radius in crowns if radius is not None), 0.0)
        length = lengths[k] if len(lengths) == count else lengths[0]
        bodies = (elastic_material(materials[side[k]]) for side in (layout.first, layout.second))
        modulus = pair(*bodies).contact_modulus
        for (word, load), track in zip(shapes, (drive.first_radius[k], drive.second_radius[k]), strict=True):
            if word == ISO_16281:
                coefficient = iso_16281_coefficient(roller_diameter=2.0 * track)
            elif word == LOGARITHMIC:
                coefficient = lundberg_coefficient(line_load=load / length, contact_modulus=modulus)
            else:
                continue
            curvature = curvature + 8.0 * coefficient / length**2  # A ln 1/(1 - (2y/B)^2) in the middle
        curvatures.append(curvature)
    profiled = tuple(any(word for word, _ in both) for both in profiles)
    return Crowns(tuple(curvatures), profiled if any(profiled) else None)
