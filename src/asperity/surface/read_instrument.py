"""Instrument formats: NanoFocus and TIFF by themselves, others through SurfaceTopography, checked by their headers."""

from __future__ import annotations

import logging
import struct
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.extras import optional_module
from asperity.surface.file_formats import FORMATS, FileFormat, metres_per_unit
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


_HEADER_BYTES = 3468
_PARK_TAG, _DESCRIPTION_TAG = 50432, 270


def nanofocus_topography(*, path: Path) -> Topography:
    """Heights [m] of a NanoFocus .nms file; points without light are NaN.

    The header has the range of the numbers and of the heights [um], the version, the points and the length of a
    pixel [nm]; then the numbers, rows along y, and their intensities.

    References
    ----------
    The header as read by musurf-reader (D. Mendroch) and surfalize, which agree that the length is in nm.
    """
    content = path.read_bytes()
    if len(content) < _HEADER_BYTES or content[32:41] != b"OM_MS_2.0" or content[:8:4] != b"\2\1":
        raise InputError(
            f"{path.name} is no NanoFocus map of version OM_MS_2.0 with 16-bit heights, the only one that is known; "
            "export it as X3P or text"
        )
    lowest, highest, bottom, top = struct.unpack_from("<iidd", content, 8)
    columns, rows, width, height = struct.unpack_from("<iidd", content, 1368)
    points = columns * rows
    (has_intensity,) = struct.unpack_from("<i", content, 1416)
    expected = _HEADER_BYTES + (3 if has_intensity > 0 else 2) * points
    if min(columns, rows) < 1 or len(content) < expected or highest <= lowest:
        raise InputError(
            f"{path.name}: its header speaks of {columns} x {rows} points, {expected} bytes, and numbers from {lowest} "
            f"to {highest}; it has {len(content)} bytes and is damaged"
        )
    counts = np.frombuffer(content, "<u2", points, _HEADER_BYTES).astype(np.float64)
    heights = 1e-6 * (bottom + (top - bottom) / (highest - lowest) * (counts - lowest))
    if has_intensity > 0:
        heights[np.frombuffer(content, np.uint8, points, _HEADER_BYTES + 2 * points) == 0] = np.nan
    return Topography(heights.reshape(rows, columns), 1e-9 * width, 1e-9 * height, source=path.name)


def tiff_topography(*, path: Path, height_unit: str | None, spacing: float | None) -> Topography | None:
    """Heights of a grey TIFF image: its numbers times the stated height of one count, pixels ``spacing`` apart.

    None if it holds heights in tags of Park Systems or Olympus, beside its image.
    """
    import PIL.Image

    with open(path, "rb") as stream, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            image = PIL.Image.open(stream, formats=("TIFF",))
            tags = getattr(image, "tag_v2", {})
            if _PARK_TAG in tags or "TiffTagDescData" in str(tags.get(_DESCRIPTION_TAG, "")):
                return None
            frames, bands = getattr(image, "n_frames", 1), len(image.getbands())
        except Exception as error:  # the parser raises whatever it meets
            raise InputError(f"{path.name} (TIFF) cannot be opened ({type(error).__name__})") from None
        if frames > 1 or bands > 1 or image.mode in ("1", "P"):
            raise InputError(
                f"{path.name} has {frames} image(s) of {bands} channel(s), mode {image.mode}; one grey image, whose "
                "numbers are heights, is read"
            )
        if height_unit is None or spacing is None:
            raise InputError(
                f"{path.name} contains grey levels without units: give the height of one level, such as '1.5 nm' (or "
                "the unit, if the numbers are heights), and the distance of its pixels, such as '0.5 um'",
                options=["height-unit", "spacing"],
            )
        try:
            numbers = np.asarray(image, dtype=np.float64)
        except Exception as error:
            raise InputError(
                f"{path.name} (TIFF) cannot be read ({type(error).__name__}); save it without compression"
            ) from None
    return Topography(numbers * metres_per_unit(height_unit), spacing, spacing, source=path.name)
