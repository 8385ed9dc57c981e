"""Reading measured surfaces: the format is found, the file read, and its sizes checked for plausibility."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from asperity.errors import InputError
from asperity.surface.input_file import LARGEST_SPAN, MEBIBYTE, checked_file, file_bytes
from asperity.surface.read_instrument import instrument_topography, text_format
from asperity.surface.read_text import looks_like_text, numpy_topography, text_topography
from asperity.surface.topography import Topography

#: Larger files are refused before they are opened [bytes].
LARGEST_FILE = 4096 * MEBIBYTE
#: A surface is expected to be longer and wider than the first and not larger than the second length [m].
EXPECTED_SIZES = (1e-6, 1.0)


def read_surface(
    *,
    path: str | Path,
    position_unit: str | None = None,
    height_unit: str | None = None,
    spacing: float | None = None,
    decimal: str = "auto",
    any_size: bool = False,
) -> Topography:
    """Profile or map from any supported file, heights and positions in metres; missing points are NaN and counted.

    Text (columns of numbers) and ``.npy`` are read without further packages; X3P, SDF, SUR, AL3D, OPD, OPDX, Zygo,
    FRT, TMD, NetCDF and some 35 more need the extra ``surface``. Units are needed only where the file does not name
    them, and refused where they contradict it; the spacing [m] for files that hold heights only. ``any_size`` accepts
    sizes outside :data:`EXPECTED_SIZES`, and heights larger than the longest side. Nothing is filled, levelled or
    filtered.
    """
    path = checked_file(path=path, largest=LARGEST_FILE)
    if spacing is not None and not (spacing > 0.0 and np.isfinite(spacing)):
        raise InputError(f"the spacing is {spacing} m; it must be a positive length")
    beginning = file_bytes(path=path, largest=LARGEST_FILE, first=4096)
    if beginning.startswith(b"\x93NUMPY"):
        topography = numpy_topography(path=path, height_unit=height_unit, spacing=spacing)
    elif looks_like_text(beginning) and text_format(beginning) is None:
        topography = text_topography(
            path=path,
            position_unit=position_unit,
            height_unit=height_unit,
            spacing=spacing,
            decimal=decimal,
        )
    else:
        topography = instrument_topography(path=path, beginning=beginning, height_unit=height_unit)
    if np.isnan(topography.heights).all():
        raise InputError(
            f"{path.name} holds no valid height: all {topography.heights.size} points are missing"
        )
    if topography.heights.shape[-1] < 2:
        raise InputError(f"{path.name} holds {topography.heights.size} point(s); a profile needs more")
    _check_plausibility(topography, any_size)
    return topography


def _check_plausibility(topography: Topography, any_size: bool) -> None:
    """Refuse sizes that a wrong unit explains better than a measured surface."""
    smallest, largest = EXPECTED_SIZES
    known = topography.heights[~np.isnan(topography.heights)]
    with np.errstate(over="ignore"):
        height = float(known.max() - known.min())
    if not height < LARGEST_SPAN:
        raise InputError(f"{topography.source}: its heights span {height:.3g} m, which cannot be evaluated")
    if any_size:
        return
    sizes = " x ".join(f"{size:.4g} m" for size in topography.size)
    if not all(smallest <= size <= largest for size in topography.size):
        fault = f"its size is {sizes}; expected are {smallest:g} m to {largest:g} m"
    elif height > max(topography.size):
        fault = f"its heights span {height:.4g} m on a size of {sizes}; expected is less than the size"
    else:
        return
    raise InputError(
        f"{topography.source}: {fault}. A unit is probably wrong, in the options, in the file or in its "
        "reader. If these sizes are right, allow any size",
        options=["any-size"],
    )
