"""The numbers of a joint file in SI units, addressed by dotted paths such as ``load.output_torque``.

Files of one structure, which is their tables apart from the numbers, share one compiled program.
"""

from __future__ import annotations

import functools
import hashlib
import itertools
import json
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from pydantic import BaseModel

from asperity.drive.types import DEFAULT_TYPE
from asperity.engine.arrays import is_of_jax
from asperity.errors import InputError, nearest
from asperity.joint_file.case_types import CASES
from asperity.joint_file.fluid_entries import CURVES, FluidEntry
from asperity.joint_file.law_keys import RIVALS
from asperity.joint_file.model import Case
from asperity.joint_file.part_names import HOUSING, contacts_of, paths_of_track, type_of
from asperity.joint_file.quantity_key import Distribution, Key, Quantity
from asperity.joint_file.section import Section, keys_by_path, leaves
from asperity.types import Document

#: Nested tables like those of the file; leaves are SI numbers (or arrays of them) and names.
Values = Document
#: The Rz of a surface, and of its partner, texts beside the Ra that the reader makes of them.
DEPTH, PARTNER_DEPTH = "mean_roughness_depth", "partner_mean_roughness_depth"
#: Key of tables whose surfaces are measured: the document of the measurement as text, which is none of their numbers.
MEASURED = "measured_surface"
#: A joint file of any type of drive.
AnyCase = Case

_PAIRS = (
    ("hardness", "hardness_factor"),
    ("preload", "interference"),
    ("sun_speed", "output_speed"),
    ("fractal_roughness", "roughness_average"),
)
#: Keys of a surface that stand alone, and all others.
_ALONE = ("rms_height", "decay_length")
_BESIDE = (
    *("finish", "fractal_dimension", "fractal_roughness", "frequency_ratio", "roughness_average"),
    *(DEPTH, "partner_roughness_average", PARTNER_DEPTH, "cut_off"),
)
_COUNTERPARTS: dict[str, tuple[str, ...]] = {
    **{first: (second,) for first, second in _PAIRS},
    **{second: (first,) for first, second in _PAIRS},
    "fractal_roughness": (
        "roughness_average",
        DEPTH,
        "partner_roughness_average",
        PARTNER_DEPTH,
        "cut_off",
        *_ALONE,
    ),
    "roughness_average": ("fractal_roughness", DEPTH, *_ALONE),
    DEPTH: ("fractal_roughness", "roughness_average", *_ALONE),
    "rms_height": (*_BESIDE, "decay_length"),
    "decay_length": (*_BESIDE, "rms_height"),
    PARTNER_DEPTH: ("partner_roughness_average",),
    "partner_roughness_average": (PARTNER_DEPTH,),
    **{key: tuple(sorted(rivals)) for key, rivals in RIVALS.items()},
}
_NAMED = ("materials", "fluids", "duty", "form", "branch", "roller", "contact")
_STATED_PER_CONTACT = ("drive.contact_length", "load.friction_coefficient", "rolling.skew", "surface")
_STATED_PER_BODY = ("wear.coefficient",)


@dataclass(frozen=True, slots=True)
class NumericKey:
    """One number that a joint file states, by its dotted path, e.g. ``drive.contact_length.sp``; SI units.

    The tolerance is 0 where the file states none; ``distribution`` is how it scatters within it, None where the file
    does not say; ``key``, what it measures, its range and its unit for display.
    """

    path: str
    value: float
    tolerance: float
    key: Key
    distribution: Distribution | None


def si_values(case: Section) -> Values:
    """The nested tables of a joint file with every quantity as an SI number.

    What the file leaves out is absent, and so is an Rz, whose Ra is there. Of a measured surface they have what each
    contact feels under the torque of the file and, at :data:`MEASURED`, the measurement.
    """
    tables: Values = _plain(case)
    if isinstance(case, Case) and case.measured is not None:
        tables[MEASURED] = case.measured.text
    return tables


def without_measurement(values: Values) -> Values:
    """The tables as a joint file may state them, without the document of a measured surface."""
    return {name: value for name, value in values.items() if name != MEASURED}


def stated_tables(case: Case) -> Values:
    """The tables of :func:`si_values` as a file states them: a measured surface by its source and a digest of it.

    So are curves of traction.
    """
    tables = without_measurement(si_values(case))
    if case.measured is not None:
        digest = hashlib.sha256(case.measured.text.encode()).hexdigest()
        tables["surface"] = {"measurement": f"{case.measured.measured.source} ({digest[:12]})"}
    for oil in tables.get("fluids", {}).values():
        if CURVES in oil:
            oil[CURVES] = f"curves ({hashlib.sha256(oil[CURVES].encode()).hexdigest()[:12]})"
    return tables


