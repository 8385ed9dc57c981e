"""One solved joint: its capacities in the direction of its torque and in rolling, and its duty."""

import dataclasses

import numpy as np
import pytest

from asperity.joint import solved
from asperity.joint.rolling_conditions import DutyPoint
from asperity.joint.solve import solve
from asperity.joint.solved import SolvedPapersJoint


@pytest.fixture(scope="module")
def solution(paper_joint):
    """With capacities that differ, to tell the directions apart."""
    found = solve(paper_joint())
    one, two = (dataclasses.replace(found.capacity, output_torque=np.asarray(each)) for each in (1.0, 2.0))
    return dataclasses.replace(found, capacity=one, reverse_capacity=two)


@pytest.mark.slow
@pytest.mark.parametrize(("torque", "of_direction"), [(5.0, 1.0), (-5.0, 2.0)])
def test_each_direction_has_its_capacity(paper_joint, solution, monkeypatch, torque, of_direction):
    monkeypatch.setattr(solved, "rolling_capacity_of", lambda joint, solution, *, direction: 3.0 * direction)
    found = SolvedPapersJoint(paper_joint(output_torque=torque), solution)
    assert float(found.capacity_of_direction.output_torque) == of_direction
    assert [float(each.output_torque) for each in (found.capacity, found.reverse_capacity)] == [1.0, 2.0]
    assert (found.rolling_capacity, found.reverse_rolling_capacity) == (3.0, -3.0)


@pytest.mark.slow
def test_loads_of_the_duty_are_joints_under_them(paper_joint, solution):
    joint = paper_joint()
    points = tuple(DutyPoint(*map(np.asarray, each)) for each in ((2.0, 100.0, 0.4), (-4.0, 0.0, 0.6)))
    rolling = dataclasses.replace(joint.rolling, duty=points)
    found = SolvedPapersJoint(dataclasses.replace(joint, rolling=rolling), solution).duty_states
    for (there, result), point in zip(found, points, strict=True):
        alone = dataclasses.replace(joint, output_torque=point.output_torque, sun_speed=point.sun_speed)
        assert float(there.output_torque) == float(point.output_torque)
        expected = solve(alone).result.forces.normal
        np.testing.assert_allclose(result.forces.normal, expected, rtol=1e-10)
