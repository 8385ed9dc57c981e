"""Names of the bodies and contacts of each type of drive, from the tables of its joint file."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable, Mapping
from typing import Any

#: Type of the drive of Zou et al. 2025, that of a file without a type.
WEDGE_TYPE = "zou2025"

#: Name of the housing in [bodies].
HOUSING = "housing"
#: Contacts of each type with the bodies that they join.
CONTACTS: dict[str, dict[str, tuple[str, str]]] = {
    WEDGE_TYPE: {
        "sp": ("sun", "planet"),
        "pwr": ("planet", "right_loading_roller"),
        "pwl": ("planet", "left_loading_roller"),
        "wro": ("right_loading_roller", "ring"),
        "wlo": ("left_loading_roller", "ring"),
    },
    "planetary": {"sp": ("sun", "planet"), "pr": ("planet", "ring")},
    "multiroller": {
        "sf": ("sun", "first_row"),
        "fsl": ("first_row", "second_row"),
        "fsr": ("first_row", "second_row"),
        "sr": ("second_row", "ring"),
    },
    "stepped_planet": {
        "sp": ("sun", "planet"),
        "pr1": ("planet", "held_ring"),
        "pr2": ("planet", "driven_ring"),
    },
}


#: Tracks of the two bodies at each contact: ``TRACK_crown_radius`` is what a file says of their crowns.
TRACKS: dict[str, dict[str, tuple[str, str]]] = {
    WEDGE_TYPE: {
        "sp": ("sun", "planet"),
        "pwr": ("planet", "loading_roller"),
        "pwl": ("planet", "loading_roller"),
        "wro": ("loading_roller", "ring"),
        "wlo": ("loading_roller", "ring"),
    },
    "planetary": CONTACTS["planetary"],
    "multiroller": {
        "sf": ("sun", "first_row"),
        "fsl": ("first_row_small", "second_row"),
        "fsr": ("first_row_small", "second_row"),
        "sr": ("second_row_small", "ring"),
    },
    "stepped_planet": {
        "sp": ("sun", "planet"),
        "pr1": ("planet", "ring"),
        "pr2": ("planet_second", "driven_ring"),
    },
}


def type_of(tables: Mapping[str, Any]) -> str:
    """Type of the drive from the tables of a joint file; :data:`WEDGE_TYPE` where they state none."""
    return str(tables.get("type", WEDGE_TYPE))


def material_keys(kind: str) -> tuple[str, ...]:
    """Keys of the section [bodies] of a type: its bodies, both loading rollers of a planet as one."""
    return tuple(dict.fromkeys(material_key(kind, body) for body in bodies_of_type(kind)))


def material_key(kind: str, body: str) -> str:
    """Key of a body of a type in [bodies]: both loading rollers of a planet are made of one material."""
    return "loading_roller" if kind == WEDGE_TYPE and body.endswith("_loading_roller") else body


def body_key(kind: str, body: str, keys: Container[str]) -> str:
    """Key in [bodies] of a body of a solved joint, behind whose name the number of its branch may stand."""
    key = material_key(kind, body)
    return key if key in keys else material_key(kind, re.sub(r"_\d+$", "", body))


def bodies_of_type(kind: str) -> tuple[str, ...]:
    """Names of the bodies of a type."""
    return tuple(dict.fromkeys(body for pair in CONTACTS[kind].values() for body in pair))


def contacts_of(tables: Mapping[str, Any]) -> tuple[str, ...]:
    """Names of the contacts of a joint file in the order of the drive.

    Of tables as the file states them or in SI units.
    """
    kind = type_of(tables)
    return tuple(CONTACTS[kind]) if kind in CONTACTS else _listed(tables["contact"])


def sized_tracks(tables: Mapping[str, Any]) -> dict[str, tuple[tuple[str, str], ...]]:
    """What every sector has in a size of its own: rollers, or the tracks of stepped ones.

    Name in the keys ``NAME_radius`` of the drive and ``NAME_deviation`` of sections ``[[branch]]``, or that of a roller
    in a file of type ``planar`` → contacts on it, and which of their bodies it is. Of tables in SI units, of another
    drive than that of Zou et al.
    """
    kind = type_of(tables)
    if kind in TRACKS:
        named = {
            contact: tuple(
                _part(track, body) for track, body in zip(TRACKS[kind][contact], bodies, strict=True)
            )
            for contact, bodies in CONTACTS[kind].items()
        }
        return {
            name: tuple(
                (contact, side)
                for contact, pair in named.items()
                for side, track in zip(_SIDES, pair, strict=True)
                if track == name
            )
            for name in dict.fromkeys(name for pair in named.values() for name in pair if name not in _COMMON)
        }
    contacts = tables["contact"].values()
    return {
        roller["name"]: tuple(
            (contact["name"], side)
            for contact in contacts
            for side in _SIDES
            if contact[side] == roller["name"]
        )
        for roller in tables["roller"].values()
        if roller["place"] != "axis"
    }


def _part(track: str, body: str) -> str:
    """Name of a track in sections [[branch]]: both loading rollers of a planet have one radius, not one size."""
    return f"{body.split('_')[0]}_roller" if track == "loading_roller" else track


def sizes_of_tracks(tables: Mapping[str, Any]) -> dict[str, str]:
    """NAME in the keys ``NAME_deviation`` of a branch → NAME in the key ``NAME_radius`` of the drive."""
    return {
        name: "loading_roller" if name in ("right_roller", "left_roller") else name
        for name in sized_tracks(tables)
    }


def size_keys(tables: Mapping[str, Any]) -> set[str]:
    """NAME in the keys ``NAME_radius`` that the section [drive] states."""
    return {
        key.removesuffix("_radius")
        for key in tables["drive"]
        if key.endswith("_radius") and "crown" not in key
    }


def with_tracks(tables: dict[str, Any]) -> dict[str, Any]:
    """Tables in SI units whose contacts name what belongs to the structure of the drive, so that numbers may vary.

    The same tables; those of type ``planar`` with the names of the tracks, and with words in place of the truth values
    and sectors of the contacts.
    """
    contacts = tables.get("contact")
    if not isinstance(contacts, Mapping) or any("tracks" in entry for entry in contacts.values()):
        return tables
    named = {
        index: entry
        | {
            "tracks": {side: track_of(contacts.values(), entry, side) for side in _SIDES},
            "internal": "yes" if entry["internal"] else "",
            "sector": str(entry["sector"]),
        }
        for index, entry in contacts.items()
    }
    return tables | {"contact": named}


def track_of(contacts: Iterable[Mapping[str, Any]], entry: Mapping[str, Any], side: str) -> str:
    """Name of the track of a roller on which a contact of a drive of type ``planar`` lies."""
    if "tracks" in entry:
        return str(entry["tracks"][side])
    radii = [
        contact[f"{one}_radius"] for contact in contacts for one in _SIDES if contact[one] == entry[side]
    ]
    written = dict.fromkeys(f"{float(radius):.12g}" for radius in radii)
    return str([*written].index(f"{float(entry[f'{side}_radius']):.12g}"))


def paths_of_track(tables: Mapping[str, Any], path: str) -> list[str]:
    """Dotted paths of all numbers of a joint file that are the radius of the same track as a given one.

    The path itself, and where it is the radius or the crown of a contact of type ``planar``, those of the roller's
    other contacts on the same track. Tables in SI units.
    """
    steps = path.split(".")
    side, of_the_track = steps[-1].removesuffix("_radius"), "radius"
    if side.endswith("_crown"):
        side, of_the_track = side.removesuffix("_crown"), "crown_radius"
    if steps[0] != "contact" or side not in _SIDES or steps[1] not in tables.get("contact", {}):
        return [path]
    given, contacts = tables["contact"][steps[1]], tables["contact"].values()
    mine = (given[side], track_of(contacts, given, side))
    return [
        f"contact.{index}.{entry_side}_{of_the_track}"
        for index, entry in tables["contact"].items()
        for entry_side in _SIDES
        if (entry[entry_side], track_of(contacts, entry, entry_side)) == mine
    ]


_SIDES = ("first", "second")
_COMMON = ("sun", "ring", "driven_ring")  # tracks that all sectors share


def _listed(entries: Any) -> tuple[str, ...]:
    """Names of sections [[roller]] or [[contact]]: a list, or tables by their numbers."""
    sections = entries.values() if isinstance(entries, Mapping) else entries
    return tuple(str(entry["name"]) for entry in sections)
