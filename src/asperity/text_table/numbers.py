"""Fields of a table: numbers with a decimal point or comma, and the marks of a missing value."""

from __future__ import annotations

import math
import re

_DIGITS = r"[-+]?(?:\d+{sign}?\d*|{sign}\d+)(?:[eE][-+]?\d+)?"
_POINT, _COMMA = (re.compile(_DIGITS.format(sign=sign), re.ASCII) for sign in (r"\.", ","))
#: Marks of a missing value that are words, in lower case.
_WORDS = frozenset(
    (
        *("nan", "n/a", "na", "#n/a", "#na", "#nv", "#n/v", "1.#qnan", "-1.#ind", "1.#ind"),
        *("bad", "nodata", "no_data", "missing", "void", "null", "none", "invalid"),
    )
)
#: Marks of a missing value that are strokes or stars: they also underline headings.
_STROKES = re.compile(r"-{1,3}|\*+|\?+|")


def number_in(field: str, *, comma: bool) -> float | None:
    """The number of a field with a decimal point, or with a decimal ``comma``; None where it is none."""
    if (_COMMA if comma else _POINT).fullmatch(field) is None:
        return None
    return float(field.replace(",", ".")) if comma else float(field)


def is_missing_word(field: str) -> bool:
    """Whether a field says in a word that its value is missing: ``NaN``, ``Bad``, ``#N/A`` and the like."""
    return field.lower() in _WORDS


def is_missing(field: str) -> bool:
    """Whether a field says that its value is missing, by a word, by strokes or stars, or by being empty."""
    return _STROKES.fullmatch(field) is not None or is_missing_word(field)


def field_value(field: str, *, comma: bool) -> float | None:
    """The number of a field, nan where it is missing; None where it is neither."""
    number = number_in(field, comma=comma)
    return math.nan if number is None and is_missing(field) else number
