"""The pictures of a report as SVG."""

from __future__ import annotations

import io
import math
from typing import TYPE_CHECKING

from asperity.joint.description import Joint
from asperity.results.margins import margins
from asperity.results.solved import SolvedJoint
from asperity.rolling.curves import rolling_curves
from asperity.rolling.onset import RollingOnset
from asperity.show.compliance_figure import draw_budget, draw_levels, draw_margins, margins_height
from asperity.show.drive_sheet import drive_sheet, forces_sheet
from asperity.show.heat_figure import heat_figure
from asperity.show.rolling_figure import rolling_figure
from asperity.show.sheet_figure import sheet_figure
from asperity.show.window_figure import window_figure
from asperity.show.windup_figure import windup_figure
from asperity.standing.windup import Windup

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from asperity.joint_file.stated_parts import StatedParts
    from asperity.results.window import Window
    from asperity.show.title_block import Title

_WIDTH = 7.0  # of a picture on a page [in]


def report_pictures(
    joint: Joint,
    solved: SolvedJoint,
    windup: Windup | None,
    onset: RollingOnset | None,
    rolling_capacity: float,
    *,
    window: Window,
    windup_capacities: tuple[float, float],
    name: str,
    interference: float | None = None,
    title: Title | None = None,
    stated: StatedParts | None = None,
) -> dict[str, str]:
    """All pictures of a joint."""
    from matplotlib.figure import Figure

    nominal = joint if solved.branches is None else solved.branches.equal
    drawing = drive_sheet(nominal, name=name, interference=interference, title=title, stated=stated)
    pictures = {"drive": figure_svg(sheet_figure(drawing))}
    pictures["forces"] = figure_svg(sheet_figure(forces_sheet(joint, solved.result)))
    budget = Figure(figsize=(_WIDTH, 0.65 * _WIDTH), layout="constrained")
    shares, levels = budget.subplots(2, 1, height_ratios=(2.2, 1.0))
    draw_budget(shares, solved)
    draw_levels(levels, solved)
    pictures["budget"] = figure_svg(budget)
    judged = margins(solved)
    bars = Figure(figsize=(_WIDTH, margins_height(judged)), layout="constrained")
    draw_margins(bars.subplots(), judged)
    pictures["margins"] = figure_svg(bars)
    pictures["window"] = figure_svg(window_figure(window, title="", width=_WIDTH))
    if solved.joint.heat is not None:
        pictures["heat"] = figure_svg(heat_figure(solved.joint.heat, title="", width=_WIDTH))
    if windup is not None:
        pictures["windup"] = figure_svg(
            windup_figure(windup, onset, title="", stacked=True, capacities=windup_capacities)
        )
    if math.isfinite(float(solved.result.rolling.residual)):
        curves = rolling_curves(
            joint=joint, result=solved.result, laws=solved.solution.laws, torque_capacity=rolling_capacity
        )
        pictures["rolling"] = figure_svg(
            rolling_figure(curves, solved.result.rolling, joint=joint, title="", width=_WIDTH)
        )
    return pictures


def figure_svg(figure: Figure) -> str:
    """A figure as the text of an SVG file, the same text for the same figure."""
    from matplotlib import rc_context

    target = io.StringIO()
    with rc_context({"svg.hashsalt": "asperity"}):
        figure.savefig(target, format="svg", metadata={"Date": None})
    return target.getvalue()
