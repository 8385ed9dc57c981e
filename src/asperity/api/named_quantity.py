"""A number with its name and unit, as a script or a notebook gets it."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from asperity.errors import InputError, quoted
from asperity.joint.pin_bound import bounded
from asperity.types import Number
from asperity.unit_table import Dimension
from asperity.units import from_si, parse_quantity
from asperity.views.numbers import quantity


@dataclass(frozen=True, repr=False)
class NamedQuantity:
    """A number, or one number for each contact or clearance, with its name and unit.

    Parameters
    ----------
    name : str
        Its name in files and datasets.
    label : str
        What it is, in words.
    si : float or ndarray
        Value in SI units, radians for angles.
    dimension : Dimension
        What it measures.
    unit : str
        Unit in which it is shown.
    rows : tuple of str
        Names of the numbers, such as ``("sp", "pwr", …)``; empty for a single number.
    level : str or None
        Model of the stiffness that it belongs to: published, series_with_bulk or assembly.
    categories : tuple of str
        What its values number, from 0, where it is not a quantity.
    bound : str
        What it is if more than a value: an upper bound.
    """

    name: str
    label: str
    si: Number
    dimension: Dimension
    unit: str
    rows: tuple[str, ...] = ()
    level: str | None = None
    categories: tuple[str, ...] = ()
    bound: str = ""

    @property
    def said(self) -> str:
        """What it is, in a few words, and what bounds it."""
        return bounded(self.label, self.bound)

    @property
    def si_unit(self) -> str:
        """SI unit; ``"1"`` for a ratio."""
        return self.dimension.si_unit

    @property
    def value(self) -> Number | str | None:
        """Value in :attr:`unit`: a float, an array over :attr:`rows`, or the name of a category."""
        if self.categories:
            return self.categories[int(self.si)] if np.isfinite(self.si) else None
        return _converted(self.si, self.unit)

    def to(self, unit: str) -> Number:
        """Value in another unit.

        Parameters
        ----------
        unit : str
            For example ``"N*m/arcmin"``.

        Returns
        -------
        float or ndarray
            The value in that unit.

        Raises
        ------
        InputError
            If the unit is unknown or measures something else.
        """
        if unit != "1":
            parse_quantity(f"1 {unit}", self.dimension)
        elif self.dimension is not Dimension.DIMENSIONLESS:
            raise InputError(
                f"{self.name} is {self.dimension.label}; '1' is no unit of it, '{self.si_unit}' is"
            )
        return _converted(self.si, unit)

    def __getitem__(self, row: str) -> NamedQuantity:
        """The number of one contact or clearance."""
        if row not in self.rows:
            known = f"it has {', '.join(self.rows)}" if self.rows else "it is a single number"
            raise InputError(f"{self.name} has no row {quoted(row)}; {known}")
        return dataclasses.replace(
            self,
            name=f"{self.name}_{row}",
            label=f"{self.label}, {row.replace('_', ' ')}",
            si=float(self.si[self.rows.index(row)]),
            rows=(),
        )

    def singles(self) -> list[NamedQuantity]:
        """Its single numbers: one for each row."""
        return [self[row] for row in self.rows] if self.rows else [self]

    def __str__(self) -> str:
        if self.categories:
            return "–" if self.value is None else str(self.value)
        if not self.rows:
            return quantity(self.si, self.unit)
        return ", ".join(f"{row} {quantity(x, self.unit)}" for row, x in zip(self.rows, self.si, strict=True))

    def __repr__(self) -> str:
        return f"{self.said}: {self}"


def columns_of(numbers: Iterable[NamedQuantity]) -> dict[str, list[object]]:
    """Value, unit, SI value and SI unit of numbers, as columns of a data frame."""
    quantities = list(numbers)
    return {name: [getattr(q, name) for q in quantities] for name in ("value", "unit", "si", "si_unit")}


def _converted(si: Number, unit: str) -> Number:
    if np.ndim(si) == 0:
        return from_si(float(si), unit)
    return np.array([from_si(float(number), unit) for number in si])


def si_number(given: object, dimension: Dimension, *, name: str) -> float:
    """SI value of a number that a user gives: a text with its unit, or a quantity; bare where it is dimensionless.

    An ``InputError`` with the name if it has no unit, or measures something else.
    """
    if isinstance(given, NamedQuantity):
        if given.dimension is not dimension or given.rows or given.categories:
            what = "several numbers" if given.rows else given.dimension.label
            raise InputError(f"{name}: expected {dimension.label}, got {what}, {given.label}")
        return float(given.si)
    if isinstance(given, np.generic):
        given = given.item()
    try:
        return parse_quantity(given, dimension)
    except InputError as error:
        raise InputError(f"{name}: {error}") from None
