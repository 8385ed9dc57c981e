"""A measured or generated height field: equally spaced heights in metres, missing points as NaN."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from asperity.errors import InputError


@dataclass(frozen=True)
class Topography:
    """Heights on an equally spaced line or grid.

    ``heights`` [m], shape (points,) for a profile or (rows, columns) for a map, rows along y, columns along x; NaN
    marks a point that the instrument did not measure. ``spacing``: distance of neighbouring points along x [m];
    ``spacing_across``: of neighbouring rows along y [m], None for a profile; ``source``: where the heights come from (a
    file name, a generator); ``notes``: what the reader or a later step found or changed.
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
                raise InputError(
                    f"the {name} of {self.source or 'a surface'} is {value} m; it must be positive"
                )
        if np.isinf(self.heights).any():
            raise InputError(
                f"{self.source or 'the surface'} holds infinite heights; mark missing points as NaN"
            )

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
        return np.arange(self.heights.shape[-1], dtype=np.float64) * self.spacing

    def with_heights(self, heights: NDArray[np.float64], note: str = "") -> Topography:
        """The same surface with other heights, and a note of what was done."""
        return replace(self, heights=heights, notes=(*self.notes, note) if note else self.notes)

    def profiles(self, *, direction: str) -> tuple[NDArray[np.float64], float]:
        """All parallel profiles along ``"x"`` or ``"y"``: array (profiles, points) and their spacing [m].

        An ``InputError`` if the direction is unknown, or ``"y"`` is requested of a single profile.
        """
        if direction == "x":
            return np.atleast_2d(self.heights), self.spacing
        if direction == "y" and self.spacing_across is not None:
            turned = np.empty(self.heights.T.shape)
            for start in range(0, len(self.heights), 8):  # in strips of a line of the cache
                turned[:, start : start + 8] = self.heights[start : start + 8].T
            return turned, self.spacing_across
        raise InputError(f"direction must be 'x' (or 'y', for a map), not '{direction}' ({self.source})")

    def cut(self, *, start: float, stop: float) -> Topography:
        """The part of a profile between two positions [m], both ends included.

        An ``InputError`` if this is a map, or fewer than two points lie between the ends.
        """
        if self.is_map:
            raise InputError(f"only a profile can be cut by position; {self.source} is a map")
        inside = (self.position >= start - 0.5 * self.spacing) & (self.position <= stop + 0.5 * self.spacing)
        if int(inside.sum()) < 2:
            raise InputError(
                f"no points of {self.source} between {start} m and {stop} m; it is {self.size[0]:.6g} m long"
            )
        return self.with_heights(self.heights[inside], f"cut to {start:.6g} .. {stop:.6g} m")


#: Treatments of missing points; none is applied unless chosen.
MISSING_CHOICES = ("refuse", "longest", "interpolate")
_RECTANGLE_CELLS = 400_000


def without_missing(topography: Topography, *, choice: str) -> Topography:
    """The surface without missing points, by an explicit choice; the notes say how many were dropped or filled.

    ``refuse`` raises if a point is missing. ``longest`` keeps of a profile its longest complete piece and of a map its
    largest complete rectangle. ``interpolate`` first fills the gaps inside each row by straight lines along x (never
    beyond the first and last measured point), then keeps the largest piece likewise.
    """
    if choice not in MISSING_CHOICES:
        raise InputError(f"missing points: choose one of {', '.join(MISSING_CHOICES)}, not '{choice}'")
    count = topography.missing_points
    if count == 0:
        return topography
    total = topography.heights.size
    if choice == "refuse":
        raise InputError(
            f"{count} of {total} points of {topography.source} are missing; keep the longest complete piece "
            "('longest') or fill gaps by straight lines ('interpolate')",
            options=["missing"],
        )
    rows = np.atleast_2d(topography.heights)
    filled = 0
    if choice == "interpolate":
        rows = rows.copy()
        filled = _fill_gaps(rows)
    complete = ~np.isnan(rows)
    if topography.is_map:
        top, bottom, left, right = _largest_rectangle(complete)
        kept = np.ascontiguousarray(rows[top:bottom, left:right])
    else:
        left, right = _longest_run(complete[0])
        kept = rows[0, left:right]
    if kept.size == 0 or kept.shape[-1] < 2:
        raise InputError(
            f"{topography.source} has no complete piece left ({count} of {total} points are missing)"
        )
    piece = " x ".join(str(n) for n in kept.shape)
    note = f"{count} of {total} points missing: filled {filled} along x, kept a complete piece of {piece}"
    return topography.with_heights(kept, note)


def _fill_gaps(rows: NDArray[np.float64]) -> int:
    """Fill gaps between measured points of each row in place; the number of points filled."""
    filled = 0
    column = np.arange(rows.shape[1])
    for row in rows:
        gap = np.isnan(row)
        if gap.any() and not gap.all():
            present = column[~gap]
            gap[: present[0]] = gap[present[-1] + 1 :] = False
            row[gap] = np.interp(column[gap], present, row[present])
            filled += int(gap.sum())
    return filled


def _largest_rectangle(complete: NDArray[np.bool_]) -> tuple[int, int, int, int]:
    """Largest rectangle of True: top, bottom, left, right (half open); on a coarse grid for large maps."""
    cell = max(1, int(np.ceil(np.sqrt(complete.size / _RECTANGLE_CELLS))))
    tall, wide = (n // cell for n in complete.shape)
    blocks = np.asarray(
        complete[: tall * cell, : wide * cell].reshape(tall, cell, wide, cell).all(axis=(1, 3))
    )
    best, area = (0, 0, 0, 0), 0
    height = np.zeros(wide, dtype=np.int64)
    for bottom, row in enumerate(list(blocks)):
        height = np.where(row, height + 1, 0)
        stack: list[tuple[int, int]] = []  # (left edge, height), heights rising
        for right, h in enumerate([*height.tolist(), 0]):
            left = right
            while stack and stack[-1][1] >= h:
                left, tallness = stack.pop()
                if tallness * (right - left) > area:
                    area = tallness * (right - left)
                    best = (bottom + 1 - tallness, bottom + 1, left, right)
            stack.append((left, h))
    top, bottom, left, right = (cell * edge for edge in best)
    return top, bottom, left, right


def _longest_run(flags: NDArray[np.bool_]) -> tuple[int, int]:
    """Half-open range of the longest run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(np.int8)))
    if edges.size == 0:
        return 0, 0
    starts, stops = edges[::2], edges[1::2]
    best = int(np.argmax(stops - starts))
    return int(starts[best]), int(stops[best])
