"""Where the table of a text file stands, how its rows are divided, and its numbers."""

from __future__ import annotations

import collections
import contextlib
import csv
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.text_table.numbers import field_value, is_missing, is_missing_word, number_in

#: Signs between the fields of a row, in the order in which they are tried; None is white space.
SEPARATORS = ("\t", ";", ",", None)
#: Beginnings of a line that is a comment.
COMMENTS = ("#", "%", "//", "!")
#: Lines and characters of a file from which its layout is told.
_SAMPLE, _SAMPLED_CHARACTERS = 200, 200_000
#: Rows that a table begins with, one after the other.
_FIRST_ROWS = 3
_SHOWN = 40
#: Columns from which a table without names is a map.
_FEWEST_OF_MAP = 4


@dataclass(frozen=True)
class Line:
    """A line of a file with its number, from 1."""

    number: int
    text: str

    def __str__(self) -> str:
        return f"line {self.number}, '{shortened(self.text)}'"


@dataclass(frozen=True)
class Dialect:
    """How a row is divided: the ``separator``, None for white space, and whether the decimal sign is a ``comma``."""

    separator: str | None
    comma: bool

    def fields(self, line: str) -> list[str]:
        """The fields of a line, without blanks and complete quotation marks around them."""
        found = line.split(self.separator)
        if '"' in line and self.separator is not None:
            with contextlib.suppress(csv.Error, StopIteration):  # marks that are not complete stay
                found = next(csv.reader([line], delimiter=self.separator, skipinitialspace=True, strict=True))
        elif '"' in line:
            found = [field[1:-1] if re.fullmatch(r'".*"', field) else field for field in found]
        return [field.strip() for field in found]

    def value(self, field: str) -> float | None:
        """The number of a field, nan where it is missing; None where it is neither."""
        return field_value(field, comma=self.comma)

    def number(self, field: str) -> float | None:
        """The number of a field; None where it is none."""
        return number_in(field, comma=self.comma)


@dataclass(frozen=True)
class Layout:
    """The table of a file and what stands around it.

    ``values`` of shape (rows, columns), nan where missing; ``line_numbers`` of the rows; ``corner``: what stands in the
    first field of the first row if it is no number, otherwise empty; ``above`` and ``below``: the lines around the
    table that are not blank; ``inside``: comments between its rows; ``first_gap``: number of the first blank line
    between rows, 0 without one.
    """

    dialect: Dialect
    values: NDArray[np.float64]
    line_numbers: NDArray[np.int64]
    corner: str
    above: tuple[Line, ...]
    below: tuple[Line, ...]
    inside: tuple[Line, ...]
    first_gap: int


def shortened(text: str) -> str:
    """A text in one line of at most forty characters."""
    plain = " ".join(text.split())
    return plain if len(plain) <= _SHOWN else f"{plain[: _SHOWN - 3]}..."


def table_layout(text: str, *, source: str, decimal: str, fewest_rows: int = _FIRST_ROWS) -> Layout:
    """The table of a text from a file called ``source``; ``decimal`` is the decimal sign, auto, point or comma.

    An ``InputError`` names the line and what was read there, if there is no table, or two, or a row is none.
    """
    lines = _split_lines(text)
    dialect, width = _dialect(lines, decimal, source)
    first = _first_row(lines, dialect, width, fewest_rows)
    if first is None:
        raise InputError(f"{source} holds no table of numbers")
    last = next(i for i in range(len(lines) - 1, -1, -1) if _is_row(lines[i], dialect, width))
    begin, end = _with_missing_rows(lines, first, last, dialect, width)
    missing, first, last = {*range(begin, first), *range(last + 1, end + 1)}, begin, end
    above, below = (_not_blank(lines, *ends) for ends in ((0, first), (last + 1, len(lines))))
    for line in (*_first_rows_broken(above, dialect, width), *below):
        _refuse_broken_row(line, dialect, width, source)
    values = _plain_numbers(lines[first : last + 1], dialect, width)
    if values is not None:  # every line is a row of numbers
        numbers = np.arange(first + 1, last + 2, dtype=np.int64)
        return Layout(dialect, values, numbers, "", above, below, (), 0)
    skipped = [i for i in range(first, last + 1) if i not in missing and _is_skipped(lines[i])]
    inside = tuple(Line(i + 1, lines[i]) for i in skipped if lines[i].strip())
    places = sorted({*range(first, last + 1)}.difference(skipped))
    rows = [lines[i] for i in places]
    values, corner, numbers = _plain_numbers(rows, dialect, width), "", np.array(places, dtype=np.int64) + 1
    if values is None:
        values, corner = _numbers(rows, places, dialect, width, source)
    gaps = np.flatnonzero(np.diff(places) > 1)
    has_gap = bool(gaps.size) and not _is_double_spaced(places)
    blank = [places[i] + 1 for i in gaps.tolist() if not lines[places[i] + 1].strip()]
    first_gap = blank[0] + 1 if has_gap and blank else 0
    return Layout(dialect, values, numbers, corner, above, below, inside, first_gap)


