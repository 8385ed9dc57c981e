"""NumPy files of surfaces: a line or a grid of heights, or pairs of positions and heights."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError
from asperity.surface.stated import SAME_SPACING, Stated
from asperity.surface.text_columns import equal_spacing, is_ramp
from asperity.surface.topography import Topography


def numpy_topography(*, path: Path, stated: Stated) -> Topography:
    """Heights from an ``.npy`` file: a line or a grid of numbers whose unit and spacing are given.

    An array of shape (points, 2) or (2, points) of which one column or row advances evenly is a profile.
    """
    try:
        # a memory map: a header that promises more than the file holds reserves no memory
        array = np.load(path, allow_pickle=False, mmap_mode="r")
    except Exception as error:  # the parser of the header raises whatever it meets
        raise InputError(f"{path.name} is not a readable NumPy file ({_one_line(error)})") from None
    if array.ndim not in (1, 2) or array.dtype.kind not in "fiu" or min(array.shape) == 0:
        raise InputError(
            f"{path.name} holds an array {array.shape} of {array.dtype}; a line or grid of real numbers is needed"
        )
    if stated.column is not None:
        raise InputError(
            f"{path.name} is an array, which has no column '{stated.column}'; do not state it",
            options=["column"],
        )
    topography = _topography(array, stated, path)
    return topography.with_heights(topography.heights, stated.unused_decimal())


def _topography(array: NDArray[Any], stated: Stated, path: Path) -> Topography:
    """The surface that an array of numbers holds."""
    if array.ndim == 2 and 2 in array.shape and max(array.shape) > 3:
        pairs = np.array(array if array.shape[1] == 2 else array.T, dtype=np.float64)
        ramps = [is_ramp(pairs[:, j]) for j in (0, 1)]
        if any(ramps):
            return _profile(pairs if ramps[0] else pairs[:, ::-1], stated, path.name)
    height = stated.metres("height")
    if height is None or stated.spacing is None:
        raise InputError(
            f"{path.name} contains numbers without units: give the unit of its heights, such as um, and the distance "
            "of its points, such as '0.5 um'",
            options=["height-unit", "spacing"],
        )
    heights, notes = without_mark(np.array(array, dtype=np.float64), stated)
    with np.errstate(over="ignore", invalid="ignore"):
        heights = heights * height
    across = stated.spacing if heights.ndim == 2 else None
    if stated.position_unit is not None:
        notes = (*notes, "the stated unit of the positions is not used: the array has none")
    return Topography(heights, stated.spacing, across, source=path.name, notes=notes)


def without_mark(heights: NDArray[np.float64], stated: Stated) -> tuple[NDArray[np.float64], tuple[str, ...]]:
    """Numbers without those that the user states to mark missing points, and notes of how many there were."""
    notes = []
    for mark in stated.missing_marks():
        missing = heights == mark
        heights = np.where(missing, np.nan, heights)
        notes.append(f"{int(missing.sum())} numbers {mark:g} mark missing points")
    return heights, tuple(notes)


def _profile(pairs: NDArray[np.float64], stated: Stated, source: str) -> Topography:
    """A profile of positions and heights, an array of shape (points, 2)."""
    height, unit = stated.metres("height"), stated.metres("position")
    if height is None or (unit is None and stated.spacing is None):
        raise InputError(
            f"{source} holds pairs of numbers of which one advances evenly, positions and heights: give the units of "
            "both, such as mm and um",
            options=["position-unit", "height-unit"],
        )
    step, rounded = equal_spacing(pairs[:, 0], source)
    spacing = abs(step) * unit if unit is not None else stated.spacing
    assert spacing is not None
    if stated.spacing is not None and abs(spacing - stated.spacing) > SAME_SPACING * spacing:
        raise InputError(
            f"{source}: its positions give a distance of the points of {spacing:.6g} m, not {stated.spacing:.6g} m; do "
            "not state it",
            options=["spacing"],
        )
    heights, notes = without_mark(pairs[:, 1], stated)
    heights = np.ascontiguousarray(heights[::-1] if step < 0.0 else heights) * height
    said = tuple(
        filter(None, (rounded, "pairs of numbers, of which one advances evenly, read as a profile", *notes))
    )
    return Topography(heights, spacing, source=source, notes=said)


def _one_line(error: Exception) -> str:
    text = " ".join(str(error).split()) or type(error).__name__
    return text if len(text) <= 120 else text[:117] + "..."
