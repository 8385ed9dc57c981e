"""Numbers as every view writes them: four significant digits, a dash where there is none."""

from __future__ import annotations

import math
import re

from asperity.units import format_quantity

#: What stands in place of a number that does not exist, and of one that is infinite.
NONE, INFINITE = "–", "infinite"


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A quantity [SI] with the unit to show, ``um`` as µm, in so many significant digits.

    A dash where there is none.
    """
    if value is None or math.isnan(value):
        return NONE
    if math.isinf(value):
        return INFINITE if value > 0.0 else f"-{INFINITE}"
    return format_quantity(value, re.sub(r"\bum\b", "µm", unit), digits)


def number(value: float | None, factor: float = 1.0, digits: int = 4) -> str:
    """A number times a factor, without its unit; a dash where there is none."""
    return NONE if value is None else quantity(value * factor, "1", digits)


def percent(value: float | None) -> str:
    """A share in percent, number and sign; a dash where there is none."""
    shown = number(value, 100.0)
    return shown if shown in (NONE, INFINITE) else f"{shown} %"


def number_in(value: float | None, unit: str) -> str:
    """A quantity [SI] in the unit to show, without that unit."""
    shown = quantity(value, unit)
    return shown if shown in (NONE, INFINITE) else shown.partition(" ")[0]


def unit_words(unit: str) -> str:
    """A unit as people write it, such as N·m and µm; nothing for a ratio."""
    if unit == "1":
        return ""
    return re.sub(r"\bum\b", "µm", unit).replace("*", "·").replace("^2", "²").replace("^3", "³")


def words(name: str) -> str:
    """A name of a part, contact or key in words."""
    return name.replace("_", " ")


def sentence(text: str) -> str:
    """A sentence that begins with a capital and ends with a full stop."""
    text = text[:1].upper() + text[1:]
    return text if text.endswith((".", ":", "?")) else f"{text}."
