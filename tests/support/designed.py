"""The design of a joint with one goal, as it would be found."""

from asperity.study.design.design_problem import SUMMARY, DesignProblem, Objective, WorstCase
from asperity.study.design.design_result import DesignResult, LimitReport


def design_problem(case, *variables):
    """The largest stiffness of the assembly at 0 and 5 N·m."""
    return DesignProblem(
        case=case,
        joint_file="joint.toml",
        level="assembly",
        variables=variables,
        objectives=(Objective("assembly_stiffness_output", -1.0),),
        constraints=(),
        worst_case=WorstCase((0.0, 5.0), "none", 0, 0),
        starts=1,
        seed=0,
    )


def slip_limit(multiplier):
    """A limit of the slip ratio that is active."""
    return LimitReport(
        name="slip_ratio", label="slip ratio T/(mu N)", row="sp", at_most=True, limit=0.8, value=0.8, missed_by=0.0,
        active=True, multiplier=multiplier, implied=False, output_torque=5.0,
    )  # fmt: skip


def design_result(problem, point, limit, starts=()):
    """This point, its preload at the upper bound, with a sixth more stiffness."""
    return DesignResult(
        problem=problem,
        feasible=True,
        crossed=(),
        allowed=(),
        unknown=(),
        point=point,
        optimum=point,
        at_bound={"load.preload": "upper"},
        objective_before=30000.0,
        objective_after=35000.0,
        objective_unrounded=None,
        missed_before=(),
        summary_before=dict.fromkeys(SUMMARY, 1.0),
        summary_after=dict.fromkeys(SUMMARY, float("nan")),
        limits=(limit,),
        diagnostics={"diagnostics": [], "life_hours": None, "no_result_because": None},
        optimality_residual=0.0,
        starts=starts,
        evaluations=1,
        joint_text="# designed\n",
        nominal={},
    )
