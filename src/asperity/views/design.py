"""A design of a joint: before and after, and how it stands to its limits; or a Pareto front."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from asperity.joint_file.si_tables import key_at, numeric_keys
from asperity.results import RESULTS
from asperity.study.design.design_problem import SUMMARY
from asperity.study.design.design_result import (
    DesignResult,
    StartReport,
    bounds_words,
    not_limited,
    shortcoming,
)
from asperity.types import Document
from asperity.units import from_si
from asperity.views.blocks import Block, Bullets, Heading, Paragraph, Table
from asperity.views.limits import warnings
from asperity.views.numbers import NONE, number, quantity, sentence, unit_words, words
from asperity.views.stiffness import law_range_words

if TYPE_CHECKING:
    import xarray


def design(result: DesignResult) -> Iterator[Block]:
    """The goal before and as designed, the free numbers, the results, and every limit where it is closest."""
    problem = result.problem
    goal = problem.objectives[0]
    unit = RESULTS[goal.name].display_unit
    before, after = (quantity(value, unit) for value in (result.objective_before, result.objective_after))
    yield Paragraph(
        f"{problem.goal}{_worst_case(result)}: {before} in {problem.joint_file}, {after} as designed."
    )
    failed = shortcoming(result)
    yield Paragraph(sentence(failed or result.met_words), strong=True, passed=not failed)
    said = []
    if result.missed_before:
        missed = "; ".join(limit.text for limit in result.missed_before)
        said.append(f"The joint of the file misses: {missed}.")
    if held := bounds_words(result):
        said.append(f"The design is held by: {held}.")
    if result.objective_unrounded is not None:
        said.append(f"{quantity(result.objective_unrounded, unit)} before rounding to the stated steps.")
    if said:
        yield Bullets(said)
    yield _free_numbers(result)
    yield Table("Before and design", ("result", "before", "design"), list(_summary(result)))
    yield _limits(result)
    yield Paragraph(
        f"{_found(result.starts)} Optimality residual {result.optimality_residual:.2g} (0 at a local optimum). Shadow "
        "price: relative gain of the objective per relative relaxation of the limit."
    )


def _worst_case(result: DesignResult) -> str:
    """Over what each result is taken at its worst, after a comma; empty for the nominal joint."""
    worst = result.problem.worst_case
    cases = [f"{len(worst.torques)} torques"] if len(worst.torques) > 1 else []
    if worst.tolerances != "none":
        cases.append(f"the {worst.tolerances} of the tolerances")
    return f", worst case of {' and '.join(cases)}" if cases else ""


def _free_numbers(result: DesignResult) -> Table:
    stated = numeric_keys(result.problem.case)
    rows = []
    for free in result.problem.variables:
        unit = key_at(free.path).unit
        old = quantity(stated[free.path].value, unit) if free.path in stated else NONE
        numbers = (quantity(value, unit, 5) for value in (result.point[free.path], free.lower, free.upper))
        step = "" if free.step is None else quantity(free.step, unit)
        rows.append((free.path, old, *numbers, step, result.at_bound.get(free.path, "")))
    head = ("number of the file", "before", "design", "from", "to", "step", "at bound")
    shown = [place for place in range(len(head)) if any(row[place] for row in rows)]
    return Table(
        "Free numbers",
        tuple(head[place] for place in shown),
        [tuple(row[place] for place in shown) for row in rows],
        words=tuple(index for index, place in enumerate(shown) if place in (0, 6)),
    )


def _summary(result: DesignResult) -> Iterator[tuple[str, str, str]]:
    for name, which in SUMMARY.items():
        if name not in result.summary_before:
            continue
        shown = result.problem.table[name]
        label = shown.said if which == "nominal" else f"{shown.said}, {which}"
        before, after = (
            quantity(value, shown.display_unit)
            for value in (result.summary_before[name], result.summary_after[name])
        )
        yield label, before, after


def _limits(result: DesignResult) -> Table:
    rows = []
    for limit in result.limits:
        unit = RESULTS[limit.name].display_unit
        rows.append(
            (
                ", ".join(filter(None, (limit.label, words(limit.row)))),
                quantity(limit.value, unit),
                f"{'≤' if limit.at_most else '≥'} {quantity(limit.limit, unit)}",
                quantity(limit.output_torque, "N*m"),
                limit.state or "met",
                number(limit.multiplier, digits=3) if limit.multiplier > 1e-9 else "",
            )
        )
    head = ("result", "value", "limit", "at torque", "state", "shadow price")
    return Table("Limits of the design, each where it is closest", head, rows, words=(0, 4))


def _found(starts: Sequence[StartReport]) -> str:
    """How many starts of a search converged, and to how many optima that differ in four digits, as a sentence."""
    converged = [start for start in starts if start.converged]
    optima = [f"{start.objective:.4g}" for start in converged if start.violation < 1e-6]
    different = len(set(optima))
    if different == 1 and len(optima) == len(starts):
        every = {1: "The only start", 2: "Both starts"}.get(len(starts), f"All {len(starts)} starts")
        return f"{every} found the same optimum." if len(starts) > 1 else f"{every} found an optimum."
    to = {0: "", 1: ", to one optimum"}.get(different, f", to {different} different optima")
    return f"{len(converged)} of {len(starts)} starts converged{to}."


def design_warnings(result: DesignResult) -> Iterator[Block]:
    """What ``asperity joint`` warns of for the designed joint."""
    diagnostics = result.diagnostics
    if diagnostics["diagnostics"] is None:
        yield Paragraph(
            f"The designed joint has no result under the output torque of its file: {diagnostics['no_result_because']}"
        )
        return
    if line := not_limited(result):
        yield Paragraph(line)
    yield warnings(diagnostics)
    if said := law_range_words(diagnostics):
        yield Paragraph(sentence(said))


def front(dataset: xarray.Dataset, names: Sequence[str]) -> Iterator[Block]:
    """Some designs of a Pareto front, evenly spread: the columns of these names."""
    size = dataset.sizes["design"]
    shown = np.unique(np.linspace(0, size - 1, 11).round().astype(int))
    some = f", {len(shown)} of them, evenly spread" if len(shown) < size else ""
    head, columns = [], []
    for name in names:
        unit = RESULTS[name].display_unit if name in RESULTS else key_at(name).unit
        head.append(f"{name.rsplit('.', 1)[-1]}\n{unit_words(unit) or '-'}")
        columns.append(
            [number(from_si(value, unit), digits=5) for value in dataset[name].values[shown].tolist()]
        )
    title = f"Pareto front of {size} design{'s' * (size != 1)}{some}"
    yield Table(title, tuple(head), list(zip(*columns, strict=True)), words=())


def front_warnings(diagnostics: Document) -> Iterator[Block]:
    """How many designs of a front cross which limit, the most serious first."""
    designs = [entries for entries in diagnostics["diagnostics"] if entries is not None]
    crossed = Counter(label for entries in designs for label in {entry["label"] for entry in entries})
    if len(designs) < len(diagnostics["diagnostics"]):
        lost = len(diagnostics["diagnostics"]) - len(designs)
        yield Paragraph(f"{lost} designs have no result under the torque of the file.")
    if not crossed:
        yield Paragraph("No warnings: all limits of the model are met.")
        return
    yield Heading("Warnings of the designs; 'asperity joint' gives the remedies")
    yield Bullets([f"{label}: {count} of {len(designs)}" for label, count in crossed.most_common()])
