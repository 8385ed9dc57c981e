"""A design as one JSON document, which the command prints and the page sends."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from asperity.study.datasets import number_or_null
from asperity.study.design.design_result import DesignResult
from asperity.study.design.found_joint import found_diagnostics


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
