"""Margins, objectives and their slopes for results that are known by hand; derivatives against differences."""

import numpy as np
import pytest

from asperity.study.design.design_evaluation import FARTHEST, INSIDE, exists
from asperity.study.design.design_problem import Constraint, Objective

RING = 40e-3  # of the paper's joint [m]
LIMITS = (
    Constraint("hertz_pressure", True, 1e9, (0, 1)),
    Constraint("preload", False, 400.0, (0,)),
    Constraint("speed_ratio", True, -4.0, (0,)),
    Constraint("clearance", False, 0.0, (0, 1)),
    Constraint("slip_ratio", True, 0.8, (0,)),
)
GOALS = (Objective("mass", 1.0), Objective("slip_ratio", 1.0), Objective("published_stiffness_output", -1.0))


def test_margins_are_logarithms_of_ratios_or_differences_over_the_size_of_the_limit(evaluator):
    made = evaluator(GOALS, LIMITS)
    P, L = 500.0, 4e-3  # p0 = 2e6 sqrt(500/0.004) = 7.07107e8 Pa, slip = 50*5/500 = 0.5
    design = made(made.scaled({"load.preload": P, "drive.contact_length": L}))
    p0 = 7.0710678e8
    expected = [
        np.log(1e9 / p0), np.log(2e9 / p0),  # kept by factors
        np.log(500.0 / 400.0),
        (-4.0 + 5.0) / 4.0,  # 1 below a limit of the size 4
        200e-6 / RING, 4e-3 / RING,  # over the ring's radius, as the limit itself is 0
        np.log(0.8 / 0.5),
    ]  # fmt: skip
    np.testing.assert_allclose(design.margins, expected, rtol=1e-7)
    assert design.violation == 0.0
    worse = made(made.scaled({"load.preload": 320.0, "drive.contact_length": L}))
    assert worse.violation == pytest.approx(
        np.log(400.0 / 320.0)
    )  # more than the (4 - 3.2)/4 of the speed ratio
    np.testing.assert_allclose(
        design.objective[:, 0], [np.log(0.4), np.log(0.5), -np.log(5000.0)], rtol=1e-12
    )


@pytest.mark.parametrize("logarithmic", [True, False])
def test_slopes_are_those_of_the_margins_and_objectives(evaluator, logarithmic):
    made = evaluator(GOALS, LIMITS, torques=(2.0, 5.0), logarithmic=logarithmic)
    place, step = np.array([0.55, 0.3]), 1e-6
    design = made(place)
    for j in range(2):
        there, back = (made(place + sign * step * np.eye(2)[j]) for sign in (1, -1))
        numeric = (there.margins - back.margins) / (2 * step)
        np.testing.assert_allclose(design.margin_slopes[:, j], numeric, rtol=1e-6, atol=1e-9)
        numeric = (there.objective - back.objective) / (2 * step)
        np.testing.assert_allclose(design.objective_slopes[:, :, j], numeric, rtol=1e-6, atol=1e-9)


def test_each_scenario_has_its_margins_and_the_nominal_one_need_not_count(evaluator):
    """Torques of 2 and 4 N·m, the file's own of 5 N·m is no scenario: slip = 50 M/P at P = 500."""
    made = evaluator(
        (Objective("mass", 1.0),), (Constraint("slip_ratio", True, 1.0, (0, 1)),), torques=(2.0, 4.0)
    )
    design = made(made.scaled({"load.preload": 500.0, "drive.contact_length": 4e-3}))
    ratios = np.array([0.2, 0.4, 0.16, 0.32])  # contact by contact
    np.testing.assert_allclose(design.margins, -np.log(ratios), rtol=1e-9)
    assert [(row.row, row.scenario) for row in made.rows] == [(0, 1), (0, 2), (1, 1), (1, 2)]
    assert (design.objective.shape, design.status.shape) == ((1, 2), (3,))


def test_what_does_not_exist_is_worse_than_anything_and_has_no_slope(evaluator):
    """No stiffness from 1000 N on."""
    made = evaluator(
        (Objective("published_stiffness_output", -1.0),),
        (Constraint("published_stiffness_output", True, 1e4, (0,)),),
    )
    design = made(made.scaled({"load.preload": 1200.0, "drive.contact_length": 4e-3}))
    good = made(made.scaled({"load.preload": 110.0, "drive.contact_length": 4e-3}))
    assert design.objective[0, 0] > good.objective[0, 0] + 30.0
    assert not design.objective_slopes.any()
    assert design.margins[0] == -FARTHEST
    assert not design.margin_slopes.any()


