"""Fonts, colours and lines of the figures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from asperity.errors import printable
from asperity.types import Document

if TYPE_CHECKING:
    from matplotlib.axis import Axis

#: Colour of text and outlines.
INK = "#22303c"
#: Matplotlib settings of every figure.
STYLE: Document = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.labelsize": 10,
    "axes.labelcolor": INK,
    "axes.edgecolor": "#55626e",
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#dfe4e8",
    "grid.linewidth": 0.7,
    "lines.linewidth": 2.0,
    "lines.solid_capstyle": "round",
    "xtick.color": "#55626e",
    "ytick.color": "#55626e",
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "legend.title_fontsize": 9,
    "legend.handlelength": 1.8,
    "mathtext.fontset": "dejavusans",
    "savefig.dpi": 150,
    "figure.facecolor": "white",
}

#: Colour of a panel with one curve.
ACCENT = "#14557b"
#: Colour of text that comments.
MUTED = "#6b7782"
#: Colour of what is marked: peaks, limits.
MARK = "#c2410c"
#: Contact → colour, dash and width: right solid, left dashed; the ring's lines are thinner, so that the planet's show.
CONTACT_STYLES: dict[str, Document] = {
    "sp": {"color": INK, "linestyle": "-"},
    "pwr": {"color": "#4a9bd1", "linestyle": "-", "linewidth": 3.6},
    "pwl": {"color": "#4a9bd1", "linestyle": (0, (2.2, 1.1)), "linewidth": 3.6},
    "wro": {"color": "#d9730d", "linestyle": "-", "linewidth": 1.5},
    "wlo": {"color": "#d9730d", "linestyle": (0, (5.9, 2.9)), "linewidth": 1.5},
}
#: Contact → what it is, for legends.
CONTACT_LABELS = {
    "sp": "sun–planet",
    "pwr": "planet–right roller",
    "pwl": "planet–left roller",
    "wro": "right roller–ring",
    "wlo": "left roller–ring",
}


def plain_title(text: str) -> str:
    """A user's text as a title: printable, and without formulas, so that matplotlib shows it as it is."""
    return printable(text).replace("$", r"\$")


def mark_few_decades(axis: Axis, low: float, high: float) -> None:
    """Write more numbers at a logarithmic axis where powers of ten mark one place or none.

    At 1, 2 and 5, or in even steps, between the ends of its range.
    """
    from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator

    axis.set_minor_formatter(NullFormatter())
    if high < 100.0 * low:
        few = high < 5.0 * low
        if few:
            axis.set_minor_locator(NullLocator())
        axis.set_major_locator(
            MaxNLocator(5, steps=[1, 2, 5, 10]) if few else LogLocator(subs=(1.0, 2.0, 5.0))
        )
        axis.set_major_formatter(FuncFormatter(plain_number))


def plain_number(value: float, _: object = None) -> str:
    """A round number for a tick or a contour: 40000 rather than 4e+04, and 1e-9 rather than 1e-09."""
    return f"{value:.6g}".replace("e+0", "e").replace("e-0", "e-").replace("e+", "e")


def torque_colors(count: int) -> list[Any]:
    """Colours of a family of curves, light for the first to dark for the last."""
    from matplotlib import colormaps

    return [colormaps["YlGnBu"](x) for x in np.linspace(0.35, 0.95, count)]
