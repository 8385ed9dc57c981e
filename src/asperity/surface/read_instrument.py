"""Instrument formats through the package SurfaceTopography, checked against the header of the file."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.surface.file_formats import FORMATS, FileFormat
from asperity.surface.input_file import metres_per_unit
from asperity.surface.topography import Topography

#: Largest relative difference between sizes of the reader and of the header.
_SIZE_TOLERANCE = 1e-3


def instrument_topography(
    *, path: Path, beginning: bytes, known: FileFormat, height_unit: str | None
) -> Topography:
    """Heights of an instrument file in metres; a unit for formats that do not store one."""
    if not beginning.strip(b"\0"):
        raise InputError(
            f"{path.name} begins with {len(beginning)} zeros: it is no surface file, or a damaged one"
        )
    if known.export:
        raise InputError(f"{path.name} is {known.title}, which is not read: {known.export}")
    reader, measured, heights = _opened(path, known.name)
    header = _sdf_size(path) if known.name == "SDF" else None
    topography = _in_metres(reader, measured, heights, height_unit, path.name)
    if header is not None:
        for got, stated in zip(topography.size, header, strict=False):
            if not abs(got - stated) <= _SIZE_TOLERANCE * abs(stated):
                raise InputError(
                    f"{path.name}: the reader of {known.name} files gives a size of {got:.6g} m where the header "
                    f"of the file says {stated:.6g} m; the file is not used"
                )
    return topography


def _opened(path: Path, name: str) -> tuple[Any, Any, NDArray[np.float64]]:
    """Reader, topography and heights in the unit of the file."""
    import logging
    import warnings

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        needs = f"{path.name} ({name}) is neither a table of numbers nor .npy, so it needs"
        SurfaceTopography = optional_module("SurfaceTopography", extra="surface", needs=needs)
    logging.getLogger("SurfaceTopography").setLevel(logging.ERROR)
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            reader = SurfaceTopography.open_topography(str(path))
            if reader.format() not in {
                name for known in FORMATS if known.reader for name in known.package.split()
            }:
                raise InputError(
                    f"{path.name} ({name}) cannot be read: its format is not known; export it as X3P or text"
                )
            if not reader.channels:
                raise InputError(f"{path.name} ({name}) has no channel of heights, whose unit is a length")
            measured = reader.topography()
            heights = np.ma.filled(np.ma.asarray(measured.heights(), dtype=np.float64), np.nan)
            sizes = measured.physical_sizes
        except InputError:
            raise
        except Exception as error:  # the readers raise whatever their parsers meet
            if "CannotDetect" in type(error).__name__:
                why = "its format is not known, or this variant of it is not"
            else:
                why = f"this variant is not understood ({_reason(error)})"
            raise InputError(
                f"{path.name} ({name}) cannot be read: {why}; export it as X3P or text"
            ) from None
    if sizes is None or not all(np.isfinite(size) and size > 0.0 for size in sizes):
        raise InputError(f"{path.name} ({name}): its size is {sizes or 'not given'}; it must be positive")
    return reader, measured, heights


def _reason(error: Exception) -> str:
    kind, text = type(error).__name__, " ".join(str(error).split()).rstrip(".")
    return kind if not text or len(text) > 120 else f"{kind}: {text}"


def _in_metres(
    reader: Any, measured: Any, heights: NDArray[np.float64], height_unit: str | None, source: str
) -> Topography:
    unitless = {name for known in FORMATS if known.stated for name in known.package.split()}
    unit = None if reader.format() in unitless else measured.unit
    if unit is None:
        if height_unit is None:
            raise InputError(
                f"{source} does not name the unit of its lengths and heights; state it: mm, um, nm or m",
                options=["height-unit"],
            )
        unit = height_unit
    elif height_unit is not None and metres_per_unit(height_unit) != metres_per_unit(unit):
        raise InputError(
            f"{source} gives its unit as {unit}, not {height_unit}; do not state a unit",
            options=["height-unit"],
        )
    scale = metres_per_unit(unit)
    channels = len(reader.channels)
    notes = (f"the file has {channels} channels; the default one was read",) if channels > 1 else ()
    with np.errstate(over="ignore", invalid="ignore"):
        heights = heights * scale
    if measured.dim == 2:
        (length_x, length_y), (columns, rows) = measured.physical_sizes, measured.nb_grid_pts
        return Topography(
            np.ascontiguousarray(heights.T),
            float(length_x) * scale / columns,
            float(length_y) * scale / rows,
            source=source,
            notes=notes,
        )
    if not measured.is_uniform:
        raise InputError(f"{source}: positions are not equally spaced; resample the profile first")
    spacing = float(measured.physical_sizes[0]) * scale / heights.shape[0]
    return Topography(np.ascontiguousarray(heights), spacing, source=source, notes=notes)


def _sdf_size(path: Path) -> tuple[float, float] | None:
    """Lengths along x and y from the header of an SDF file [m] (ISO 25178-71)."""
    with path.open("rb") as file:
        head = file.read(4096)
    try:
        if head.startswith(b"b"):
            columns, rows, step_x, step_y = struct.unpack_from("<HHdd", head, 42)
        else:
            lines = (line.split("=", 1) for line in head.decode("latin-1").splitlines() if "=" in line)
            field = {key.strip().lower(): value.strip() for key, value in lines}
            columns, rows = int(field["numpoints"]), int(field["numprofiles"])
            step_x, step_y = float(field["xscale"]), float(field["yscale"])
    except (struct.error, KeyError, ValueError):
        return None  # the reader says what is wrong with it
    return columns * step_x, rows * step_y
