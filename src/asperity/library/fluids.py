"""Oils with their sources, as data: viscosity over temperature and pressure, and the shear stress that a film bears."""

from __future__ import annotations

import functools
from collections.abc import Iterable
from dataclasses import dataclass

from asperity.errors import InputError, nearest, quoted
from asperity.library import built_in_entries, library_name
from asperity.types import Document

_WORDS = ("description", "reference", "note")


@dataclass(frozen=True)
class LibraryFluid:
    """An oil of the library, with its source and a remark; SI units.

    ``viscosity`` and ``pressure_rise``: name of a law of :mod:`asperity.contact.viscosity` at ``law``, and its numbers;
    empty where the viscosity is not known. ``limiting_traction``: numbers of
    :class:`asperity.contact.fluid.LimitingTraction`. ``shear_law`` and ``conductivity`` [W/(m K)], None where they are
    not known; ``lowest_temperature`` [degC] of the data, None where the source states none. ``also``: other spellings.
    """

    name: str
    description: str
    reference: str
    note: str
    also: tuple[str, ...]
    viscosity: Document
    pressure_rise: Document
    limiting_traction: Document
    shear_law: str | None
    conductivity: float | None
    lowest_temperature: float | None


@functools.cache
def _fluids() -> dict[str, LibraryFluid]:
    """The oils of the library by their names."""
    return {name: _fluid(name, entry) for name, entry in built_in_entries("fluids_library.toml").items()}


def _fluid(name: str, entry: Document) -> LibraryFluid:
    """An oil from its table, which a test checks."""
    return LibraryFluid(
        name=name,
        **{word: entry[word] for word in _WORDS},
        also=tuple(entry["also"]),
        viscosity=entry.get("viscosity", {}),
        pressure_rise=entry.get("pressure_rise", {}),
        limiting_traction=entry["limiting_traction"],
        shear_law=entry.get("shear_law"),
        conductivity=entry.get("conductivity"),
        lowest_temperature=entry.get("lowest_temperature"),
    )


def read_fluids() -> dict[str, LibraryFluid]:
    """Name → oil of the library."""
    return dict(_fluids())


def library_fluid(name: str) -> LibraryFluid | None:
    """The oil that the library has by a name or another spelling; capitals, blanks and hyphens do not count."""
    known = library_name(name, _fluids())
    return None if known is None else _fluids()[known]


def section_of(name: str, sections: Iterable[str]) -> str | None:
    """The section ``[fluids.NAME]`` of a joint file that describes an oil; None without one.

    That with its name, or with another spelling of the same oil of the library.
    """
    names = list(sections)
    known = library_fluid(name)
    same = [other for other in names if known is not None and library_fluid(other) == known]
    return name if name in names else next(iter(same), None)


def refuse_unknown_fluid(name: str, sections: Iterable[str]) -> None:
    """Refuse the name of an oil, with near ones, that neither a section of the file nor the library has."""
    names = list(sections)
    if section_of(name, names) is None and library_fluid(name) is None:
        choice = [*names, *_fluids()]
        hint = nearest(name, choice) or f"; known are {', '.join(choice)}"
        raise InputError(
            f"there is no fluid {quoted(name)}{hint}; or describe it in a section [fluids.{_plain(name)}]"
        )


def _plain(name: str) -> str:
    """A name that a section may have."""
    return "".join(letter if letter.isascii() and letter.isalnum() else "_" for letter in name)[:60] or "NAME"
