"""Measured torque–angle and stiffness–torque curves from CSV files whose column names state the units."""

from __future__ import annotations

import csv
import io
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.joint_file.messages import nearest
from asperity.reading import read_text
from asperity.unit_table import Dimension
from asperity.units import format_quantity, parse_quantity

COLUMNS = {
    "torque": Dimension.TORQUE,
    "angle": Dimension.ANGLE,
    "stiffness": Dimension.TORSIONAL_STIFFNESS,
    "time": Dimension.TIME,
    "repetition": None,
}

#: Largest size that a number of a column may have, in SI units: beyond it a unit or a column is wrong.
LARGEST = {"torque": 1e9, "angle": 1e3, "stiffness": 1e15, "time": 1e12, "repetition": 1e9}

#: Largest file [byte].
LARGEST_FILE = 50_000_000
#: Rows of numbers a file must and may have.
FEWEST_ROWS, MOST_ROWS = 2, 200_000


@dataclass(frozen=True)
class Measurement:
    """A measured curve in SI units, rows in the order of time.

    Parameters
    ----------
    torque : ndarray
        Output torque, of either sign, shape (points,) [N·m].
    angle : ndarray or None
        Output angle with the sun locked, shape (points,) [rad].
    stiffness : ndarray or None
        Incremental stiffness, shape (points,) [N·m/rad]. Exactly one of angle and stiffness is there.
    time : ndarray or None
        Time, shape (points,) [s].
    repetition : ndarray
        Number of the repetition of each row, shape (points,); zeros if the file states none.
    source : str
        Name of the file.
    """

    torque: np.ndarray
    angle: np.ndarray | None
    stiffness: np.ndarray | None
    time: np.ndarray | None
    repetition: np.ndarray
    source: str

    @property
    def measured(self) -> np.ndarray:
        """The angle or the stiffness, whichever is there."""
        found = self.angle if self.angle is not None else self.stiffness
        assert found is not None
        return found


def _column(header: str) -> tuple[str, float]:
    """Name of a column and the factor to SI units: ``torque [N*m]``, ``torque_Nm``, ``stiffness_Nm_per_arcmin``."""
    match = re.fullmatch(r"\s*([A-Za-z]+)\s*(?:[\[(](.*)[\])]|_(\S+))?\s*", header)
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
        raise InputError(
            f"column '{header}' states no unit, e.g. '{name} [{dimension.example.split(' ', 1)[1]}]'"
        )
    try:
        return name, parse_quantity(f"1 {unit}", dimension)
    except InputError as error:
        raise InputError(f"column '{header}': {error}") from None


def _refuse_constant(path: str | Path, columns: dict[str, np.ndarray]) -> None:
    """Torques or angles of a curve that never change: a sensor that was not connected, or a wrong column."""
    for name, unit in (("torque", "N*m"), ("angle", "arcmin")):
        if "angle" in columns and np.ptp(columns[name]) == 0.0:
            raise InputError(
                f"{path}: all {len(columns[name])} rows have the {name} {format_quantity(columns[name][0], unit)}; "
                "a curve needs different ones, so check the column and its unit"
            )


def _cells(path: str | Path, number: int, line: str, delimiter: str) -> list[str]:
    try:
        return next(csv.reader([line], delimiter=delimiter, strict=True))
    except csv.Error as error:
        raise InputError(f"{path}, line {number}: not a row of a CSV table: {error}") from None


def read_measurement(path: str | Path) -> Measurement:
    """Read a measured curve.

    Parameters
    ----------
    path : str or Path
        A CSV file with a header: ``torque`` and ``angle``, or ``torque`` and ``stiffness``; optionally ``time`` and
        ``repetition``. Units stand in the header, ``torque [N*m]`` or ``torque_Nm``. Rows in the order of time; lines
        that begin with ``#`` are comments.

    Returns
    -------
    Measurement
        In SI units.

    Raises
    ------
    InputError
        With line and column, if something cannot be read.
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
    if "torque" not in names or ("angle" in names) == ("stiffness" in names):
        raise InputError(
            f"{path}: needs the columns 'torque' and either 'angle' or 'stiffness', got {', '.join(names)}"
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
    )
