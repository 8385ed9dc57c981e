"""Materials and surface finishes with their sources, as data; a user's file can extend them.

Each entry states its reference; values without a traceable reference are not included.
"""

from __future__ import annotations

import contextlib
import copy
import functools
import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from asperity.errors import InputError, quoted
from asperity.reading import read_toml
from asperity.surface.roughness_average import fractal_roughness_from_average
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import parse_quantity

__all__ = [
    "Finish",
    "LibraryMaterial",
    "fill_in_materials",
    "library_name",
    "read_finishes",
    "read_materials",
]

#: Frequency ratio gamma for which the fractal roughness of finishes is stated.
FREQUENCY_RATIO = 1.5

_MATERIAL_NUMBERS = {
    "youngs_modulus": Dimension.PRESSURE,
    "poisson_ratio": Dimension.DIMENSIONLESS,
    "density": Dimension.DENSITY,
    "yield_strength": Dimension.PRESSURE,
    "hardness": Dimension.HARDNESS,
    "hardness_factor": Dimension.DIMENSIONLESS,
    "thermal_conductivity": Dimension.THERMAL_CONDUCTIVITY,
    "specific_heat_capacity": Dimension.SPECIFIC_HEAT_CAPACITY,
    "thermal_expansion": Dimension.THERMAL_EXPANSION,
    "fatigue_strength": Dimension.PRESSURE,
    "tensile_strength": Dimension.PRESSURE,
}
_MATERIAL_NEEDS = ("youngs_modulus", "poisson_ratio", "density", "yield_strength")
_WORDS = ("description", "reference", "note")
#: Other designations of a material.
_ALSO = "also"


@dataclass(frozen=True)
class LibraryMaterial:
    """A material of the library, with its source and a remark.

    ``numbers``: keys of a material section of a joint file → text with units; ``also``: its designations in other
    standards.
    """

    name: str
    description: str
    reference: str
    note: str
    numbers: Document
    also: tuple[str, ...]


@dataclass(frozen=True)
class Finish:
    """A surface finish of the library, with its source and remark; ranges are lowest and highest value.

    ``roughness_average``: Ra [m], taken over the ``sampling_length``, the cut-off of the profile filter [m];
    ``fractal_dimension``: D [-] for which G is stated, equal where the source gives one value; ``fractal_roughness``: G
    [m], from Ra by :func:`asperity.surface.roughness_average.fractal_roughness_from_average`; ``published_dimension``:
    D [-] that publications give for such surfaces: what is known of D where only Ra is.
    """

    name: str
    description: str
    reference: str
    note: str
    roughness_average: tuple[float, float]
    sampling_length: float
    fractal_dimension: tuple[float, float]
    fractal_roughness: tuple[float, float]
    published_dimension: tuple[float, float]

    @property
    def ranges(self) -> dict[str, tuple[float, float]]:
        """Keys of a surface section of a joint file → lowest and highest value [SI]."""
        return {
            "fractal_dimension": self.fractal_dimension,
            "fractal_roughness": self.fractal_roughness,
            "roughness_average": self.roughness_average,
        }


@functools.cache
def built_in_entries(name: str) -> dict[str, Document]:
    """The tables of a file of this folder; not to be changed."""
    from importlib.resources import files

    return tomllib.loads(files("asperity.library").joinpath(name).read_text(encoding="utf-8"))


def _tables(name: str, extension: str | Path | None) -> dict[str, Document]:
    tables = copy.deepcopy(built_in_entries(name))
    if extension is not None:
        added = read_toml(extension)
        for entry, value in added.items():
            if not isinstance(value, dict):
                raise InputError(f"{extension}: {entry}: expected a table, got {quoted(value)}")
        tables.update(added)
    return tables


@contextlib.contextmanager
def _naming(extension: str | Path | None) -> Iterator[None]:
    """Prefix an error in an entry with the user's library file; the built-in entries are tested."""
    try:
        yield
    except InputError as error:
        raise (error if extension is None else InputError(f"{extension}: {error}")) from None


