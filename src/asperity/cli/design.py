"""``asperity design``: the best joint within limits, or a Pareto front of several objectives."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import click

from asperity.cli.terminal import say_written
from asperity.errors import InputError
from asperity.writing import check_file, check_image, write_image, write_text

if TYPE_CHECKING:
    from asperity.study.design.design import DesignResult
    from asperity.study.design.design_problem import DesignProblem


@click.command()
@click.argument("file", type=click.Path())
@click.option("--out", type=click.Path(), help="Write the designed joint as a joint file (a front: as .csv).")
@click.option(
    "--plot",
    type=click.Path(),
    help="Draw the objective along each variable, or the front (.png, .svg, .pdf).",
)
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON document in SI units instead of tables."
)
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
    file: str, out: str | None, plot: str | None, as_json: bool, population: int, generations: int
) -> None:
    """Choose the free variables of a joint as the design file FILE asks.

    FILE is a TOML file that names a joint file, free variables with bounds, one objective (or two or three for a
    Pareto front), limits, and the torques and tolerances for which they must hold. Where no design meets all limits,
    the command says which of them conflict and by how much, and ends with exit code 3.
    """
    from asperity.cli.progress import progress_bar
    from asperity.precision import use_compilation_cache, use_double_precision

    check_image(plot)
    check_file(out, file)
    from asperity.study.design.design_file import read_design

    problem = read_design(file)
    check_file(out, problem.joint_file)
    use_double_precision()
    use_compilation_cache()
    if len(problem.objectives) > 1:
        _front(problem, out, plot, as_json, population, generations)
        return
    from asperity.study.design.design import conflict
    from asperity.study.design.design import design as search

    with progress_bar("starts") as report:
        result = search(problem, progress=report)
    if out is not None:  # files first: whoever reads the tables may close the pipe
        write_text(result.joint_text, out)
        say_written(out)
    if plot is not None:
        from asperity.study.design.design_plot import design_figure

        write_image(design_figure(result), plot)
        say_written(plot)
    if as_json:
        import json

        click.echo(json.dumps(_document(result), indent=2, allow_nan=False))
    else:
        _show(result)
    if not result.feasible:
        from asperity.errors import NoSolutionError

        raise NoSolutionError(conflict(result))


def _front(
    problem: DesignProblem,
    out: str | None,
    plot: str | None,
    as_json: bool,
    population: int,
    generations: int,
) -> None:
    from asperity.cli.progress import progress_bar
    from asperity.study.design.pareto import pareto_front, require_pymoo

    require_pymoo()
    if out is not None and not out.endswith(".csv"):
        raise InputError(f"{out}: a Pareto front is a table of many joints; give it a name that ends in .csv")
    with progress_bar("generations") as report:
        front = pareto_front(problem, population=population, generations=generations, progress=report)
    names = [goal.name for goal in problem.objectives] + [variable.path for variable in problem.variables]
    if out is not None:
        head = ",".join(f"{name} [{front[name].attrs['units']}]" for name in names)
        rows = zip(*(front[name].values for name in names), strict=True)
        write_text("\n".join([head, *(",".join(repr(float(v)) for v in row) for row in rows)]) + "\n", out)
        say_written(out)
    if plot is not None:
        from asperity.study.design.design_plot import pareto_figure

        write_image(pareto_figure(front, tuple(goal.name for goal in problem.objectives)), plot)
        say_written(plot)
    if as_json:
        import json

        click.echo(
            json.dumps({name: front[name].values.tolist() for name in names}, indent=2, allow_nan=False)
        )
    else:
        _show_front(problem, front, names)


def _show_front(problem: DesignProblem, front: Any, names: list[str]) -> None:
    import numpy as np

    from asperity.cli.terminal import console, table
    from asperity.joint_file.values import key_at
    from asperity.study.quantities import QUANTITIES
    from asperity.units import from_si

    target = console()
    units = [QUANTITIES[n].unit if n in QUANTITIES else key_at(n).unit for n in names]
    shown = table(
        target,
        f"Pareto front: {front.sizes['design']} designs, {problem.level} stiffness (eleven of them, evenly spread)",
        *(f"{name.rsplit('.', 1)[-1]}\n[{unit}]" for name, unit in zip(names, units, strict=True)),
    )
    for index in np.unique(np.linspace(0, front.sizes["design"] - 1, 11).round().astype(int)):
        shown.add_row(
            *(f"{from_si(float(front[n].values[index]), u):.5g}" for n, u in zip(names, units, strict=True))
        )
    target.print(shown)


def _document(result: DesignResult) -> dict[str, Any]:
    from dataclasses import asdict

    goal = result.problem.objectives[0]
    return {
        "objective": {
            "quantity": goal.name,
            "sense": "minimise" if goal.sign > 0 else "maximise",
            "level": result.problem.level,
            "before": _number(result.objective_before),
            "after": _number(result.objective_after),
        },
        "feasible": result.feasible,
        "violation": result.violation,
        "optimality": result.optimality,
        "variables": result.point,
        "at_bound": result.at_bound,
        "limits": [{key: _number(value) for key, value in asdict(limit).items()} for limit in result.limits],
        "starts": [{**asdict(start), "objective": _number(start.objective)} for start in result.starts],
        "nominal": {name: [_number(v) for v in value.tolist()] for name, value in result.nominal.items()},
        "evaluations": result.evaluations,
    }


def _number(value: Any) -> Any:
    import math

    return None if isinstance(value, float) and not math.isfinite(value) else value


def _show(result: DesignResult) -> None:
    from asperity.cli.terminal import console, table
    from asperity.joint_file.values import key_at, numeric_keys
    from asperity.study.quantities import QUANTITIES
    from asperity.units import format_quantity

    target, problem = console(), result.problem
    goal = problem.objectives[0]
    unit = QUANTITIES[goal.name].unit
    met = "(all limits met)" if result.feasible else "(limits missed)"
    worst = f" at its worst over {int(len(problem.worst_case.torques) or 1)} torques"
    if problem.worst_case.tolerances != "none":
        worst += f" and the {problem.worst_case.tolerances} of the tolerances"
    target.print(f"{goal.text} ({problem.level}){worst}:")
    target.print(
        f"  {format_quantity(result.objective_before, unit)} in {problem.joint_file} -> "
        f"{format_quantity(result.objective_after, unit)} {met}"
    )
    stated = numeric_keys(problem.case)
    variables = table(target, "Variables", "number", "before", "design", "from", "to", "")
    for each in problem.variables:
        shown = key_at(each.path).unit
        before = format_quantity(stated[each.path].value, shown) if each.path in stated else "-"
        numbers = (result.point[each.path], each.lower, each.upper)
        variables.add_row(
            each.path,
            before,
            *(format_quantity(v, shown, 5) for v in numbers),
            result.at_bound.get(each.path, ""),
        )
    target.print(variables)
    limits = table(
        target,
        "Limits, each where it is closest",
        "quantity",
        "value",
        "limit",
        "at torque",
        "active",
        "price",
    )
    for limit in result.limits:
        kind = QUANTITIES[limit.name]
        sign = "<=" if limit.at_most else ">="
        limits.add_row(
            f"{kind.label} {limit.row}".strip(),
            format_quantity(limit.value, kind.unit),
            f"{sign} {format_quantity(limit.limit, kind.unit)}",
            format_quantity(limit.output_torque, "N*m"),
            "yes" if limit.active else "",
            f"{limit.multiplier:.3g}" if limit.multiplier > 1e-9 else "",
        )
    target.print(limits)
    ends = sorted(
        {f"{start.objective:.4g}" for start in result.starts if start.converged and start.violation < 1e-6}
    )
    converged = sum(start.converged for start in result.starts)
    target.print(
        f"{converged} of {len(result.starts)} starts converged, to {len(ends)} different value{'s' * (len(ends) != 1)} "
        f"(4 digits); gradient left unexplained by the limits: {result.optimality:.2g}. "
        "Price: relative gain per relative relaxation of the limit."
    )
