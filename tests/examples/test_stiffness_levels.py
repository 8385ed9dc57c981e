"""The three levels of the paper's joint, against the independent assembly in benchmarks/baseline_assembly.py."""

import math

import numpy as np
import pytest

from asperity.joint.solve import solve_joint


@pytest.mark.slow
def test_levels_of_the_papers_joint(load_example, monkeypatch, paper_joint):
    monkeypatch.setenv("ASPERITY_CACHE_DIR", "")
    result = load_example("stiffness_levels").main()
    # printed by benchmarks/baseline_assembly.py for a solid ring at 0 N·m and 0 rpm; 60 mm of wall is within 1e-3 of it
    assert float(result.published.output) == pytest.approx(5.0413e6, rel=2e-5)
    assert float(result.series_with_bulk.output) == pytest.approx(3.1710e5, rel=1e-3)
    joint = paper_joint(ring_wall_thickness=60e-3, output_torque=1e-6, sun_speed=0.0, body_model="springs")
    springs = float(solve_joint(joint).result.assembly.stiffness.output)
    assert springs == pytest.approx(3.0892e4, rel=1e-3)
    # what exact bodies change without asperities, by the machine of examples/ring_wall.py
    wall = load_example("ring_wall")
    widths = wall.half_widths(wall.rest_forces(1000.0))
    of_springs = wall.assembled_stiffness(np.diag(np.tile(wall.springs(widths, 60e-3), 2))[..., None])
    change = float((wall.stiffness_over_wall(np.array([60e-3]), math.inf) / of_springs)[0])
    assert float(result.assembly.stiffness.output) / springs == pytest.approx(change, rel=5e-4)
