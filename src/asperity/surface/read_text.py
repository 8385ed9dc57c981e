"""Text files of surfaces: profiles and maps as columns of numbers, whatever the line ends and separators."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.file_formats import MEBIBYTE, file_bytes
from asperity.surface.instrument_text import instrument_text_topography, is_instrument_text
from asperity.surface.map_axes import map_axes, refuse_wrapped
from asperity.surface.stated import Stated, with_its_sizes
from asperity.surface.text_columns import Columns, columns_of, equal_spacing, is_ramp, kind_of
from asperity.surface.text_scales import KNOWN_KEYS, Scales
from asperity.surface.topography import Topography
from asperity.text_table.decoding import decoded
from asperity.text_table.headings import Heading, heading_of
from asperity.text_table.text_table import TextTable, text_table

#: Largest text file that is read [bytes].
LARGEST_TEXT = 512 * MEBIBYTE


def text_topography(*, path: Path, stated: Stated) -> Topography:
    """Profile or map in metres from a text file of numbers; missing values are NaN.

    The rules are those of :doc:`/reading_files`: columns by their names, units by their headings, what other lines
    state, and what the user states, held against each other.

    An ``InputError`` if something is missing, not understood, or contradicts something else, with the line.

    References
    ----------
    NIST, *Acceptable Data Format*, pml.nist.gov/VSC, and NPL's softgauges: one column that begins with the spacing.
    """
    text = decoded(file_bytes(path=path, largest=LARGEST_TEXT), source=path.name)
    if is_instrument_text(text):
        return with_its_sizes(
            instrument_text_topography(text, path=path), stated, path, "text of an instrument"
        )
    if text.startswith("DSAA"):
        raise InputError(f"{path.name} is a grid of Surfer, whose sizes are not read; export it as x, y, z")
    table = text_table(text, source=path.name, decimal=stated.decimal)
    columns = columns_of(table, stated.column)
    scales = Scales(table, stated)
    if columns.heights is None:
        topography = _map(table, scales)
    elif columns.y is not None and columns.x is not None:
        topography = _grid(table, columns, columns.x, columns.y, scales)
    elif columns.x is not None:
        topography = _profile(table, columns, columns.x, scales)
    else:
        topography = _heights_alone(table, columns.heights, scales)
    return dataclasses.replace(
        topography, notes=(*topography.notes, *columns.notes, *table.left_out(KNOWN_KEYS))
    )


def _scaled(
    scales: Scales, column: int, heights: NDArray[np.float64], heading: Heading | None = None
) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """Heights in metres without the marks of missing ones, and notes; by another ``heading`` than the column's."""
    heights, marked = scales.without_marks(heights)
    known = heights[np.isfinite(heights)]
    metres, words = scales.unit("height", column, heading, whole=bool(np.all(known == np.round(known))))
    return heights * metres, (words, *marked)


def _measured(
    table: TextTable, columns: Columns, scales: Scales
) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """The column of heights in metres, missing where the flag says so, and notes."""
    assert columns.heights is not None
    heights, notes = _scaled(scales, columns.heights, table.values[:, columns.heights])
    if columns.flag is None:
        return heights, notes
    flags = table.values[:, columns.flag]
    wrong = ~np.isin(flags, (0.0, 1.0)) & ~np.isnan(flags)
    if wrong.any():
        row = int(np.argmax(wrong))
        raise InputError(
            f"{table.source}: line {int(table.line_numbers[row])} has the flag {flags[row]:g} in column "
            f"{columns.flag + 1} '{table.headings[columns.flag].text}'; it must be 0 or 1"
        )
    return np.where(flags == columns.valid, heights, np.nan), notes


def _topography(
    heights: NDArray[np.float64], steps: Sequence[float], table: TextTable, notes: Sequence[str]
) -> Topography:
    """A profile of one step, or a map of two, along x and y [m]."""
    said = tuple(note for note in notes if note)
    across = steps[1] if len(steps) == 2 else None
    return Topography(np.ascontiguousarray(heights), steps[0], across, source=table.source, notes=said)


def _profile(table: TextTable, columns: Columns, place: int, scales: Scales) -> Topography:
    """A profile of positions and heights."""
    positions = table.values[:, place]
    scales.refuse_other_counts(len(positions), 1)
    heights, notes = _measured(table, columns, scales)
    if table.first_gap and not is_ramp(positions):
        raise InputError(
            f"{table.source}: line {table.first_gap} between the rows is empty, and the positions do not go on behind "
            "it: two profiles have to be saved in two files"
        )
    step, rounded = equal_spacing(positions, table.source)
    (spacing,), words = scales.steps((place,), (abs(step),), (len(positions),))
    return _topography(heights[::-1] if step < 0.0 else heights, (spacing,), table, (rounded, words, *notes))