@pytest.mark.parametrize("at_most", [True, False])
def test_a_result_without_a_value_keeps_no_limit(evaluator, at_most):
    """No stiffness from 1000 N on: neither at most nor at least 1 N·m/rad is met, whatever the search looks at."""
    made = evaluator(
        (Objective("mass", 1.0),), (Constraint("published_stiffness_output", at_most, 1.0, (0,)),)
    )
    point = made.scaled({"load.preload": 1200.0, "drive.contact_length": 4e-3})
    assert made(point).margins[0] == -FARTHEST
    assert made.many(point[None])[1][0, 0] == -FARTHEST
    assert np.isnan(made.nearest[0][1])  # no design had a value yet


@pytest.mark.parametrize("at_most", [True, False])
def test_the_value_nearest_to_a_limit_is_kept_of_all_designs(evaluator, at_most):
    """10 P at 300 and 900 N: 9000 is next to at least 2e4, 3000 to at most 100."""
    limit = Constraint("published_stiffness_output", at_most, 100.0 if at_most else 2e4, (0,))
    made = evaluator((Objective("mass", 1.0),), (limit,))
    for preload in (300.0, 900.0, 1200.0):
        made(made.scaled({"load.preload": preload, "drive.contact_length": 4e-3}))
    assert made.nearest[0][1] == pytest.approx(3000.0 if at_most else 9000.0)


def test_a_joint_exists_while_it_does_not_slip_and_rollers_do_not_overlap(evaluator):
    made = evaluator((Objective("mass", 1.0),), LIMITS)
    slack = made.existence_slack
    assert np.isinf(slack[:4]).all()
    # clearance 0 is the limit itself; a slip ratio of 0.8 may rise to 1
    np.testing.assert_allclose(slack[4:], [-INSIDE, -INSIDE, np.log(1 / 0.8) - INSIDE], rtol=1e-9)

    def lack(preload):
        return made.nonexistence(made(made.scaled({"load.preload": preload, "drive.contact_length": 4e-3})))

    assert lack(400.0) == 0.0  # slip 0.625, clearance 0.1 mm
    assert lack(280.0) == pytest.approx(20e-6 / RING + INSIDE)  # overlap of 20 um, slip 0.89
    assert lack(200.0) == pytest.approx(np.log(1.25) + INSIDE)  # slip 1.25
    margins = made.many(
        np.array([made.scaled({"load.preload": P, "drive.contact_length": 4e-3}) for P in (400.0, 280.0)])
    )[1]
    assert made.existing(margins).tolist() == [True, False]


def test_many_designs_at_once_have_the_worst_of_each_scenario_and_contact(evaluator):
    made = evaluator(
        (Objective("slip_ratio", 1.0), Objective("published_stiffness_output", -1.0)),
        (Constraint("preload", False, 400.0, (0,)), Constraint("hertz_pressure", True, 1e9, (1,))),
        torques=(2.0, 4.0),
    )
    points = [{"load.preload": P, "drive.contact_length": 4e-3} for P in (200.0, 1200.0)]
    objectives, margins = made.many(np.array([made.scaled(point) for point in points]))
    # slip at 4 N·m and the first contact; stiffness 10 P, to be made large, or none
    np.testing.assert_allclose(objectives[:, 0], [1.0, 200.0 / 1200.0], rtol=1e-9)
    assert objectives[0, 1] == pytest.approx(-2000.0)
    assert exists(objectives).tolist() == [[True, True], [True, False]]
    np.testing.assert_allclose(margins[:, 0], np.log([0.5, 3.0]), rtol=1e-9)
    np.testing.assert_allclose(
        margins[:, 1], np.log(1e3 / np.sqrt(np.array([200.0, 1200.0]) / 4e-3)), rtol=1e-9
    )


def test_an_objective_is_the_worst_of_its_own_rows(evaluator):
    """Slip of the second contact alone, 40 M/P, with its slope; the first has more."""
    made = evaluator((Objective("slip_ratio", 1.0, (1,)),), LIMITS, logarithmic=False)
    at = made.scaled({"load.preload": 400.0, "drive.contact_length": 4e-3})
    design = made(at)
    np.testing.assert_allclose(np.exp(design.objective), 0.5, rtol=1e-12)
    np.testing.assert_allclose(design.objective_slopes[0, 0], [-1500.0 / 400.0, 0.0], rtol=1e-12)
    assert made.many(at[None])[0] == pytest.approx(0.5)


def test_the_last_design_is_kept_and_evaluations_are_counted(evaluator):
    made = evaluator((Objective("mass", 1.0),), LIMITS)
    first = made(np.array([0.2, 0.3]))
    assert made(np.array([0.2, 0.3])) is first
    made(np.array([0.2, 0.4]))
    made.many(np.full((5, 2), 0.5))
    assert made.evaluations == 2 + 5
