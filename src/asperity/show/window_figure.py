"""The window of a joint as a picture: torques that it may pass over temperature or preload, and its loads."""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from asperity.results.limit_torques import SHOWN_ONLY
from asperity.results.window import Region, Window
from asperity.results.window_document import Stretch, borders, governing, verdict
from asperity.show.compliance_figure import FAIL_COLOUR, PASS_COLOUR
from asperity.show.placed_words import PlacedWords
from asperity.show.style import INK, MUTED, STYLE
from asperity.types import Document
from asperity.units import format_quantity, from_si

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Region that is allowed for all parts within their tolerances, and for some of them only.
_ALLOWED, _SOME, _CLOSED = "#bcd9ea", "#e1eef6", "#f2f2f2"
#: Panel in the figure, in parts of it: left, bottom, right, top, and the top below a second axis.
_PANEL, _BELOW_AXIS = (0.09, 0.11, 0.975, 0.81), 0.75
#: Of the highest border, the height of the panel.
_ROOM = 1.18
_SMALL = 8.5
_LINE = 40  # letters of a line of a label
#: Of the panel's height, by how much a limit must lie apart from the first one to have words of its own.
_APART = 0.03
#: Where words may stand beside a line: distance from it [points], with a thin line to it beyond the near ones, and
#: shares of its length.
_DISTANCES, _NEAR = (5, 10, 16, 26, 42, 60, 84), 16
_SHARES = (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9, 0.03, 0.97)


def window_figure(window: Window, *, title: str, width: float = 9.0) -> Figure:
    """The window on one sheet so wide [in]: what is allowed is shaded, every limit is written at its line."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context(STYLE):
        figure = Figure(figsize=(width, 0.62 * width))
        FigureCanvasAgg(figure)
        left, bottom, right, top = _PANEL
        top = _BELOW_AXIS if _has_second_axis(window) else top
        axes = figure.add_axes((left, bottom, right - left, top - bottom))
        _frame(axes, window)
        for region in window.regions:
            _draw_region(axes, window, region)
        _draw_loads(axes, window)
        words = PlacedWords(axes)
        _keep_free(words, window)
        _write_loads(words, window)
        for region in window.regions:
            _write_limits(words, window, region)
        said = verdict(window)
        figure.text(left, 0.955, title, fontsize=11, fontweight="bold", color=INK, va="top")
        figure.text(left, 0.862, _key(window), fontsize=_SMALL, color=MUTED, va="top")
        figure.text(
            left,
            0.912,
            _units(said["title"]),
            color=PASS_COLOUR if said["inside"] else FAIL_COLOUR,
            fontsize=10,
            va="top",
        )
    return figure


def _key(window: Window) -> str:
    """What the shades mean."""
    if not window.has_tolerances:
        return "blue: the joint passes the torque; grey: it passes none"
    return (
        "blue: all parts within their tolerances pass the torque; light blue: some do; grey: none is passed"
    )


def _units(text: str) -> str:
    """A text with its units as people write them."""
    return text.replace("degC", "°C").replace(" um", " µm").replace("N*m", "N·m")


def _shown(window: Window, at: np.ndarray) -> np.ndarray:
    """Places of the axis in its unit."""
    return np.array([from_si(float(place), window.axis.unit) for place in at])


def _signed(region: Region, torque: np.ndarray) -> np.ndarray:
    """Torques of a direction; nan where there is none."""
    return np.where(np.isfinite(torque), region.sign * torque, np.nan)


def _frame(axes: Axes, window: Window) -> None:
    """Range and names of both axes, and the preload along the top where an interference makes it."""
    ends = _shown(window, window.axis.places[[0, -1]])
    name = {"temperature": "working temperature [°C]", "load.preload": "preload [N]"}.get(
        window.axis.over if window.axis.over == "temperature" else window.axis.key, "interference [µm]"
    )
    axes.set(xlim=ends, xlabel=name, ylabel="torque at the output [N·m]")
    tops = [abs(judged.load.torque) for judged in window.loads]
    for sign in (1.0, -1.0):
        for region in window.regions:
            if region.sign == sign:
                tops += _finite(region.capacity.torque, region.greatest)
    high = _ROOM * max(tops, default=1.0)
    if high <= 0.0 or all(np.all(region.capacity.torque == 0.0) for region in window.regions):
        slips = [border.torque for region in window.regions for border in borders(window, region)]
        high = _ROOM * max([1e-9, *tops, *(max(_finite(slip)) for slip in slips)])
    signs = [region.sign for region in window.regions]
    axes.set_ylim(-high if -1.0 in signs else 0.0, high if 1.0 in signs else 0.0)
    if len(signs) > 1:
        axes.axhline(0.0, color=MUTED, linewidth=0.8, zorder=1)
    if _has_second_axis(window):
        at = _shown(window, window.at)
        top = axes.secondary_xaxis(
            "top",
            functions=(
                lambda x: _linear(np.asarray(x, dtype=float), at, window.preload),
                lambda force: _linear(np.asarray(force, dtype=float), window.preload, at),
            ),
        )
        top.set_xlabel("preload without torque [N]", fontsize=_SMALL)


def _has_second_axis(window: Window) -> bool:
    """Whether the preload is shown along the top, which an interference makes."""
    return window.axis.key == "load.interference" and bool(np.all(np.diff(window.preload) > 0.0))


def _linear(x: np.ndarray, known: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values between known ones, and beyond them on along the last lines."""
    inside = np.interp(x, known, values)
    first, last = (
        (values[b] - values[a]) / (known[b] - known[a]) for a, b in ((0, 1), (len(known) - 2, len(known) - 1))
    )
    below, above = values[0] + first * (x - known[0]), values[-1] + last * (x - known[-1])
    return np.where(x < known[0], below, np.where(x > known[-1], above, inside))


