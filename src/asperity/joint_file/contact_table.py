"""Tables of roller pairs: CSV with the unit in every column's name, any number of rows, in bounded memory."""

from __future__ import annotations

import csv
import math
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple, TextIO

import numpy as np

from asperity.contact.asperity import AsperityBase
from asperity.contact.interface import RoughContact
from asperity.contact.laws.zou_2025 import Zou2025
from asperity.contact.roller_pairs import (
    CONTACT_FACTOR_MODELS,
    numbered_contact_factors,
    roller_pairs,
    rough_contacts,
)
from asperity.engine.arrays import xp
from asperity.engine.control import at_once
from asperity.errors import InputError, nearest, quoted
from asperity.joint_file import limits
from asperity.joint_file.quantity_key import Key
from asperity.made_files import table_where
from asperity.materials import ContactPair, contact_modulus, tangential_contact_modulus
from asperity.reading import open_text
from asperity.types import Array, Document
from asperity.unit_table import Dimension
from asperity.units import from_si
from asperity.writing import check_file, replacing

#: What is held in memory at a time.
ROWS_AT_ONCE, CHARACTERS_AT_ONCE = 65536, 100_000_000
LONGEST_ROW = 1_000_000
MOST_ERRORS = 12
_MOST_SUGGESTIONS = 200

_FORCE = Key(Dimension.FORCE, 0.0, 1e9, "N", open_lower=True)
_TANGENTIAL_FORCE = Key(Dimension.FORCE, 0.0, 1e9, "N")
_MODULUS = Key(Dimension.PRESSURE, 0.1, 1e7, "MPa")

#: Numeric input columns: name → what it measures and its range; the unit of the range is that of the column.
INPUT_COLUMNS: dict[str, Key] = {
    "D": limits.FRACTAL_DIMENSION,
    "G_mm": limits.FRACTAL_ROUGHNESS,
    "F_N": _FORCE,
    "T_N": _TANGENTIAL_FORCE,
    "mu": limits.FRICTION_COEFFICIENT,
    "R1_mm": limits.ROLLER_RADIUS,
    "R2_mm": limits.ROLLER_RADIUS,
    "sign": Key(Dimension.DIMENSIONLESS, -1, 1, integer=True),
    "B_mm": limits.CONTACT_LENGTH,
    "E1_MPa": _MODULUS,
    "E2_MPa": _MODULUS,
    "nu1": limits.POISSON_RATIO,
    "nu2": limits.POISSON_RATIO,
    "H_MPa": limits.HARDNESS,
}
#: The one column of names: which model of the contact factor lambda the row uses.
MODEL_COLUMN = "lambda"

#: Result columns, in this order behind the input: name → field of
#: :class:`asperity.contact.interface.RoughContact`, unit.
OUTPUT_COLUMNS: dict[str, tuple[str, str]] = {
    "psi": ("domain_extension_factor", "1"),
    "lam": ("contact_factor", "1"),
    "a_c_mm2": ("critical_area", "mm^2"),
    "a_l_mm2": ("largest_area", "mm^2"),
    "A_r_mm2": ("real_contact_area", "mm^2"),
    "Fe_N": ("elastic_load", "N"),
    "Fp_N": ("plastic_load", "N"),
    "Kt_N_per_mm": ("tangential_stiffness", "N/mm"),
    "Kn_N_per_mm": ("normal_stiffness", "N/mm"),
}


def _is_of_results(columns: list[str]) -> bool:
    """Whether columns are those of a table that was read, and behind them the results and nothing else."""
    read, results = columns[: -len(OUTPUT_COLUMNS)], columns[-len(OUTPUT_COLUMNS) :]
    return results == list(OUTPUT_COLUMNS) and {*INPUT_COLUMNS, MODEL_COLUMN} <= set(map(str.strip, read))


_RESULTS = table_where("a table of results", _is_of_results)
#: What the contact law does not give where every spot is plastic.
_STIFFNESSES = ("Kt_N_per_mm", "Kn_N_per_mm")


class Summary(NamedTuple):
    """What was done with a table: its rows, the columns replaced by results, the rows where every spot is plastic."""

    rows: int
    replaced_columns: tuple[str, ...]
    plastic_rows: int


