"""Pareto fronts: no design beats another, all limits hold, and the front is the one of an exhaustive search."""

import tomllib

import numpy as np
import pytest

from asperity.joint_file.si_tables import si_values
from asperity.study.batch import derivatives_at
from asperity.study.design import pareto as module
from asperity.study.design.design_file import design_from_tables
from asperity.study.design.design_problem import Constraint, Objective
from asperity.study.design.pareto import pareto_front

TEXT = """
joint = "zou2025.toml"
level = "published"
[variables]
load.preload = { lower = "300 N", upper = "3000 N" }
surface.fractal_dimension = { lower = 1.3, upper = 1.9 }
[objective]
maximise = "stiffness"
minimise = "preload"
[constraints]
slip_ratio = { at_most = 0.8 }
pressure_over_first_yield = { at_most = 10.0 }
shakedown_ratio = { at_most = 10.0 }
"""
#: Smallest preload for a slip ratio of 0.8 at the sun, with the force at rest: T_sp/(0.8 mu).
PRELOAD = 5.0 / (9 * 3 * 0.004) / (0.8 * 0.12)


def shortfall(front, values):
    """By which share the stiffnesses of a front are below the best of all D at their preloads, on average."""
    preload, dimension = np.meshgrid(front["load.preload"].values, np.linspace(1.3, 1.9, 61), indexing="ij")
    changes = {"load.preload": preload.ravel(), "surface.fractal_dimension": dimension.ravel()}
    _, found, _ = derivatives_at(values, changes, ("published_stiffness_output", "slip_ratio"))
    best = found["published_stiffness_output"].reshape(preload.shape).max(axis=1)
    return float(np.mean(1.0 - front["published_stiffness_output"].values / best))


@pytest.mark.long
def test_front(zou_file):
    pytest.importorskip("pymoo")
    problem = design_from_tables(tomllib.loads(TEXT), folder=zou_file.parent)
    values = si_values(problem.case)
    calls = []
    front = pareto_front(problem, population=24, generations=40, progress=lambda done, of: calls.append(done))
    one_generation = pareto_front(problem, population=24, generations=1)
    stiffness, preload = front["published_stiffness_output"].values, front["preload"].values
    assert calls[-1] == 40
    assert front["published_stiffness_output"].attrs["units"] == "N*m/rad"
    assert front.sizes["design"] == 24
    assert np.all(front["margin"].values >= 0.0)
    assert np.all(np.diff(stiffness) > 0.0)
    assert np.all(np.diff(preload) > 0.0)  # sorted by stiffness, more of it costs preload
    assert preload == pytest.approx(front["load.preload"].values)
    # both ends are reached, and in between nothing is gained by another D: one generation is far from it
    assert PRELOAD * 0.98 <= preload.min() <= PRELOAD * 1.05
    assert preload.max() >= 0.95 * 3000.0
    # of ten seeds: 0.005 after 40 generations, 0.19 after one (geometric means), a factor of 1.7 and 1.9 of scatter
    assert shortfall(front, values) < 0.03 < shortfall(one_generation, values)


@pytest.mark.slow  # pymoo alone takes a second to import
def test_front_of_a_made_up_joint_by_hand(evaluator, monkeypatch):
    """Much preload at little pressure, 2 MPa sqrt(P/L): lines of 10 mm throughout, from 400 N, the limit, to 1600 N."""
    pytest.importorskip("pymoo")
    goals = (Objective("preload", -1.0), Objective("hertz_pressure", 1.0))
    made = evaluator(goals, (Constraint("preload", False, 400.0, (0,)),))
    monkeypatch.setattr(module, "DesignEvaluator", lambda problem: made)
    # sizes of both in the middle of the bounds: 400 N, the middle of the logarithm, on 6 mm
    np.testing.assert_allclose(module._scales(made), [400.0, 2e6 * np.sqrt(400.0 / 6e-3)], rtol=1e-12)
    seen = []
    found = pareto_front(
        made.problem, population=24, generations=25, progress=lambda *done: seen.append(done)
    )
    assert seen[-1] == (25, 25)
    preload, pressure = found["preload"].values, found["hertz_pressure"].values
    assert np.all(np.diff(preload) >= 0.0)
    assert preload[0] == pytest.approx(400.0, rel=0.05)
    assert preload[-1] == pytest.approx(1600.0, rel=0.02)
    np.testing.assert_allclose(pressure, 2e6 * np.sqrt(preload / 10e-3), rtol=0.05)
    np.testing.assert_allclose(found["load.preload"], preload, rtol=1e-12)
    np.testing.assert_allclose(found["margin"], np.log(preload / 400.0), atol=1e-9)