def _with_missing_rows(
    lines: Sequence[str], first: int, last: int, dialect: Dialect, width: int
) -> tuple[int, int]:
    """First and last line of a table with the rows beside it that are missing as a whole, as around a round aperture.

    Those of a map, with strokes, stars or nothing in exactly its fields. Strokes under words are a ruling.
    """

    def is_missing_row(line: str) -> bool:
        fields = dialect.fields(line)
        return len(fields) == width and all(map(is_missing, fields))

    def grown(start: int, end: int, step: int) -> int:
        while start + step != end and is_missing_row(lines[start + step]):
            start += step
        return start

    if width < _FEWEST_OF_MAP or dialect.separator is None:
        return first, last
    begin, end = grown(first, -1, -1), grown(last, len(lines), 1)
    if begin > 0 and len(_trimmed(dialect.fields(lines[begin - 1]), width)) == width:
        begin = first  # below headings
    return begin, end


def _split_lines(text: str) -> list[str]:
    """Lines at any line end, with a minus for its typographic sign, and marks of a missing value in one word."""
    plain = text.replace("−", "-")
    if re.search("[nN][oO] [dD][aA][tT][aA]", plain):
        plain = re.sub("no data", "NoData", plain, flags=re.IGNORECASE)
    return re.split(r"\r\n|\n|\r", plain)


def _is_skipped(line: str) -> bool:
    """Whether a line between rows is no row by its nature: blank, or a comment."""
    plain = line.strip()
    return not plain or (plain.startswith(COMMENTS) and not is_missing_word(re.split(r"[\s,;]", plain)[0]))


def _is_double_spaced(numbers: Sequence[int]) -> bool:
    """Whether a blank line follows every row, as where line ends were doubled."""
    return len(numbers) > _FIRST_ROWS and bool(np.all(np.diff(numbers) == 2))


def _not_blank(lines: Sequence[str], start: int, stop: int) -> tuple[Line, ...]:
    return tuple(Line(i + 1, lines[i]) for i in range(start, stop) if lines[i].strip())


def _trimmed(fields: list[str], width: int) -> list[str]:
    """Fields without the empty ones that stand beyond the columns of a table."""
    while len(fields) > width and not fields[-1]:
        fields = fields[:-1]
    return fields


def _is_row(line: str, dialect: Dialect, width: int) -> bool:
    """Whether a line has the fields of the table: numbers or missing values, or numbers for the most part."""
    if not line or line.isspace():
        return False
    fields = _trimmed(dialect.fields(line), width)
    if len(fields) != width:
        return False
    numbers = sum(dialect.number(field) is not None for field in fields)
    if 2 * numbers > width:
        return True
    complete = all(dialect.value(field) is not None for field in fields)
    return complete and (numbers > 0 or all(is_missing_word(field) for field in fields))


def _first_row(lines: Sequence[str], dialect: Dialect, width: int, fewest: int) -> int | None:
    """The line where a table begins: rows follow at once, as many as a table must have; None where none does."""
    for start, line in enumerate(lines):
        if _is_skipped(line) or not _is_row(line, dialect, width):
            continue
        following: list[str] = []
        for later in lines[start : start + 4 * fewest]:
            if not _is_skipped(later):
                following.append(later)
        block = following[:fewest]
        if len(block) == fewest and all(_is_row(later, dialect, width) for later in block):
            return start
    return None


def _candidates(decimal: str, source: str, *, quoted: bool) -> Iterator[Dialect]:
    """The layouts of a row in the order of preference; commas between decimal commas only of ``quoted`` fields."""
    if decimal not in ("auto", "point", "comma"):
        raise InputError(f"{source}: the decimal sign must be 'auto', 'point' or 'comma', not '{decimal}'")
    for comma in (False, True):
        if decimal == ("point" if comma else "comma"):
            continue
        for separator in SEPARATORS:
            if not (separator == "," and comma) or quoted:
                yield Dialect(separator, comma)


