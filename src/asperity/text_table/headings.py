"""Headings of columns: their names, and the unit that each states for itself."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass

from asperity.text_table.layout import COMMENTS, Dialect, Line
from asperity.units import unit_exponents

#: Lines above a table in which its headings are looked for.
_LINES = 6
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
#: A word that is a number, also with a unit behind it: ``0.8``, ``0.8mm``, but not ``Z1``.
_OWN_NUMBER = re.compile(rf"{_NUMBER}[^\W\d_]*[%°]?")
_BRACKETS = re.compile(r"[\[({<]([^\[\](){}<>]*)[\])}>]")
#: A unit at the end of a heading without brackets: ``z/nm``, ``height in um``, ``height_um``, ``height um``.
_AT_END = re.compile(r"(?P<name>.*?)(?:\s*/\s*|\s+in\s+|[\s_]+|^)(?P<unit>[^\s_/]+)")
#: Words at the end of a heading that are units elsewhere.
_NO_UNITS = frozenset(("a", "bar", "d", "g", "h", "in", "min", "s", "t", "T", "K", "N", "J", "W"))
_WORD = re.compile(r"[^\W\d_]")
#: A factor behind a name: ``Z x10``, ``Z*1000``.
_TIMES = re.compile(r"[^\W\d_]\s*[*×·]\s*10*\b|\s[xX]\s?10+\b")
_SEPARATORS = (";", ",", "\t", None)


@dataclass(frozen=True)
class Heading:
    """The heading of a column: its ``name`` without the unit, and the ``unit`` as it is written, None without one.

    ``text`` is what the file says, for messages; ``in_brackets``: whether the unit stands in brackets.
    """

    name: str = ""
    unit: str | None = None
    text: str = ""
    in_brackets: bool = False

    def __str__(self) -> str:
        return f"'{self.text}'" if self.text else "without a heading"


def column_headings(
    above: Sequence[Line], dialect: Dialect, width: int
) -> tuple[tuple[Heading, ...], tuple[Line, ...]]:
    """The heading of each column from the lines above a table, and the lines that it was read from.

    A line is one of headings if it has a field for each column and no numbers of its own: a line with numbers states
    a value, and its unit is that of the value; above one column so does a line with a sign
    between two parts, and only the last line of words, with a row of units below it, is the heading. Units in brackets
    come before others, later lines before earlier ones.
    """
    columns: list[list[Heading]] = [[] for _ in range(width)]
    used: list[Line] = []
    for line in above[-_LINES:]:
        fields = heading_fields(line.text, dialect, width)
        if fields is not None and width == 1 and re.search(r"[=:,;\t]", line.text.strip()):
            continue  # of one column the heading has no value
        if fields is None:
            continue
        row_of_units = _is_row_of_units(fields)
        if width == 1 and not row_of_units:
            columns, used = [[]], []
        used.append(line)
        for column, field in zip(columns, fields, strict=True):
            column.append(_unit_alone(field) if row_of_units else heading_of(field))
    return tuple(map(_together, columns)), tuple(used)


def heading_fields(text: str, dialect: Dialect, width: int) -> list[str] | None:
    """The fields of a line of headings, one for each column; None where a line is none."""
    plain = _uncommented(text)
    for separator in dict.fromkeys((dialect.separator, *_SEPARATORS)):
        if separator == "," and dialect.comma and dialect.separator == ";":
            continue
        divided = [Dialect(separator, dialect.comma).fields(plain)]
        if separator is None and width > 1:
            # names of several words, under each other, and units that follow a name after a blank
            divided += [re.split(split, plain.strip()) for split in (r"\s{2,}", r"\s+(?![\[({<])")]
        for fields in divided:
            while len(fields) > width and not fields[-1]:
                fields = fields[:-1]
            if len(fields) != width or not any(_WORD.search(field) for field in fields):
                continue
            states_units = _is_row_of_units(fields) or _all_state_units(fields)
            if separator is None and dialect.separator is not None and not states_units:
                continue  # words of a sentence
            return None if any(map(_has_number, fields)) and not _all_state_units(fields) else fields
    return None


def _uncommented(text: str) -> str:
    """A line without the sign of a comment before it."""
    plain = text.strip(" ")
    for sign in COMMENTS:
        plain = plain.removeprefix(sign)
    return plain.strip(" ")


def _has_number(field: str) -> bool:
    """Whether a field has a number of its own, outside brackets: ``0.8 mm``, but not ``Z1`` or ``z [0.1 nm]``."""
    return any(_OWN_NUMBER.fullmatch(word) for word in re.split(r"[\s=:,;]+", _BRACKETS.sub(" ", field)))


def _all_state_units(fields: Sequence[str]) -> bool:
    """Whether several columns have their units in brackets, so that numbers are parts of names: ``Profile 2 [um]``."""
    stated = [any(is_unit(unit) for unit in _BRACKETS.findall(field)) for field in fields]
    bare = any(re.fullmatch(rf"\s*{_NUMBER}\s*", _BRACKETS.sub("", field)) for field in fields)
    return len(fields) > 1 and all(stated) and not bare


def _is_row_of_units(fields: Sequence[str]) -> bool:
    """Whether all fields of a line are units, or strokes."""
    units = [field for field in fields if re.fullmatch(r"\W*", field) is None]
    return bool(units) and all(is_unit(field) for field in units)


def _unit_alone(field: str) -> Heading:
    """The heading of a field in a row of units."""
    return Heading("", field if is_unit(field) else None, field, in_brackets=True)


def heading_of(field: str) -> Heading:
    """The heading that a text states: its name, and the unit in brackets or at its end."""
    inside = [unit.strip() for unit in _BRACKETS.findall(field)]
    name = " ".join(_BRACKETS.sub(" ", field).split())
    if _TIMES.search(name):  # numbers so many times those in the unit, or the unit so many times as large
        return Heading(name, field, field, in_brackets=True)
    stated = next((unit for unit in inside if is_unit(unit)), None)
    if stated is not None:
        return Heading(name, stated, field, in_brackets=True)
    ended = _AT_END.fullmatch(name)
    if ended is not None and ended["name"] and ended["unit"] not in _NO_UNITS and is_unit(ended["unit"]):
        return Heading(ended["name"].strip(), ended["unit"], field)
    unread = next((unit for unit in inside if _may_be_unit(unit)), None)
    return Heading(name, unread, field, in_brackets=unread is not None)


def _together(stated: Sequence[Heading]) -> Heading:
    """One heading from those of several lines: the last name, and the last unit in brackets or else the last one."""
    name = next((heading for heading in reversed(stated) if heading.name), Heading())
    units = [heading for heading in reversed(stated) if heading.unit is not None]
    unit = next((heading for heading in units if heading.in_brackets), units[0] if units else Heading())
    text = name.text if unit.text in ("", name.text) else " ".join(filter(None, (name.text, unit.text)))
    return Heading(name.name, unit.unit, text, unit.in_brackets)


#: Units of numbers that are no length, beside those of the table of units, in lower case.
_ELECTRICAL = re.compile(
    r"[pnuµmkM]?V|[pnuµmk]A|[kM]?(Ohm|Ω)|(milli|micro)?[Vv]olts?|dB|a\.?u\.?|arb(\.|itrary)?( units?)?"
)
#: What numbers are called that are counted: a unit of them may be stated as the height of one.
_COUNTED = re.compile(
    r"counts?|cts|digits?|lsb|bits?|px|pix|pixels?|points?|samples?|grey|gray|levels?|-|1|", re.I
)
_FACTOR = re.compile(
    r"(?:[x×*·]\s*)?(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?:\s*(?:\^|\*\*)\s*[-+]?\d+|[⁻⁺]?[⁰¹²³⁴-⁹]+)?)"
    r"\s*[x×*·]?\s*(?P<unit>[^\W\d].*|°.*|%)"
)
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺", "0123456789-+")


def factor_and_unit(text: str) -> tuple[float, str]:
    """The number before a unit, 1 without one, and the unit: ``0.1 nm``, ``x10 nm``, ``1e-9 m``, ``10^-6 m``."""
    found = _FACTOR.fullmatch(text.strip())
    if found is None:
        return 1.0, _spelled(text.strip())
    number = re.sub(r"([⁻⁺]?[⁰¹²³⁴-⁹]+)$", lambda m: "^" + m[1].translate(_RAISED), found["number"])
    base, _, power = number.replace("**", "^").replace(" ", "").partition("^")
    try:
        return (float(base) ** int(power) if power else float(base)), _spelled(found["unit"].strip())
    except OverflowError:
        return 1.0, text.strip()


def is_scale(text: str) -> bool:
    """Whether a number before a unit scales it: a power of ten, or one behind a sign of multiplication.

    ``0.1 nm``, ``1e-9 m``, ``x 2.5 nm``; but ``0.8 mm`` is a length, such as a cut-off.
    """
    factor, _ = factor_and_unit(text)
    if re.match(r"10[eE]", text.strip()):  # ten times a power of ten, or that power
        return False
    power = math.log10(factor) if factor > 0.0 else math.nan
    return (
        abs(power - round(power)) < 1e-9
        if math.isfinite(power) and text.strip()[:1] not in "x×*·"
        else factor > 0.0
    )


def _spelled(unit: str) -> str:
    """A unit whose name in words is written in small letters, as the table of units has it."""
    lower = unit.lower()
    return (
        lower
        if len(unit) > 3 and unit_exponents(unit) is None and unit_exponents(lower) is not None
        else unit
    )


def is_unit(text: str) -> bool:
    """Whether a text is a unit, of whatever it may be, with or without a number before it."""
    _, unit = factor_and_unit(text)
    if not unit or is_counted(unit):
        return False
    return unit_exponents(unit) is not None or _ELECTRICAL.fullmatch(unit) is not None


def is_counted(text: str) -> bool:
    """Whether a unit says that numbers are counted: ``counts``, ``px``."""
    return _COUNTED.fullmatch(text.strip()) is not None


def _may_be_unit(text: str) -> bool:
    """Whether what stands in brackets looks like a unit that is not known, or one that is not understood."""
    if is_counted(text):
        return False
    if text == "A":  # ampere, or an ångström in ASCII
        return True
    if re.search(r"\d", text) and _WORD.search(text):
        return True
    words = re.findall(r"[^\W\d_]+", text)
    return any(is_unit(word) or unit_exponents(word.lower()) is not None for word in words)
