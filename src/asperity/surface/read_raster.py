"""Grids of numbers with their scale in a header or from the user: NanoFocus .nms and TIFF images."""

from __future__ import annotations

import struct
import warnings
from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.surface.input_file import metres_per_unit
from asperity.surface.topography import Topography

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

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            image = PIL.Image.open(path, formats=("TIFF",))
        except Exception as error:  # the parser raises whatever it meets
            raise InputError(f"{path.name} (TIFF) cannot be opened ({type(error).__name__})") from None
    with image:
        tags = getattr(image, "tag_v2", {})
        if _PARK_TAG in tags or "TiffTagDescData" in str(tags.get(_DESCRIPTION_TAG, "")):
            return None
        frames, bands = getattr(image, "n_frames", 1), len(image.getbands())
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
