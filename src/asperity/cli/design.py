"""``asperity design``: the best joint within limits, or a Pareto front of several objectives."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import (
    json_option,
    prepare_computation,
    print_json,
    save_image,
    say_written,
    show_table,
)
from asperity.errors import InputError
from asperity.made_files import MADE_JOINT, Kind, table_with
from asperity.writing import check_apart, check_file, check_image, write_text

if TYPE_CHECKING:
    from rich.console import Console

    from asperity.study.design.design_problem import DesignProblem
    from asperity.study.design.design_result import DesignResult, StartReport


def front_columns(problem: DesignProblem) -> dict[str, str]:
    """Objectives and variables of a problem → the column, with its unit, in the table of its Pareto front."""
    from asperity.joint_file.si_tables import key_at

    units = {goal.name: problem.table[goal.name].si_unit for goal in problem.objectives}
    units |= {variable.path: key_at(variable.path).dimension.si_unit for variable in problem.variables}
    return {name: f"{name} [{unit}]" for name, unit in units.items()}


def front_table(problem: DesignProblem) -> Kind:
    """The table of the Pareto front of a problem, as a kind of file."""
    return table_with(
        "the table of a Pareto front of these objectives and variables", *front_columns(problem).values()
    )


@click.command()
@click.argument("file", type=click.Path())
@click.option("--out", type=click.Path(), help="Write the designed joint as a joint file (a front: as .csv).")
@click.option(
    "--plot",
    type=click.Path(),
    help="Draw the objective along each variable, or the front (.png, .svg, .pdf).",
)
@click.option(
    "--map",
    "map_file",
    type=click.Path(),
    help="Draw where two variables meet all limits, with the line of each limit (.png, .svg, .pdf).",
)
@click.option(
    "--map-over",
    nargs=2,
    metavar="VARIABLE VARIABLE",
    help="The two variables of the map; by default the first two.",
)
@json_option()
@click.option(
    "--population",
    default=100,
    show_default=True,
    type=click.IntRange(8, 5000),
    help="Designs of a generation (front).",
)
@click.option(
    "--generations",
    default=150,
    show_default=True,
    type=click.IntRange(1, 10000),
    help="Generations (front).",
)
def design(
    file: str,
    out: str | None,
    plot: str | None,
    map_file: str | None,
    map_over: tuple[str, str] | None,
    as_json: bool,
    population: int,
    generations: int,
) -> None:
    """Choose the free variables of a joint as specified in the design file FILE.

    FILE is a TOML file that names a joint file, free variables with bounds, one objective (or two or three for a
    Pareto front), limits, and the torques and tolerances for which they must hold. Where no design meets all limits,
    the command says which of them conflict and by how much, and ends with exit code 3.
    """
    from asperity.cli.terminal import progress_bar
    from asperity.study.design.design_file import read_design

    problem = read_design(file)
    front = len(problem.objectives) > 1
    check_apart(out=out, plot=plot, map=map_file)
    for image in (plot, map_file):
        check_image(image, file, problem.joint_file)
    check_file(out, file, problem.joint_file, kind=front_table(problem) if front else MADE_JOINT)
    prepare_computation()
    if map_file is not None or map_over is not None:
        _check_map(problem, map_file, map_over)
    if front:
        _front(problem, out, plot, as_json, population, generations)
        return
    from asperity.study.design.design import design as search
    from asperity.study.design.design_result import shortcoming

    with progress_bar("searches") as report:
        result = search(problem, progress=report)
    if out is not None:  # files first: whoever reads the tables may close the pipe
        write_text(result.joint_text, out, kind=MADE_JOINT)
        say_written(out)
    if plot is not None:
        from asperity.study.design.design_plot import design_figure

        save_image(design_figure(result), plot)
    if map_file is not None:
        from asperity.study.design.design_map import design_map

        save_image(design_map(result, over=map_over), map_file)
    if as_json:
        from asperity.study.design.design_result import design_document

        print_json(design_document(result))
    else:
        _show(result)
        _show_warnings(result)
    if shortcoming(result):
        from asperity.errors import NoSolutionError

        raise NoSolutionError(shortcoming(result))


def _check_map(problem: DesignProblem, map_file: str | None, over: tuple[str, str] | None) -> None:
    from asperity.study.design.design_map import mapped_variables

    if map_file is None:
        raise InputError("--map-over chooses the variables of a map; name its file with --map")
    if len(problem.objectives) > 1:
        raise InputError("--map draws the limits around one design; a Pareto front has many, see --plot")
    mapped_variables(problem, over)


def _front(
    problem: DesignProblem,
    out: str | None,
    plot: str | None,
    as_json: bool,
    population: int,
    generations: int,
) -> None:
    from asperity.cli.terminal import console, progress_bar
    from asperity.study.design.design_result import front_diagnostics
    from asperity.study.design.pareto import pareto_front, require_pymoo

    require_pymoo()
    if out is not None and not out.endswith(".csv"):
        raise InputError(f"{out}: a Pareto front is a table of many joints; give it a name that ends in .csv")
    with progress_bar("generations") as report:
        front = pareto_front(problem, population=population, generations=generations, progress=report)
    with progress_bar("joints") as report:
        warned = front_diagnostics(problem, front, progress=report)
    columns = front_columns(problem)
    names = list(columns)
    if out is not None:
        head = ",".join(columns.values())
        rows = zip(*(front[name].values for name in names), strict=True)
        write_text(
            "\n".join([head, *(",".join(repr(float(v)) for v in row) for row in rows)]) + "\n",
            out,
            kind=front_table(problem),
        )
        say_written(out)
    if plot is not None:
        from asperity.study.design.design_plot import pareto_figure

        save_image(pareto_figure(front, tuple(goal.name for goal in problem.objectives)), plot)
    if as_json:
        print_json({name: front[name].values.tolist() for name in names} | warned)
    else:
        _show_front(problem, front, names)
        _show_front_warnings(console(), warned)


def _show_front(problem: DesignProblem, front: Any, names: list[str]) -> None:
    import numpy as np

    from asperity.cli.terminal import console
    from asperity.joint_file.si_tables import key_at
    from asperity.results import RESULTS
    from asperity.units import format_quantity, from_si

    size = front.sizes["design"]
    units = [RESULTS[n].display_unit if n in RESULTS else key_at(n).unit for n in names]
    shown = np.unique(np.linspace(0, size - 1, 11).round().astype(int))
    some = f", {len(shown)} of them, evenly spread" if len(shown) < size else ""
    head, columns = [], []
    for name, unit in zip(names, units, strict=True):
        head.append(f"{name.rsplit('.', 1)[-1]}\n[{unit}]")
        values = front[name].values[shown].tolist()
        columns.append([format_quantity(from_si(value, unit), "1", 5) for value in values])
    title = f"Pareto front of {size} design{'s' * (size != 1)}{some}"
    show_table(console(), title, head, zip(*columns, strict=True))


def _show(result: DesignResult) -> None:
    from asperity.cli.document_text import print_wrapped
    from asperity.cli.terminal import console
    from asperity.results import RESULTS
    from asperity.study.design.design_result import bounds_words
    from asperity.units import format_quantity

    target, problem = console(), result.problem
    goal, torques = problem.objectives[0], len(problem.worst_case.torques) or 1
    unit = RESULTS[goal.name].display_unit
    cases = [f"{torques} torques"] if torques > 1 else []
    if problem.worst_case.tolerances != "none":
        cases.append(f"the {problem.worst_case.tolerances} of the tolerances")
    worst = f", worst case of {' and '.join(cases)}" if cases else ""
    before, after = (format_quantity(v, unit) for v in (result.objective_before, result.objective_after))
    target.print(f"{problem.goal}{worst}:")
    said = [f"{before} in {problem.joint_file} -> {after}"]
    said.append(result.met_words)
    if result.missed_before:
        missed = "; ".join(limit.text for limit in result.missed_before)
        said.append(f"The joint of the file misses: {missed}")
    if words := bounds_words(result):
        said.append(f"The design is held by: {words}")
    for text in said:
        print_wrapped(target, f"  {text}", indent=4)
    if result.objective_unrounded is not None:
        target.print(
            f"  {format_quantity(result.objective_unrounded, unit)} before rounding to the stated steps"
        )
    _show_variables(target, result)
    _show_summary(target, result)
    _show_limits(target, result)
    _show_search(target, result)


def _show_warnings(result: DesignResult) -> None:
    """What ``asperity joint`` warns of for the designed joint."""
    from asperity.cli.document_text import show_law_range, show_warnings
    from asperity.cli.terminal import console
    from asperity.study.design.design_result import not_limited

    diagnostics = result.diagnostics
    if diagnostics["diagnostics"] is None:
        because = diagnostics["no_result_because"]
        click.echo(f"The designed joint has no result under the output torque of its file: {because}")
        return
    if line := not_limited(result):
        console().print(line, markup=False)
    show_warnings(console(), diagnostics)
    show_law_range(console(), diagnostics)


def _show_front_warnings(target: Console, diagnostics: dict[str, Any]) -> None:
    """How many designs of a front cross which limit, the most serious first."""
    from collections import Counter

    designs = [entries for entries in diagnostics["diagnostics"] if entries is not None]
    crossed = Counter(label for entries in designs for label in {entry["label"] for entry in entries})
    if len(designs) < len(diagnostics["diagnostics"]):
        target.print(
            f"{len(diagnostics['diagnostics']) - len(designs)} designs have no result under the torque of the file"
        )
    if not crossed:
        target.print("No warnings: all limits of the model are met")
        return
    target.print("Warnings of the designs; 'asperity joint' gives the remedies", style="bold")
    for label, count in crossed.most_common():
        target.print(f"  {label}: {count} of {len(designs)}", markup=False)


def _show_variables(target: Console, result: DesignResult) -> None:
    from asperity.joint_file.si_tables import key_at, numeric_keys
    from asperity.units import format_quantity

    stated = numeric_keys(result.problem.case)
    rows = []
    for free in result.problem.variables:
        unit = key_at(free.path).unit
        rows.append(
            {
                "number": free.path,
                "before": format_quantity(stated[free.path].value, unit) if free.path in stated else "-",
                "design": format_quantity(result.point[free.path], unit, 5),
                "from": format_quantity(free.lower, unit, 5),
                "to": format_quantity(free.upper, unit, 5),
                "step": "" if free.step is None else format_quantity(free.step, unit),
                "at bound": result.at_bound.get(free.path, ""),
            }
        )
    columns = [name for name in rows[0] if any(row[name] for row in rows)]
    show_table(target, "Variables", columns, ([row[name] for name in columns] for row in rows))


def _show_summary(target: Console, result: DesignResult) -> None:
    from asperity.cli.terminal import table
    from asperity.study.design.design_problem import SUMMARY
    from asperity.units import format_quantity

    rows = table(target, "Before and design", "result", "before", "design")
    for name, which in SUMMARY.items():
        if name not in result.summary_before:
            continue
        shown = result.problem.table[name]
        values = (result.summary_before[name], result.summary_after[name])
        label = shown.said if which == "nominal" else f"{shown.said}, {which}"
        rows.add_row(label, *("-" if v != v else format_quantity(v, shown.display_unit) for v in values))
    target.print(rows)


def _show_limits(target: Console, result: DesignResult) -> None:
    from asperity.results import RESULTS
    from asperity.units import format_quantity

    rows = []
    for limit in result.limits:
        unit = RESULTS[limit.name].display_unit
        rows.append(
            (
                ", ".join(filter(None, (limit.label, limit.row.replace("_", " ")))),
                "-" if limit.value != limit.value else format_quantity(limit.value, unit),
                f"{'<=' if limit.at_most else '>='} {format_quantity(limit.limit, unit)}",
                format_quantity(limit.output_torque, "N*m"),
                limit.state,
                f"{limit.multiplier:.3g}" if limit.multiplier > 1e-9 else "",
            )
        )
    head = ("result", "value", "limit", "at torque", "", "shadow price")
    show_table(target, "Limits, each at its tightest", head, rows)


def _show_search(target: Console, result: DesignResult) -> None:
    target.print(
        f"{_found(result.starts)} Optimality residual {result.optimality_residual:.2g} (0 at a local optimum). Shadow "
        "price: relative gain of the objective per relative relaxation of the limit."
    )


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
