"""The oil in the contacts of a joint as a picture: traction capacity and share of the asperities over speed."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.results.film_document import FilmOverSpeed
from asperity.rolling.conditions import ZERO_CELSIUS
from asperity.show.placed_words import PlacedWords
from asperity.show.style import INK, MUTED, STYLE, mark_few_decades, plain_number
from asperity.types import Document

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_RPM = 30.0 / math.pi
_SMALL = 8.5
#: A colour for each contact, a line for each temperature.
_COLOURS = (INK, "#2f7fb8", "#d9730d", "#2f8f5b", "#8e5ea2")
_LINES: tuple[Any, ...] = ("-", "--", ":", "-.", (0, (1, 3)), (0, (8, 2, 1, 2)))
#: Field of the curves and factor, and what stands at the axis.
_PANELS = (
    ("traction_capacity", 1.0, "largest traction T/N [-]"),
    ("asperity_share", 100.0, "load on the asperities [%]"),
)
#: Of the height of a panel, by how much the curves of two contacts differ that count as one.
_ALIKE = 0.02
#: Of the height of a panel, how far a point lies from other curves that is certainly of its own.
_APART = 0.1
#: Where words may stand beside a point of a line: distances from it [points], and sides, across and up.
_DISTANCES = (3, 7, 13)
_SIDES = ((0, 1), (0, -1), (1, 1), (1, -1), (-1, 1), (-1, -1), (1, 0), (-1, 0))


def film_figure(film: FilmOverSpeed, *, title: str, width: float = 9.0) -> Figure:
    """Stribeck curves on one sheet so wide [in]: every line says its contact and the temperature of its oil."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context(STYLE):
        figure = Figure(figsize=(width, 0.86 * width))
        FigureCanvasAgg(figure)
        panels = figure.subplots(2, 1, sharex=True)
        figure.subplots_adjust(left=0.09, right=0.975, top=0.9, bottom=0.075, hspace=0.1)
        figure.text(0.09, 0.965, title, fontsize=11, fontweight="bold", color=INK, va="top")
        figure.text(0.09, 0.93, _key(film), fontsize=_SMALL, color=MUTED, va="top")
        groups = _groups(film)
        for axes, (name, factor, label) in zip(panels, _PANELS, strict=True):
            _draw(axes, film, groups, name, factor)
            axes.set_ylabel(label)
        panels[-1].set_xlabel("speed of the input [rpm]")
        for axes, (name, factor, _) in zip(panels, _PANELS, strict=True):
            _write(axes, film, groups, name, factor)
    return figure


def _key(film: FilmOverSpeed) -> str:
    """What colours and lines mean."""
    lines = "; line styles: temperatures of the oil" if len(film.curves) > 1 else ""
    return f"colours: contacts{lines}; dotted upright: speed of the file; gaps: no steady rolling"


def _groups(film: FilmOverSpeed) -> list[list[int]]:
    """Numbers of the contacts, those together whose curves lie on each other in both panels."""
    groups: list[list[int]] = []
    for contact in range(len(film.contact_names)):
        alike = [group for group in groups if _are_alike(film, group[0], contact)]
        if alike:
            alike[0].append(contact)
        else:
            groups.append([contact])
    return groups


def _are_alike(film: FilmOverSpeed, one: int, other: int) -> bool:
    """Whether the curves of two contacts can hardly be told apart."""
    for name, _, _ in _PANELS:
        values = [getattr(curves, name) for curves in film.curves]
        height = max((float(np.nanmax(each)) for each in values if np.isfinite(each).any()), default=1.0)
        if any(np.any(np.abs(each[one] - each[other]) > _ALIKE * height) for each in values):
            return False
    return True


def _draw(axes: Axes, film: FilmOverSpeed, groups: list[list[int]], name: str, factor: float) -> None:
    """The curves of one panel, and the speed of the file."""
    from matplotlib.ticker import FuncFormatter

    for curves, line in zip(film.curves, _LINES, strict=False):
        for group, colour in zip(groups, itertools.cycle(_COLOURS), strict=False):
            for contact in group:
                values = factor * getattr(curves, name)[contact]
                axes.plot(_RPM * curves.input_speed, values, color=colour, linestyle=line, linewidth=1.6)
    speeds = _RPM * film.curves[0].input_speed
    axes.set_xscale("log")
    axes.set_xlim(float(speeds[0]), float(speeds[-1]))
    axes.xaxis.set_major_formatter(FuncFormatter(plain_number))
    mark_few_decades(axes.xaxis, float(speeds[0]), float(speeds[-1]))
    values = [factor * getattr(curves, name) for curves in film.curves]
    known = np.concatenate([each[np.isfinite(each)] for each in values])
    axes.set_ylim(0.0, 1.15 * float(known.max()) if known.size and known.max() > 0.0 else 1.0)
    if film.here.input_speed[0] > 0.0:
        axes.axvline(
            _RPM * float(film.here.input_speed[0]), color=MUTED, linestyle=":", linewidth=1.0, zorder=1
        )


def _write(axes: Axes, film: FilmOverSpeed, groups: list[list[int]], name: str, factor: float) -> None:
    """What every line is, at the line."""
    words, speed = PlacedWords(axes), _RPM * film.curves[0].input_speed
    lines = [
        (curves.temperature, style, group, colour, factor * getattr(curves, name)[group[0]])
        for curves, style in zip(film.curves, _LINES, strict=False)
        for group, colour in zip(groups, itertools.cycle(_COLOURS), strict=False)
    ]
    for *_, values in lines:
        words.keep_free(speed, values)
    unlabelled = []
    for number, (temperature, style, group, colour, values) in enumerate(lines):
        contacts = ", ".join(film.contact_names[contact].replace("_", " ") for contact in group)
        said = f"{contacts} at {temperature - ZERO_CELSIUS:.4g} °C"
        others = [other for k, (*_, other) in enumerate(lines) if k != number]
        free = _most_apart(values, others, _APART * axes.get_ylim()[1])
        if not words.place(said, _beside(speed[free], values[free], colour)):
            unlabelled.append((said, colour, style))
    _legend(axes, unlabelled)


def _most_apart(values: np.ndarray, others: list[np.ndarray], enough: float) -> list[int]:
    """Numbers of the points of a curve, those first that lie far enough from all others, and of these the middle."""
    known = np.flatnonzero(np.isfinite(values))
    apart = np.full(values.shape, enough)
    for other in others:
        apart = np.fmin(apart, np.abs(values - other))
    middle = float(np.mean(known)) if known.size else 0.0
    return sorted(known.tolist(), key=lambda at: (-float(apart[at]), abs(at - middle)))


def _beside(x: np.ndarray, y: np.ndarray, colour: str) -> Iterator[tuple[float, float, Document]]:
    """Places beside points: above, below, and on both sides; those close to the line first, at whatever point."""
    for distance, (at, height) in itertools.product(_DISTANCES, zip(x, y, strict=True)):
        for across, up in _SIDES:
            options: Document = {
                "xytext": (across * 2 * distance, up * distance),
                "ha": {-1: "right", 0: "center", 1: "left"}[across],
                "va": {-1: "top", 0: "center", 1: "bottom"}[up],
                "fontsize": _SMALL,
                "color": colour,
            }
            yield float(at), float(height), options


def _legend(axes: Axes, lines: list[tuple[str, str, Any]]) -> None:
    """The lines at which there was no room for words."""
    from matplotlib.lines import Line2D

    if lines:
        keys = [Line2D([], [], color=colour, linestyle=line, label=said) for said, colour, line in lines]
        axes.legend(handles=keys, fontsize=_SMALL - 1.0, loc="best", ncols=2)