def _sample(lines: Sequence[str]) -> list[str]:
    """Lines from everywhere in a file, not blank, none a comment."""
    stride = max(1, len(lines) // (4 * _SAMPLE))
    pairs = (lines[i : i + min(2, stride)] for i in range(0, len(lines), stride))  # also of doubled line ends
    filled = [line for pair in pairs for line in pair if not _is_skipped(line)]
    if not filled:
        return []
    length = max(1, sum(map(len, filled)) // len(filled))
    count = max(8, min(_SAMPLE, _SAMPLED_CHARACTERS // length))
    return filled[:: max(1, len(filled) // count)]


def _dialect(lines: Sequence[str], decimal: str, source: str) -> tuple[Dialect, int]:
    """How most lines of a file are divided into numbers, and into how many."""
    sample = _sample(lines)
    if decimal == "auto":
        bare = [line.strip() for line in sample]
        pairs = [line for line in bare if re.fullmatch(r"[-+]?\d+,\d+", line)]
        if pairs and 2 * len(pairs) >= len(bare) and not _has_two_headings(lines):
            raise InputError(
                f"{source}: '{pairs[-1]}' may be one number with a decimal comma or two whole numbers; "
                "choose 'comma' or 'point'",
                options=["decimal"],
            )
    best, width, most = None, 0, 0
    for dialect in _candidates(
        decimal, source, quoted=any(re.search(r'"[^"]*\d,\d', line) for line in sample)
    ):
        widths: dict[int, list[int]] = collections.defaultdict(list)
        for line in sample:
            fields = dialect.fields(line)
            if all(dialect.value(field) is not None for field in fields) and any(
                dialect.number(field) is not None for field in fields
            ):
                widths[len(fields)].append(len(_trimmed(fields, 0)))
        for full, trimmed in widths.items():
            if len(trimmed) > most:
                best, most = dialect, len(trimmed)
                # the last columns of a map that are empty everywhere are missing heights, unless longer lines pad them
                padded = max(len(_trimmed(dialect.fields(line), 0)) for line in sample) > max(trimmed)
                beyond = full - max(trimmed)
                ragged = beyond > 1 or (
                    beyond == 1 and len(set(trimmed)) > 1
                )  # one separator more ends every row
                is_missing_part = max(trimmed) >= _FEWEST_OF_MAP and ragged and not padded
                width = full if is_missing_part else max(trimmed)
    if best is None:
        raise InputError(f"{source} holds no table of numbers ({len(lines)} lines were looked at)")
    _refuse_blank_after_some_commas(sample, best, source)
    if decimal == "auto":
        _refuse_thousands(sample, best, width, source)
    return best, width


def _has_two_headings(lines: Sequence[str]) -> bool:
    """Whether the last line before a number has two fields of words between which there is a comma."""
    words = ""
    for line in lines:
        if re.match(r"\s*[-+]?[\d.]", line):
            break
        words = line if line.strip() else words
    fields = words.split(",")
    return len(fields) == 2 and all(re.search(r"[^\W\d]", field) for field in fields)


def _refuse_blank_after_some_commas(sample: Sequence[str], dialect: Dialect, source: str) -> None:
    """Whole numbers between commas, of which some are followed by a blank, may be decimals: ``0,5, 1,25``."""
    for line in sample:
        fields = dialect.fields(line) if dialect.separator == "," and "." not in line else []
        if len(fields) > 1 and re.search(r"\d,\d", line) and re.search(r"\d,\s+[-+\d]", line):
            raise InputError(
                f"{source}: '{shortened(line)}' has commas with and without a blank; if they are decimal commas, "
                "put semicolons between the numbers"
            )


def _refuse_thousands(sample: Sequence[str], dialect: Dialect, width: int, source: str) -> None:
    """Signs that may stand between thousands: ``734`` and ``1.106`` in one column, and never ``0.5`` or ``1.1``."""
    rows = [fields for line in sample if len(fields := _trimmed(dialect.fields(line), width)) == width]
    sign, word = (",", "comma") if dialect.comma else (".", "point")
    for column in zip(*rows, strict=True):
        numbers = [field for field in column if dialect.number(field) is not None]
        signed = [field for field in numbers if sign in field]
        grouped = all(re.fullmatch(rf"[-+]?[1-9]\d{{0,2}}(?:\{sign}\d{{3}})", field) for field in signed)
        whole = [field for field in numbers if re.fullmatch(r"[-+]?\d{1,3}", field)]
        if signed and grouped and len(whole) == len(numbers) - len(signed) and any(map(int, whole)):
            raise InputError(
                f"{source}: '{signed[0]}' beside '{next(field for field in whole if int(field))}' may be a whole "
                f"number with a sign between its thousands, or have a decimal {word}; choose '{word}' if it has, or "
                "save the file without signs between thousands",
                options=["decimal"],
            )


def _plain_numbers(rows: list[str], dialect: Dialect, width: int) -> NDArray[np.float64] | None:
    """The numbers of rows that hold nothing but numbers; None where one has to be looked at by itself."""
    if dialect.comma and (dialect.separator == "," or any("." in row for row in rows)):
        return None
    if dialect.separator is not None and len(dialect.fields(rows[0])) > width:
        rows = [row.rstrip(dialect.separator + " \t") for row in rows]
    if dialect.comma:
        rows = [row.replace(",", ".") for row in rows]
    try:
        values = np.loadtxt(rows, delimiter=dialect.separator, ndmin=2, comments=None)
    except ValueError:
        return None
    return values if values.shape == (len(rows), width) else None


def _numbers(
    rows: Sequence[str], places: Sequence[int], dialect: Dialect, width: int, source: str
) -> tuple[NDArray[np.float64], str]:
    """The numbers of rows, nan where missing, and what stands in the first field of the first row if it is text."""
    values = np.full((len(rows), width), np.nan)
    corner = ""
    for i, (place, row) in enumerate(zip(places, rows, strict=True)):
        fields = _trimmed(dialect.fields(row), width)
        line = Line(place + 1, row)
        if len(fields) != width:
            _refuse_width(line, fields, rows, i, dialect, width, source)
        for j, field in enumerate(fields):
            value = dialect.value(field)
            if value is None and i == j == 0 and width > 1 and _ends_in_numbers(fields, dialect):
                corner = field
            elif value is None:
                _refuse_field(line, field, rows, i, dialect, width, source)
            else:
                values[i, j] = value
    return values, corner


def _ends_in_numbers(fields: Sequence[str], dialect: Dialect) -> bool:
    """Whether all fields but the first are numbers."""
    return all(dialect.number(field) is not None for field in fields[1:])


def _refuse_width(
    line: Line,
    fields: Sequence[str],
    rows: Sequence[str],
    index: int,
    dialect: Dialect,
    width: int,
    source: str,
) -> None:
    """Raise because of a line between rows that has not their number of fields."""
    if not any(dialect.number(field) is not None for field in fields):
        _refuse_second_table(line, rows, index, dialect, width, source)
    short = " (heights that are wrapped, several to a line, must be saved one to a line)" if width > 3 else ""
    raise InputError(
        f"{source}: {line} has {len(fields)} column{'' if len(fields) == 1 else 's'}, the table has {width}{short}; "
        "correct or remove this line"
    )


def _refuse_field(
    line: Line, field: str, rows: Sequence[str], index: int, dialect: Dialect, width: int, source: str
) -> None:
    """Raise because of a field that is no number."""
    other = number_in(field.replace("." if dialect.comma else ",", ""), comma=dialect.comma)
    if other is not None and ("." if dialect.comma else ",") in field:
        signs = ("commas", "point") if dialect.comma else ("points", "comma")
        raise InputError(
            f"{source}: line {line.number} holds '{shortened(field)}', a {signs[1]} in a table of decimal {signs[0]}: "
            "one file with two decimal signs, or with signs between thousands, is not read; save it with one"
        )
    if not _is_row(rows[index], dialect, width):
        _refuse_second_table(line, rows, index, dialect, width, source)
    raise InputError(
        f"{source}: '{shortened(field)}' in line {line.number} is not a number; a value that is missing is written nan"
    )


def _refuse_second_table(
    line: Line, rows: Sequence[str], index: int, dialect: Dialect, width: int, source: str
) -> None:
    """Raise because words stand between rows, where they do: the table goes on behind them."""
    if any(dialect.number(field) is not None for field in dialect.fields(rows[index])):
        return
    raise InputError(
        f"{source}: {line} stands between rows of numbers: the file holds two tables, or the line does not belong "
        "there; save one table a file"
    )


def _first_rows_broken(above: Sequence[Line], dialect: Dialect, width: int) -> tuple[Line, ...]:
    """The line directly above a table if it has its fields, so that it may be a row of it that is broken."""
    return tuple(line for line in above[-1:] if len(_trimmed(dialect.fields(line.text), width)) == width)


def _refuse_broken_row(line: Line, dialect: Dialect, width: int, source: str) -> None:
    """Raise if a line beside the table is a row of it that is broken."""
    fields = _trimmed(dialect.fields(line.text), width)
    numbers = [field for field in fields if dialect.number(field) is not None]
    if not numbers or line.text.strip().startswith(COMMENTS) or re.match(r"\s*[^\W\d]", line.text):
        return
    wrong = next((f for f in fields if not is_missing(f) and dialect.number(f) is None), None)
    if wrong is not None:
        raise InputError(
            f"{source}: '{shortened(wrong)}' in line {line.number} is not a number; a value that is missing is "
            "written nan"
        )
    _refuse_width(line, fields, [line.text], 0, dialect, width, source)


def finite_or_missing(values: NDArray[np.float64], line_numbers: NDArray[np.int64], *, source: str) -> None:
    """Raise if a number of a table is infinite."""
    bad = np.argwhere(np.isinf(values))
    if bad.size:
        row = int(bad[0][0])
        raise InputError(
            f"{source}: line {int(line_numbers[row])} holds a number that is not finite; a value that is missing is "
            "written nan"
        )
