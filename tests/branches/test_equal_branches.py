"""Equal branches beside those that a file states: under the same torque, or below their capacity."""

import dataclasses

import numpy as np
import pytest

from asperity.branches.equal_branches import solve_equal_branches
from asperity.errors import InputError
from asperity.joint.solve import solve_joint


@pytest.fixture(scope="module")
def joint(paper_joint):
    return paper_joint()


def test_a_torque_that_equal_branches_carry(joint):
    solution, carries = solve_equal_branches(joint)
    assert carries
    assert bool(solution.result.solved)
    assert float(solution.result.forces.output_torque) == float(joint.output_torque)


def test_a_torque_beyond_is_solved_below_their_capacity(joint):
    own = solve_joint(joint)
    for torque, capacity in ((20.0, own.capacity), (-20.0, own.reverse_capacity)):
        solution, carries = solve_equal_branches(dataclasses.replace(joint, output_torque=torque))
        assert not carries
        assert float(solution.capacity.output_torque) == pytest.approx(float(own.capacity.output_torque))
        found = float(solution.result.forces.output_torque)
        assert 0.0 < found / np.copysign(float(capacity.output_torque), torque) < 1.0


def test_another_reason_is_told_as_it_is(paper_joint):
    for torque in (1.0, 20.0):
        bad = paper_joint(planet_radius=20e-3, output_torque=torque)
        with pytest.raises(InputError) as own:
            solve_joint(bad)
        with pytest.raises(InputError) as told:
            solve_equal_branches(bad)
        assert str(told.value) == str(own.value)
