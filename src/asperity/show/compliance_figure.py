"""A joint as pictures: shares of its compliance, stiffness on every level, curves over temperature and size errors."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from asperity.joint.fit import Fit
from asperity.joint.pin_bound import stiffness_bound
from asperity.joint.temperature import TemperatureCurves, temperature_curves
from asperity.joint.temperature_limits import limits_document, lost_words
from asperity.results import LEVELS, RESULTS
from asperity.results.document import NO_SHARE, budget_words
from asperity.results.margins import Margin, margins
from asperity.results.solved import SolvedJoint
from asperity.show.style import ACCENT, MARK, MUTED, mark_few_decades
from asperity.types import Document
from asperity.units import format_quantity

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from asperity.branches.size_errors import SizeErrorCurves


_PER_ARCMINUTE = np.pi / 10800.0
_NOTE_WIDTH = 58  # letters below a panel of half a sheet
_LABEL_WIDTH = 28  # letters in the legend of a panel of a third of a sheet
_ROW = 3.7  # height of a row of panels [in]
#: A ground that hides the line at 0.
_LEGEND: Document = {"fontsize": "x-small", "framealpha": 1.0, "edgecolor": "none"}
#: Colours that are told apart by everybody, and in grey by their brightness.
PASS_COLOUR, FAIL_COLOUR = "#2c7fb8", "#d95f02"
_COLOURS = {"pass": PASS_COLOUR, "FAIL": FAIL_COLOUR, "unknown": "#9a9a9a"}
_SERIOUS = ("function", "damage", "accuracy")
_WORDS = 0.18  # width of the words at a bar over that of the picture
_LETTERS = 48  # of a line of a bar's name; a longer name has two lines


def compliance_shares(solved: SolvedJoint) -> dict[str, float]:
    """Share of every spring in the compliance of the assembled joint, without those that have none [-]."""
    shares = {}
    for name, row in RESULTS.items():
        if row.group == "assembly" and name.endswith("_share"):
            words = name.removesuffix("_share").replace("_", " ")
            for place, share in row.rows_of(solved).items():
                shares[f"{place} {words}".strip()] = share
    return {
        words: share
        for words, share in sorted(shares.items(), key=lambda pair: -pair[1])
        if abs(share) > NO_SHARE
    }


def compliance_figure(solved: SolvedJoint, *, title: str) -> Figure:
    """Shares of the compliance and the output stiffness on every level, side by side."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 4.2), layout="constrained")
    budget, levels = figure.subplots(1, 2)
    draw_budget(budget, solved)
    draw_levels(levels, solved)
    figure.suptitle(title, fontsize=10)
    return figure


def joint_figure(solved: SolvedJoint, *, title: str, size_errors: SizeErrorCurves | None = None) -> Figure:
    """Shares of the compliance, stiffness on every level, and safety margins on one sheet."""
    from matplotlib.figure import Figure

    fit = solved.joint.fit
    rows = 2 + (fit is not None) + (size_errors is not None)
    judged = margins(solved)
    heights = [_ROW] * rows
    heights[1] = max(_ROW, margins_height(judged))
    figure = Figure(figsize=(10.0, sum(heights)), layout="constrained")
    upper, lower, *further = figure.subfigures(rows, 1, squeeze=False, height_ratios=heights)[:, 0]
    budget, levels = upper.subplots(1, 2)
    draw_budget(budget, solved)
    draw_levels(levels, solved)
    draw_margins(lower.subplots(), judged)
    if fit is not None:
        draw_temperatures(
            further[0].subplots(1, 3),
            temperature_curves(solved.joint, solved.at_temperature),
            fit,
            limits_document(solved.temperature_limits),
        )
    if size_errors is not None:
        draw_size_errors(further[-1].subplots(1, 3), size_errors)
    figure.suptitle(title, fontsize=10)
    return figure


def draw_budget(axes: Axes, solved: SolvedJoint) -> None:
    """Share of every spring in the compliance of the assembled joint, as bars."""
    shares = compliance_shares(solved)
    bars = axes.barh(list(shares), [100.0 * share for share in shares.values()], color="tab:blue")
    axes.bar_label(bars, fmt="%.3g %%", padding=3)
    axes.invert_yaxis()
    axes.margins(x=0.25)
    note = budget_words(shares.values(), elastic_bodies=bool(shares) and solved.joint.body_model != "springs")
    note = note and "\n" + textwrap.fill(note, _NOTE_WIDTH)
    axes.set(xlabel=f"share of the compliance at the output [%]{note}")


