"""Pareto fronts: no design beats another, all limits hold, and the front meets the monotone trade-off."""

import tomllib

import numpy as np
import pytest

from asperity.study.design.design_file import design_from_tables
from asperity.study.design.pareto import pareto_front

TEXT = """
joint = "zou2025.toml"
[variables]
load.preload = { lower = "300 N", upper = "3000 N" }
surface.fractal_dimension = { lower = 1.3, upper = 1.9 }
[objective]
maximise = "stiffness"
minimise = "preload"
[constraints]
slip_ratio = { at_most = 0.8 }
"""


def test_front(zou_file):
    pytest.importorskip("pymoo")
    problem = design_from_tables(tomllib.loads(TEXT), folder=zou_file.parent)
    calls = []
    front = pareto_front(problem, population=24, generations=8, progress=lambda done, of: calls.append(done))
    stiffness, preload = front["assembly_stiffness_output"].values, front["preload"].values
    assert calls[-1] == 8
    assert front["assembly_stiffness_output"].attrs["units"] == "N*m/rad"
    assert np.all(front["margin"].values >= 0.0)
    assert np.all(np.diff(stiffness) > 0.0)
    assert np.all(np.diff(preload) > 0.0)  # sorted by stiffness, more of it costs preload
    assert preload.min() >= 0.98 * 5.0 / (9 * 3 * 0.004) / (0.8 * 0.12)  # slip at sp, as in test_design
    assert preload == pytest.approx(front["load.preload"].values)
