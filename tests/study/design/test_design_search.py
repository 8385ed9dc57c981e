"""The search on power laws: optima, shadow prices, conflicts and existence as they follow by hand."""

import dataclasses

import numpy as np
import pytest

from asperity.results import RESULTS
from asperity.study.design import design_evaluation, design_search
from asperity.study.design.design_problem import Constraint, Objective
from asperity.study.design.design_search import (
    SearchProgress,
    local_optimum,
    optimality,
    smallest_violation,
    starting_points,
    violation_rank,
)

LIGHT = (Objective("mass", 1.0),)
#: p0 = 2e6 sqrt(P/L) at most 7e8 Pa: L = P (2/700)^2; slip 50 M/P at most 0.5, M = 5 N·m: P = 500 N
LIMITS = (Constraint("hertz_pressure", True, 7e8, (0, 1)), Constraint("slip_ratio", True, 0.5, (0, 1)))
BEST = {"load.preload": 500.0, "drive.contact_length": 500.0 * (2 / 700) ** 2}


@pytest.mark.parametrize("start", [(0.5, 0.5), (0.0, 0.0), (1.0, 1.0), (0.9, 0.05)])
def test_the_optimum_of_power_laws_from_every_start(evaluator, start):
    made = evaluator(LIGHT, LIMITS)
    end, converged = local_optimum(made, np.array(start))
    assert converged
    assert made.point(end) == pytest.approx(BEST, rel=1e-6)


def test_a_line_search_that_fails_beyond_the_limits_begins_again_within_them(evaluator, monkeypatch):
    """SLSQP that gives up at a slip ratio of 0.83 still ends at the optimum, without the slower trust-constr."""
    made = evaluator(LIGHT, LIMITS)
    minimize, methods = design_search.minimize, []

    def gives_up_first(*arguments, **options):
        methods.append(options["method"])
        found = minimize(*arguments, **options)
        if len(methods) == 1:
            far = made.scaled({"load.preload": 300.0, "drive.contact_length": 4e-3})
            found.x, found.success = np.append(far, found.x[-1]), False
        return found

    monkeypatch.setattr(design_search, "minimize", gives_up_first)
    end, converged = local_optimum(made, np.array([0.5, 0.5]))
    assert converged
    assert made.point(end) == pytest.approx(BEST, rel=1e-6)
    assert set(methods) == {"SLSQP"}


def test_shadow_prices_are_the_exponents_of_the_optimum(evaluator):
    """m = 100 L = 100 P c^2/p^2 with P = 250/s: 1 % of the pressure limit gains 2 %, of the slip limit 1 %."""
    made = evaluator(LIGHT, LIMITS)
    residual, multipliers = optimality(made, made.scaled(BEST))
    assert residual < 1e-7
    np.testing.assert_allclose(multipliers, [2.0, 0.0, 1.0, 0.0], atol=1e-5)


def test_shadow_prices_of_an_objective_that_may_be_negative_are_relative_too(evaluator, monkeypatch):
    """The same mass without its logarithm: what 1 % of a limit gains stays 2 % and 1 % of it."""
    rows = {**RESULTS, "mass": dataclasses.replace(RESULTS["mass"], positive=False)}
    for module in (design_search, design_evaluation):
        monkeypatch.setattr(module, "RESULTS", rows)
    made = evaluator(LIGHT, LIMITS)
    residual, multipliers = optimality(made, made.scaled(BEST))
    assert residual < 1e-7
    np.testing.assert_allclose(multipliers, [2.0, 0.0, 1.0, 0.0], atol=1e-5)


def test_a_point_inside_the_limits_is_no_optimum(evaluator):
    """All of the slope of ln m, (10 - 2)/5 per unit of the scaled length at 5 mm, is left."""
    made = evaluator(LIGHT, LIMITS)
    residual, multipliers = optimality(
        made, made.scaled({"load.preload": 520.0, "drive.contact_length": 5e-3})
    )
    assert residual == pytest.approx(1.0)
    assert not multipliers.any()


def test_a_bound_holds_the_objective_as_a_limit_does(evaluator):
    made = evaluator(LIGHT, (Constraint("slip_ratio", True, 0.5, (0, 1)),))
    end, converged = local_optimum(made, np.array([0.8, 0.7]))
    assert converged
    assert made.point(end)["drive.contact_length"] == pytest.approx(2e-3, rel=1e-9)
    assert optimality(made, end)[0] < 1e-7
    # the upper bound of 10 mm holds nothing: (10 - 2)/10 per unit, less than one logarithmic unit
    assert optimality(made, np.array([0.8, 1.0]))[0] == pytest.approx(0.8)
    # but it holds what is to be as heavy as possible, which the lower bound does not
    heavy = evaluator((Objective("mass", -1.0),), (Constraint("slip_ratio", True, 0.5, (0, 1)),))
    assert optimality(heavy, np.array([0.8, 1.0]))[0] < 1e-7
    assert optimality(heavy, np.array([0.8, 0.0]))[0] == pytest.approx(1.0)


