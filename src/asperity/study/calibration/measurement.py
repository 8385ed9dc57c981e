"""Measured torque–angle, stiffness and drift curves from CSV files whose column names state the units."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from asperity.errors import InputError, nearest
from asperity.reading import read_text
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

    ``torque`` at the output, of either sign [N·m]; ``angle`` of the output with the sun locked [rad], incremental
    ``stiffness`` [N·m/rad] or ``drift``, the angle lost in one turn of the output while the joint rolls, with the sign
    of the torque [rad]: exactly one of them is there, the others are None. ``time`` [s] or None; ``repetition``: number
    of the repetition of each row, zeros if the file states none; ``source``: name of the file; ``unloaded_ratio``:
    speed ratio without creep with which the drift was derived from measured speed ratios [-], None otherwise.
    """

    torque: np.ndarray
    angle: np.ndarray | None
    stiffness: np.ndarray | None
    time: np.ndarray | None
    repetition: np.ndarray
    source: str
    drift: np.ndarray | None = None
    unloaded_ratio: float | None = None

    @property
    def measured(self) -> np.ndarray:
        """The angle, the stiffness or the drift, whichever is there."""
        return next(column for column in (self.angle, self.stiffness, self.drift) if column is not None)

    @property
    def quantity(self) -> MeasuredQuantity:
        """What :attr:`measured` is."""
        return _DRIFT if self.drift is not None else _ANGLE if self.angle is not None else _STIFFNESS


def _column(header: str) -> tuple[str, float]:
    """Name of a column and the factor to SI units: ``torque [N*m]``, ``torque_Nm``, ``stiffness_Nm_per_arcmin``."""
    plain = re.sub(r"^(\s*speed)[ _]+(loss|ratio)", r"\1 \2", header, flags=re.IGNORECASE)
    match = re.fullmatch(
        r"\s*([A-Za-z]+(?: (?:loss|ratio))?)\s*(?:[\[(](.*)[\])]|_(\S+))?\s*", plain, re.IGNORECASE
    )
    name = match[1].lower() if match else header.strip()
    if match is None or name not in COLUMNS:
        raise InputError(f"column '{header}'{nearest(name, COLUMNS) or '; known are ' + ', '.join(COLUMNS)}")
    dimension = COLUMNS[name]
    if dimension is None:
        return name, 1.0
    unit = (match[2] if match[2] is not None else match[3]) or ""
    if match[3]:
        unit = re.sub(r"\bNm\b|\bNm(?=/)", "N*m", unit.replace("_per_", "/"))
    if not unit.strip():
        if dimension is Dimension.DIMENSIONLESS:
            return name, 1.0
        raise InputError(
            f"column '{header}' states no unit, e.g. '{name} [{dimension.example.split(' ', 1)[1]}]'"
        )
    try:
        if name == "drift" and re.search(r"/\s*(turn|rev)", unit):
            return name, 2.0 * np.pi * parse_quantity(f"1 {unit}", Dimension.DIMENSIONLESS)
        return name, parse_quantity(f"1 {unit}", dimension)
    except InputError as error:
        raise InputError(f"column '{header}': {error}") from None


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


def _cells(path: str | Path, number: int, line: str, delimiter: str) -> list[str]:
    try:
        return next(csv.reader([line], delimiter=delimiter, strict=True))
    except csv.Error as error:
        raise InputError(f"{path}, line {number}: not a row of a CSV table: {error}") from None


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
    """A measured curve in SI units from a CSV file; an ``InputError`` with line and column if something cannot be read.

    Columns: ``torque`` and one of ``angle``, ``stiffness``, ``drift`` (angle lost per output turn), ``speed loss``,
    ``speed ratio`` (input over output; needs the ratio of the joint without creep); optionally ``time`` and
    ``repetition``. Units stand in the header, ``torque [N*m]`` or ``torque_Nm``. Rows in the order of time; lines that
    begin with ``#`` are comments.
    """
    text = read_text(path, largest=LARGEST_FILE)
    lines = list(enumerate(io.StringIO(text, newline=""), 1))
    lines = [(number, line) for number, line in lines if line.strip() and not line.startswith("#")]
    if not lines:
        raise InputError(f"{path}: the file is empty")
    if len(lines) > MOST_ROWS + 1:
        raise InputError(
            f"{path}: {len(lines) - 1} rows; at most {MOST_ROWS} are allowed, so reduce their number"
        )
    delimiter = ";" if ";" in lines[0][1] else ","
    rows = [_cells(path, number, line, delimiter) for number, line in lines]
    try:
        columns = [_column(header) for header in rows[0]]
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
    numbers = np.empty((len(rows) - 1, len(columns)))
    for index, (row, (line, _)) in enumerate(zip(rows[1:], lines[1:], strict=True)):
        if len(row) != len(columns):
            raise InputError(f"{path}, line {line}: {len(row)} values for {len(columns)} columns")
        for place, (text, (name, factor)) in enumerate(zip(row, columns, strict=True)):
            try:
                numbers[index, place] = float(text) * factor
            except ValueError:
                raise InputError(
                    f"{path}, line {line}, column '{name}': '{text.strip()}' is not a number"
                ) from None
            if not np.isfinite(numbers[index, place]):
                raise InputError(f"{path}, line {line}, column '{name}': '{text.strip()}' is not finite")
            if abs(numbers[index, place]) > LARGEST[name]:
                raise InputError(
                    f"{path}, line {line}, column '{name}': {text.strip()} is not allowed; it must be between "
                    f"{-LARGEST[name] / factor:.6g} and {LARGEST[name] / factor:.6g} in the unit of the column"
                )
    if len(numbers) < FEWEST_ROWS:
        raise InputError(f"{path}: needs at least {FEWEST_ROWS} rows of numbers, got {len(numbers)}")
    by_name = {name: numbers[:, place] for place, name in enumerate(names)}
    _refuse_constant(path, by_name)
    time, stiffness = by_name.get("time"), by_name.get("stiffness")
    if time is not None and np.any(np.diff(time) < 0.0):
        line = lines[int(np.argmax(np.diff(time) < 0.0)) + 2][0]
        raise InputError(f"{path}, line {line}: time runs backwards; rows must be in the order of time")
    if stiffness is not None and np.any(stiffness <= 0.0):
        line = lines[int(np.argmax(stiffness <= 0.0)) + 1][0]
        raise InputError(
            f"{path}, line {line}: the stiffness {stiffness[stiffness <= 0.0][0]:g} must be positive"
        )
    return Measurement(
        torque=by_name["torque"],
        angle=by_name.get("angle"),
        stiffness=stiffness,
        time=time,
        repetition=by_name.get("repetition", np.zeros(len(numbers))),
        source=str(path),
        drift=_drift(path, by_name, unloaded_ratio),
        unloaded_ratio=unloaded_ratio if "speed ratio" in by_name else None,
    )