def _plain(node: Any) -> Any:
    if isinstance(node, Quantity):
        return node.value
    if isinstance(node, BaseModel):
        plain = {
            name: _plain(value)
            for name, value in node
            if value is not None and name not in (DEPTH, PARTNER_DEPTH)
        }
        return node.in_tables(plain) if isinstance(node, FluidEntry) else plain
    if isinstance(node, dict):
        return {name: _plain(value) for name, value in node.items()}
    if isinstance(node, tuple):
        return {str(index): _plain(value) for index, value in enumerate(node, start=1)}
    return node


def key_at(path: str, kind: str | None = None) -> Key:
    """What a dotted path of a joint file measures, such as ``materials.steel.youngs_modulus``: dimension, range, unit.

    ``kind`` is the type of the drive, any of them if None. An ``InputError`` is raised if a joint file has no such
    number.
    """
    parts = path.split(".")
    if parts[0] == "tilt":
        raise InputError(
            f"{path}: [tilt] is used by `asperity loads` only, where no study varies it; write it into the file"
        )
    known = _keys(kind)
    one = [".".join([*parts[:i], "*", *parts[i + 1 :]]) for i in range(1, len(parts))]
    if parts[0] == "branch" and len(parts) == 4:  # sector and roller of type planar
        one.append(f"branch.*.{parts[2]}.*")
    if parts[0] == "form" and len(parts) == 4:  # number of waves
        one.append(f"form.*.{parts[2]}.*")
    if parts[0] == "fluids" and len(parts) == 5:  # row of a table of traction
        one.append(f"fluids.*.{parts[2]}.*.{parts[4]}")
    for generic in (path, *one):
        if generic in known and parts[0] != "*":
            return known[generic]
    whose = "a joint file" if kind in (None, DEFAULT_TYPE) else f"the joint file of a drive of type {kind}"
    named = parts[0] in _NAMED and len(parts) > 2
    if parts[0] == "surface" and parts[-1] in (DEPTH, PARTNER_DEPTH):
        average = ".".join([*parts[:-1], parts[-1].replace(DEPTH, "roughness_average")])
        raise InputError(f"{path}: Rz is read as a range of Ra; vary '{average}' instead")
    near = nearest(".".join([parts[0], "*", *parts[2:]]) if named else path, known)
    raise InputError(f"{whose} has no number '{path}'{near}")


@functools.cache
def _keys(kind: str | None) -> dict[str, Key]:
    """Numeric keys of joint files, with ``*`` for the names of materials, entries and parts."""
    if kind is not None:
        return keys_by_path(CASES[kind])
    return {path: key for name in reversed(CASES) for path, key in _keys(name).items()}


def numeric_keys(case: AnyCase) -> dict[str, NumericKey]:
    """Every number that a joint file states: dotted path → the number, in the order of its sections."""
    return {
        path: NumericKey(
            path, quantity.value, quantity.tolerance, key_at(path, case.type), quantity.distribution
        )
        for path, quantity in leaves(case, Quantity)
    }


def varied_keys(case: AnyCase) -> dict[str, NumericKey]:
    """The numbers of a joint file that may vary: without those that follow from a measured surface."""
    keys = numeric_keys(case)
    curves = [name for name, oil in (case.fluids or {}).items() if oil.traction_curve]
    fixed = tuple(f"fluids.{name}.rig." for name in curves) + (("surface.",) if case.measured else ())
    return {path: number for path, number in keys.items() if not path.startswith(fixed)}


def replace_values(values: Values, changes: Mapping[str, Any]) -> Values:
    """Nested tables of :func:`si_values` with some numbers replaced; the given ones are left alone.

    ``changes``: dotted path → SI number or array. A path to one contact (``surface.sp.fractal_dimension``) splits an
    entry that stood for all; a path without a contact (``surface.fractal_dimension``) sets all of them. The radius of a
    track of a drive of type ``planar`` is that of all contacts on it. An ``InputError`` is raised if a joint file has
    no such number, or the material is not in this one.
    """
    tables: Values = _copied(values)
    for path, value in changes.items():
        key_at(path, type_of(tables))
        if MEASURED in tables and path.startswith("surface."):
            raise InputError(
                f"{path}: follows from the measured surface of the joint, what each contact feels of it; give the "
                "surface by numbers in place of surface.measurement to change them"
            )
        if path.startswith("fluids.") and path.split(".")[2] == "rig":
            _refuse_rig_of_curves(tables, path)
        for track_path in paths_of_track(tables, path):
            for steps in change_targets(tables, track_path):
                _set(tables, steps, value)
    return tables


def _refuse_rig_of_curves(tables: Values, path: str) -> None:
    """Refuse another rig for curves from which its discs are taken off when they are read."""
    name = path.split(".")[1]
    if CURVES in tables.get("fluids", {}).get(name, {}):
        raise InputError(
            f"{path}: the discs of the rig are taken off the curves when the file is read; write another rig into it"
        )


def _copied(node: Any) -> Any:
    """Copies of the tables; the leaves, perhaps large arrays, are shared."""
    return {name: _copied(below) for name, below in node.items()} if isinstance(node, dict) else node


def _for_each_contact(entry: Any, contacts: tuple[str, ...]) -> Values:
    return {name: _copied(entry) for name in contacts}