def test_fixed_variables_stay_and_the_rest_is_optimal(evaluator):
    """P = 600 N kept: L = P c^2/p^2 still follows from the pressure."""
    made = evaluator(LIGHT, LIMITS)
    start = made.scaled({"load.preload": 600.0, "drive.contact_length": 8e-3})
    end, converged = local_optimum(made, start, fixed=np.array([True, False]))
    assert converged
    wanted = {"load.preload": 600.0, "drive.contact_length": 600.0 * (2 / 700) ** 2}
    assert made.point(end) == pytest.approx(wanted, rel=1e-6)
    residual, multipliers = optimality(made, end, fixed=np.array([True, False]))
    assert residual < 1e-7
    np.testing.assert_allclose(multipliers, [2.0, 0.0, 0.0, 0.0], atol=1e-5)
    # without the length free, nothing is left to choose that would meet the slip ratio at 300 N
    low = made.scaled({"load.preload": 300.0, "drive.contact_length": 8e-3})
    end, converged = local_optimum(made, low, fixed=np.array([True, False]))
    assert not converged
    assert made.point(end)["load.preload"] == pytest.approx(300.0)


def test_the_worst_scenario_counts(evaluator):
    """slip = 50 M/P at M = 1, 8 N·m: P = 800 N, L = P c^2/p^2."""
    made = evaluator(LIGHT, LIMITS, torques=(1.0, 8.0))
    end, converged = local_optimum(made, np.array([0.5, 0.5]))
    assert converged
    wanted = {"load.preload": 800.0, "drive.contact_length": 800.0 * (2 / 700) ** 2}
    assert made.point(end) == pytest.approx(wanted, rel=1e-6)


def test_conflicting_limits_are_missed_by_the_same_factor(evaluator):
    """At least 600 N and at most 400 N: the geometric mean, both by sqrt(1.5)."""
    made = evaluator(
        LIGHT, (Constraint("preload", False, 600.0, (0,)), Constraint("preload", True, 400.0, (0,)))
    )
    end = smallest_violation(made, np.array([0.1, 0.5]))
    assert made.point(end)["load.preload"] == pytest.approx(np.sqrt(600.0 * 400.0), rel=1e-6)
    assert made(end).violation == pytest.approx(0.5 * np.log(1.5), rel=1e-6)
    assert violation_rank(made, end) == (0.0, made(end).violation)
    residual, multipliers = optimality(made, end)
    assert residual < 1e-6
    np.testing.assert_allclose(multipliers, [0.5, 0.5], atol=1e-5)
    found, converged = local_optimum(made, np.array([0.9, 0.5]))
    assert not converged
    assert made.point(found)["load.preload"] == pytest.approx(np.sqrt(600.0 * 400.0), rel=1e-4)


def test_the_smallest_violation_is_that_of_a_joint_that_exists(evaluator):
    """At most 150 N would slip (250/P > 1) and overlap (P < 300): the nearest joint has 300 N."""
    made = evaluator(
        LIGHT,
        (
            Constraint("preload", True, 150.0, (0,)),
            Constraint("slip_ratio", True, 1.0, (0, 1), implied=True),
            Constraint("clearance", False, 0.0, (0,), implied=True),
        ),
    )
    start = made.scaled({"load.preload": 140.0, "drive.contact_length": 4e-3})
    assert violation_rank(made, start)[0] == pytest.approx(np.log(250 / 140), rel=1e-4)
    end = smallest_violation(made, start)
    assert made.point(end)["load.preload"] == pytest.approx(300.0, rel=1e-3)
    assert violation_rank(made, end)[0] == 0.0
    assert made(end).violation == pytest.approx(np.log(2.0), rel=1e-3)


def test_the_search_begins_at_the_joint_of_the_file_and_spreads_over_the_bounds(evaluator):
    points = starting_points(evaluator(LIGHT, LIMITS, starts=6, seed=3))
    assert len(points) == 6
    # 1000 N and 5 mm: ln 10/ln 16 and 3/8
    np.testing.assert_allclose(points[0], [np.log(10) / np.log(16), 3 / 8], rtol=1e-12)
    strata = np.sort(np.floor(5 * np.array(points[1:])), axis=0)  # one of each fifth of every variable
    np.testing.assert_array_equal(strata, np.arange(5.0)[:, None] * np.ones(2))
    again = starting_points(evaluator(LIGHT, LIMITS, starts=6, seed=3))
    np.testing.assert_array_equal(points, again)
    assert len(starting_points(evaluator(LIGHT, LIMITS, starts=1))) == 1


def test_progress_counts_searches_done_and_known():
    told = []
    progress = SearchProgress(lambda done, total: told.append((done, total)))
    progress.expect(2)
    progress.step()
    progress.expect(1)
    assert told == [(0, 2), (1, 2), (1, 3)]
    SearchProgress(None).step()