def _words(name: str, entry: Mapping[str, Any]) -> dict[str, str]:
    for word in ("description", "reference"):
        if not isinstance(entry.get(word), str) or not entry[word].strip():
            raise InputError(
                f"library entry {name}: '{word}' is missing or is not text; every entry must state its source"
            )
    return {word: str(entry.get(word, "")) for word in _WORDS}


def read_materials(extension: str | Path | None = None) -> dict[str, LibraryMaterial]:
    """Name → material of the library; a TOML file of the same form adds entries, or replaces those of the same name.

    An ``InputError`` if an entry is incomplete, has an unknown key, or a number that cannot be read.
    """
    return dict(_materials_built_in()) if extension is None else _materials(extension)


@functools.cache
def _materials_built_in() -> dict[str, LibraryMaterial]:
    return _materials(None)


def _materials(extension: str | Path | None) -> dict[str, LibraryMaterial]:
    materials = {}
    tables = _tables("materials_library.toml", extension)
    with _naming(extension):
        for name, entry in tables.items():
            words = _words(name, entry)
            numbers = {key: value for key, value in entry.items() if key not in (*_WORDS, _ALSO)}
            also = entry.get(_ALSO, [])
            if not isinstance(also, list) or not all(isinstance(alias, str) for alias in also):
                raise InputError(
                    f"library entry {name}: {_ALSO}: expected a list of names, got {quoted(also)}"
                )
            for key, value in numbers.items():
                if key not in _MATERIAL_NUMBERS:
                    raise InputError(
                        f"library entry {name}: unknown key '{key}'; known are "
                        f"{', '.join((*_MATERIAL_NUMBERS, *_WORDS, _ALSO))}"
                    )
                try:
                    parse_quantity(value, _MATERIAL_NUMBERS[key])
                except InputError as error:
                    raise InputError(f"library entry {name}: {key}: {error}") from None
            for key in _MATERIAL_NEEDS:
                if key not in numbers:
                    raise InputError(f"library entry {name}: '{key}' is missing")
            if ("hardness" in numbers) == ("hardness_factor" in numbers):
                raise InputError(
                    f"library entry {name}: exactly one of 'hardness' and 'hardness_factor' is needed"
                )
            materials[name] = LibraryMaterial(name=name, numbers=numbers, also=tuple(also), **words)
    return materials


class _Entry(Protocol):
    """An entry of a library that has other names."""

    @property
    def name(self) -> str: ...
    @property
    def also(self) -> tuple[str, ...]: ...


def library_name(name: str, library: Mapping[str, _Entry]) -> str | None:
    """The name under which a library has a material or fluid of this name or designation; None where it has none.

    Of designations in other standards capitals, blanks and hyphens do not count; the library is that of
    :func:`read_materials`.
    """
    if name in library:
        return name
    names = {_plain(alias): entry.name for entry in library.values() for alias in entry.also}
    return names.get(_plain(name))


def _plain(name: str) -> str:
    """A name without capitals, blanks and hyphens."""
    return name.lower().replace(" ", "").replace("-", "")


def _range(name: str, key: str, value: Any, dimension: Dimension) -> tuple[float, float]:
    pair = value if isinstance(value, list) else [value, value]
    if len(pair) != 2:
        raise InputError(
            f"library entry {name}: {key}: expected one value or [lowest, highest], got {quoted(value)}"
        )
    try:
        low, high = (parse_quantity(text, dimension) for text in pair)
    except InputError as error:
        raise InputError(f"library entry {name}: {key}: {error}") from None
    if not 0.0 < low <= high:
        raise InputError(
            f"library entry {name}: {key}: must satisfy 0 < lowest <= highest, got {quoted(value)}"
        )
    return low, high


def read_finishes(extension: str | Path | None = None) -> dict[str, Finish]:
    """Name → surface finish of the library; a TOML file of the same form adds entries, or replaces those of its names.

    An ``InputError`` if an entry is incomplete, has an unknown key, or a number that cannot be read.
    """
    return dict(_finishes_built_in()) if extension is None else _finishes(extension)


@functools.cache
def _finishes_built_in() -> dict[str, Finish]:
    return _finishes(None)


