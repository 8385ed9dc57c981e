"""A design as one JSON document, which the command prints and the page sends."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from asperity.errors import InputError, NoSolutionError
from asperity.joint_file.edited_text import joint_file_text
from asperity.joint_file.reader import parse_case
from asperity.joint_file.solved_document import solve_case
from asperity.study.datasets import number_or_null
from asperity.study.design.design_problem import DesignProblem
from asperity.study.design.design_result import DesignResult

if TYPE_CHECKING:
    import xarray

Diagnostics = dict[str, Any]


def found_diagnostics(joint_text: str) -> Diagnostics:
    """Every limit of a joint that a design has found, kept or crossed, under the torque of its file.

    Parameters
    ----------
    joint_text : str
        The designed joint as a joint file.

    Returns
    -------
    dict
        ``diagnostics``, as in the document of :func:`asperity.results.document.joint_document`; None where the joint
        has no result under that torque, with the reason in ``no_result_because``.
    """
    try:
        document = solve_case(parse_case(joint_text, source="the designed joint")).document
    except (InputError, NoSolutionError) as error:
        return {"diagnostics": None, "no_result_because": str(error)}
    return {"diagnostics": document["diagnostics"], "no_result_because": None}


def front_diagnostics(
    problem: DesignProblem, front: xarray.Dataset, *, progress: Callable[[int, int], None] | None = None
) -> Diagnostics:
    """The limits that the joints of a Pareto front cross."""
    count = int(front.sizes["design"])
    told: Diagnostics = {"diagnostics": [], "no_result_because": []}
    for index in range(count):
        point = {each.path: float(front[each.path].values[index]) for each in problem.variables}
        found = found_diagnostics(joint_file_text(problem.case, point, comment=""))
        entries = found["diagnostics"]
        told["diagnostics"].append(
            None if entries is None else [entry for entry in entries if not entry["ok"]]
        )
        told["no_result_because"].append(found["no_result_because"])
        if progress is not None:
            progress(index + 1, count)
    return told


def design_document(result: DesignResult) -> dict[str, Any]:
    """A design as plain data.

    Parameters
    ----------
    result : DesignResult
        What :func:`asperity.study.design.design.design` returns.

    Returns
    -------
    dict
        Objective before and after, variables, limits, starts and results of the joint, in SI units; its
        ``diagnostics`` as in the document of ``asperity joint``.
    """

    def plain(node: Any) -> Any:
        if isinstance(node, dict):
            return {key: plain(value) for key, value in node.items()}
        if isinstance(node, list | tuple):
            return [plain(each) for each in node]
        return number_or_null(node) if isinstance(node, float) else node

    goal = result.problem.objectives[0]
    document: dict[str, Any] = plain(
        {
            "objective": {
                "result": goal.name,
                "label": result.problem.table[goal.name].label,
                "sense": "minimise" if goal.sign > 0 else "maximise",
                "before": result.objective_before,
                "after": result.objective_after,
                "unrounded": result.objective_unrounded,
            },
            "feasible": result.feasible,
            "converged": result.converged,
            "violation": result.violation,
            "optimality_residual": result.optimality_residual,
            "variables": result.point,
            "at_bound": result.at_bound,
            "before": result.summary_before,
            "after": result.summary_after,
            "limits": [asdict(limit) | {"met": limit.met} for limit in result.limits],
            "starts": [asdict(start) for start in result.starts],
            "nominal": {name: value.tolist() for name, value in result.nominal.items()},
            "evaluations": result.evaluations,
            **found_diagnostics(result.joint_text),
        }
    )
    return document