def draw_levels(axes: Axes, solved: SolvedJoint) -> None:
    """Stiffness at the output on every level of the model that has one."""
    rows = [RESULTS[f"{level}_stiffness_output"] for level in LEVELS]
    bound = stiffness_bound(solved.joint)
    numbers = np.array([float(np.asarray(row.of(solved))) * _PER_ARCMINUTE for row in rows])
    words = [row.label.split(", ")[-1] + f"\n{bound}" * (row.gives_way and bool(bound)) for row in rows]
    known = np.where(numbers > 0.0, numbers, np.nan)  # no stiffness is no point, and not a stiffness of 0
    places = np.arange(len(rows))
    axes.semilogx(known, places, "o", color="tab:orange")  # no bars: a logarithmic axis has no zero
    for place, number in zip(places, known, strict=True):
        if np.isnan(number):
            axes.annotate(
                "no value", (0.5, place), xycoords=("axes fraction", "data"), ha="center", va="center"
            )
        else:
            axes.annotate(
                format_quantity(number, "1"), (number, place), (8, 0), textcoords="offset points", va="center"
            )
    axes.set_yticks(places, words)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.margins(x=0.45)
    if np.isfinite(known).any():
        mark_few_decades(axes.xaxis, *axes.get_xlim())
    axes.set(xlabel="torsional stiffness at the output [N·m/arcmin]")


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
    sun.plot(x, curves.central_force, color=ACCENT)
    sun.set(ylabel="force on the sun's bearings [N]")
    for panel in axes:
        panel.axvline(0.0, color="black", linestyle=":", linewidth=1.0)
        panel.set_ylim(bottom=0.0)
        panel.set_xlim(x[0], x[-1])
        panel.set(xlabel=f"added to the {whose}radius of {curves.noun} 1 [µm]")


def draw_temperatures(
    axes: Sequence[Axes], curves: TemperatureCurves, fit: Fit, limits: list[Document]
) -> None:
    """Three panels over temperature, with those of assembly and work, and where something of the joint is lost.

    ``limits`` are those of :func:`asperity.joint.temperature_limits.limits_document`.
    """
    temperature = np.asarray(curves.temperature)
    panels = (
        ("preload [N]", np.asarray(curves.preload)),
        ("assembled stiffness [N·m/arcmin]", np.asarray(curves.stiffness) * _PER_ARCMINUTE),
        ("standing torque capacity [N·m]", np.asarray(curves.standing_torque_capacity)),
    )
    first = {entry["side"]: entry for entry in reversed(limits)}
    marks = (
        ("assembly", float(fit.assembly_temperature), MUTED, ":"),
        ("work", float(fit.working_temperature), "black", "--"),
    )
    for panel, (label, values) in zip(axes, panels, strict=True):
        known = np.where(np.isfinite(values), values, np.nan)
        panel.plot(temperature, known, color=ACCENT)
        for name, at, color, style in marks:
            panel.axvline(at, color=color, linestyle=style, linewidth=1.0, label=name)
        for side, entry in first.items():
            if temperature[0] < entry["temperature_degC"] < temperature[-1]:
                end = temperature[-1] if side == "above" else temperature[0]
                label = textwrap.fill(lost_words(entry), _LABEL_WIDTH)
                panel.axvspan(entry["temperature_degC"], end, color=MARK, alpha=0.12, label=label)
        panel.set_xlim(temperature[0], temperature[-1])
        panel.set_ylim(bottom=0.0)
        panel.set(xlabel="temperature [°C]", ylabel=label)
    axes[0].legend(frameon=False, fontsize="small")


def drawn_margins(margins: Sequence[Margin]) -> list[Margin]:
    """Margins of function, damage and accuracy whose share of the limit has a meaning, the fullest first."""
    chosen = [
        margin
        for margin in margins
        if margin.severity in _SERIOUS
        and margin.result.group != "residuals"
        and not margin.state
        and math.isfinite(margin.utilisation)
        and margin.utilisation > 0.0
    ]
    return sorted(chosen, key=lambda margin: -margin.utilisation)


def margins_height(margins: Sequence[Margin]) -> float:
    """Height of the picture [in] in which the bars have room for their names."""
    return 1.0 + 0.35 * max(1, len(drawn_margins(margins)))


def draw_margins(axes: Axes, margins: Sequence[Margin]) -> None:
    """Bars of the share of each limit that is used; the line at 100 % is the limit, and no words lie on it."""
    shown = drawn_margins(margins)
    labels = [f"{margin.result.label}, {margin.place}".removesuffix(", ") for margin in shown]
    names = [textwrap.fill(label, _LETTERS) for label in labels]
    used = [100.0 * margin.utilisation for margin in shown]
    bars = axes.barh(
        range(len(shown)),
        used,
        left=0.0,
        color=[_COLOURS[margin.outcome] for margin in shown],
        hatch=["///" if margin.failed else "" for margin in shown],
        edgecolor="white",
    )
    right = 1.35 * max([110.0, *used])
    for bar, margin, share in zip(bars, shown, used, strict=True):
        meets_line = share <= 100.0 < share + _WORDS * right
        inside = meets_line and share > _WORDS * right
        axes.annotate(
            f"{share:.3g} %, {margin.outcome}",
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
    axes.set(xlabel="used share of the limit [%]")
