"""Load share and capacity of unequal branches over the size of one planet, as a picture."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from asperity.show.style import ACCENT, MARK, MUTED

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from asperity.branches.size_errors import SizeErrorCurves

#: A ground that hides the line at 0.
_LEGEND: dict[str, Any] = {"fontsize": "x-small", "framealpha": 1.0, "edgecolor": "none"}


def draw_size_errors(axes: Sequence[Axes], curves: SizeErrorCurves) -> None:
    """Three panels over a further deviation of the first planet; 0 is the joint as its file has it."""
    x = 1e6 * curves.deviation
    whose = "" if curves.track == curves.noun else f"{curves.track} "
    shares, capacity, sun = axes
    for name, values, style in (
        ("standing", curves.standing_share, "-"),
        ("rolling", curves.rolling_share, "--"),
    ):
        shares.plot(x, 100.0 * values[:, 0], style, color=ACCENT, label=f"{curves.noun} 1, {name}")
        shares.plot(x, 100.0 * values[:, 1:], style, color=MUTED, linewidth=1.0)
        shares.plot([], [], style, color=MUTED, linewidth=1.0, label=f"others, {name}")
    shares.set(ylabel="share of the torque [%]")
    shares.legend(**_LEGEND)
    capacity.plot(x, curves.first_slip, color=ACCENT, label="first branch slips")
    capacity.plot(x, curves.all_slip, "--", color=MARK, label="all branches slip")
    capacity.set(ylabel="torque, standing [N·m]")
    capacity.legend(**_LEGEND)
    sun.plot(x, curves.sun_force, color=ACCENT)
    sun.set(ylabel="force on the sun's bearings [N]")
    for panel in axes:
        panel.axvline(0.0, color="black", linestyle=":", linewidth=1.0)
        panel.set_ylim(bottom=0.0)
        panel.set_xlim(x[0], x[-1])
        panel.set(xlabel=f"added to the {whose}radius of {curves.noun} 1 [µm]")
