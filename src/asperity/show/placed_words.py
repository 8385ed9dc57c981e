"""Words in a picture where they cover no line, no point and no other words."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import numpy as np

from asperity.types import Document

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.transforms import Bbox

#: Parts into which a piece of a line is cut, to see whether words cover it.
_PIECES = 400
#: Room around words [pixels].
_PAD = 2.0


@dataclass
class PlacedWords:
    """The words of a panel, and what they must not cover; places are those of its data.

    The limits and the size of the panel must be final.
    """

    axes: Axes
    _points: list[np.ndarray] = field(default_factory=list)
    _boxes: list[Bbox] = field(default_factory=list)

    def keep_free(self, x: np.ndarray, y: np.ndarray) -> int:
        """Let no words cover a line through points, those that are finite; its number, to release it."""
        known = np.isfinite(x) & np.isfinite(y)
        ends = self.axes.transData.transform(np.column_stack([x[known], y[known]]))
        if len(ends) < 2:
            self._points.append(ends)
            return len(self._points) - 1
        along = np.linspace(0.0, len(ends) - 1.0, _PIECES * (len(ends) - 1) + 1)
        of = np.arange(len(ends))
        self._points.append(np.column_stack([np.interp(along, of, ends[:, axis]) for axis in (0, 1)]))
        return len(self._points) - 1

    def release(self, line: int) -> None:
        """Let words cover a line again."""
        self._points[line] = np.empty((0, 2))

    def place(self, words: str, candidates: Iterable[tuple[float, float, Document]]) -> bool:
        """Write words at the first of some places where they cover nothing; whether there was one.

        A candidate is a point of the data, and what :meth:`matplotlib.axes.Axes.annotate` takes besides.
        """
        for x, y, options in candidates:
            text = self.axes.annotate(words, (x, y), textcoords="offset points", **options)
            box = text.get_window_extent(self.axes.figure.canvas.get_renderer()).padded(_PAD)  # type: ignore[attr-defined]
            if self._is_free(box):
                self._boxes.append(box)
                return True
            text.remove()
        return False

    def _is_free(self, box: Bbox) -> bool:
        """Whether a box lies in the panel and covers nothing."""
        panel = self.axes.get_window_extent()
        inside = panel.x0 <= box.x0 and box.x1 <= panel.x1 and panel.y0 <= box.y0 and box.y1 <= panel.y1
        if not inside or any(box.overlaps(other) for other in self._boxes):
            return False
        for points in self._points:
            x, y = points[:, 0], points[:, 1]
            if np.any((x > box.x0) & (x < box.x1) & (y > box.y0) & (y < box.y1)):
                return False
        return True
