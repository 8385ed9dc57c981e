"""Any drive whose file lists its rollers and contacts, one sector of it: ``type = "planar"``."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from asperity.drive.layout.closing import closed
from asperity.drive.layout.drive import Body, Closure, Contact, Drive
from asperity.drive.layout.drive_type import (
    SIDES,
    Assumed,
    DriveType,
    Places,
    Sectors,
    ShapeSizes,
    Tables,
)
from asperity.drive.layout.sizes import ContactLength
from asperity.engine.arrays import xp
from asperity.types import Array, Document


@dataclass(frozen=True, kw_only=True)
class ListedType(DriveType):
    """A type whose bodies and contacts each file lists, in sections [[roller]] and [[contact]]."""

    def _misfits(self) -> list[str]:
        """Nothing is known of its parts before a file is."""
        return []

    @property
    def is_listed(self) -> bool:
        """Whether its file lists its rollers and contacts."""
        return True

    def contact_names(self, tables: Tables) -> tuple[str, ...]:
        """Names of the sections [[contact]]."""
        return tuple(str(entry["name"]) for entry in _entries(tables["contact"]))

    def sized_tracks(self, tables: Tables) -> dict[str, tuple[tuple[str, str], ...]]:
        """Rollers off the axis → their contacts, and on which side of each they are."""
        contacts = _entries(tables["contact"])
        return {
            roller["name"]: tuple(
                (contact["name"], side)
                for contact in contacts
                for side in SIDES
                if contact[side] == roller["name"]
            )
            for roller in _entries(tables["roller"])
            if roller["place"] != "axis"
        }

    def deviations(self, branch: Tables) -> Document:
        """Deviations of the rollers that a section [[branch]] states [m]."""
        return dict(branch.get("deviation", {}))

    def crown_radii(self, tables: Tables) -> list[list[Any]]:
        """Crown radii of both tracks of each contact, None for a cylinder [m]."""
        return [
            [entry.get(f"{side}_crown_radius") for side in SIDES] for entry in _entries(tables["contact"])
        ]

    def profiles(self, tables: Tables) -> list[list[tuple[Any, Any]]]:
        """Profiles of both tracks of each contact, and the normal forces of logarithmic ones [N], None where absent."""
        return [
            [(entry.get(f"{side}_profile"), entry.get(f"{side}_profile_load")) for side in SIDES]
            for entry in _entries(tables["contact"])
        ]

    def shapes(self, tables: Tables) -> tuple[ShapeSizes, ...]:
        """What the sections [[roller]] say of the shapes of the bodies."""
        return tuple(
            ShapeSizes(
                roller.get("wall_thickness"),
                roller.get("ring_support"),
                roller.get("bore_diameter"),
                roller.get("length"),
            )
            for roller in _entries(tables["roller"])
        )

    def interference_shares(self, tables: Tables) -> tuple[float, ...]:
        """Interference of each contact over that of the drive."""
        return tuple(1.0 if contact["internal"] else 0.0 for contact in _entries(tables["contact"]))

    def drive_of(self, tables: Tables) -> Drive:
        """The drive that the rollers and contacts of a file make."""
        rollers, contacts, drive = _entries(tables["roller"]), _entries(tables["contact"]), tables["drive"]
        made = Drive(
            bodies=tuple(Body(roller["name"], roller["place"]) for roller in rollers),
            contacts=tuple(
                Contact(
                    contact["name"],
                    contact["first"],
                    contact["second"],
                    internal=bool(contact["internal"]),
                    sector=int(contact["sector"]),
                    tracks=(track_of(contacts, contact, "first"), track_of(contacts, contact, "second")),
                )
                for contact in contacts
            ),
            centres=xp.stack([_centre(roller) for roller in rollers]),
            first_radius=xp.stack([xp.asarray(contact["first_radius"]) for contact in contacts]),
            second_radius=xp.stack([xp.asarray(contact["second_radius"]) for contact in contacts]),
            push_angles=xp.array(
                [roller.get("push_angle", 0.0) for roller in rollers if roller["place"] == "pin"], dtype=float
            ),
            sectors=drive["sectors"],
            input=drive["input"],
            output=drive["output"],
            grounded=drive["grounded"],
            closure=Closure(
                equal_coefficients=tuple(
                    (contact["same_coefficient_as"], contact["name"])
                    for contact in contacts
                    if "same_coefficient_as" in contact
                ),
                constant_pins=tuple(
                    roller["name"] for roller in rollers if roller.get("pin_force") == "constant"
                ),
            ),
        )
        return closed(made)


def _entries(sections: Any) -> list[Any]:
    """Sections [[roller]] or [[contact]]: a list, or tables by their numbers."""
    return list(sections.values()) if isinstance(sections, Mapping) else list(sections)


def _centre(roller: Tables) -> Array:
    """Centre of a roller as its section states it, above the axis without an angle [m]."""
    angle = roller.get("angle", 0.5 * math.pi)
    return xp.asarray(roller.get("orbit", 0.0) * xp.stack([xp.cos(angle), xp.sin(angle)]))


def track_of(contacts: Iterable[Tables], entry: Tables, side: str) -> str:
    """Name of the track of a roller on which a listed contact lies: its number among the radii of the roller."""
    if "tracks" in entry:
        return str(entry["tracks"][side])
    radii = [contact[f"{one}_radius"] for contact in contacts for one in SIDES if contact[one] == entry[side]]
    written = dict.fromkeys(f"{float(radius):.12g}" for radius in radii)
    return str([*written].index(f"{float(entry[f'{side}_radius']):.12g}"))


def _no_layout(sizes: Tables) -> Places:
    """The places of a listed drive stand in its sections [[roller]]."""
    raise TypeError("a listed drive is made by drive_of, from all tables of its file")


LISTED = ListedType(
    name="planar",
    words="planar",
    summary="Any drive: rollers and rings, their contacts, and which members turn.",
    rank=4,
    sectors=Sectors("sectors", "Number of equal sectors; the file describes one of them.", "sectors"),
    parts=(),
    contacts=(),
    sizes=(ContactLength(),),
    input="",
    output="",
    grounded="",
    layout=_no_layout,
    assumed=(Assumed("every track is as long as its longest contact line"),),
)
