"""Safety margins as a picture: the share of each limit that is used."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from asperity.results.margins import Margin

if TYPE_CHECKING:
    from matplotlib.axes import Axes

#: Colours that are told apart by everybody, and in grey by their brightness.
PASS_COLOUR, FAIL_COLOUR = "#2c7fb8", "#d95f02"
_SERIOUS = ("function", "damage", "accuracy")
_WORDS = 0.18  # width of the words at a bar over that of the picture
_LETTERS = 48  # of a line of a bar's name; a longer name has two lines


def drawn_margins(margins: Sequence[Margin]) -> list[Margin]:
    """Margins of function, damage and accuracy whose share of the limit has a meaning, the fullest first."""
    chosen = [
        each
        for each in margins
        if each.severity in _SERIOUS
        and each.result.group != "residuals"
        and not each.state
        and math.isfinite(each.utilisation)
        and each.utilisation > 0.0
    ]
    return sorted(chosen, key=lambda each: -each.utilisation)


def margins_height(margins: Sequence[Margin]) -> float:
    """Height of the picture in which the bars have room for their names.

    Parameters
    ----------
    margins : sequence of Margin
        The margins.

    Returns
    -------
    float
        Height [in].
    """
    return 1.0 + 0.35 * max(1, len(drawn_margins(margins)))


def draw_margins(axes: Axes, margins: Sequence[Margin]) -> None:
    """Bars of the share of each limit that is used; the line at 100 % is the limit, and no words lie on it.

    Parameters
    ----------
    axes : Axes
        Where to draw.
    margins : sequence of Margin
        The margins.
    """
    shown = drawn_margins(margins)
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
    right = 1.35 * max([110.0, *used])
    for bar, each, share in zip(bars, shown, used, strict=True):
        meets_line = share <= 100.0 < share + _WORDS * right
        inside = meets_line and share > _WORDS * right
        axes.annotate(
            f"{share:.3g} %, {'pass' if each.passes else 'FAIL'}",
            (100.0 if meets_line and not inside else share, bar.get_y() + 0.5 * bar.get_height()),
            (-4 if inside else 4, 0),
            textcoords="offset points",
            va="center",
            ha="right" if inside else "left",
            color="white" if inside else "black",
            fontsize="small",
        )
    axes.set_yticks(range(len(shown)), names, fontsize="small", linespacing=0.95)
    axes.axvline(100.0, color="black", linewidth=1.2)
    axes.set_xlim(0.0, right)
    axes.invert_yaxis()
    axes.set(xlabel="share of the limit that is used [%]")


def _name(margin: Margin) -> str:
    return textwrap.fill(f"{margin.result.label}, {margin.place}".removesuffix(", "), _LETTERS)
