"""A measured or generated height field: equally spaced heights in metres, missing points as NaN."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError


@dataclass(frozen=True)
class Topography:
    """Heights on an equally spaced line or grid.

    Attributes
    ----------
    heights : array, shape (points,) for a profile or (rows, columns) for a map
        Height [m]; NaN marks a point that the instrument did not measure. Rows run along y, columns along x.
    spacing : float
        Distance of neighbouring points along x [m].
    spacing_across : float or None
        Distance of neighbouring rows along y [m]; None for a profile.
    source : str
        Where the heights come from (a file name, a generator).
    notes : tuple of str
        What the reader or a later step found or did, in words.
    """

    heights: NDArray[np.float64]
    spacing: float
    spacing_across: float | None = None
    source: str = ""
    notes: tuple[str, ...] = field(default=())

    def __post_init__(self) -> None:
        if self.heights.ndim not in (1, 2):
            raise InputError(
                f"heights must be a line or a grid, not an array with {self.heights.ndim} axes ({self.source})"
            )
        if self.heights.ndim == 2 and self.spacing_across is None:
            raise InputError(f"a map needs the distance of its rows, spacing_across ({self.source})")
        for name, value in (("spacing", self.spacing), ("spacing_across", self.spacing_across)):
            if value is not None and not (np.isfinite(value) and value > 0.0):
                raise InputError(f"the {name} of {self.source or 'a surface'} is {value} m; it must be positive")
        if np.isinf(self.heights).any():
            raise InputError(f"{self.source or 'the surface'} holds infinite heights; mark missing points as NaN")

    @property
    def is_map(self) -> bool:
        """Whether the heights form a grid (True) or a single line (False)."""
        return self.heights.ndim == 2

    @property
    def missing_points(self) -> int:
        """Number of points without a height."""
        return int(np.isnan(self.heights).sum())

    @property
    def size(self) -> tuple[float, ...]:
        """Evaluation length, or length along x and along y [m]: points times spacing."""
        if self.spacing_across is None:
            return (self.heights.shape[0] * self.spacing,)
        return (self.heights.shape[1] * self.spacing, self.heights.shape[0] * self.spacing_across)

    @property
    def position(self) -> NDArray[np.float64]:
        """Position of the points along x [m], starting at zero, shape (points,) or (columns,)."""
        return np.arange(self.heights.shape[-1]) * self.spacing

    def with_heights(self, heights: NDArray[np.float64], note: str = "") -> Topography:
        """The same surface with other heights, and a note of what was done."""
        return replace(self, heights=heights, notes=(*self.notes, note) if note else self.notes)

    def profiles(self, *, direction: str) -> tuple[NDArray[np.float64], float]:
        """All parallel profiles along ``"x"`` or ``"y"``: array (profiles, points) and their spacing [m].

        Raises
        ------
        InputError
            If the direction is unknown, or ``"y"`` is asked of a single profile.
        """
        if direction == "x":
            return np.atleast_2d(self.heights), self.spacing
        if direction == "y" and self.spacing_across is not None:
            return np.ascontiguousarray(self.heights.T), self.spacing_across
        raise InputError(f"direction must be 'x' (or 'y', for a map), not '{direction}' ({self.source})")

    def cut(self, *, start: float, stop: float) -> Topography:
        """The part of a profile between two positions [m], both ends included.

        Raises
        ------
        InputError
            If this is a map, or fewer than two points lie between the ends.
        """
        if self.is_map:
            raise InputError(f"only a profile can be cut by position; {self.source} is a map")
        inside = (self.position >= start - 0.5 * self.spacing) & (self.position <= stop + 0.5 * self.spacing)
        if int(inside.sum()) < 2:
            raise InputError(
                f"no points of {self.source} between {start} m and {stop} m; it is {self.size[0]:.6g} m long"
            )
        return self.with_heights(self.heights[inside], f"cut to {start:.6g} .. {stop:.6g} m")


#: What may be done with missing points; none of these happens unless asked for.
MISSING_CHOICES = ("refuse", "longest", "interpolate")


def without_missing(topography: Topography, *, choice: str) -> Topography:
    """The surface without missing points, by an explicit choice.

    Parameters
    ----------
    topography : Topography
        Surface that may have missing points.
    choice : {"refuse", "longest", "interpolate"}
        ``refuse`` raises if a point is missing. ``longest`` keeps of a profile its longest complete piece and of
        a map its largest block of complete neighbouring rows. ``interpolate`` fills gaps along x by straight
        lines and drops rows of a map whose ends, or more than half of whose points, are missing.

    Returns
    -------
    Topography
        Without NaN; the notes say how many points were dropped or filled.

    Raises
    ------
    InputError
        If points are missing and the choice is ``refuse``, or nothing usable is left.
    """
    if choice not in MISSING_CHOICES:
        raise InputError(f"missing points: choose one of {', '.join(MISSING_CHOICES)}, not '{choice}'")
    count = topography.missing_points
    if count == 0:
        return topography
    total = topography.heights.size
    if choice == "refuse":
        raise InputError(
            f"{count} of {total} points of {topography.source} are missing; say what to do with them: keep the "
            "longest complete piece (--missing longest) or fill gaps by straight lines (--missing interpolate)"
        )
    rows = np.atleast_2d(topography.heights)
    absent = np.isnan(rows)
    if choice == "longest":
        complete = ~absent[0] if not topography.is_map else ~absent.any(axis=1)
        first, last = _longest_run(complete)
        if last - first < 2:
            raise InputError(f"{topography.source} has no complete piece left ({count} of {total} points are missing)")
        kept = topography.heights[first:last]
        note = f"{count} of {total} points missing: kept the longest complete piece, {kept.size} points"
        return topography.with_heights(kept, note)
    usable = ~absent[:, 0] & ~absent[:, -1] & (absent.mean(axis=1) <= 0.5)
    if not usable.any():
        raise InputError(
            f"no row of {topography.source} can be filled: ends or more than half of the points are missing"
        )
    first, last = _longest_run(usable)
    filled = rows[first:last].copy()
    column = np.arange(rows.shape[1])
    for row, gap in zip(filled, absent[first:last], strict=True):
        if gap.any():
            row[gap] = np.interp(column[gap], column[~gap], row[~gap])
    note = (
        f"{count} of {total} points missing: filled {int(absent[first:last].sum())} by straight lines along x, "
        f"dropped {rows.shape[0] - (last - first)} rows"
    )
    return topography.with_heights(filled if topography.is_map else filled[0], note)


def _longest_run(flags: NDArray[np.bool_]) -> tuple[int, int]:
    """Half-open range of the longest run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    if edges.size == 0:
        return 0, 0
    starts, stops = edges[::2], edges[1::2]
    best = int(np.argmax(stops - starts))
    return int(starts[best]), int(stops[best])


def each_profile(topographies: list[Topography], *, direction: str) -> Iterator[tuple[NDArray[np.float64], float]]:
    """Profiles and spacing of every surface of a list, in turn."""
    for topography in topographies:
        yield topography.profiles(direction=direction)
