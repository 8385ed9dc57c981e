"""Sections of a report on studies of the joint: sensitivities, tolerances, and a design of it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from asperity.joint_file.si_tables import key_at, numeric_keys
from asperity.report.content import Block, Heading, Listing, Paragraph, Picture, Table, number, quantity
from asperity.report.figures import figure_svg
from asperity.results import RESULTS
from asperity.study.design.design_problem import SUMMARY
from asperity.study.design.design_result import DesignResult, bounds_words, shortcoming
from asperity.study.tolerances.documents import TOLERANCES_OF_PARTS, failures
from asperity.units import from_si

if TYPE_CHECKING:
    import xarray

#: Results of the sections on sensitivities and tolerances.
STUDIED = ("assembly_stiffness_output", "standing_torque_capacity", "drift", "efficiency", "drive_life")
#: Of them those with a picture.
DRAWN = ("assembly_stiffness_output", "drift")
_ROWS = 20
_WIDTH = 7.0  # of a picture on a page [in]
_ROUNDING = 1e-12  # of an elasticity


@dataclass(frozen=True)
class ReportStudies:
    """Studies that a report shows; each may be absent.

    What sensitivity and uncertainty say of :data:`STUDIED`; a design of the joint with name and text of its file; and
    options of the command that made them.
    """

    sensitivities: xarray.Dataset | None = None
    spread: xarray.Dataset | None = None
    design: DesignResult | None = None
    design_name: str = ""
    design_text: str = ""
    options: tuple[str, ...] = ()


def study_sections(studies: ReportStudies) -> Iterator[Block]:
    """The sections of the studies that were made."""
    if studies.sensitivities is not None:
        yield from sensitivity_section(studies.sensitivities)
    if studies.spread is not None:
        yield from tolerance_section(studies.spread)
    if studies.design is not None:
        yield from design_section(studies.design, name=studies.design_name)


def sensitivity_section(dataset: xarray.Dataset) -> Iterator[Block]:
    """Elasticities of the results, largest influence on the stiffness first."""
    from asperity.study.tolerances.documents import ABOUT_FINISHED_PARTS
    from asperity.study.tolerances.influence_plot import tornado_figure
    from asperity.study.tolerances.sensitivity import FINISHED_PART, path_of_input, ranking

    yield Heading("Sensitivities")
    ranked = ranking(dataset, STUDIED[0])["input"].values.tolist()
    shown, rest = ranked[:_ROWS], len(ranked) - _ROWS
    left_out = f" Of the file's {len(ranked)} numbers, the {_ROWS} of most influence." if rest > 0 else ""
    yield Paragraph(
        "Elasticities: by how many per cent a result changes for one per cent more of a number of the joint file. "
        f"Exact derivatives at the file's values.{left_out}"
    )
    if any(path.endswith(FINISHED_PART) for path in shown):
        yield Paragraph(ABOUT_FINISHED_PARTS)
    rows = []
    for path in shown:
        one = dataset.sel(input=path)
        cells = (_elasticity(float(one["elasticity"].sel(result=name))) for name in STUDIED)
        rows.append((path, quantity(float(one["value"]), key_at(path_of_input(path)).unit), *cells))
    yield Table(
        f"Elasticities, ordered by those of the {_words(dataset, STUDIED[0])}",
        ("number of the file", "value", *(_short(name) for name in STUDIED)),
        rows,
    )
    figure = tornado_figure(dataset, result=DRAWN[0], panels=DRAWN[1:], width=_WIDTH)
    yield Picture("Elasticities of stiffness and drift", figure_svg(figure))


def _elasticity(value: float) -> str:
    """An elasticity; 0 where it is only what rounding leaves of nothing."""
    return number(0.0 if abs(value) < _ROUNDING else value)


def tolerance_section(spread: xarray.Dataset) -> Iterator[Block]:
    """Intervals of the results under the tolerances of the file, and what each tolerance contributes."""
    from asperity.study.tolerances.influence_plot import uncertainty_figure

    yield Heading("Tolerances")
    parts = f" {TOLERANCES_OF_PARTS}" if bool(spread["finished_part"].any()) else ""
    lost = [f"{line}. " for line in failures(spread, {name: _words(spread, name) for name in STUDIED})]
    yield Paragraph(
        f"{spread.sizes['sample']} joints drawn from the tolerances of the joint file, seed {spread.attrs['seed']}. "
        f"{''.join(lost)}The shares of the variance are Sobol indices: first order for a tolerance alone, total with "
        f"all its interactions.{parts}"
    )
    rows = []
    for name in STUDIED:
        one, unit = spread.sel(result=name), RESULTS[name].display_unit
        low, _, high = one["quantiles"].values
        numbers = [from_si(float(one[column]), unit) for column in ("nominal", "mean", "standard_deviation")]
        ends = ["fails" if math.isinf(end) else number(from_si(float(end), unit)) for end in (low, high)]
        rows.append((_titled(spread, name), *map(number, numbers), *ends))
    yield Table(
        "95 % of the drawn joints",
        ("result", "as stated", "mean", "standard\ndeviation", "2.5 %", "97.5 %"),
        rows,
    )
    yield Table(
        "Shares of the variance, total order",
        ("tolerance", "± value", "distribution", *(_short(name) for name in STUDIED)),
        _shares(spread),
        words=(0, 2),
    )
    for name in DRAWN:
        yield Picture(
            f"Scatter of the {_words(spread, name)}, and the shares of its variance",
            figure_svg(uncertainty_figure(spread, result=name, width=_WIDTH)),
        )


def _shares(spread: xarray.Dataset) -> list[tuple[str, ...]]:
    """Total Sobol indices of every toleranced number, the largest for the stiffness first."""
    order = np.argsort(-np.nan_to_num(spread["total_order"].sel(result=STUDIED[0]).values), kind="stable")
    rows = []
    for place in order:
        one = spread.isel(input=int(place))
        path = str(one["input"].item())
        shares = (number(float(one["total_order"].sel(result=name))) for name in STUDIED)
        tolerance = quantity(float(one["tolerance"]), key_at(path).unit, 3)
        rows.append((path, tolerance, str(one["distribution"].item()), *shares))
    return rows


def design_section(result: DesignResult, *, name: str) -> Iterator[Block]:
    """A design of the joint: before and after, and how it stands to its limits."""
    from asperity.study.design.design_plot import design_figure

    problem = result.problem
    goal = problem.objectives[0]
    unit = RESULTS[goal.name].display_unit
    before, after = (quantity(value, unit) for value in (result.objective_before, result.objective_after))
    torques = len(problem.worst_case.torques)
    over = f" over {torques} torques, each result at its worst" if torques > 1 else ""
    yield Heading("Design")
    yield Paragraph(f"{name} asks for the {problem.goal}{over}: {before} before, {after} as designed.")
    met = _sentence(shortcoming(result)) or result.met_words
    yield Paragraph(f"{met}.", strong=True)
    if words := bounds_words(result):
        yield Paragraph(f"The design is held by: {words}.")
    stated = numeric_keys(result.problem.case)
    rows = []
    for free in result.problem.variables:
        shown = key_at(free.path).unit
        old = quantity(stated[free.path].value, shown) if free.path in stated else "–"
        numbers = (quantity(value, shown) for value in (result.point[free.path], free.lower, free.upper))
        rows.append((free.path, old, *numbers, result.at_bound.get(free.path, "")))
    yield Table(
        "Free numbers",
        ("number of the file", "before", "design", "from", "to", "at bound"),
        rows,
        words=(0, 5),
    )
    yield Table("Before and design", ("result", "before", "design"), list(_summary(result)))
    yield Table(
        "Limits of the design, each where it is closest",
        ("result", "value", "limit", "at torque", "state"),
        list(_limits(result)),
        words=(0, 4),
    )
    yield Picture(
        "The objective along each free number through the design, and the smallest margin of the limits",
        figure_svg(design_figure(result, width=_WIDTH)),
    )


def _summary(result: DesignResult) -> Iterator[tuple[str, str, str]]:
    for name, which in SUMMARY.items():
        if name not in result.summary_before:
            continue
        shown = result.problem.table[name]
        pair = (result.summary_before[name], result.summary_after[name])
        label = shown.said if which == "nominal" else f"{shown.said}, {which}"
        before, after = (quantity(value, shown.display_unit) for value in pair)
        yield label, before, after


def _limits(result: DesignResult) -> Iterator[tuple[str, ...]]:
    for limit in result.limits:
        shown = RESULTS[limit.name]
        yield (
            ", ".join(filter(None, (limit.label, limit.row.replace("_", " ")))),
            quantity(limit.value, shown.display_unit),
            f"{'≤' if limit.at_most else '≥'} {quantity(limit.limit, shown.display_unit)}",
            quantity(limit.output_torque, "N*m"),
            limit.state or "met",
        )


def study_files(studies: ReportStudies) -> Iterator[Block]:
    """The design file and the designed joint, from which the section on the design follows."""
    if studies.design is not None:
        yield Heading("Design file")
        yield Listing(studies.design_text)
        yield Heading("Designed joint as a joint file")
        yield Listing(studies.design.joint_text)


def _short(name: str) -> str:
    """Head of a narrow column."""
    heads = {
        "assembly_stiffness_output": "stiffness,\nassembled",
        "standing_torque_capacity": "standing\ntorque\ncapacity",
        "drive_life": "life",
    }
    return heads.get(name, name)


def _words(dataset: xarray.Dataset, name: str) -> str:
    """What a result is called for the drive at hand."""
    return str(dataset["result_name"].sel(result=name).item())


def _titled(dataset: xarray.Dataset, name: str) -> str:
    unit, words = RESULTS[name].display_unit, _words(dataset, name)
    return words if unit == "1" else f"{words}, {unit.replace('*', '·')}"


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:]
