"""Wear of a joint as a picture: preload, torque capacity and drift over time, with both ends."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from asperity.errors import InputError
from asperity.results.wear_document import WearOverLife
from asperity.show.style import ACCENT, INK, MARK, MUTED, STYLE
from asperity.types import Document
from asperity.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ARCMINUTES = 10800.0 / math.pi
_SMALL = 8.5


def wear_figure(found: WearOverLife, *, title: str, width: float = 9.0) -> Figure:
    """Preload, torque of the first slide and drift over hours, or over k t without a coefficient; so wide [in].

    An ``InputError`` where the force of the joint stays.
    """
    if found.wear.course is None:
        raise InputError(
            "the preload stays, as a cam or a force follows the wear, so that there is no course to draw; ask for no "
            "picture",
            options=["plot"],
        )
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context(STYLE):
        figure = Figure(figsize=(width, 0.92 * width))
        FigureCanvasAgg(figure)
        panels = figure.subplots(3, 1, sharex=True)
        figure.subplots_adjust(left=0.1, right=0.915, top=0.9, bottom=0.075, hspace=0.12)
        figure.text(0.1, 0.97, title, fontsize=11, fontweight="bold", color=INK, va="top")
        figure.text(0.1, 0.935, _key(found), fontsize=_SMALL, color=MUTED, va="top")
        time, label = _time(found)
        _forces(panels[0], found, time)
        _capacity(panels[1], found, time)
        _drift(panels[2], found, time)
        panels[2].set_xlabel(label)
        panels[2].set_xlim(0.0, 1.02 * float(time[-1]))
        _mark_ends(panels, found)
    return figure


def _key(found: WearOverLife) -> str:
    """Under which load, and with which coefficient."""
    loads = found.wear.loads
    under = f"{loads[0][0]:.4g} N·m" if len(loads) == 1 else f"a duty of {len(loads)} loads"
    k = (
        "k t: wear coefficient times time"
        if found.coefficient is None
        else f"k = {found.coefficient:.3g} 1/Pa"
    )
    return f"under {under}; {k}; upright: ends"


def _time(found: WearOverLife) -> tuple[np.ndarray, str]:
    """The axis of time with its label."""
    course = found.wear.course
    assert course is not None
    if found.coefficient is None:
        return course.coefficient_time, "wear coefficient times time [s/Pa]"
    return course.coefficient_time / found.coefficient / 3600.0, "time [h]"


def _forces(axes: Axes, found: WearOverLife, time: np.ndarray) -> None:
    """Preload, with the interference at its right side."""
    course = found.wear.course
    assert course is not None
    axes.plot(time, course.preload, color=ACCENT)
    axes.set(ylabel="preload [N]")
    axes.set_ylim(0.0, 1.1 * float(course.preload.max()))
    right = axes.twinx()
    right.plot(time, 1e6 * course.interference, color=MUTED, linewidth=1.2, linestyle="--")
    right.set_ylabel("interference [µm], dashed", color=MUTED)
    right.set_ylim(0.0, 1.1e6 * float(course.interference.max()))
    right.grid(False)
    right.spines["right"].set_visible(True)


def _capacity(axes: Axes, found: WearOverLife, time: np.ndarray) -> None:
    """Torque at which the first contact slides, and the torques that the joint passes."""
    course = found.wear.course
    assert course is not None
    known = np.isfinite(course.capacity)
    torques = [abs(load[0]) for load in found.wear.loads]
    if known.any():
        axes.plot(time[known], course.capacity[known], color=ACCENT, marker="o", markersize=3.0)
    for torque in torques:
        axes.axhline(torque, color=MUTED, linewidth=1.0, linestyle=":")
    _note(axes, max(torques), "torque at the output" if len(torques) == 1 else "torques of the duty")
    axes.set(ylabel="first contact slides at [N·m]")
    axes.set_ylim(0.0, 1.15 * max([*torques, *course.capacity[known].tolist()]))


def _drift(axes: Axes, found: WearOverLife, time: np.ndarray) -> None:
    """Drift by creep, and by the worn radii."""
    course = found.wear.course
    assert course is not None
    axes.plot(time, _ARCMINUTES * course.drift, color=ACCENT, label="by creep")
    axes.plot(time, _ARCMINUTES * course.size_drift, color=MUTED, linestyle="--", label="by worn radii")
    axes.set(ylabel="drift [arcmin per turn]")
    axes.legend(loc="upper left", fontsize=_SMALL)


def _mark_ends(panels: np.ndarray, found: WearOverLife) -> None:
    """Both ends, named above the first panel's floor, and the life that is asked for."""
    scale = 1.0 if found.coefficient is None else 1.0 / found.coefficient / 3600.0
    ends = [("first contact slides", found.wear.first_slide), ("nothing left", found.wear.nothing_left)]
    unit = "s/Pa" if found.coefficient is None else "h"
    marks: list[tuple[float, str, str]] = []
    for words, end in ends:
        if end is not None:
            contact = f" ({found.wear.contact_names[end.contact]})" if end.contact >= 0 else ""
            at = end.coefficient_time * scale
            marks.append((at, f"{words}{contact}: {format_quantity(at, '1')} {unit}", MARK))
    life = found.life_time
    if life is not None and life * scale <= panels[0].get_xlim()[1]:
        marks.append((life * scale, f"required life: {format_quantity(life * scale, '1')} {unit}", INK))
    first = min((at for at, _, _ in marks), default=0.0)
    for row, (at, words, colour) in enumerate(sorted(marks, reverse=True)):
        for axes in panels:
            axes.axvline(at, color=colour, linewidth=1.0, zorder=1)
        _beside(panels[0], first, 0.06 + 0.11 * row, words, colour)


def _beside(axes: Axes, x: float, height: float, words: str, colour: str) -> None:
    """Words at the left of an upright line, so high in the panel [-]."""
    options: Document = {"ha": "right", "va": "bottom", "fontsize": _SMALL, "color": colour}
    axes.annotate(
        words,
        (x, height),
        xycoords=axes.get_xaxis_transform(),
        xytext=(-4, 0),
        textcoords="offset points",
        **options,
    )


def _note(axes: Axes, y: float, words: str) -> None:
    """Words above a level line, at its begin."""
    axes.annotate(words, (0.0, y), xytext=(4, 3), textcoords="offset points", fontsize=_SMALL, color=MUTED)
