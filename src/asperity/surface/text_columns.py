"""Which column of a text table holds positions, heights, flags or numbers of points: by its name, or as even ramp."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError, nearest
from asperity.text_table.headings import Heading, factor_and_unit, is_unit
from asperity.text_table.text_table import TextTable
from asperity.unit_table import Dimension
from asperity.units import unit_exponents

#: Columns of a table without names above which it is a map, whatever its first column holds.
_COLUMNS_OF_MAP = 16
#: Columns without use that are named.
_NAMED = 3
#: Words of a heading, in small letters.
_X = frozenset(
    (
        *("position", "positions", "pos", "xpos", "xposition", "lateral", "axial"),
        *("distance", "distanz", "way", "weg", "abscissa"),
    )
)
_Y = frozenset(("ypos", "yposition"))
_Z = frozenset(
    (
        *(
            "height",
            "heights",
            "zheight",
            "höhe",
            "hoehe",
            "hauteur",
            "elevation",
            "depth",
            "amplitude",
            "deviation",
        ),
        *("profile", "primary", "roughness", "waviness", "raw", "topography"),
    )
)
#: Names of columns that number the rows of a map, and the places in them.
_ROW = frozenset(("row", "line", "zeile", "ligne"))
_PLACE = frozenset(("column", "col", "spalte", "colonne", "pixel"))
#: Names of columns that number the points.
_INDEX = frozenset(
    (
        *("index", "idx", "no", "nr", "num", "number", "#", "n", "i", "id", "count", "record"),
        *("point", "pointno", "sample", "sampleno", "punkt", "pkt", "punktnr", "messpunkt", "lfdnr", "lfd"),
        *(*_ROW, *_PLACE),
    )
)
#: Names of flags of good and of bad points, beside valid and invalid; others of 0 and 1 are not known.
_GOOD = frozenset(("ok", "good", "gültig", "gueltig", "valide"))
_BAD = frozenset(
    (
        *("bad", "outlier", "missing", "error", "nan", "defect"),
        *("ungültig", "ungueltig", "invalide", "fehler"),
    )
)


@dataclass(frozen=True)
class Columns:
    """Places of the columns of a table, None without one: positions ``x`` and ``y``, ``heights``, ``flag``.

    Without one column of ``heights`` each holds a column of a map. ``valid``: the flag of a good point; ``notes``: what
    was decided.
    """

    x: int | None = None
    y: int | None = None
    heights: int | None = None
    flag: int | None = None
    valid: float = 1.0
    notes: tuple[str, ...] = ()


def columns_of(table: TextTable, column: str | None) -> Columns:
    """What the columns of a table are; ``column`` is that of the heights by name or number, if the user states it.

    An ``InputError`` if more than one may be the heights, or the stated one does not exist.
    """
    kinds = [kind_of(heading) for heading in table.headings]
    chosen = None if column is None else _chosen(table, column)
    flag = next((j for j, kind in enumerate(kinds) if kind in ("valid", "invalid") and j != chosen), None)
    kinds = _with_rows_and_places(table, kinds)
    numbers = [j for j in range(table.width) if j != chosen and _numbers_points(table, kinds, j)]
    notes = tuple(f"column {j + 1} numbers the points" for j in numbers)
    rest = [j for j in range(table.width) if j != flag and j not in numbers]
    has_names = any(kinds) or all(heading.unit is not None for heading in table.headings)
    if chosen is None and not has_names and len(rest) > 3 and not _is_table_of_profiles(table):
        return Columns()
    x, y = _positions(table, kinds, rest, chosen)
    heights = _heights(table, kinds, [j for j in rest if j not in (x, y)]) if chosen is None else chosen
    valid = 0.0 if flag is not None and kinds[flag] == "invalid" else 1.0
    others = [j for j in rest if j not in (x, y, heights)]
    if chosen is None:
        _refuse_unclear_flag(table, others)
    notes = (*notes, *(f"{_column_words(table, j)} is not used" for j in others[:_NAMED]))
    if len(others) > _NAMED:
        notes = (*notes, f"{len(others) - _NAMED} more columns are not used")
    if x is not None and heights < x:
        notes = (
            *notes,
            f"heights from {_column_words(table, heights)}, positions from {_column_words(table, x)}",
        )
    if x is not None and y is not None and y < x:
        notes = (*notes, f"x from {_column_words(table, x)}, y from {_column_words(table, y)}")
    return Columns(x, y, heights, flag, valid, notes)


def _heights(table: TextTable, kinds: Sequence[str], left: Sequence[int]) -> int:
    """The one column of heights among those that are left."""
    named = [j for j in left if kinds[j] == "z"]
    heights = named or [j for j in left if not _is_no_length(table.headings[j])] or list(left)
    if len(heights) == 1:
        return heights[0]
    if heights:
        words = ", ".join(_column_words(table, j) for j in heights[:6])
        raise InputError(
            f"{table.source}: more than one column may hold the heights: {words}{' ...' if len(heights) > 6 else ''}; "
            "choose one by its name or number",
            options=["column"],
        )
    raise InputError(
        f"{table.source}: no column of heights is left beside {_column_words(table, 0)}; correct the headings",
        options=["column"],
    )


def kind_of(heading: Heading) -> str:
    """What the name of a column says: x, y, z, valid, invalid, index, or nothing that is known."""
    name = heading.name.lower()
    words = {word.rstrip("0123456789") for word in re.split(r"[\W_]+", name)} - {""}
    joined = re.sub(r"[\W_]", "", name)
    if "valid" in name:
        return "invalid" if re.search(r"(in|un|not?n?[\W_]*)valid", name) else "valid"
    if heading.unit is None and (joined in _GOOD | _BAD or words & (_GOOD | _BAD)):
        return "invalid" if joined in _BAD or words & _BAD else "valid"
    for kind, known in (("z", {"z"}), ("x", {"x"}), ("y", {"y"}), ("x", _X), ("y", _Y), ("z", _Z)):
        if words & known or joined in known:
            return kind
    is_index = bool(heading.text) and heading.unit is None and (name.strip() in _INDEX or joined in _INDEX)
    return "index" if is_index else ""


def _numbers_points(table: TextTable, kinds: Sequence[str], column: int) -> bool:
    """Whether a column has the numbers of the points beside others: by its name, or without one where others have."""
    nameless = not table.headings[column].text and any(heading.text for heading in table.headings)
    others = (
        is_ramp(table.values[:, j]) and table.headings[j].unit is not None
        for j in range(table.width)
        if j != column
    )
    beside = kinds[column] == "" and table.headings[column].unit is None and any(others)
    numbers = kinds[column] == "index" or nameless or beside
    return table.width > 1 and numbers and counts_up(table.values[:, column])


def _with_rows_and_places(table: TextTable, kinds: Sequence[str]) -> list[str]:
    """The kinds of columns where two number the rows of a map and the places in them: y and x.

    An ``InputError`` if their names do not say which is which.
    """
    names = [re.sub(r"[\W_]", "", heading.name.lower()) for heading in table.headings]
    rows, places = ([j for j, name in enumerate(names) if name in known] for known in (_ROW, _PLACE))
    if len(rows) == 1 and len(places) == 1 and table.width > 2:
        return [{rows[0]: "y", places[0]: "x"}.get(j, kind) for j, kind in enumerate(kinds)]
    if {"i", "j"} <= set(names) and table.width > 2:
        raise InputError(
            f"{table.source}: which of the columns 'i' and 'j' numbers the rows is not known; name them x and y"
        )
    return list(kinds)


def _refuse_unclear_flag(table: TextTable, others: Sequence[int]) -> None:
    """Raise if a column without use holds 0 and 1 alone: it may say which points are good."""
    for j in others:
        values = table.values[:, j]
        if np.isin(values, (0.0, 1.0)).all() and np.ptp(values) > 0.0:
            raise InputError(
                f"{table.source}: {_column_words(table, j)} holds 0 and 1 alone: if it says which points are good, "
                "name it valid or invalid; if not, choose the column of the heights",
                options=["column"],
            )


def _positions(
    table: TextTable, kinds: Sequence[str], rest: Sequence[int], chosen: int | None
) -> tuple[int | None, int | None]:
    """The columns of positions along x and y: by their names, or else the one that advances evenly."""
    left = [j for j in rest if j != chosen]
    x, y = (next((j for j in left if kinds[j] == kind), None) for kind in ("x", "y"))
    if chosen is not None:
        x = max(
            (j for j in left if kinds[j] == "x" and j < chosen), default=x
        )  # of pairs side by side, its own
    if len(rest) == 1:
        return None, None
    if x is not None and y is not None:  # a profile whose other position does not change
        still = [j for j in (x, y) if np.ptp(table.values[:, j]) == 0.0]
        if len(still) == 1:
            return (y if still[0] == x else x), None
    if x is not None and y is not None and len(rest) > 2:
        return x, y
    if x is not None or y is not None:
        return (y if x is None else x), None  # of two columns x and y the second is measured over the first
    lengths = [j for j in rest if not _is_no_length(table.headings[j])]
    ramps = [j for j in left if j in lengths and is_ramp(table.values[:, j])]
    ramps.sort(key=lambda j: table.headings[j].unit is None)  # those with a unit of length first
    is_named = any(kinds[j] for j in rest)
    is_grid = len(lengths) == 3 and lengths[0] not in ramps
    if is_grid and (chosen is None or (chosen == lengths[2] and not is_named)):
        return lengths[0], lengths[1]
    if len(lengths) == 2 and chosen is None and "z" in (kinds[j] for j in lengths):
        return next((j for j in lengths if kinds[j] != "z"), None), None
    if ramps:
        return ramps[0], None
    return (lengths[0] if len(lengths) == 2 and chosen is None else None), None


def _is_table_of_profiles(table: TextTable) -> bool:
    """Whether a table without names may hold positions and a few profiles: its first column is an even ramp."""
    ramps = [is_ramp(table.values[:, j]) for j in (0, 1)]
    return table.width <= _COLUMNS_OF_MAP and ramps[0] and not ramps[1] and not is_ramp(table.values[0, 1:])


def counts_up(values: NDArray[np.float64]) -> bool:
    """Whether numbers count from 0 or 1, one by one."""
    return bool(values.size > 1 and values[0] in (0.0, 1.0) and np.all(np.diff(values) == 1.0))


def is_ramp(values: NDArray[np.float64]) -> bool:
    """Whether numbers that may be rounded advance evenly, up or down, from each to the next."""
    if values.size < 3 or not np.isfinite(values).all():
        return False
    steps = np.diff(values)
    if not (np.all(steps > 0.0) or np.all(steps < 0.0)):
        return False
    step = (values[-1] - values[0]) / (values.size - 1)
    deviation = np.abs(values - (values[0] + step * np.arange(values.size))).max()
    return bool(deviation <= 1.02 * decimal_step(values) + 1e-3 * abs(step))


def decimal_step(values: NDArray[np.float64]) -> float:
    """The decimal step to which numbers are printed: the largest power of ten that divides all of them."""
    sample = values[:: max(1, values.size // 2000)]
    for exponent in range(3, -16, -1):
        scaled = sample / 10.0**exponent
        if np.all(np.abs(scaled - np.round(scaled)) < 1e-6 * np.maximum(1.0, np.abs(scaled) * 1e-6)):
            return float(10.0**exponent)
    return 0.0


@np.errstate(over="ignore", invalid="ignore")  # the spacing of too large positions is refused
def equal_spacing(position: NDArray[np.float64], source: str) -> tuple[float, str]:
    """Spacing from all of a column of positions that may be rounded, with its sign, and a note if they are.

    An ``InputError`` if they are not equally spaced, or one is missing.
    """
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
    quantum = decimal_step(position)
    if deviation > 0.51 * quantum + 0.05 * abs(step):
        raise InputError(
            f"{source}: positions are not equally spaced (off by up to {deviation:.4g} at a mean spacing of "
            f"{abs(step):.6g}, in the unit of the file); resample the profile first"
        )
    rounded = f"positions are rounded to {quantum:g}; spacing from a straight line through all of them"
    return step, rounded if deviation > 0.05 * abs(step) else ""


def _is_no_length(heading: Heading) -> bool:
    """Whether a heading states a unit that is no length."""
    if heading.unit is None or not is_unit(heading.unit):
        return False
    return unit_exponents(factor_and_unit(heading.unit)[1]) != Dimension.LENGTH.exponents


def _column_words(table: TextTable, column: int) -> str:
    """A column with its number and heading."""
    text = table.headings[column].text
    return f"column {column + 1} '{text}'" if text else f"column {column + 1}"


def _chosen(table: TextTable, column: str) -> int:
    """The place of a column that the user states by its number from 1, or by its heading."""
    wanted = column.strip()
    if re.fullmatch(r"\d{1,6}", wanted) and 1 <= int(wanted) <= table.width:
        return int(wanted) - 1
    texts = [heading.text for heading in table.headings]
    for same in (
        [
            j
            for j, heading in enumerate(table.headings)
            if wanted.lower() in (heading.name.lower(), heading.text.lower())
        ],
        [j for j, text in enumerate(texts) if text and wanted.lower() in text.lower()],
    ):
        if len(same) == 1:
            return same[0]
    known = ", ".join(_column_words(table, j) for j in range(min(table.width, 8)))
    raise InputError(
        f"{table.source} has no single column '{column}'{nearest(wanted, [text for text in texts if text])}; its "
        f"columns are {known}{' ...' if table.width > 8 else ''}",
        options=["column"],
    )