def _finite(*torques: np.ndarray | None) -> list[float]:
    return [0.0, *(float(t) for torque in torques if torque is not None for t in torque[np.isfinite(torque)])]


def _draw_region(axes: Axes, window: Window, region: Region) -> None:
    """What is allowed in one direction, shaded, with the lines of its limits; where nothing is, the ground is grey."""
    x, top = _shown(window, window.at), axes.get_ylim()[1 if region.sign > 0.0 else 0]
    capacity = np.where(np.isfinite(region.capacity.torque), region.sign * region.capacity.torque, top)
    if region.least is not None and region.greatest is not None:
        least, greatest = (
            np.where(np.isfinite(part), region.sign * part, top) for part in (region.least, region.greatest)
        )
        axes.fill_between(x, 0.0, greatest, color=_SOME, linewidth=0.0, zorder=0)
        axes.fill_between(x, 0.0, least, color=_ALLOWED, linewidth=0.0, zorder=0)
    else:
        axes.fill_between(x, 0.0, capacity, color=_ALLOWED, linewidth=0.0, zorder=0)
    for part in governing(window, region):
        if part.closed:
            axes.fill_between(
                _ends(window, part),
                0.0,
                top,
                color=_CLOSED,
                hatch="///",
                edgecolor="#d5d9dd",
                linewidth=0.0,
                zorder=0,
            )
    for border in borders(window, region):
        if border.limit in SHOWN_ONLY:
            axes.plot(x, _signed(region, border.torque), color=MUTED, linestyle="--", linewidth=1.2)
        else:
            axes.plot(x, _signed(region, border.torque), color=MUTED, linewidth=0.9, zorder=1.5)
    axes.plot(x, _signed(region, region.capacity.torque), color=INK, linewidth=2.0, zorder=2)


def _ends(window: Window, part: Stretch) -> np.ndarray:
    return _shown(window, window.at[[part.first, part.last]])


def _draw_loads(axes: Axes, window: Window) -> None:
    """The loads where the joint works."""
    at = from_si(window.axis.working, window.axis.unit)
    axes.axvline(at, color=INK, linestyle=":", linewidth=1.0, zorder=1.5)
    for judged in window.loads:
        inside = bool(judged.inside[window.working])
        axes.plot(
            at,
            judged.load.torque,
            marker=("s" if judged.load.stands else "o") if inside else "X",
            color=PASS_COLOUR if inside else FAIL_COLOUR,
            markeredgecolor="white",
            markersize=8.0,
            zorder=5,
            clip_on=False,
        )


def _keep_free(words: PlacedWords, window: Window) -> None:
    """Lines and points that no words may cover."""
    x, at = _shown(window, window.at), from_si(window.axis.working, window.axis.unit)
    for region in window.regions:
        words.keep_free(x, _signed(region, region.capacity.torque))
        for border in borders(window, region):
            words.keep_free(x, _signed(region, border.torque))
    words.keep_free(np.array([at, at]), np.array(words.axes.get_ylim()))
    for judged in window.loads:
        words.keep_free(np.array([at]), np.array([judged.load.torque]))