def convert_contact_table(
    source: str | Path,
    target: str | Path,
    *,
    frequency_ratio: float,
    asperity_base: AsperityBase,
    progress: Callable[[int], None] = lambda rows: None,
) -> Summary:
    """Read a table of roller pairs and write it again with the results behind each row."""
    check_file(target, source, kind=_RESULTS)
    with open_text(source) as stream:
        try:
            return _convert(stream, str(source), Path(target), frequency_ratio, asperity_base, progress)
        except csv.Error as error:
            raise InputError(f"{source}: not a CSV table: {error}") from None
        except OSError as error:
            raise InputError(f"{source}: cannot be read: {error.strerror or error}") from None


def _convert(
    stream: TextIO,
    source: str,
    target: Path,
    frequency_ratio: float,
    asperity_base: AsperityBase,
    progress: Callable[[int], None],
) -> Summary:
    lines_read = _Lines(stream, source)
    reader = csv.reader(lines_read, strict=True)
    header = [name.strip() for name in next(reader, [])]
    _check_header(header, source)
    kept = [index for index, name in enumerate(header) if name not in OUTPUT_COLUMNS]
    rows = plastic_rows = 0
    with replacing(target, kind=_RESULTS) as part, part.open("x", encoding="utf-8", newline="") as made:
        writer = csv.writer(made, lineterminator="\n")
        writer.writerow([*(header[index] for index in kept), *OUTPUT_COLUMNS])
        for lines, cells in _chunks(reader, lines_read, header, source):
            columns = _columns(cells, lines, header, source)
            results = _evaluated(columns, frequency_ratio, asperity_base)
            plastic = results["Kn_N_per_mm"] <= 0.0  # K_t is also 0 in gross slip, and that is right
            for name in _STIFFNESSES:
                results[name] = np.where(plastic, np.nan, results[name])
            plastic_rows += int(plastic.sum())
            written = [[repr(number) for number in results[name].tolist()] for name in OUTPUT_COLUMNS]
            writer.writerows(
                [*(row[index] for index in kept), *numbers]
                for row, numbers in zip(cells, zip(*written, strict=True), strict=True)
            )
            rows += len(cells)
            progress(rows)
    return Summary(rows, tuple(name for name in header if name in OUTPUT_COLUMNS), plastic_rows)


def _check_header(header: list[str], source: str) -> None:
    needed = [*INPUT_COLUMNS, MODEL_COLUMN]
    if not header:
        raise InputError(f"{source}: empty; the first line must name the columns {', '.join(needed)}")
    twice = sorted(name for name, count in Counter(header).items() if count > 1)
    if twice:
        raise InputError(f"{source}: line 1: there is more than one column {quoted(twice[0])}")
    missing = [name for name in needed if name not in header]
    if missing:
        others = [name for name in header[:_MOST_SUGGESTIONS] if name not in needed]
        hints = [f"{name}{nearest(name, others)}" for name in missing]
        raise InputError(f"{source}: line 1: missing columns: {', '.join(hints)}")


class _Lines:
    """The lines of a table; a row of unbounded length is an error instead of a full memory."""

    def __init__(self, stream: TextIO, source: str) -> None:
        self._stream, self._source = stream, source
        self.characters = 0

    def __iter__(self) -> _Lines:
        return self

    def __next__(self) -> str:
        line = self._stream.readline(LONGEST_ROW + 1)
        if not line:
            raise StopIteration
        self.characters += len(line)
        if self.characters > LONGEST_ROW:
            raise InputError(
                f"{self._source}: a row has more than {LONGEST_ROW} characters; this is not a table"
            )
        return line


def _chunks(
    reader: Any, lines_read: _Lines, header: list[str], source: str
) -> Iterator[tuple[list[int], list[list[str]]]]:
    """Rows with their line numbers, a bounded amount at a time; empty lines are skipped."""
    lines: list[int] = []
    cells: list[list[str]] = []
    characters = 0
    lines_read.characters = 0
    for row in reader:
        characters += lines_read.characters
        lines_read.characters = 0
        if not row:
            continue
        if len(row) != len(header):
            raise InputError(
                f"{source}: line {reader.line_num}: {len(row)} cells, but the header has {len(header)} columns"
            )
        lines.append(reader.line_num)
        cells.append(row)
        if len(cells) == ROWS_AT_ONCE or characters > CHARACTERS_AT_ONCE:
            yield lines, cells
            lines, cells, characters = [], [], 0
    if cells:
        yield lines, cells