def _grid(table: TextTable, columns: Columns, x_column: int, y_column: int, scales: Scales) -> Topography:
    """A full grid from rows of x, y, z in any order."""
    places, source = table.values[:, (x_column, y_column)], table.source
    if not np.isfinite(places).all():
        raise InputError(f"{source}: a column of positions has missing values")
    x, column = np.unique(places[:, 0], return_inverse=True)
    y, row = np.unique(places[:, 1], return_inverse=True)
    if x.size < 2 or y.size < 2 or len(places) > x.size * y.size or len(places) < 0.5 * x.size * y.size:
        raise InputError(
            f"{source}: three columns are read as x, y, z of a grid, but {len(places)} rows do not fill "
            f"{x.size} by {y.size} places"
        )
    measured, notes = _measured(table, columns, scales)
    heights = np.full((y.size, x.size), np.nan)
    heights[row, column] = measured
    if np.unique(row * x.size + column).size < len(places):
        raise InputError(f"{source}: the grid has two heights at one place; save one measurement a file")
    steps = tuple(equal_spacing(axis, source)[0] for axis in (x, y))
    spacings, words = scales.steps((x_column, y_column), steps, (x.size, y.size))
    return _topography(heights, spacings, table, (words, *notes))


def _map(table: TextTable, scales: Scales) -> Topography:
    """A map whose rows are lines of the file."""
    if table.first_gap:
        raise InputError(
            f"{table.source}: line {table.first_gap} between the rows is empty: two maps in one file, or a row that is "
            "missing; save one map a file"
        )
    _refuse_lines_inside(table)
    axes = map_axes(table)
    scales.refuse_other_counts(*axes.heights.shape)
    if axes.x_step is None and axes.y_step is None and not scales.state_a_map:
        refuse_wrapped(axes.heights, table.source)
    corner = heading_of(table.corner)
    names_heights = corner.unit is not None and kind_of(corner) == "z"
    if names_heights and re.search(r"[,;&\\]|/\s*\w+\s*[\[(]", table.corner):
        raise InputError(
            f"{table.source}: the corner '{table.corner}' names heights and positions; write the units of both in "
            "lines of their own: 'z unit: um' and 'xy unit: mm'"
        )
    heights, notes = _scaled(scales, 0, axes.heights, corner if names_heights else None)
    corner = heading_of("") if names_heights else corner
    spacings, words = scales.map_steps(axes.x_step, axes.y_step, axes.heights.shape, corner)
    unused = scales.unused() if axes.x_step is None and axes.y_step is None else ()
    return _topography(heights, spacings, table, (*words, *axes.notes, *notes, *unused))


def _refuse_lines_inside(table: TextTable) -> None:
    """Raise if comments stand between heights without positions: a second surface may begin there."""
    if table.inside:
        raise InputError(
            f"{table.source}: {table.inside[0]} stands between the heights: if another profile or map begins there, "
            "save it in a file of its own; if not, remove the line"
        )


def _heights_alone(table: TextTable, column: int, scales: Scales) -> Topography:
    """A profile of heights, one a line; or a map whose numbers of rows and columns the file states."""
    values, spacing = table.values[:, column], scales.stated.spacing
    if table.first_gap:
        raise InputError(
            f"{table.source}: line {table.first_gap} between the heights is empty: one that is missing is written nan; "
            "two profiles have to be saved in two files"
        )
    _refuse_lines_inside(table)
    first = ""
    if table.width == 1 and values[0] == len(values) - 1:
        first = f"the first number, {values[0]:g}, counts the points, and is no height"
        values = values[1:]
    heights, notes = _scaled(scales, column, values)
    if (
        not first
        and table.width == 1
        and spacing is not None
        and np.isclose(heights[0], spacing, rtol=1e-9, atol=0.0)
    ):
        first = "the first number is the spacing, as in text files of NIST and NPL, and no height"
        heights = heights[1:]
    shape = scales.grid_shape(len(heights))
    if shape is not None:
        spacings, more = scales.map_steps(None, None, shape, heading_of(""))
        stated = f"heights one a line, {shape[0]} rows of {shape[1]} as the file states"
        return _topography(heights.reshape(shape), spacings, table, (*more, stated, first, *notes))
    scales.refuse_other_counts(len(heights), 1)
    step, words = scales.step("x", len(heights), None)
    step = spacing if step is None else step
    if step is None:
        raise scales.no_spacing()
    return _topography(heights, (step,), table, (first, words, *notes, *scales.unused()))