def change_targets(
    tables: Any, path: str, *, split: Callable[[Any, tuple[str, ...]], Any] = _for_each_contact
) -> list[tuple[str, ...]]:
    """Where a change of a number goes in nested tables."""
    for place in (*_STATED_PER_CONTACT, *_STATED_PER_BODY):
        if path == place or path.startswith(f"{place}."):
            break
    else:
        return [tuple(path.split("."))]
    head = tuple(place.split("."))
    rest = tuple(path.split(".")[len(head) :])
    parent = tables
    for step in head[:-1]:
        parent = parent.setdefault(step, {})
    entry = parent.get(head[-1], 0.0)  # the skew, and wear, may be absent
    noun, names = (
        ("contact", contacts_of(tables)) if place in _STATED_PER_CONTACT else ("body", _worn(tables))
    )
    for_each = isinstance(entry, dict) and names[0] in entry
    if contact_in(path) is not None:
        if rest[0] not in names:
            raise InputError(
                f"{path}: this drive has no {noun} '{rest[0]}'"
                f"{nearest(rest[0], names) or '; it has ' + ', '.join(names)}"
            )
        if not for_each:
            parent[head[-1]] = split(entry, names)
        return [head + rest]
    return [(*head, name, *rest) for name in names] if for_each else [head + rest]


def _worn(tables: Mapping[str, Any]) -> tuple[str, ...]:
    """Names of the bodies that wear: those of [bodies] without the housing."""
    return tuple(name for name in tables["bodies"] if name != HOUSING)


def contact_in(path: str) -> str | None:
    """The contact, or body, that a dotted path names, if the number may be stated for each.

    None where the path stands for all of them, or for a number that has none.
    """
    for place in (*_STATED_PER_CONTACT, *_STATED_PER_BODY):
        rest = path.removeprefix(f"{place}.").split(".")
        if path.startswith(f"{place}.") and len(rest) == (2 if place == "surface" else 1):
            return rest[0]
    return None


def _set(tables: Values, steps: tuple[str, ...], value: Any) -> None:
    table = tables
    for step in steps[:-1]:
        if steps[0] in ("duty", "form", "branch", "roller", "contact") and step not in table:
            raise InputError(f"{'.'.join(steps)}: the file has no section {step} in [[{steps[0]}]]")
        if steps[0] == "materials" and step not in table:
            raise InputError(f"{'.'.join(steps)}: there is no material '{step}'{nearest(step, table)}")
        if steps[0] == "fluids" and step not in table:
            raise InputError(
                f"{'.'.join(steps)}: the file has no section [{'.'.join(steps[:-1])}]; give one with this number"
            )
        table = table.setdefault(step, {})
    for other in counterparts(steps[-1]):
        table.pop(other, None)
    table[steps[-1]] = value


def counterparts(name: str) -> tuple[str, ...]:
    """The keys that a key replaces, because a file states exactly one of them; those of Ra go with it."""
    return _COUNTERPARTS.get(name, ())


def check_values(changes: Mapping[str, Any]) -> None:
    """Raise an ``InputError`` with the key, the value and its range unless every number [SI] is inside that of its key.

    Abstract arrays inside ``jit`` or ``grad`` have no values and are not looked at.
    """
    for path, value in changes.items():
        key = key_at(path)
        if _is_abstract(value):
            continue
        numbers = np.asarray(value, dtype=float).reshape(-1)
        if numbers.size == 0:
            raise InputError(f"{path}: an empty list of values")
        broken = numbers[numbers != np.round(numbers)][:1] if key.integer else numbers[:0]
        for number in (numbers.min(), numbers.max(), *broken):  # nan propagates through both
            try:
                key.check(float(number))
            except InputError as error:
                raise InputError(f"{path}: {error}") from None


def _is_abstract(value: Any) -> bool:
    return is_of_jax(value) and isinstance(value, sys.modules["jax"].core.Tracer)


Numbers = tuple[Any, ...]


def numbers(values: Values) -> Numbers:
    """The leaves of the tables of a joint file that are numbers, in SI units, by sorted names."""
    return tuple(value for value in _leaves(values) if not isinstance(value, str))


def _leaves(node: Any) -> Iterator[Any]:
    if isinstance(node, dict):
        for name in sorted(node):
            yield from _leaves(node[name])
    else:
        yield node


def with_numbers(values: Values, replaced: Iterable[Any]) -> Values:
    """The same tables in SI units with other numbers or arrays, in the order of :func:`numbers`."""
    return _filled(values, iter(replaced))


def _filled(node: Any, replaced: Iterator[Any]) -> Any:
    if isinstance(node, dict):
        return {name: _filled(node[name], replaced) for name in sorted(node)}
    return node if isinstance(node, str) else next(replaced)


def table_structure(values: Values) -> str:
    """The tables of a joint file as JSON with 1.0 for every number, to recognise files of the same structure."""
    return json.dumps(with_numbers(without_measurement(values), itertools.repeat(1.0)))
