"""Axes inside a matrix of heights: a first row or column of positions; and heights that are wrapped to lines."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.text_columns import counts_up, is_ramp
from asperity.text_table.text_table import TextTable

#: Fewest points of a row or column that may be told to be an axis.
_FEWEST = 6
#: Rows of heights with which one that may be an axis is compared.
_COMPARED = 3
#: Heights are wrapped to lines where the step from the end of a line to the next one is at most so many times that
#: within a line (rms), and that between places below each other is at least so many times larger.
_SAME_STEP, _LARGER_STEP = 1.5, 2.0


@dataclass(frozen=True)
class MapAxes:
    """Heights of a map without its axes, in the unit of the file, rows and columns in the order of rising positions.

    ``x_step`` and ``y_step`` of the axes in their unit, None where there is none, or where it only numbers.
    """

    heights: NDArray[np.float64]
    x_step: float | None
    y_step: float | None
    notes: tuple[str, ...]


def map_axes(table: TextTable) -> MapAxes:
    """A matrix of heights without a first row or column that is an axis: one that advances evenly, as others do not.

    Whole numbers from 0 or 1 number the rows or columns. An ``InputError`` if the first row begins with text and is no
    axis.
    """
    values = table.values
    inside = values[1:, 1:]
    if _is_axis(values[0, 1:], inside) and _is_axis(values[1:, 0], inside.T):
        return _without_axes(inside, values[0, 1:], values[1:, 0])
    if table.corner:
        raise InputError(
            f"{table.source}: '{table.corner}' in line {int(table.line_numbers[0])} is not a number, and first row and "
            "first column are no even positions; a value that is missing is written nan"
        )
    if _is_axis(values[0], values[1:]):
        return _without_axes(values[1:], values[0], None)
    if _is_axis(values[:, 0], values[:, 1:].T):
        return _without_axes(values[:, 1:], None, values[:, 0])
    return MapAxes(values, None, None, ())


def _is_axis(line: NDArray[np.float64], others: NDArray[np.float64]) -> bool:
    """Whether numbers advance evenly, and those beside them do not all."""
    if line.size < _FEWEST or not is_ramp(line):
        return False
    return not all(is_ramp(other) for other in others[:_COMPARED])


def _without_axes(
    heights: NDArray[np.float64], x: NDArray[np.float64] | None, y: NDArray[np.float64] | None
) -> MapAxes:
    """The heights in the order of rising positions, and the steps."""
    steps: list[float | None] = []
    notes = []
    number = [line is None or counts_up(line) for line in (x, y)]  # where one axis has positions both have
    for axis, (name, positions) in enumerate((("column", y), ("row", x))):
        if positions is None:
            steps.append(None)
            continue
        step = float(positions[-1] - positions[0]) / (positions.size - 1)
        heights = np.flip(heights, axis) if step < 0.0 else heights
        numbers = all(number)
        steps.append(None if numbers else abs(step))
        what = (
            "numbers the points" if numbers else f"holds the positions {positions[0]:g} to {positions[-1]:g}"
        )
        notes.append(f"the first {name} {what}")
    return MapAxes(np.ascontiguousarray(heights), steps[1], steps[0], tuple(notes))


def refuse_wrapped(heights: NDArray[np.float64], source: str) -> None:
    """Raise if the rows of a matrix follow each other as one profile that is wrapped to lines.

    The step from the end of a line to the begin of the next is then like those within a line, while the heights below
    each other, which lie a line apart, differ by more. In a map it is the other way round.
    """
    with np.errstate(over="ignore", invalid="ignore"):
        within, below = (_rms(np.diff(heights, axis=axis)) for axis in (1, 0))
        between = _rms(heights[1:, 0] - heights[:-1, -1])
    if between <= _SAME_STEP * within and below >= _LARGER_STEP * within:
        rows, columns = heights.shape
        raise InputError(
            f"{source} holds {rows} lines of {columns} heights that follow each other as one profile wrapped to lines: "
            "save one height a line; a map that looks so is read with its positions in the first row and column"
        )


def _rms(values: NDArray[np.float64]) -> float:
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if known.size else np.inf
