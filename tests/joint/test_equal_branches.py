"""Equal branches beside those that a file states: under the same torque, or without a state where they slip."""

import dataclasses

import numpy as np
import pytest

from asperity.errors import InputError
from asperity.joint.equal_branches import solve_equal_branches, without_state
from asperity.joint.solve import solve


@pytest.fixture(scope="module")
def joint(paper_joint):
    return paper_joint()


@pytest.fixture(scope="module")
def beyond(joint):
    return dataclasses.replace(joint, output_torque=20.0)


def test_a_torque_that_equal_branches_carry(joint):
    solution, carries = solve_equal_branches(joint, solve)
    assert carries
    assert bool(solution.result.solved)
    assert float(solution.result.forces.output_torque) == float(joint.output_torque)


def test_a_torque_beyond_is_solved_below_their_capacity(joint, beyond):
    own = solve(joint)
    for torque, capacity in ((20.0, own.capacity), (-20.0, own.reverse_capacity)):
        solution, carries = solve_equal_branches(dataclasses.replace(joint, output_torque=torque), solve)
        assert not carries
        assert float(solution.capacity.output_torque) == pytest.approx(float(own.capacity.output_torque))
        found = float(solution.result.forces.output_torque)
        assert 0.0 < found / np.copysign(float(capacity.output_torque), torque) < 1.0


def test_another_reason_is_told_as_it_is(joint, beyond):
    apart = dataclasses.replace(joint.geometry, planet_radius=20e-3)
    for torque in (1.0, 20.0):
        bad = dataclasses.replace(beyond, geometry=apart, output_torque=torque)
        with pytest.raises(InputError) as own:
            solve(bad)
        with pytest.raises(InputError) as told:
            solve_equal_branches(bad, solve)
        assert str(told.value) == str(own.value)


def test_what_depends_on_the_torque_is_unknown(joint, beyond):
    solution, _ = solve_equal_branches(beyond, solve)
    empty = without_state(solution, 20.0)
    result = empty.result
    assert not bool(result.solved)
    assert float(result.forces.output_torque) == 20.0
    unknown = (
        result.forces.normal,
        result.assembly.stiffness.output,
        result.diagnostics.hertz_pressure,
        result.rolling.drift_per_output_turn,
    )
    for each in unknown:
        assert np.all(np.isnan(np.asarray(each)))
    known = (result.planet_mass, result.interference, empty.capacity.output_torque, result.speed_ratio)
    before = solution.result
    expected = (before.planet_mass, before.interference, solution.capacity.output_torque, before.speed_ratio)
    np.testing.assert_array_equal(np.array(known, dtype=float), np.array(expected, dtype=float))