def _columns(cells: list[list[str]], lines: list[int], header: list[str], source: str) -> Document:
    """Numbers of the input columns as they are written, checked; the model as its index."""
    by_name = {name: index for index, name in enumerate(header)}
    errors: list[tuple[int, str]] = []
    columns: Document = {}
    for name, key in INPUT_COLUMNS.items():
        written = [row[by_name[name]] for row in cells]
        columns[name] = _numbers(written, name, key, lines, errors)
    known: dict[str, int] = {model: index for index, model in enumerate(CONTACT_FACTOR_MODELS)}
    chosen = [row[by_name[MODEL_COLUMN]].strip() for row in cells]
    errors += [
        (line, f"column {MODEL_COLUMN}: {quoted(model)} is not one of {', '.join(CONTACT_FACTOR_MODELS)}")
        for line, model in zip(lines, chosen, strict=True)
        if model not in known
    ]
    inner = (columns["sign"] < 0.0) & (columns["R1_mm"] == columns["R2_mm"])
    errors += [
        (lines[row], "column R2_mm: an inner contact (sign -1) needs two different radii")
        for row in np.flatnonzero(inner)
    ]
    neutral = np.flatnonzero(columns["sign"] == 0.0)
    errors += [(lines[row], "column sign: 0 is not allowed; it must be 1 or -1") for row in neutral]
    if errors:
        raise InputError(_listed(errors, source))
    columns[MODEL_COLUMN] = np.array([known[model] for model in chosen])
    return columns


def _listed(errors: list[tuple[int, str]], source: str) -> str:
    """Bad cells in the order of the lines, the first dozen of them."""
    sentences = [f"line {line}, {sentence}" for line, sentence in sorted(errors)[:MOST_ERRORS]]
    if len(errors) == 1:
        return f"{source}: {sentences[0]}; nothing was written"
    if len(errors) > MOST_ERRORS:
        sentences.append(f"and {len(errors) - MOST_ERRORS} more")
    return "\n  ".join([f"{source}: {len(errors)} bad cells, nothing was written", *sentences])


def _numbers(
    written: list[str], name: str, key: Key, lines: list[int], errors: list[tuple[int, str]]
) -> np.ndarray:
    try:
        numbers = np.array(written, dtype=float)
    except ValueError:
        numbers = np.array([_number(text) for text in written])
    low, high = key.lower, key.upper
    good = (numbers > low if key.open_lower else numbers >= low) & (
        numbers < high if key.open_upper else numbers <= high
    )
    if key.integer:
        good &= numbers == np.round(numbers)
    for row in np.flatnonzero(~good):
        shown = written[row].strip()
        unit = "" if key.unit == "1" else f" {key.unit}"
        is_number = not math.isnan(_number(shown))
        problem = f"{shown[:80]}{unit} is not allowed" if is_number else f"{quoted(shown)} is not a number"
        errors.append((lines[row], f"column {name}: {problem}; it must be {key.allowed}"))
    return numbers


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan


def _evaluated(
    columns: dict[str, np.ndarray], frequency_ratio: float, asperity_base: AsperityBase
) -> dict[str, np.ndarray]:
    """Results of some rows in the units of their columns."""
    si: Document = {name: columns[name] / from_si(1.0, key.unit) for name, key in INPUT_COLUMNS.items()}
    surface = Zou2025(si["D"], si["G_mm"], xp.full(si["D"].size, frequency_ratio), asperity_base)
    contacts = at_once(_contacts, si, surface, columns[MODEL_COLUMN])
    return {
        name: np.asarray(getattr(contacts, field)) * from_si(1.0, unit)
        for name, (field, unit) in OUTPUT_COLUMNS.items()
    }


def _contacts(si: dict[str, Array], surface: Zou2025, model_number: Array) -> RoughContact:
    """The contacts of some rows, each with its own model of the contact factor."""
    elastic = {
        "youngs_modulus_1": si["E1_MPa"],
        "youngs_modulus_2": si["E2_MPa"],
        "poisson_ratio_1": si["nu1"],
        "poisson_ratio_2": si["nu2"],
    }
    pairs = roller_pairs(
        radius_1=si["R1_mm"],
        radius_2=si["R2_mm"],
        sign=si["sign"],
        contact_length=si["B_mm"],
        friction_coefficient=si["mu"],
        moduli=ContactPair(
            contact_modulus=contact_modulus(**elastic),
            tangential_contact_modulus=tangential_contact_modulus(**elastic),
            hardness=si["H_MPa"],
            yield_strength=xp.nan,  # has no part in the contact law
        ),
        surface=surface,
    )
    factor = numbered_contact_factors(pairs=pairs, model_number=model_number, normal_force=si["F_N"])
    return rough_contacts(
        pairs=pairs, contact_factor=factor, normal_force=si["F_N"], tangential_force=si["T_N"]
    )
