"""What the command of :mod:`asperity.cli.design` does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from asperity.cli.progress import progress_bar
from asperity.cli.terminal import print_json, save_image, say_written, show_blocks
from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.si_tables import key_at
from asperity.made_files import MADE_JOINT, Kind, table_with
from asperity.study.design.design import design as search
from asperity.study.design.design_file import read_design
from asperity.study.design.design_map import design_map, mapped_variables
from asperity.study.design.design_plot import design_figure, pareto_figure
from asperity.study.design.design_result import design_document, front_diagnostics, shortcoming
from asperity.study.design.pareto import pareto_front, require_pymoo
from asperity.views.design import design as designed
from asperity.views.design import design_warnings, front_warnings
from asperity.views.design import front as front_blocks
from asperity.writing import check_apart, check_file, check_image, write_text

if TYPE_CHECKING:
    from asperity.study.design.design_problem import DesignProblem


def front_columns(problem: DesignProblem) -> dict[str, str]:
    """Objectives and variables of a problem → the column, with its unit, in the table of its Pareto front."""
    units = {goal.name: problem.table[goal.name].si_unit for goal in problem.objectives}
    units |= {variable.path: key_at(variable.path).dimension.si_unit for variable in problem.variables}
    return {name: f"{name} [{unit}]" for name, unit in units.items()}


def front_table(problem: DesignProblem) -> Kind:
    """The table of the Pareto front of a problem, as a kind of file."""
    return table_with(
        "the table of a Pareto front of these objectives and variables", *front_columns(problem).values()
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
    """What ``asperity design`` does; its options stand in :mod:`asperity.cli.design`."""
    problem = read_design(file)
    front = len(problem.objectives) > 1
    check_apart(out=out, plot=plot, map=map_file)
    for image in (plot, map_file):
        check_image(image, file, problem.joint_file)
    check_file(out, file, problem.joint_file, kind=front_table(problem) if front else MADE_JOINT)
    if map_file is not None or map_over is not None:
        _check_map(problem, map_file, map_over)
    if front:
        _front(problem, out, plot, as_json, population, generations)
        return
    with progress_bar("searches") as report:
        result = search(problem, progress=report)
    if out is not None:  # files first: whoever reads the tables may close the pipe
        write_text(result.joint_text, out, kind=MADE_JOINT)
        say_written(out)
    if plot is not None:
        save_image(design_figure(result), plot)
    if map_file is not None:
        save_image(design_map(result, over=map_over), map_file)
    if as_json:
        print_json(design_document(result))
    else:
        show_blocks(*designed(result), *design_warnings(result))
    if shortcoming(result):
        raise NoSolutionError(shortcoming(result))


def _check_map(problem: DesignProblem, map_file: str | None, over: tuple[str, str] | None) -> None:
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
        save_image(pareto_figure(front, tuple(goal.name for goal in problem.objectives)), plot)
    if as_json:
        print_json({name: front[name].values.tolist() for name in names} | warned)
    else:
        show_blocks(*front_blocks(front, names), *front_warnings(warned))