def _finishes(extension: str | Path | None) -> dict[str, Finish]:
    known = ("roughness_average", "sampling_length", "fractal_dimension", "published_dimension", *_WORDS)
    finishes = {}
    tables = _tables("finishes_library.toml", extension)
    with _naming(extension):
        for name, entry in tables.items():
            words = _words(name, entry)
            for key in entry:
                if key not in known:
                    raise InputError(
                        f"library entry {name}: unknown key '{key}'; known are {', '.join(known)}"
                    )
            for key in known[:3]:
                if key not in entry:
                    raise InputError(f"library entry {name}: '{key}' is missing")
            average = _range(name, "roughness_average", entry["roughness_average"], Dimension.LENGTH)
            length = _range(name, "sampling_length", entry["sampling_length"], Dimension.LENGTH)[0]
            dimension = _range(name, "fractal_dimension", entry["fractal_dimension"], Dimension.DIMENSIONLESS)
            published = _range(
                name,
                "published_dimension",
                entry.get("published_dimension", list(dimension)),
                Dimension.DIMENSIONLESS,
            )
            for key, pair in (("fractal_dimension", dimension), ("published_dimension", published)):
                if not 1.0 < pair[0] <= pair[1] < 2.0:
                    raise InputError(f"library entry {name}: {key} must be between 1 and 2, got {pair}")
            corners = [
                fractal_roughness_from_average(roughness_average=height, cut_off=length, fractal_dimension=d)
                for height in average
                for d in dimension
            ]
            finishes[name] = Finish(
                name=name,
                roughness_average=average,
                sampling_length=length,
                fractal_dimension=dimension,
                fractal_roughness=(min(corners), max(corners)),
                published_dimension=published,
                **words,
            )
    return finishes


def fill_in_materials(tables: Mapping[str, Any], *, folder: Path) -> tuple[Document, dict[str, str]]:
    """The tables of a joint file with names of library materials replaced by their numbers, and what was refused.

    ``materials.NAME = {library = "52100"}`` refers to an entry, further keys replace single values, ``file =
    "my.toml"`` names a library file of the user, relative to the folder. If the file does not define the material of
    a body, it is taken from the library, of whichever name or designation. What was refused says by the dotted path of
    a material why its entry was not found; its table is left unchanged.
    """
    refused: dict[str, str] = {}
    materials = tables.get("materials", {})
    bodies = tables.get("bodies", {})
    if not isinstance(materials, dict) or not isinstance(bodies, dict):
        return dict(tables), refused
    filled = dict(materials)
    for name, entry in materials.items():
        if isinstance(entry, dict) and "library" in entry:
            try:
                filled[name] = _from_library(entry, folder)
            except InputError as error:
                refused[f"materials.{name}"] = f"materials.{name}.{error}"
    wanted = [name for name in bodies.values() if isinstance(name, str) and name not in filled]
    if not wanted:
        return ({**tables, "materials": filled} if filled else dict(tables)), refused
    library = read_materials()
    known = {name: key for name in wanted if (key := library_name(name, library)) and key not in materials}
    filled.update({key: dict(library[key].numbers) for key in known.values()})
    named = {body: known.get(name, name) if isinstance(name, str) else name for body, name in bodies.items()}
    return ({**tables, "materials": filled, "bodies": named} if filled else dict(tables)), refused


def _from_library(entry: Document, folder: Path) -> Document:
    stated = {key: value for key, value in entry.items() if key not in ("library", "file")}
    for key in ("library", "file"):
        if not isinstance(entry.get(key, ""), str):
            raise InputError(f"{key}: expected a name as text, got {quoted(entry[key])}")
    try:
        library = read_materials(folder / entry["file"] if "file" in entry else None)
    except InputError as error:
        raise InputError(f"file: {error}") from None
    name = library_name(entry["library"], library)
    if name is None:
        raise InputError(
            f"library: there is no material {quoted(entry['library'])}; known are {', '.join(library)}"
        )
    numbers = dict(library[name].numbers)
    if "hardness" in stated or "hardness_factor" in stated:
        numbers.pop("hardness", None)
        numbers.pop("hardness_factor", None)
    return {**numbers, **stated}
