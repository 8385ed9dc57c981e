"""The accuracy of a joint as a picture: orders, one turn of the output as a curve, and as a polar picture."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.results.accuracy_document import AccuracyOfJoint
from asperity.rolling.accuracy import Component
from asperity.show.placed_words import PlacedWords
from asperity.show.style import ACCENT, INK, MARK, MUTED, STYLE

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_ARCSECONDS = 648000.0 / math.pi
_SMALL = 8.5
_COLOURS = (INK, "#2f7fb8", "#d9730d", "#2f8f5b", "#8e5ea2", "#b0457b", "#7a6a1f")
#: So many of the largest orders have their names.
_NAMED = 8
#: Where the name of a harmonic may stand: how far from the end of its line, to the right and up [points], and on which
#: side of that.
_BESIDE = ((0, 5, "center"), (6, -3, "left"), (-6, -3, "right"), (0, 15, "center"))
#: Smaller transmission errors than this share of the largest are those of rounding.
_NOTHING = 1e-6


def accuracy_figure(accuracy: AccuracyOfJoint, *, title: str, width: float = 10.0) -> Figure:
    """Spectrum, curve and polar picture of the transmission error on one sheet so wide [in]."""
    from matplotlib import rc_context
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    with rc_context(STYLE):
        figure = Figure(figsize=(width, 0.78 * width))
        FigureCanvasAgg(figure)
        figure.text(0.07, 0.97, title, fontsize=11, fontweight="bold", color=INK, va="top")
        figure.text(0.07, 0.938, _key(accuracy), fontsize=_SMALL, color=MUTED, va="top")
        spectrum = figure.add_axes((0.07, 0.56, 0.9, 0.34))
        turn = figure.add_axes((0.07, 0.075, 0.50, 0.375))
        polar = figure.add_axes((0.70, 0.055, 0.26, 0.35), projection="polar")
        _spectrum(spectrum, accuracy)
        _turn(turn, accuracy)
        _polar(polar, accuracy)
    return figure


def _key(accuracy: AccuracyOfJoint) -> str:
    """What the picture shows besides the axes."""
    error = accuracy.forward.transmission_error
    unknown = any(one.error.phase is None for one in accuracy.forward.components)
    phases = "; the turn has a phase of 0 where none is stated" if unknown else ""
    return (
        f"transmission error of the {accuracy.output.replace('_', ' ')}: worst {float(error.worst) * _ARCSECONDS:.3g}, "
        f"rms {float(error.rms) * _ARCSECONDS:.3g} arcsec{phases}"
    )


def _spectrum(axes: Axes, accuracy: AccuracyOfJoint) -> None:
    """Transmission errors over their orders, a colour for each part."""
    components = accuracy.forward.components
    largest = max((abs(one.transmission_error) for one in components), default=0.0)
    shown = [one for one in components if abs(one.transmission_error) > _NOTHING * largest]
    parts = list(dict.fromkeys(one.error.part for one in components))
    for number, part in enumerate(parts):
        of_part = [one for one in shown if one.error.part == part]
        colour = _COLOURS[number % len(_COLOURS)]
        axes.vlines(
            [one.order for one in of_part],
            0.0,
            [_arcseconds(one) for one in of_part],
            color=colour,
            linewidth=2.0 + 0.9 * (len(parts) - number),  # parts of one order stand behind each other
            label=part.replace("_", " "),
        )
        axes.plot(
            [one.order for one in of_part],
            [_arcseconds(one) for one in of_part],
            linestyle="none",
            marker="o",
            markersize=3.0 + 0.9 * (len(parts) - number),
            color=colour,
        )
    axes.set_xlim(0.0, 1.06 * max((one.order for one in components), default=1.0))
    axes.set_ylim(0.0, 1.25 * largest * _ARCSECONDS if largest > 0.0 else 1.0)
    axes.set_xlabel(f"order: waves per turn of the {accuracy.output.replace('_', ' ')}")
    axes.set_ylabel("amplitude of each [arcsec]")
    axes.legend(fontsize=_SMALL, loc="upper right", ncols=2)
    _named(axes, shown)


def _named(axes: Axes, components: list[Component]) -> None:
    """The harmonics with the largest errors, each once, above their lines or beside their ends."""
    words = PlacedWords(axes)
    for one in components:
        words.keep_free(np.full(2, one.order), np.array([0.0, _arcseconds(one)]))
    told: set[tuple[str, int]] = set()
    for one in sorted(components, key=lambda each: -abs(each.transmission_error)):
        key = (one.error.part, one.error.harmonic)
        if key in told or len(told) == _NAMED:
            continue
        told.add(key)
        words.place(
            str(one.error.harmonic),
            (
                (
                    one.order,
                    _arcseconds(one),
                    {"xytext": (aside, above), "ha": align, "fontsize": _SMALL, "color": INK},
                )
                for aside, above, align in _BESIDE
            ),
        )


def _arcseconds(component: Component) -> float:
    return abs(component.transmission_error) * _ARCSECONDS


def _turn(axes: Axes, accuracy: AccuracyOfJoint) -> None:
    """One turn of the output: transmission error, and the force of the contact that it changes most."""
    turn = accuracy.over_turn
    degrees = np.degrees(turn.angle)
    axes.plot(degrees, turn.transmission_error * _ARCSECONDS, color=ACCENT, linewidth=1.1)
    axes.set_xlim(0.0, 360.0)
    axes.set_xticks(range(0, 361, 60))
    axes.set_xlabel("angle of the output [°]")
    axes.set_ylabel("transmission error [arcsec]", color=ACCENT)
    swings = np.ptp(turn.normal, axis=0)
    most = int(np.argmax(swings))
    beside = axes.twinx()
    beside.plot(degrees, turn.normal[:, most], color=MARK, linewidth=0.8, alpha=0.55)
    beside.set_ylabel(
        f"normal force of {accuracy.forward.contact_names[most].replace('_', ' ')} [N]", color=MARK
    )
    beside.grid(visible=False)
    beside.spines["right"].set_visible(True)
    axes.set_zorder(beside.get_zorder() + 1)
    axes.patch.set_visible(False)


def _polar(axes: Any, accuracy: AccuracyOfJoint) -> None:
    """The transmission error round the output, about the circle of steady rotation."""
    turn = accuracy.over_turn
    error = turn.transmission_error * _ARCSECONDS
    most = float(np.max(np.abs(error)))
    scale = most if most > 0.0 else 1.0
    axes.plot(turn.angle, np.zeros_like(error), color=MUTED, linewidth=0.9)
    axes.plot(turn.angle, error, color=ACCENT, linewidth=1.1)
    axes.set_ylim(-3.0 * scale, 1.1 * scale)
    axes.set_yticks([0.0, scale])
    axes.set_yticklabels(["", ""])
    axes.set_title(
        f"outer circle {most:.3g} arcsec", fontsize=_SMALL, color=MUTED, fontweight="normal", loc="center"
    )
    axes.tick_params(axis="x", labelsize=_SMALL)
    axes.spines["polar"].set_visible(False)