def _write_limits(words: PlacedWords, window: Window, region: Region) -> None:
    """What every limit is, at its line or in the part of the axis that it closes."""
    high = words.axes.get_ylim()[1 if region.sign > 0.0 else 0]
    parts = governing(window, region)
    for part in parts:
        if part.closed:
            _write_closed(words, window, part, high)
    named = set()
    for part in sorted(parts, key=lambda each: each.first - each.last):
        if not part.closed and part.meaning not in named:
            named.add(part.meaning)
            at = slice(part.first, part.last + 1)
            line = region.capacity.torque[at]
            words.place(_wrapped(part.meaning), _along(window, region, window.at[at], line, INK))
    for border in borders(window, region):
        apart = np.abs(border.torque - region.capacity.torque)
        seen = (border.torque > 0.0) & (border.torque < abs(high)) & (apart > _APART * abs(high))
        if border.meaning not in named and seen.any():
            named.add(border.meaning)
            line = np.where(seen, border.torque, np.inf)
            words.place(_wrapped(border.meaning), _along(window, region, window.at, line, MUTED))


def _write_closed(words: PlacedWords, window: Window, part: Stretch, high: float) -> None:
    """Why a part of the axis is closed, inside it."""
    start, end = _ends(window, part)
    options: Document = {
        "ha": "center",
        "va": "center",
        "xytext": (0, 0),
        "fontsize": _SMALL,
        "color": INK,
    }
    edges = [words.keep_free(np.array([edge, edge]), np.array([0.0, high])) for edge in (start, end)]
    for letters in (_LINE, 24, 16, 11):
        said = textwrap.fill(f"no torque is allowed: {part.meaning}", letters)
        places = (
            (start + along * (end - start), share * high, options)
            for share in (0.5, 0.62, 0.38, 0.75, 0.25, 0.88)
            for along in (0.5, 0.35, 0.65, 0.2, 0.8)
        )
        if words.place(said, places):
            break
    for edge in edges:
        words.release(edge)


def _wrapped(meaning: str) -> str:
    return textwrap.fill(meaning, _LINE)


def _along(
    window: Window, region: Region, at: np.ndarray, torque: np.ndarray, colour: str
) -> Iterator[tuple[float, float, Document]]:
    """Places beside a line, above and below it: near its middle first."""
    known = np.isfinite(torque) & (torque > 0.0)
    if not known.any():
        return
    x, y = _shown(window, at[known]), region.sign * torque[known]
    ends = _shown(window, window.axis.places[[0, -1]])
    inside = (x >= ends[0]) & (x <= ends[1])
    if not inside.any():
        return
    x, y = x[inside], y[inside]
    for side, distance, share in itertools.product((1.0, -1.0), _DISTANCES, _SHARES):
        place = x[0] + share * (x[-1] - x[0])
        for ha, shift in (("center", 0.0), ("left", 0.7), ("right", -0.7)):
            options: Document = {
                "xytext": (shift * distance, side * region.sign * distance),
                "ha": ha,
                "va": "bottom" if side * region.sign > 0.0 else "top",
                "fontsize": _SMALL,
                "color": colour,
            }
            if distance > _NEAR:
                options["arrowprops"] = {"arrowstyle": "-", "color": colour, "linewidth": 0.7}
            yield place, float(np.interp(place, x, y)), options


def _write_loads(words: PlacedWords, window: Window) -> None:
    """Names of the loads at their points, and where the joint works."""
    at = from_si(window.axis.working, window.axis.unit)
    low, high = words.axes.get_ylim()
    works = f"works at\n{format_quantity(window.axis.working, window.axis.unit)}".replace(
        "degC", "°C"
    ).replace("um", "µm")
    options: Document = {"fontsize": _SMALL, "color": INK, "va": "top"}
    words.place(
        works,
        (
            (at, low + share * (high - low), {**options, "ha": ha, "xytext": (shift, 0)})
            for share in (0.99, 0.9, 0.8, 0.7, 0.3, 0.2, 0.1)
            for ha, shift in (("left", 4), ("right", -4))
        ),
    )
    for judged in window.loads:
        name = judged.load.name.replace("output torque of the file", "torque of the file").replace(
            " of the duty", ""
        )
        name += f", {_units(format_quantity(abs(judged.load.torque), 'N*m'))}"
        name += ", standing" if judged.load.stands else ""
        colour = PASS_COLOUR if judged.inside[window.working] else FAIL_COLOUR
        words.place(
            name,
            (
                (
                    at,
                    judged.load.torque,
                    {"ha": ha, "va": "center", "xytext": (shift, dy), "fontsize": _SMALL, "color": colour},
                )
                for ha, shift in (("right", -8), ("left", 8))
                for dy in (0, 6, -6, 12, -12, 20, -20)
            ),
        )
