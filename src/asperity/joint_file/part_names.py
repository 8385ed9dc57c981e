"""Names of the bodies and contacts of a drive, from the tables of its joint file."""

from __future__ import annotations

import re
from collections.abc import Container, Mapping
from typing import Any

from asperity.drive.layout.drive_type import SIDES, DriveType
from asperity.drive.types import DEFAULT_TYPE, FORMER_NAMES, TYPES
from asperity.drive.types.listed import track_of
from asperity.types import Document

#: Name of the housing in [bodies].
HOUSING = "housing"


def type_of(tables: Mapping[str, Any]) -> str:
    """Type of the drive from the tables of a joint file, by the name that it has now; that of a file without a type."""
    name = str(tables.get("type", DEFAULT_TYPE))
    return FORMER_NAMES.get(name, name)


def drive_type_of(tables: Mapping[str, Any]) -> DriveType:
    """The type of drive that the tables of a joint file describe."""
    return TYPES[type_of(tables)]


def body_key(kind: str, body: str, keys: Container[str]) -> str:
    """Key in [bodies] of a body of a solved joint, behind whose name the number of its branch may stand."""
    key = TYPES[kind].material_key(body)
    return key if key in keys else TYPES[kind].material_key(re.sub(r"_\d+$", "", body))


def contacts_of(tables: Mapping[str, Any]) -> tuple[str, ...]:
    """Names of the contacts of a joint file in the order of the drive.

    Of tables as the file states them or in SI units.
    """
    return drive_type_of(tables).contact_names(tables)


def sized_tracks(tables: Mapping[str, Any]) -> dict[str, tuple[tuple[str, str], ...]]:
    """What every sector has in a size of its own: rollers, or the tracks of stepped ones.

    Name in the keys ``NAME_deviation`` of sections ``[[branch]]``, or that of a roller in a file of type ``planar`` →
    contacts on it, and which of their bodies it is. Of tables in SI units.
    """
    return drive_type_of(tables).sized_tracks(tables)


def sizes_of_tracks(tables: Mapping[str, Any]) -> dict[str, str]:
    """NAME in the keys ``NAME_deviation`` of a branch → NAME in the key ``NAME_radius`` of the drive."""
    return drive_type_of(tables).sizes_of_tracks(tables)


def size_keys(tables: Mapping[str, Any]) -> set[str]:
    """NAME in the keys ``NAME_radius`` that the section [drive] states."""
    return {
        key.removesuffix("_radius")
        for key in tables["drive"]
        if key.endswith("_radius") and "crown" not in key
    }


#: Key of tables of a file with form errors: the number of sectors of its drive, as a word.
SECTORS = "form_sectors"


def with_structure(tables: Document) -> Document:
    """Tables in SI units that name what belongs to the structure of the drive, so that numbers may vary.

    The same tables; those of type ``planar`` with the names of the tracks, and with words in place of the truth values
    and sectors of the contacts; those with form errors with :data:`SECTORS`, and words in place of theirs.
    """
    contacts, named = tables.get("contact"), tables
    if isinstance(contacts, Mapping) and not any("tracks" in entry for entry in contacts.values()):
        named = tables | {
            "contact": {
                index: entry
                | {
                    "tracks": {side: track_of(contacts.values(), entry, side) for side in SIDES},
                    "internal": "yes" if entry["internal"] else "",
                    "sector": str(entry["sector"]),
                }
                for index, entry in contacts.items()
            }
        }
    if "form" not in tables or SECTORS in tables:
        return named
    form = {
        index: entry | ({"sector": str(entry["sector"])} if "sector" in entry else {})
        for index, entry in tables["form"].items()
    }
    return named | {"form": form, SECTORS: str(_sectors_of(tables))}


def _sectors_of(tables: Document) -> int:
    """Number of equal sectors of the drive of a file, or of its branches."""
    if "branch" in tables:
        return len(tables["branch"])
    sectors = drive_type_of(tables).sectors
    return 1 if sectors is None else round(float(tables["drive"][sectors.key]))


def paths_of_track(tables: Mapping[str, Any], path: str) -> list[str]:
    """Dotted paths of all numbers of a joint file that are the radius of the same track as a given one.

    The path itself, and where it is the radius, the crown or the load of the profile of a contact of type ``planar``,
    those of the roller's other contacts on the same track. Tables in SI units.
    """
    steps = path.split(".")
    side, _, of_the_track = steps[-1].partition("_")
    if of_the_track not in ("radius", "crown_radius", "profile_load"):
        return [path]
    if steps[0] != "contact" or side not in SIDES or steps[1] not in tables.get("contact", {}):
        return [path]
    given, contacts = tables["contact"][steps[1]], tables["contact"].values()
    mine = (given[side], track_of(contacts, given, side))
    return [
        f"contact.{index}.{entry_side}_{of_the_track}"
        for index, entry in tables["contact"].items()
        for entry_side in SIDES
        if (entry[entry_side], track_of(contacts, entry, entry_side)) == mine
    ]
