"""Numbers as a table of a report shows them; a dash where there is none, a word where it is infinite."""

from __future__ import annotations

import math
import re

from asperity.units import format_quantity

#: What stands in place of a number that is infinite.
INFINITE = "infinite"


def quantity(value: float | None, unit: str, digits: int = 4) -> str:
    """A quantity with its unit; a dash where there is none.

    Parameters
    ----------
    value : float or None
        The value [SI].
    unit : str
        The unit to show; ``"1"`` for a number, ``"um"`` is shown as µm.
    digits : int, optional
        Significant digits.

    Returns
    -------
    str
        Number and unit.
    """
    if value is None or math.isnan(value):
        return "–"
    return INFINITE if math.isinf(value) else format_quantity(value, re.sub(r"\bum\b", "µm", unit), digits)


def number(value: float | None, factor: float = 1.0) -> str:
    """A number times a factor with four digits, without its unit; a dash where there is none."""
    return "–" if value is None else quantity(value * factor, "1")


def percent(value: float | None) -> str:
    """A share in percent, number and sign; a dash where there is none."""
    if value is None:
        return "–"
    shown = number(value, 100.0)
    return shown if shown == INFINITE else f"{shown} %"
