"""What a study varies: numeric keys of the joint file, as axes with values in SI units."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from asperity.errors import InputError
from asperity.joint_file.part_names import paths_of_track
from asperity.joint_file.si_tables import (
    AnyCase,
    check_values,
    contact_in,
    counterparts,
    key_at,
    replace_values,
    si_values,
)
from asperity.types import Document
from asperity.units import format_quantity, parse_quantity

Scale = Literal["linear", "log"]

#: Values of one axis, which are all held in memory.
MOST_VALUES = 10_000_000

_FORM = "KEY=start:stop:count or KEY=start:stop:count:log, e.g. load.output_torque=0 N*m:5 N*m:11"


@dataclass(frozen=True)
class Axis:
    """One axis of a sweep: even steps of a number of the joint file, or of its logarithm, from start to stop [SI]."""

    path: str
    start: float
    stop: float
    count: int
    scale: Scale

    @property
    def values(self) -> np.ndarray:
        """All values in SI units, shape (count,); first and last are exactly start and stop."""
        if self.scale == "log":
            return np.geomspace(self.start, self.stop, self.count)
        return np.linspace(self.start, self.stop, self.count)

    def as_dict(self) -> Document:
        """The axis as plain data."""
        return {
            "key": self.path,
            "start": self.start,
            "stop": self.stop,
            "count": self.count,
            "scale": self.scale,
        }


@dataclass(frozen=True)
class ListedAxis:
    """One axis of a sweep: any values of a number of the joint file [SI]."""

    path: str
    listed: Sequence[float]

    @property
    def count(self) -> int:
        """Number of values."""
        return len(self.listed)

    @property
    def values(self) -> np.ndarray:
        """All values in SI units, shape (count,)."""
        return np.asarray(self.listed, dtype=float)


SweepAxis = Axis | ListedAxis


def axis_from_dict(plain: Document) -> SweepAxis:
    """An axis from plain data, as :func:`dataclasses.asdict` makes them."""
    return ListedAxis(**plain) if "listed" in plain else Axis(**plain)


def parse_axis(text: str, *, kind: str | None = None) -> Axis:
    """Read an axis, in SI units, from ``KEY=start:stop:count`` or ``KEY=start:stop:count:log`` with units.

    ``kind`` is the type of the drive that must have this number, None for any. An ``InputError`` if the text has
    another form, a joint file has no such number, or a value is of the wrong unit or outside its range.

    Examples
    --------
    >>> parse_axis("load.output_torque=0 N*m:5 N*m:3").values.tolist()
    [0.0, 2.5, 5.0]
    """
    path, equals, rest = (part.strip() for part in text.partition("="))
    parts = [part.strip() for part in rest.split(":")]
    if not equals or not path or len(parts) not in (3, 4):
        raise InputError(f"cannot read the axis '{text}'; write {_FORM}")
    if len(parts) == 4 and parts[3] != "log":
        raise InputError(f"{path}: the only spacing besides even steps is 'log', got '{parts[3]}'")
    key = key_at(path, kind)
    ends = []
    for which, written in zip(("start", "stop"), parts, strict=False):
        try:
            ends.append(parse_quantity(written, key.dimension))
        except InputError as error:
            raise InputError(f"{path}: the {which} of the axis: {error}") from None
    try:
        count = int(parts[2])
    except ValueError:
        raise InputError(
            f"{path}: the count must be a whole number of at least 1, got '{parts[2]}'"
        ) from None
    axis = Axis(path, ends[0], ends[1], count, "log" if len(parts) == 4 else "linear")
    check_axis(axis)
    return axis


def check_axis(axis: SweepAxis) -> None:
    """Raise unless an axis makes sense."""
    unit = key_at(axis.path).unit
    if axis.count < 1:
        raise InputError(f"{axis.path}: the count must be at least 1, got {axis.count}")
    if axis.count > MOST_VALUES:
        raise InputError(
            f"{axis.path}: the count must be at most {MOST_VALUES}, got {axis.count}; choose fewer steps"
        )
    if isinstance(axis, ListedAxis):
        twice = sorted(value for value, times in Counter(axis.listed).items() if times > 1)
        if twice:
            raise InputError(
                f"{axis.path}: the value {format_quantity(twice[0], unit, 6)} is listed twice; list it once"
            )
        check_values({axis.path: axis.values})
        return
    if axis.count == 1 and axis.start != axis.stop:
        raise InputError(
            f"{axis.path}: one value cannot start and stop at different ones; the count must be above 1"
        )
    if axis.count > 1 and axis.start == axis.stop:
        raise InputError(
            f"{axis.path}: {axis.count} values from {format_quantity(axis.start, unit)} to the same value; "
            "start and stop must differ"
        )
    if axis.scale == "log" and not (axis.start > 0.0 and axis.stop > 0.0):
        raise InputError(
            f"{axis.path}: logarithmic steps need values above 0, got {format_quantity(axis.start, unit)} to "
            f"{format_quantity(axis.stop, unit)}"
        )
    values = axis.values
    if axis.count > 1 and np.any(np.diff(values) == 0.0):
        raise InputError(
            f"{axis.path}: {axis.count} values do not fit between start and stop in double precision"
        )
    check_values({axis.path: values})


def check_axes(case: AnyCase, axes: Sequence[SweepAxis]) -> None:
    """Raise an ``InputError`` unless there are axes, all of different numbers that the file's joint has."""
    if not axes:
        raise InputError(f"a sweep needs at least one axis: {_FORM}", options=["over"])
    for axis in axes:
        check_axis(axis)
    check_paths(case, [axis.path for axis in axes])


def check_paths(case: AnyCase, paths: Sequence[str]) -> None:
    """Raise unless these numbers of a joint file can be varied independently."""
    values = si_values(case)
    for path in paths:
        replace_values(values, {path: 1.0})  # raises if this joint has no such number
    refuse_twice(case, paths, named="axes")


def refuse_twice(case: AnyCase, paths: Sequence[str], *, named: str) -> None:
    """Raise where two paths stand for one number of a joint file, or for two of which a file states one.

    ``named``: what the paths are, in the plural.
    """
    values = si_values(case)
    seen: list[tuple[str, str, str | None]] = []
    for path in paths:
        generic, contact = _generic(paths_of_track(values, path)[0])
        section, _, name = generic.rpartition(".")
        alike = {generic, *(f"{section}.{other}" for other in counterparts(name))}
        for other, other_generic, other_contact in seen:
            if other_generic in alike and (
                contact == other_contact or contact is None or other_contact is None
            ):
                both = path if other == path else f"{other} and {path}"
                raise InputError(f"{both}: two {named} for the same number; vary it once")
        seen.append((path, generic, contact))


def _generic(path: str) -> tuple[str, str | None]:
    """A path without its contact, and the contact."""
    contact = contact_in(path)
    return ".".join(part for part in path.split(".") if part != contact), contact


def long_name(path: str) -> str:
    """A dotted path in words, for labels.

    Examples
    --------
    >>> long_name("drive.contact_length.sp"), long_name("materials.steel.youngs_modulus")
    ('contact length, sp', "Young's modulus, steel")
    """
    section, *rest = path.split(".")
    generic, contact = _generic(path)
    named = section in ("materials", "fluids")
    words = path.split(".")[-1] if named else generic.split(".")[-1]
    words = words.replace("youngs", "Young's").replace("poisson", "Poisson's").replace("_", " ")
    if section in ("bearings", "compliance"):
        return f"{words} ({section})"
    whose = rest[0] if named else contact
    return f"{words}, {whose}" if whose else words
