"""A design problem whose results are power laws, so that its optima are known by hand."""

import numpy as np
import pytest

from asperity.study.design import design_evaluation
from asperity.study.design.design_evaluation import DesignEvaluator
from asperity.study.design.design_problem import DesignProblem, Variable, WorstCase

PRELOAD, LENGTH = "load.preload", "drive.contact_length"
TORQUE = "load.output_torque"


def known_results(preload, length, torque):
    """Name → (rows of values, rows of their derivatives by preload and length), each of shape (points,).

    mass = 100 L; pressure p0 = 2e6 sqrt(P/L) at the first contact and half of it at the second; slip ratio
    50 M/P and 40 M/P; speed ratio -P/100; clearances 1e-6 (P - 300) and L; a published stiffness that exists
    only below P = 1000.
    """
    P, L, M = preload, length, torque
    o = np.zeros_like(P)
    p0 = 2e6 * np.sqrt(P / L)
    stiffness = np.where(P < 1000.0, 10.0 * P, np.nan)
    return {
        "mass": ([100 * L], [(o, o + 100)]),
        "preload": ([P], [(o + 1, o)]),
        "hertz_pressure": ([p0, p0 / 2], [(p0 / P / 2, -p0 / L / 2), (p0 / P / 4, -p0 / L / 4)]),
        "slip_ratio": ([50 * M / P, 40 * M / P], [(-50 * M / P**2, o), (-40 * M / P**2, o)]),
        "speed_ratio": ([-P / 100], [(o - 0.01, o)]),
        "clearance": ([1e-6 * (P - 300), L], [(o + 1e-6, o), (o, o + 1)]),
        "published_stiffness_output": ([stiffness], [(np.where(P < 1000.0, 10.0, np.nan), o)]),
    }


@pytest.fixture
def evaluator(case, monkeypatch):
    """Maker of evaluators of the known results; preload from 100 to 1600 N, length from 2 to 10 mm."""

    def known(values, changes, results, paths=(), *, block):
        preload, length, torque = np.broadcast_arrays(*(changes[path] for path in (PRELOAD, LENGTH, TORQUE)))
        found = known_results(preload, length, torque)
        place = {PRELOAD: 0, LENGTH: 1}
        slopes = {
            name: np.array([np.stack([row[place[path]] for path in paths], axis=-1) for row in rows])
            for name, (_, rows) in found.items()
            if paths
        }
        status = np.zeros(preload.shape, dtype=np.int8)
        return status, {name: np.array(rows) for name, (rows, _) in found.items()}, slopes

    monkeypatch.setattr(design_evaluation, "derivatives_at", known)

    def make(objectives, constraints, *, torques=(), starts=1, seed=0, logarithmic=True):
        problem = DesignProblem(
            case=case,
            joint_file="zou2025.toml",
            level="published",
            variables=(
                Variable(PRELOAD, 100.0, 1600.0, logarithmic),
                Variable(LENGTH, 2e-3, 10e-3, False),
            ),
            objectives=tuple(objectives),
            constraints=tuple(constraints),
            worst_case=WorstCase(torques, "none", 0, 0),
            starts=starts,
            seed=seed,
        )
        return DesignEvaluator(problem)

    return make
