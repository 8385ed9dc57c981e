"""A joint file written back with some of its numbers replaced: comments, order and layout stay as they are."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Mapping
from typing import Any

import tomlkit
from pydantic import BaseModel
from tomlkit.items import AoT, Table

from asperity.errors import one_line
from asperity.joint_file.fluid_entries import FluidEntry
from asperity.joint_file.model import Case
from asperity.joint_file.old_comments import without_old_comments
from asperity.joint_file.open_radius import radii_of
from asperity.joint_file.part_names import paths_of_track, type_of
from asperity.joint_file.quantity_key import Key, Quantity
from asperity.joint_file.reader import model_of_type, parse_case
from asperity.joint_file.section import keys_by_path, leaves
from asperity.joint_file.sections import BoundaryPoint
from asperity.joint_file.si_tables import (
    DEPTH,
    MEASURED,
    PARTNER_DEPTH,
    AnyCase,
    NumericKey,
    change_targets,
    counterparts,
    key_at,
    numbers,
    numeric_keys,
    replace_values,
    si_values,
    table_structure,
)
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import from_si, parse_quantity

#: What a change of units and back costs a number: two units in the last place.
_UNIT_ROUNDING = 5e-16

#: Two numbers are the same if they differ by less: conversion to a unit and back costs a few units in the last place.
_ROUNDING = 1e-12


#: What earlier designs said at the head of the file: it holds for their numbers only.
_EARLIER_VERDICTS = re.compile(
    r"\A((?:#:schema.*\n)?)"
    r"(?:# Designed by asperity from .*\n# (?:(?:All|NOT all) limits .*are met|No limit ).*\n)+"
)


def exact_text(value_si: float, key: Key) -> str:
    """A quantity as text that reads back as the same number, to the rounding of a change of units."""
    texts = [
        f"{from_si(value_si, key.unit):.{digits}g} {key.unit}".removesuffix(" 1") for digits in (15, 16, 17)
    ]
    read = (parse_quantity(text, key.dimension) for text in texts)
    same = (math.isclose(number, value_si, rel_tol=_UNIT_ROUNDING, abs_tol=0.0) for number in read)
    return next((text for text, alike in zip(texts, same, strict=True) if alike), texts[-1])


def joint_file_text(
    case: AnyCase, changes: Mapping[str, float], *, comment: str, words: Mapping[str, str] | None = None
) -> str:
    """The TOML of a joint file with its comments, where some numbers are replaced: dotted path → new value [SI].

    A number that has a tolerance keeps it, with its distribution. Comments that state a number which is no longer there
    are left out. An entry of a library file of the user's is replaced
    by its numbers, because its path would be wrong in another folder, and where numbers change, an Rz by the range of
    Ra that it was read as. ``comment``: lines for the head of the file, without the comment sign. ``words``: choices
    and materials by their paths, which are for the caller to check.
    """
    stated, values = numeric_keys(case), si_values(case)
    kind = type_of(values)
    written = {
        track_path: _written(key_at(path, kind), value, stated.get(track_path))
        for path, value in changes.items()
        for track_path in paths_of_track(values, path)
    }
    wanted = replace_values(values, changes)
    plain = _texts(case) | _surface_of(case)
    original = case.text or tomlkit.dumps(plain)
    if changes or comment:
        original = _EARLIER_VERDICTS.sub(r"\1", original)
    text = _edited(original, case, written, words or {})
    # a layout that cannot be edited in place: the same content without comments
    if not words and not _says(text, wanted):
        text = _edited(tomlkit.dumps(plain), case, written, {})
    if case.text:
        text = without_old_comments(text, original)
    return _with_head(text, comment)


def _with_head(text: str, comment: str) -> str:
    # names of files stand there, and TOML allows no control characters in a comment
    head = "".join(f"# {one_line(line)}".rstrip() + "\n" for line in comment.splitlines())
    if not text.startswith("#:schema"):  # editors look for this in the first line
        return head + text
    first, _, rest = text.partition("\n")
    return f"{first}\n{head}{rest}"


def _written(key: Key, value: float, stated: NumericKey | None) -> float | str:
    """A new value as it stands in the file."""
    tolerance = stated.tolerance if stated else 0.0
    if key.dimension is Dimension.DIMENSIONLESS and not tolerance:
        return int(value) if key.integer else float(exact_text(value, key))
    text = exact_text(value, key)
    if stated is None or not tolerance:
        return text
    distribution = f", {stated.distribution}" if stated.distribution else ""
    return f"{text} +- {exact_text(tolerance, key)}{distribution}"


def _edited(text: str, case: AnyCase, written: Mapping[str, float | str], words: Mapping[str, str]) -> str:
    document = tomlkit.parse(text)
    for name, entry in document.get("materials", {}).items():
        if "file" in entry:
            for key in ("library", "file"):
                entry.remove(key)
            for key, stated in _texts(case.materials[name]).items():
                _put(entry, key, stated)
    for name, oil in (case.fluids or {}).items():
        if any(curve.file for curve in oil.traction_curve or ()):
            _put(document["fluids"][name], "traction_curve", _inline_curves(oil))
    surfaces, texts = document["surface"], _texts(case.surface)
    for path, name in _surface_of(case).get("surface", {}).items():
        surfaces[path], texts = name, {}
    for table, stated in [
        (surfaces, texts),
        *((surfaces[name], surface) for name, surface in texts.items() if isinstance(surface, dict)),
    ]:
        for depth in (DEPTH, PARTNER_DEPTH):
            if depth not in stated:
                continue
            average = depth.replace(DEPTH, "roughness_average")
            if not written:
                table.pop(average, None)
                continue
            for key in (average, "cut_off"):
                _put(table, key, stated[key])
            del table[depth]
    radius = case.open_radius
    if radius is not None and any(path.startswith("drive.") for path in written):
        _set(
            document,
            ("drive", radius.name),
            exact_text(radius.radius, key_at(f"drive.{radius.name}", case.type)),
        )
    set_texts(document, written)
    set_words(document, words)
    return tomlkit.dumps(document)


def _inline_curves(oil: FluidEntry) -> list[Document]:
    """Curves of an oil with their points, in place of the names of their files, and with their conditions."""
    units = {"pressure": "Pa", "temperature": "degC", "speed": "m/s"}
    return [
        {"points": [list(point) for point in curve.points or ()]}
        | {
            name: f"{getattr(curve, name)!r} {unit}"
            for name, unit in units.items()
            if getattr(curve, name) is not None
        }
        for curve in oil.traction_curve or ()
    ]


def _surface_of(case: Case) -> Document:
    """The section of a surface that files have measured, with their complete names: any folder can have the text."""
    files = case.measured.files if case.measured else ()
    if not files:
        return {}
    if len(files) > 1:
        return {"surface": {"measurement": list(files)}}
    # of one body is what a document is that does not say otherwise
    pair = {"measurement_of": "pair"} if case.measured.measured.of == "pair" else {}
    return {"surface": {"measurement": files[0], **pair}}


def with_measurement(text: str, name: str, *, comment: str = "") -> str:
    """The TOML of a joint file with the measured surface of a file of this name in place of its surfaces."""
    document, table = tomlkit.parse(text), tomlkit.table()
    if comment:
        table.add(tomlkit.comment(one_line(comment)))
    table.add("measurement", name)
    del document["surface"]
    document.add("surface", table)
    return tomlkit.dumps(document)


def set_texts(document: Any, written: Mapping[str, float | str]) -> None:
    """Change values in the tables of a joint file before they are checked."""
    for path, value in written.items():
        if entered_key_at(path, type_of(document)) is None:
            key_at(path, type_of(document))
        section = path.split(".")[0]
        if section not in document and section != "materials":
            document[section] = _new_section(section, type_of(document))
        for steps in change_targets(document, path, split=_split):
            _set(document, steps, value)


def set_words(document: Any, written: Mapping[str, str]) -> None:
    """Change words in the tables of a joint file before they are checked, such as ``drive.ring_support``."""
    for path, word in written.items():
        section, *place, name = path.split(".")
        if not word:
            leave_out(document, path)
            continue
        if section not in document:
            document[section] = _new_section(section, type_of(document))
        table = document[section]
        for step in place:  # of a list, counted from 1
            table = table[int(step) - 1]
        _put(table, name, word)


def leave_out(document: Any, path: str) -> None:
    """Remove a key from the tables of a joint file; one that is not there is left alone."""
    *above, name = path.split(".")
    table = document
    for step in above:
        table = table[int(step) - 1] if isinstance(table, list) else table.get(step, {})
    if name in table:
        del table[name]


def _new_section(section: str, kind: str) -> Any:
    """A section that the file left out, in which the numbers that it needs are 0 where they may be."""
    table = tomlkit.table()
    annotation = model_of_type(kind).model_fields[section].annotation
    (model,) = [member for member in annotation.__args__ if issubclass(member, BaseModel)]  # type: ignore[union-attr]
    for name, field in model.model_fields.items():
        path = f"{section}.{name}"
        if (
            field.is_required()
            and path in keys_by_path(model_of_type(kind))
            and key_at(path, kind).admits(0.0)
        ):
            table[name] = _written(key_at(path, kind), 0.0, None)
    return table


def _split(entry: Any, contacts: tuple[str, ...]) -> Any:
    """An entry for all contacts as a table with an entry for each."""
    plain = entry.unwrap() if hasattr(entry, "unwrap") else entry
    if plain == 0.0:  # only the skew may be absent
        plain = "0 mrad"
    table = tomlkit.table(is_super_table=True) if isinstance(plain, dict) else tomlkit.inline_table()
    for name in contacts:
        table[name] = tomlkit.item(plain)
    return table


def _set(document: Any, steps: tuple[str, ...], value: float | str) -> None:
    table = document
    for index, step in enumerate(steps[:-1]):
        if isinstance(table, list):  # the loads of the duty, counted from 1
            table = table[int(step) - 1]
            continue
        if step not in table:
            new: Any = tomlkit.inline_table() if steps[0] == "form" else tomlkit.table()
            # a body names a material of the library, which the file now changes
            if steps[index - 1] == "materials":
                new["library"] = step
            table[step] = new
        table = table[step]
    if (
        steps[0] == "drive"
        and steps[-1] in radii_of(model_of_type(type_of(document)))
        and steps[-1] not in table
    ):
        table.pop("ratio", None)  # which leaves this radius open
    if isinstance(table, list):  # the friction at a speed, [speed, coefficient]
        table[list(BoundaryPoint.model_fields).index(steps[-1])] = value
        return
    _put(table, steps[-1], value)
    for other in counterparts(steps[-1]):
        if other in table:
            del table[other]


def _put(table: Any, name: str, value: Any) -> None:
    """Write a key: in its place, in that of the key that it replaces, or after the last one of its section."""
    plain = [key for key, item in table.items() if not isinstance(item, Table | AoT)]
    if name in table or not plain or not isinstance(table, Table):
        table[name] = value
        return
    before = next((other for other in counterparts(name) if other in plain), plain[-1])
    table.value._insert_after(before, name, tomlkit.item(value))  # no public way for a table of a document
    dict.__setitem__(table, name, table.value[name])


def _says(text: str, wanted: Any) -> bool:
    """Whether a file contains these numbers, and nothing else; what is measured of its surfaces is not read again."""
    edited, measured = (
        si_values(parse_case(text, source="the edited joint file", measured=False)),
        MEASURED in wanted,
    )
    used = set(wanted["bodies"].values()) & set(wanted["materials"])
    for tables in (edited, wanted):
        tables["materials"] = {name: entry for name, entry in tables["materials"].items() if name in used}
        tables["surface"] = {} if measured else tables["surface"]
    return table_structure(edited) == table_structure(wanted) and all(
        math.isclose(one, other, rel_tol=_ROUNDING)
        for one, other in zip(numbers(edited), numbers(wanted), strict=True)
    )


def _texts(node: Any) -> Any:
    """The content of a file as nested tables of numbers and texts with units."""
    if isinstance(node, Quantity):
        plain = node.text.replace("_", "").replace(".", "").isdigit()
        return (int(node.text) if node.text.isdigit() else float(node.text)) if plain else node.text
    if isinstance(node, BaseModel):
        return {name: _texts(value) for name, value in node if value is not None}
    if isinstance(node, dict):
        return {name: _texts(value) for name, value in node.items()}
    if isinstance(node, tuple):
        return [_texts(value) for value in node]
    return node


@functools.lru_cache(maxsize=1024)
def entered_key_at(path: str, kind: str) -> Key | None:
    """What a dotted path means where such a number stands; None where the path is that of another key."""
    known, parts = keys_by_path(model_of_type(kind), numbers="entered"), path.split(".")
    generic = [".".join([*parts[:i], "*", *parts[i + 1 :]]) for i in range(1, len(parts) - 1)]
    return next((known[pattern] for pattern in (path, *generic) if pattern in known), None)


def entered_values(case: Case) -> dict[str, tuple[Key, Quantity]]:
    """Every such number that a joint file states."""
    kind = case.type
    return {
        path: (key, key.read(written))
        for path, written in leaves(case, (str, float))
        if (key := entered_key_at(path, kind)) is not None
    }
