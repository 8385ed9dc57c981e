"""Measured torque–angle, stiffness and drift curves from text tables whose headings state names and units."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from asperity.errors import InputError, nearest
from asperity.reading import read_bytes
from asperity.text_table.decoding import decoded
from asperity.text_table.headings import Heading, factor_and_unit
from asperity.text_table.text_table import TextTable, text_table
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity

COLUMNS = {
    "torque": Dimension.TORQUE,
    "angle": Dimension.ANGLE,
    "stiffness": Dimension.TORSIONAL_STIFFNESS,
    "drift": Dimension.ANGLE,
    "speed loss": Dimension.DIMENSIONLESS,
    "speed ratio": Dimension.DIMENSIONLESS,
    "time": Dimension.TIME,
    "repetition": None,
}

#: What these columns are called in other files, in small letters.
_ALSO_CALLED = {
    **dict.fromkeys(("moment", "drehmoment", "load torque", "output torque", "couple"), "torque"),
    **dict.fromkeys(
        (
            "rotation",
            "twist",
            "angle of twist",
            "twist angle",
            "torsion angle",
            "output angle",
            "winkel",
            "theta",
            "phi",
        ),
        "angle",
    ),
    **dict.fromkeys(("torsional stiffness", "steifigkeit"), "stiffness"),
    **dict.fromkeys(("zeit",), "time"),
    **dict.fromkeys(("cycle", "run"), "repetition"),
}

#: Columns of which a file has exactly one, beside the torque.
MEASURED = ("angle", "stiffness", "drift", "speed loss", "speed ratio")

#: Largest size that a number of a column may have, in SI units: beyond it a unit or a column is wrong.
LARGEST = {
    "torque": 1e9,
    "angle": 1e3,
    "stiffness": 1e15,
    "drift": 1.0,
    "speed loss": 0.2,
    "speed ratio": 1e6,
    "time": 1e12,
    "repetition": 1e9,
}

#: Largest share by which a measured speed ratio may differ from that of the joint without creep.
FARTHEST_RATIO = 0.2

#: Largest file [byte].
LARGEST_FILE = 50_000_000
#: Rows of numbers a file must and may have.
FEWEST_ROWS, MOST_ROWS = 2, 200_000


@dataclass(frozen=True)
class MeasuredQuantity:
    """What the second column of a measurement means: in words, with the units of curve, residuals and arrays."""

    name: str
    unit: str
    fine_unit: str
    si_unit: str


_ANGLE = MeasuredQuantity("angle", "arcmin", "arcsec", "rad")
_STIFFNESS = MeasuredQuantity("stiffness", "N*m/arcmin", "N*m/arcmin", "N*m/rad")
_DRIFT = MeasuredQuantity("drift per output turn", "arcmin", "arcsec", "rad")


@dataclass(frozen=True)
class Measurement:
    """A measured curve in SI units, rows in the order of time; all arrays of shape (points,).

    ``torque`` at the output, of either sign [N·m]; ``angle`` of the output with the input locked [rad], incremental
    ``stiffness`` [N·m/rad] or ``drift``, the angle lost in one turn of the output while the joint rolls, with the sign
    of the torque [rad]: exactly one of them is there, the others are None. ``time`` [s] or None; ``repetition``: number
    of the repetition of each row, zeros if the file states none; ``source``: name of the file; ``unloaded_ratio``:
    speed ratio without creep with which the drift was derived from measured speed ratios [-], None otherwise;
    ``line_numbers`` of the rows in the file, None without one; ``notes``: which of its lines were not used.
    """

    torque: np.ndarray
    angle: np.ndarray | None
    stiffness: np.ndarray | None
    time: np.ndarray | None
    repetition: np.ndarray
    source: str
    drift: np.ndarray | None = None
    unloaded_ratio: float | None = None
    line_numbers: np.ndarray | None = None
    notes: tuple[str, ...] = ()

    def place(self, row: int) -> str:
        """Where a row stands: its line in the file, or its number from 1."""
        return f"row {row + 1}" if self.line_numbers is None else f"line {int(self.line_numbers[row])}"

    @property
    def measured(self) -> np.ndarray:
        """The angle, the stiffness or the drift, whichever is there."""
        return next(column for column in (self.angle, self.stiffness, self.drift) if column is not None)

    @property
    def quantity(self) -> MeasuredQuantity:
        """What :attr:`measured` is."""
        return _DRIFT if self.drift is not None else _ANGLE if self.angle is not None else _STIFFNESS


def _column(heading: Heading) -> tuple[str, float]:
    """Name of a column and the factor to SI units: ``torque [N*m]``, ``torque_Nm``, ``stiffness_Nm_per_arcmin``."""
    shown = heading.text
    joined = re.fullmatch(r"\s*([A-Za-z]+(?:[ _](?:loss|ratio))?)(?:_(\S+))?\s*", shown, re.IGNORECASE)
    if joined is not None:
        name, unit = (
            joined[1].replace("_", " "),
            re.sub(r"\bNm(?=\b|/)", "N*m", (joined[2] or "").replace("_per_", "/").replace("_", "*")),
        )
    else:
        name, unit = heading.name.replace("_", " "), heading.unit or ""
    name = " ".join(name.lower().split())
    name = _ALSO_CALLED.get(name, name)
    if name not in COLUMNS:
        known = nearest(name, COLUMNS) or f"; known are {', '.join(COLUMNS)}"
        raise InputError(f"column '{shown}'{known}")
    dimension = COLUMNS[name]
    if dimension is None:
        return name, 1.0
    if not unit:
        if dimension is Dimension.DIMENSIONLESS:
            return name, 1.0
        raise InputError(
            f"column '{shown}' states no unit, e.g. '{name} [{dimension.example.split(' ', 1)[1]}]'"
        )
    try:
        if name == "drift" and re.search(r"/\s*(turn|rev)", unit):
            return name, 2.0 * np.pi * parse_quantity(f"1 {unit}", Dimension.DIMENSIONLESS)
        factor, plain = factor_and_unit(unit)
        return name, factor * parse_quantity(f"1 {plain}", dimension)
    except InputError as error:
        raise InputError(f"column '{shown}': {error}") from None


def _refuse_constant(path: str | Path, columns: dict[str, np.ndarray]) -> None:
    """Torques or angles of a curve that never change: a sensor that was not connected, or a wrong column."""
    curve = next((name for name in MEASURED if name in columns and name != "stiffness"), None)
    units = {"angle": "arcmin", "drift": "arcmin", "speed loss": "%", "speed ratio": "1"}
    for name, unit in (("torque", "N*m"), (curve, units.get(curve or "", ""))):
        if curve is not None and name is not None and np.ptp(columns[name]) == 0.0:
            raise InputError(
                f"{path}: all {len(columns[name])} rows have the {name} {format_quantity(columns[name][0], unit)}; "
                "a curve needs different ones, so check the column and its unit"
            )


def _drift(
    path: str | Path, columns: dict[str, np.ndarray], unloaded_ratio: float | None
) -> np.ndarray | None:
    """Angle lost per output turn, from whichever column states it [rad]."""
    if "drift" in columns:
        return columns["drift"]
    if "speed loss" in columns:
        return 2.0 * np.pi * columns["speed loss"] / (1.0 - columns["speed loss"])
    if "speed ratio" not in columns:
        return None
    if unloaded_ratio is None:
        raise InputError(f"{path}: a column 'speed ratio' needs the ratio of the joint without creep")
    over = np.abs(columns["speed ratio"] / unloaded_ratio)
    worst = int(np.argmax(np.abs(over - 1.0)))
    if abs(over[worst] - 1.0) > FARTHEST_RATIO:
        raise InputError(
            f"{path}: the speed ratio {columns['speed ratio'][worst]:g} is far from {abs(unloaded_ratio):g}, that of "
            f"the joint file without creep (at most {100.0 * FARTHEST_RATIO:g} % away); the column is the speed of the "
            "input over that of the output"
        )
    return 2.0 * np.pi * (over - 1.0)


def read_measurement(path: str | Path, *, unloaded_ratio: float | None = None) -> Measurement:
    """A measured curve in SI units from a text table; an ``InputError`` with line and column if it cannot be read.

    Columns: ``torque`` and one of ``angle``, ``stiffness``, ``drift`` (angle lost per output turn), ``speed loss``,
    ``speed ratio`` (input over output; needs the ratio of the joint without creep); optionally ``time`` and
    ``repetition``. Units stand in the heading, ``torque [N*m]`` or ``torque_Nm``, or in a row of their own below it.
    Rows in the order of time. Separators, decimal signs and encodings are those of every text table, see
    :doc:`/reading_files`.
    """
    text = decoded(read_bytes(path, largest=LARGEST_FILE), source=str(path))
    if not text.strip():
        raise InputError(f"{path}: the file is empty")
    table = text_table(text, source=str(path), fewest_rows=1)
    if len(table.values) > MOST_ROWS:
        raise InputError(
            f"{path}: {len(table.values)} rows; at most {MOST_ROWS} are allowed, so reduce their number"
        )
    if table.first_gap and table.inside:
        raise InputError(
            f"{path}: {table.inside[0]} stands between rows, after an empty line: one file holds one curve; save the "
            "second in a file of its own, or number its rows in a column 'repetition'"
        )
    by_name = _named_columns(table)
    if len(table.values) < FEWEST_ROWS:
        raise InputError(f"{path}: needs at least {FEWEST_ROWS} rows of numbers, got {len(table.values)}")
    _refuse_constant(path, by_name)
    time, stiffness = by_name.get("time"), by_name.get("stiffness")
    if time is not None and np.any(np.diff(time) < 0.0):
        line = int(table.line_numbers[int(np.argmax(np.diff(time) < 0.0)) + 1])
        raise InputError(f"{path}, line {line}: time runs backwards; rows must be in the order of time")
    if stiffness is not None and np.any(stiffness <= 0.0):
        line = int(table.line_numbers[int(np.argmax(stiffness <= 0.0))])
        raise InputError(
            f"{path}, line {line}: the stiffness {stiffness[stiffness <= 0.0][0]:g} must be positive"
        )
    return Measurement(
        torque=by_name["torque"],
        angle=by_name.get("angle"),
        stiffness=stiffness,
        time=time,
        repetition=by_name.get("repetition", np.zeros(len(table.values))),
        source=str(path),
        drift=_drift(path, by_name, unloaded_ratio),
        unloaded_ratio=unloaded_ratio if "speed ratio" in by_name else None,
        line_numbers=table.line_numbers,
        notes=table.left_out(()),
    )


def _named_columns(table: TextTable) -> dict[str, np.ndarray]:
    """The columns of a table by their names in SI units, none of them twice, all numbers finite and of a usual size."""
    path = table.source
    if not any(heading.name or heading.text for heading in table.headings):
        raise InputError(
            f"{path}: no line above the table has a heading for each of its {table.width} column(s), such as "
            "'torque [N*m],angle [arcmin]'"
        )
    try:
        columns = [_column(heading) for heading in table.headings]
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    names = [name for name, _ in columns]
    for name in names:
        if names.count(name) > 1:
            raise InputError(f"{path}: there are {names.count(name)} columns '{name}'")
    if "torque" not in names or sum(name in names for name in MEASURED) != 1:
        choice = "', '".join(MEASURED[:-1])
        raise InputError(
            f"{path}: needs the columns 'torque' and one of '{choice}' or '{MEASURED[-1]}', got {', '.join(names)}"
        )
    found = {}
    for place, (name, factor) in enumerate(columns):
        numbers = table.values[:, place] * factor
        wrong = ~(np.abs(numbers) <= LARGEST[name])
        if wrong.any():
            row = int(np.argmax(wrong))
            told = f"{path}, line {int(table.line_numbers[row])}, column '{name}': "
            if np.isnan(numbers[row]):
                raise InputError(f"{told}the value is missing; remove the row, or measure it")
            raise InputError(
                f"{told}{table.values[row, place]:g} is not allowed; it must be between {-LARGEST[name] / factor:.6g} "
                f"and {LARGEST[name] / factor:.6g} in the unit of the column"
            )
        found[name] = numbers
    return found
