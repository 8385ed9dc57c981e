"""Map of a sweep over two axes: filled contours with labelled lines, limits, and why a region has no result."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.errors import InputError, quoted
from asperity.results import RESULTS, known_result
from asperity.show.style import plain_number
from asperity.study.datasets import result_words, row_dimensions
from asperity.units import format_quantity, parse_quantity

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

_LEVELS = 9
_LOG_RATIO = 30.0
_FORBIDDEN_SIDE = -60.0  # ticks of a line point where its limit is violated [deg]
#: Colour and line of the limits, told apart without colours too; dark on every colour of the map.
_LINES = (
    ("#8c1515", "-"),
    ("#000000", "--"),
    ("#5b2a86", "-."),
    ("#7a4a00", ":"),
    ("#0b3d2e", (0, (6, 1, 1, 1))),
)
_HATCHES = ("///", "\\\\\\", "...", "xxx", "+++", "ooo")


@dataclass(frozen=True)
class MapLimit:
    """A limit [SI] of a result whose line a map shows."""

    name: str
    at_most: bool
    limit: float

    def text_of(self, data: xarray.Dataset) -> str:
        """The limit in words, as they are for the drive of a sweep."""
        sign, unit = "≤" if self.at_most else "≥", RESULTS[self.name].display_unit
        return f"{result_words(data, self.name)} {sign} {format_quantity(self.limit, unit)}"


def parse_limit(text: str) -> MapLimit:
    """The limit of a text ``NAME<=VALUE`` or ``NAME>=VALUE`` in the unit of the result; ``<`` and ``>`` mean the same.

    Examples
    --------
    >>> parse_limit("slip_ratio<=0.8")
    MapLimit(name='slip_ratio', at_most=True, limit=0.8)
    """
    match = re.fullmatch(r"\s*([a-z_0-9]+)\s*(<=|>=|<|>)\s*([^=\s].*?)\s*", text)
    if match is None:
        raise InputError(f"a limit is NAME<=VALUE or NAME>=VALUE, e.g. 'slip_ratio<=0.8', got {quoted(text)}")
    name = known_result(match[1], among=tuple(name for name, row in RESULTS.items() if not row.categories))
    try:
        value = parse_quantity(match[3], RESULTS[name].dimension)
    except InputError as error:
        raise InputError(f"limit of {name}: {error}") from None
    return MapLimit(name, match[2].startswith("<"), value)


def limits_of_the_model(data: xarray.Dataset) -> tuple[MapLimit, ...]:
    """The limits of function and damage by which the results of a sweep are judged."""
    limits = []
    for name in map(str, data.data_vars):
        limit = RESULTS[name].limit if name in RESULTS else None
        if limit is not None and limit.severity in ("function", "damage"):
            bounds = ((True, limit.highest), (False, limit.lowest))
            limits += [MapLimit(name, upper, bound) for upper, bound in bounds if np.isfinite(bound)]
    return tuple(limits)


def draw_map(
    figure: Figure,
    data: xarray.Dataset,
    *,
    x: np.ndarray,
    y: np.ndarray,
    values: np.ndarray,
    label: str,
    limits: Sequence[MapLimit],
    here: tuple[float, float] | None = None,
) -> Axes:
    """Draw a map."""
    from matplotlib import colormaps
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import BoundaryNorm
    from matplotlib.ticker import FuncFormatter

    panel = figure.subplots()
    panel.set_facecolor("0.92")
    known = values[np.isfinite(values)]
    if known.size and known.min() < known.max():
        levels = _levels(known)
        colours = colormaps["viridis"]
        norm = BoundaryNorm(levels, colours.N)
        shown = np.ma.masked_invalid(values)
        # cells below the contours, which end at the last points that have a value
        panel.pcolormesh(x, y, shown, shading="nearest", norm=norm, cmap=colours, rasterized=True)
        panel.contourf(x, y, shown, levels=levels, norm=norm, cmap=colours)
        lines = panel.contour(x, y, shown, levels=levels[1:-1], colors="white", linewidths=0.8)
        panel.clabel(lines, fmt=plain_number, fontsize="small")
        figure.colorbar(
            ScalarMappable(norm, colours),
            ax=panel,
            label=label,
            ticks=levels,
            format=FuncFormatter(plain_number),
        )
    elif known.size:
        panel.pcolormesh(x, y, np.ma.masked_invalid(values), shading="nearest", rasterized=True)
        panel.set_title(f"{label}: {known[0]:.4g} throughout", fontsize="small")
    keys = [*_hatch_failures(panel, data, x, y), *_draw_limits(panel, data, x, y, limits)]
    if here is not None:
        (point,) = panel.plot(
            *here, "o", color="C3", markersize=8, markeredgecolor="white", clip_on=False, zorder=5
        )
        point.set_label("the joint of the file")
        keys.append(point)
    if keys:
        figure.legend(handles=keys, loc="outside lower center", ncols=1, fontsize="small", frameon=False)
    panel.set_xlim(x.min(), x.max())
    panel.set_ylim(y.min(), y.max())
    return panel


def _levels(known: np.ndarray) -> np.ndarray:
    """Round values that enclose all others; in steps of a logarithm where they span more than a decade."""
    from matplotlib.ticker import LogLocator, MaxNLocator

    low, high = float(known.min()), float(known.max())
    if low > 0.0 and high > _LOG_RATIO * low:
        for steps in ((1.0, 2.0, 5.0), (1.0, 3.0), (1.0,)):
            # the locator leaves out what lies within the last decade but above all values
            levels = np.asarray(LogLocator(subs=steps, numticks=200).tick_values(0.1 * low, 10.0 * high))
            inner = levels[(levels > low) & (levels < high)]
            if inner.size <= 2 * _LEVELS:
                below, above = levels[levels <= low], levels[levels >= high]
                return np.concatenate([below[-1:], inner, above[:1]])
        return np.geomspace(low, high, _LEVELS)
    levels = np.asarray(MaxNLocator(_LEVELS, steps=[1, 2, 2.5, 5, 10]).tick_values(low, high))
    return levels[np.append(levels[1:] > low, True) & np.append(True, levels[:-1] < high)]


def _hatch_failures(panel: Axes, data: xarray.Dataset, x: np.ndarray, y: np.ndarray) -> Iterator[Any]:
    """Hatch the regions without a solution, one pattern for each reason."""
    from matplotlib.patches import Patch

    status = data["status"].values.T
    codes, reasons = data["status"].attrs.get("flag_values", ()), data["status"].attrs.get("reasons", ())
    meanings = dict(zip(np.asarray(codes).tolist(), reasons, strict=False))
    failed = [code for code in np.unique(status).tolist() if code != 0]
    for index, code in enumerate(failed):
        hatch = _HATCHES[index % len(_HATCHES)]
        cells = np.kron(status == code, np.ones((2, 2)))
        edges = (_cell_edges(x), _cell_edges(y))
        drawn = panel.contourf(*edges, cells, levels=[0.5, 1.5], colors=["none"], hatches=[hatch])
        drawn.set(edgecolor="0.35", linewidth=0.0)
        told = meanings.get(code, "no result")
        yield Patch(facecolor="0.92", edgecolor="0.35", hatch=hatch, label=f"no solution: {told}")


def _cell_edges(values: np.ndarray) -> np.ndarray:
    """Both edges of the cell around each value, half-way to its neighbours, as shading has them."""
    middles = 0.5 * (values[1:] + values[:-1])
    return np.repeat(np.concatenate([values[:1], middles, values[-1:]]), 2)[1:-1]


def _draw_limits(
    panel: Axes, data: xarray.Dataset, x: np.ndarray, y: np.ndarray, limits: Sequence[MapLimit]
) -> Iterator[Any]:
    """A line for each limit that the map crosses; its ticks point where the limit is violated."""
    solved = data["status"].values == 0
    drawn = 0
    for limit in limits:
        values = data[limit.name]
        rows = [name for name in row_dimensions(RESULTS[limit.name]) if name in values.dims]
        if rows:
            values = values.max(rows) if limit.at_most else values.min(rows)
        ordered = values.transpose(*data["status"].dims).values
        margin = np.where(solved, (1.0 if limit.at_most else -1.0) * (limit.limit - ordered), np.nan).T
        if not np.nanmin(margin, initial=np.inf) < 0.0 < np.nanmax(margin, initial=-np.inf):
            continue
        colour, style = _LINES[drawn % len(_LINES)]
        drawn += 1
        yield draw_limit(panel, x, y, margin, colour, style, label=limit.text_of(data))


def draw_limit(
    panel: Axes, x: np.ndarray, y: np.ndarray, margin: np.ndarray, colour: str, style: Any, *, label: str
) -> Line2D:
    """Draw the line where the margin of a limit is 0, with ticks where it is negative; its entry in a legend."""
    from matplotlib.lines import Line2D
    from matplotlib.patheffects import withTickedStroke

    line = panel.contour(x, y, margin, levels=[0.0], colors=[colour], linestyles=[style], linewidths=2.0)
    line.set_path_effects([withTickedStroke(angle=_FORBIDDEN_SIDE, spacing=9.0, length=0.6)])
    return Line2D([], [], color=colour, linestyle=style, linewidth=2.0, label=label)
