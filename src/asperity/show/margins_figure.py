"""Safety margins as a picture: the share of each limit that is used."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from asperity.joint.margins import Margin

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colours that are told apart by everybody, and in grey by their brightness.
PASS_COLOUR, FAIL_COLOUR = "#2c7fb8", "#d95f02"
_SERIOUS = ("function", "damage", "accuracy")


def drawn_margins(found: Sequence[Margin]) -> list[Margin]:
    """Margins of function, damage and accuracy whose share of the limit has a meaning, the fullest first.

    Parameters
    ----------
    found : sequence of Margin
        As :func:`asperity.joint.margins.margins` gives them.

    Returns
    -------
    list of Margin
        Without the residuals of the solution.
    """
    chosen = [
        each
        for each in found
        if each.severity in _SERIOUS
        and each.result.group != "residuals"
        and math.isfinite(each.utilisation)
        and each.utilisation > 0.0
    ]
    return sorted(chosen, key=lambda each: -each.utilisation)


def draw_margins(axes: Axes, found: Sequence[Margin]) -> None:
    """Bars of the share of each limit that is used; the line at 100 % is the limit.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    found : sequence of Margin
        The margins.
    """
    shown = drawn_margins(found)
    names = [_name(each) for each in shown]
    used = [100.0 * each.utilisation for each in shown]
    bars = axes.barh(
        range(len(shown)),
        used,
        left=0.0,
        color=[PASS_COLOUR if each.passes else FAIL_COLOUR for each in shown],
        hatch=["" if each.passes else "///" for each in shown],
        edgecolor="white",
    )
    for bar, each, share in zip(bars, shown, used, strict=True):
        axes.annotate(
            f"{share:.3g} %, {'pass' if each.passes else 'FAIL'}",
            (bar.get_width(), bar.get_y() + 0.5 * bar.get_height()),
            (4, 0),
            textcoords="offset points",
            va="center",
            fontsize="small",
            bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.5},
        )
    axes.set_yticks(range(len(shown)), names)
    axes.axvline(100.0, color="black", linewidth=1.2)
    axes.set_xlim(0.0, 1.35 * max([110.0, *used]))
    axes.invert_yaxis()
    axes.set(xlabel="share of the limit that is used [%]")


def _name(margin: Margin) -> str:
    return f"{margin.result.label}, {margin.place}".removesuffix(", ")
