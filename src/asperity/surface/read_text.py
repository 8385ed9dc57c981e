"""Text and NumPy files: profiles and maps as columns of numbers, whatever the line ends and separators."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.file_formats import MEBIBYTE, file_bytes, metres_per_unit
from asperity.surface.topography import Topography
from asperity.unit_table import Dimension, unit_table

#: Largest text file that is read [bytes].
LARGEST_TEXT = 512 * MEBIBYTE

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_NUMBER_COMMA = r"[-+]?(?:\d+,?\d*|,\d+)(?:[eE][-+]?\d+)?"
_MISSING = r"(?:[nN][aA][nN]|---?|BAD|bad|\*+)"
_HEADER_LINES = 500


def text_topography(
    *, path: Path, position_unit: str | None, height_unit: str | None, spacing: float | None, decimal: str
) -> Topography:
    """Profile or map in metres from a text file of numbers; missing values are NaN.

    Two columns are position and height; three columns are position, height and a valid flag (a heading that
    says so) or x, y, z of a full grid; one column, or more than three, are heights that need ``spacing``.

    References
    ----------
    NIST, *Acceptable Data Format*, pml.nist.gov/VSC, and NPL's softgauges: one column that begins with the spacing.
    """
    text = decoded(path, largest=LARGEST_TEXT)
    lines = re.split(r"\r\n|\n|\r", text)
    first, separator, comma = _data_block(lines, decimal, path)
    header = [line for line in lines[:first] if line.strip()]
    table = _table(lines, first, separator, comma, path)
    names = _column_words(header, table.shape[1], separator)
    units = [_unit_in_words(name) for name in names]
    columns = table.shape[1]
    flagged = columns == 3 and any("valid" in line.lower() for line in header[-2:])
    source = path.name

    if columns == 2 or flagged:
        scale_x = _scale(position_unit, units[0], "position", source)
        scale_z = _scale(height_unit, units[1], "height", source)
        height = table[:, 1] * scale_z
        if flagged:
            height = np.where(table[:, 2] == 1.0, height, np.nan)
        step, note = _equal_spacing(table[:, 0], source)
        if step < 0.0:
            step, height = -step, height[::-1]
        return Topography(
            np.ascontiguousarray(height), step * scale_x, source=source, notes=(note,) if note else ()
        )
    if columns == 3:
        scale_x = _scale(position_unit, units[0], "position", source)
        return _grid(table, scale_x, _scale(height_unit, units[2], "height", source), source)
    scale_z = _scale(height_unit, units[0], "height", source)
    if spacing is None:
        raise InputError(
            f"{source} has {columns} column(s) of heights and no positions; give the distance of the points, "
            "such as '0.5 um'; in text files of NIST and NPL their first number, in um",
            options=["spacing"],
        )
    heights = table * scale_z
    if columns == 1:
        stated = int(np.isclose(heights[0, 0], spacing, rtol=1e-9, atol=0.0))
        note = "the first number is the spacing, as in text files of NIST and NPL, and no height"
        return Topography(heights[stated:, 0].copy(), spacing, source=source, notes=(note,) * stated)
    return Topography(
        heights, spacing, spacing, source=source, notes=("rows and columns taken as equally spaced",)
    )


def numpy_topography(*, path: Path, height_unit: str | None, spacing: float | None) -> Topography:
    """Heights from an ``.npy`` file: a line or a grid of numbers whose unit and spacing are given."""
    try:
        # a memory map: a header that promises more than the file holds reserves no memory
        array = np.load(path, allow_pickle=False, mmap_mode="r")
    except Exception as error:  # the parser of the header raises whatever it meets
        raise InputError(f"{path.name} is not a readable NumPy file ({_one_line(error)})") from None
    if array.ndim not in (1, 2) or array.dtype.kind not in "fiu" or min(array.shape) == 0:
        raise InputError(
            f"{path.name} holds an array {array.shape} of {array.dtype}; a line or grid of real numbers is needed"
        )
    if height_unit is None or spacing is None:
        raise InputError(
            f"{path.name} contains numbers without units: give the unit of its heights, such as um, and the distance "
            "of its points, such as '0.5 um'",
            options=["height-unit", "spacing"],
        )
    with np.errstate(over="ignore", invalid="ignore"):
        heights = np.array(array, dtype=np.float64) * metres_per_unit(height_unit)
    return Topography(heights, spacing, spacing if heights.ndim == 2 else None, source=path.name)


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split()) or type(error).__name__
    return text if len(text) <= 120 else text[:117] + "..."


def looks_like_text(beginning: bytes) -> bool:
    """Whether the first bytes of a file are text: no NUL and hardly any control characters."""
    if not beginning or b"\0" in beginning:
        return False
    control = sum(byte < 9 or 13 < byte < 32 for byte in beginning)
    return control < 0.01 * len(beginning)


def decoded(path: Path, *, largest: int) -> str:
    """The text of a file of at most so many bytes, in UTF-8 or Latin-1."""
    data = file_bytes(path=path, largest=largest)
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        return data.decode("latin-1")  # decodes every byte


def _patterns(decimal: str) -> list[tuple[str | None, bool, re.Pattern[str]]]:
    """Line patterns in order of preference: separator (None is white space), decimal comma, pattern."""
    patterns: list[tuple[str | None, bool, re.Pattern[str]]] = []
    for comma in (False, True):
        if (decimal == "comma" and not comma) or (decimal == "point" and comma):
            continue
        value = rf"(?:{_NUMBER_COMMA if comma else _NUMBER}|{_MISSING})"
        for separator, sign in ((None, r"[ \t]+"), (";", r"[ \t]*;[ \t]*"), (",", r"[ \t]*,[ \t]*")):
            if separator == "," and comma:
                continue
            empty = "" if separator is None else "?"
            pattern = rf"[ \t]*{value}(?:{sign}{value}{empty})*[ \t]*"
            patterns.append((separator, comma, re.compile(pattern)))
    return patterns


def _data_block(lines: list[str], decimal: str, path: Path) -> tuple[int, str | None, bool]:
    """First line of numbers, their separator and whether the decimal sign is a comma."""
    if decimal not in ("auto", "point", "comma"):
        raise InputError(f"the decimal sign must be 'auto', 'point' or 'comma', not '{decimal}'")
    if decimal == "auto":
        sample = [line.strip() for line in lines[-200:] if line.strip()]
        if sample and all(re.fullmatch(r"[-+]?\d+,\d+", line) for line in sample):
            raise InputError(
                f"{path.name}: '{sample[-1]}' may be one number with a decimal comma or two whole numbers; "
                "choose 'comma' or 'point'",
                options=["decimal"],
            )
    for start in range(min(len(lines), _HEADER_LINES)):
        block = [line for line in lines[start : start + 8] if line.strip()][:4]
        if len(block) < 3 or not lines[start].strip():
            continue
        for separator, comma, pattern in _patterns(decimal):
            if all(pattern.fullmatch(line) for line in block):
                return start, separator, comma
    raise InputError(
        f"{path.name} holds no table of numbers (looked at the first {min(len(lines), _HEADER_LINES)} lines)"
    )


def _table(
    lines: list[str], first: int, separator: str | None, comma: bool, path: Path
) -> NDArray[np.float64]:
    body = [line for line in lines[first:] if line and not line.isspace()]
    if comma:
        body = [line.replace(",", ".") for line in body]
    if separator is not None:
        trailing = len(body[0]) - len(body[0].rstrip(separator + " \t"))
        if trailing:
            body = [line.rstrip(separator + " \t") for line in body]
    try:
        return np.loadtxt(body, delimiter=separator, ndmin=2, comments=None)
    except ValueError:
        return _table_with_gaps(body, separator, first, path)


def _table_with_gaps(body: list[str], separator: str | None, first: int, path: Path) -> NDArray[np.float64]:
    """Line by line: empty fields and the usual marks of a missing value become NaN, all else is an error."""
    missing = re.compile(_MISSING + r"|\s*")
    width = len(body[0].split(separator))
    rows = np.full((len(body), width), np.nan)
    for i, line in enumerate(body):
        fields = line.split(separator)
        if len(fields) > width or (len(fields) < width and separator is None):
            raise InputError(
                f"{path.name}: row {i + 1} of the table has {len(fields)} columns, the first has {width}"
            )
        for j, value in enumerate(fields):
            try:
                rows[i, j] = float(value)
            except ValueError:
                if missing.fullmatch(value.strip()) is None:
                    raise InputError(
                        f"{path.name}: '{value.strip()[:40]}' in row {i + 1} of the table (which starts in line "
                        f"{first + 1}) is not a number"
                    ) from None
    return rows


def _column_words(header: list[str], columns: int, separator: str | None) -> list[str]:
    """What the last two lines of the heading say above each column."""
    words = [""] * columns
    for line in header[-2:]:
        for sign in (separator, ";", ",", "\t"):
            fields = line.strip().rstrip(",;").lstrip("#").split(sign)
            if len(fields) == columns:
                words = [f"{word} {more}" for word, more in zip(words, fields, strict=True)]
                break
    return words


def _unit_in_words(text: str) -> str | None:
    """The unit of length in a column heading such as ``"[mm]"`` or ``"Lateral um"``, or None."""
    units = unit_table()
    for word in re.findall(r"[^\W\d_]+", text.replace("°", " ").replace("μ", "µ")):
        name = word.lower() if len(word) > 3 else word  # symbols mean what their case says, names any case
        known = "µ" + name[1:] if name[0] == "u" and "µ" + name[1:] in units else name
        if known != "in" and known in units and units[known][3] == Dimension.LENGTH.exponents:
            return name
    return None


def _scale(given: str | None, heading_unit: str | None, what: str, source: str) -> float:
    if given is None and heading_unit is None:
        raise InputError(
            f"{source} does not name the unit of its {what}s; state it: mm, um, nm or m",
            options=[f"{what}-unit"],
        )
    scale = metres_per_unit(given if given is not None else str(heading_unit))
    if heading_unit is not None and scale != metres_per_unit(heading_unit):
        raise InputError(
            f"the heading of {source} gives the unit of its {what}s as {heading_unit}, not {given}; do "
            "not state a unit, or correct the file",
            options=[f"{what}-unit"],
        )
    return scale


@np.errstate(over="ignore", invalid="ignore")  # the spacing of too large positions is refused
def _equal_spacing(position: NDArray[np.float64], source: str) -> tuple[float, str]:
    """Spacing from all of a column of positions that may be rounded; refuse unequal spacing."""
    if position.size < 2 or not np.isfinite(position).all():
        raise InputError(f"{source}: the column of positions has missing values or fewer than two rows")
    if np.ptp(position) == 0.0 or not np.isfinite(np.ptp(position)):
        raise InputError(
            f"{source}: all positions are {position[0]:g}; the first column must hold the positions of the points"
        )
    index = np.arange(position.size) - 0.5 * (position.size - 1)
    start = float(position[0] + np.mean(position - position[0]))
    step = float(index @ (position - start) / (index @ index))
    if step == 0.0:
        raise InputError(f"{source}: the positions do not advance; order the rows by position")
    deviation = float(np.abs(position - (start + step * index)).max())
    quantum = _quantum(position)
    if deviation > 0.51 * quantum + 0.05 * abs(step):
        raise InputError(
            f"{source}: positions are not equally spaced (off by up to {deviation:.4g} at a mean spacing of "
            f"{abs(step):.6g}, in the unit of the file); resample the profile first"
        )
    rounded = f"positions are rounded to {quantum:g}; spacing from a straight line through all of them"
    return step, rounded if deviation > 0.05 * abs(step) else ""


def _quantum(values: NDArray[np.float64]) -> float:
    """The decimal step to which numbers are printed: the largest power of ten that divides all of them."""
    sample = values[:: max(1, values.size // 2000)]
    for exponent in range(3, -16, -1):
        scaled = sample / 10.0**exponent
        if np.all(np.abs(scaled - np.round(scaled)) < 1e-6 * np.maximum(1.0, np.abs(scaled) * 1e-6)):
            return float(10.0**exponent)
    return 0.0


def _grid(table: NDArray[np.float64], scale_x: float, scale_z: float, source: str) -> Topography:
    """A full grid from rows of x, y, z in any order."""
    if not np.isfinite(table[:, :2]).all():
        raise InputError(f"{source}: a column of positions has missing values")
    x, column = np.unique(table[:, 0], return_inverse=True)
    y, row = np.unique(table[:, 1], return_inverse=True)
    if x.size < 2 or y.size < 2 or table.shape[0] > x.size * y.size or table.shape[0] < 0.5 * x.size * y.size:
        raise InputError(
            f"{source}: three columns are read as x, y, z of a grid, but {table.shape[0]} rows do not fill "
            f"{x.size} by {y.size} places"
        )
    heights = np.full((y.size, x.size), np.nan)
    heights[row, column] = table[:, 2] * scale_z
    step_x, _ = _equal_spacing(x, source)
    step_y, _ = _equal_spacing(y, source)
    return Topography(heights, step_x * scale_x, step_y * scale_x, source=source)
