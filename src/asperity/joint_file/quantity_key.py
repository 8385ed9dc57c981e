"""One numeric key of a joint file: what it measures, its range, how its text and its tolerance are read."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from asperity.errors import InputError
from asperity.types import Document
from asperity.unit_table import Dimension
from asperity.units import format_quantity, from_si, parse_quantity, parse_tolerance

if TYPE_CHECKING:
    from pydantic import GetCoreSchemaHandler, GetJsonSchemaHandler
    from pydantic_core import CoreSchema


@dataclass(frozen=True, slots=True)
class Quantity:
    """A number of a joint file in SI units, and its text as the file writes it.

    ``tolerance`` is what stands behind ``+-``, in SI units, 0 where the file states none; ``distribution``, how it
    scatters within it, None where the file does not say.
    """

    value: float
    tolerance: float
    text: str
    distribution: Distribution | None = None


@dataclass(frozen=True)
class Key:
    """What a numeric key measures and the range it may have; used as an annotation of :class:`Quantity` fields.

    ``lower`` and ``upper`` are in ``unit``, which displays have too; ``open_lower`` and ``open_upper`` leave out the
    bound itself. ``integer``: only whole numbers are allowed. ``exact``: it has no tolerance, because somebody decides
    it. ``example``: what messages quote; if empty, the example of the dimension. ``reason``: why nothing below the
    range is possible; ``hint``: what a number outside of it may be.
    """

    dimension: Dimension
    lower: float
    upper: float
    unit: str = "1"
    open_lower: bool = False
    open_upper: bool = False
    integer: bool = False
    exact: bool = False
    example: str = ""
    reason: str = ""
    hint: str = ""

    @property
    def typical(self) -> str:
        """A value that the key could have, as text."""
        return self.example or self.dimension.example

    @property
    def allowed(self) -> str:
        """The range in words."""
        low = format_quantity(self._si(self.lower), self.unit)
        high = format_quantity(self._si(self.upper), self.unit)
        kind = "a whole number, " if self.integer else ""
        above, below = "above" if self.open_lower else "at least", "below" if self.open_upper else "at most"
        return f"{kind}{above} {low} and {below} {high}"

    def _si(self, value: float) -> float:
        return value / from_si(1.0, self.unit)

    def admits(self, value_si: float) -> bool:
        """Whether a value in SI units is inside the range."""
        value = from_si(value_si, self.unit)
        # a bound that was converted there and back is still the bound
        low_side = value > self.lower or (
            not self.open_lower and math.isclose(value, self.lower, rel_tol=1e-12)
        )
        high_side = value < self.upper or (
            not self.open_upper and math.isclose(value, self.upper, rel_tol=1e-12)
        )
        return low_side and high_side and not (self.integer and value_si != round(value_si))

    def check(self, value_si: float) -> None:
        """Raise an ``InputError`` with the value [SI] and the allowed range unless the value is inside it."""
        if not self.admits(value_si):
            why = f": {self.reason}" if self.reason and from_si(value_si, self.unit) < self.lower else ""
            why += f"; {self.hint}" if self.hint else ""
            raise InputError(
                f"{format_quantity(value_si, self.unit)} is not allowed; it must be {self.allowed}{why}"
            )

    def read(self, written: object) -> Quantity:
        """The value and the tolerance of a text with a unit, or of a number if dimensionless, in SI units.

        An ``InputError`` is raised if it is no such quantity, or outside the allowed range.
        """
        if isinstance(written, str) and any(sign in written for sign in ("±", "+-", "+/-", "+ -", "+ /")):
            text, distribution = split_distribution(written)
            value, tolerance = parse_tolerance(text, self.dimension, example=self.typical)
        else:
            value = parse_quantity(written, self.dimension, example=self.typical)
            tolerance, distribution = 0.0, None
        self.check(value)
        if self.integer and tolerance != 0.0:
            raise InputError(f"a whole number has no tolerance, got '{written}'")
        if self.exact and tolerance != 0.0:
            raise InputError(f"what is required has no tolerance, got '{written}'")
        return Quantity(value=value, tolerance=tolerance, text=str(written), distribution=distribution)

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Tell pydantic to read a value with :meth:`read`."""
        from pydantic_core import core_schema

        return core_schema.no_info_plain_validator_function(self.read)

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> Document:
        """Describe the key to editors: text with a unit, or a plain number if dimensionless."""
        text = {"type": "string", "examples": [self.typical]}
        if self.dimension is not Dimension.DIMENSIONLESS:
            return text
        bounds = {
            "exclusiveMinimum" if self.open_lower else "minimum": self.lower,
            "exclusiveMaximum" if self.open_upper else "maximum": self.upper,
        }
        number = {"type": "integer" if self.integer else "number", **bounds}
        return number if self.integer else {"anyOf": [number, text]}


@dataclass(frozen=True, slots=True)
class Entered:
    """Annotation of a field that keeps a number as the file writes it: only the file states it, no study varies it.

    ``key``: what it measures, its range and its unit for display.
    """

    key: Key


#: What can be written after the comma of a tolerance.
FORMS = "'uniform', 'triangular' or 'normal K sigma' (e.g. 'normal 2 sigma': the tolerance is two standard deviations)"
_MOST_SIGMAS = 10.0


@dataclass(frozen=True, slots=True)
class Distribution:
    """A symmetric distribution about a value v with a tolerance t: "uniform" or "triangular" in v ± t, or "normal".

    ``sigmas``: how many standard deviations make t if it is normal; 0 otherwise.
    """

    kind: Literal["uniform", "triangular", "normal"]
    sigmas: float

    def __str__(self) -> str:
        return f"normal {self.sigmas:g} sigma" if self.kind == "normal" else self.kind

    def standard_deviation(self, tolerance: float) -> float:
        """Standard deviation of a number with this tolerance."""
        shrink = {"uniform": 3.0**0.5, "triangular": 6.0**0.5, "normal": self.sigmas}[self.kind]
        return tolerance / shrink


def parse_distribution(text: str) -> Distribution:
    """The distribution of a text ``uniform``, ``triangular`` or ``normal K sigma``; an ``InputError`` for any other.

    Examples
    --------
    >>> parse_distribution("normal 2 sigma")
    Distribution(kind='normal', sigmas=2.0)
    """
    words = " ".join(text.lower().split())
    if words == "uniform":
        return Distribution("uniform", 0.0)
    if words == "triangular":
        return Distribution("triangular", 0.0)
    match = re.fullmatch(r"normal (\d+(?:\.\d*)?|\.\d+) ?(?:sigmas?|σ)", words)
    if match is None:
        raise InputError(f"a tolerance can be distributed as {FORMS}, got '{text}'")
    sigmas = float(match[1])
    if not 0.0 < sigmas <= _MOST_SIGMAS:
        raise InputError(
            f"a tolerance is above 0 and at most {_MOST_SIGMAS:g} standard deviations, got '{text}'"
        )
    return Distribution("normal", sigmas)


def split_distribution(written: str) -> tuple[str, Distribution | None]:
    """Split the text of a tolerance from the distribution behind its comma."""
    text, comma, tail = written.rpartition(",")
    signs = ("±", "+-", "+/-", "+ -", "+ /")
    if not comma or not any(sign in text for sign in signs) or re.match(r"\s*\d", tail):
        return written, None
    return text, parse_distribution(tail)
