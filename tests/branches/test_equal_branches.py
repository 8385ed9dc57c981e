"""Equal branches beside those that a file states: under the same torque, or without a state where they slip."""

import dataclasses

import numpy as np
import pytest

from asperity.branches.equal_branches import solve_equal_branches, without_state
from asperity.branches.results import branch_rolling
from asperity.errors import InputError
from asperity.joint.solve import solve_joint
from asperity.rolling.power import RollingLosses


@pytest.fixture(scope="module")
def joint(paper_joint):
    return paper_joint()


@pytest.fixture(scope="module")
def beyond(joint):
    return dataclasses.replace(joint, output_torque=20.0)


def test_a_torque_that_equal_branches_carry(joint):
    solution, carries = solve_equal_branches(joint)
    assert carries
    assert bool(solution.result.solved)
    assert float(solution.result.forces.output_torque) == float(joint.output_torque)


def test_a_torque_beyond_is_solved_below_their_capacity(joint, beyond):
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


def test_what_depends_on_the_torque_is_unknown(joint, beyond, unequal_branches):
    solution, _ = solve_equal_branches(beyond)
    own = unequal_branches()
    empty = without_state(
        solution, 20.0, dataclasses.replace(own, standing=None, stiffness=None, turning=None)
    )
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
    known = (result.masses[1], result.interference, empty.capacity.output_torque, result.speed_ratio)
    before = solution.result
    expected = (before.masses[1], before.interference, solution.capacity.output_torque, before.speed_ratio)
    np.testing.assert_array_equal(np.array(known, dtype=float), np.array(expected, dtype=float))


def test_what_all_branches_do_together_is_known(beyond, unequal_branches):
    """3 N·m at the input and 20 at the output of the paper's ratio of 9; 5 W of losses beside 15 W of output."""
    solution, _ = solve_equal_branches(beyond)
    own = unequal_branches()
    nothing = np.zeros(5)
    turning = branch_rolling(
        losses=RollingLosses(nothing, nothing, nothing, nothing, np.asarray(1.0), np.full(5, 0.8)),
        speed_loss=2e-3,
        drift_per_output_turn=0.0126,
        output_torque=20.0,
        output_speed=0.75,
        input_speed=5.0,
    )
    state = dataclasses.replace(own.standing, input_torque=3.0)
    told = dataclasses.replace(own, standing=state, stiffness=4e4, turning=turning)
    result = without_state(solution, 20.0, told).result
    assert float(result.forces.input_torque) == 3.0
    assert float(result.assembly.stiffness.output) == 4e4
    assert float(result.assembly.stiffness.sun) == pytest.approx(
        4e4 / float(result.speed_ratio) ** 2, rel=1e-12
    )
    assert float(result.rolling.power.loss) == pytest.approx(5.0, rel=1e-12)
    assert float(result.rolling.power.efficiency) == pytest.approx(0.75, rel=1e-12)
    assert float(result.rolling.drift_rate) == pytest.approx(0.0126 * 0.75 / (2.0 * np.pi), rel=1e-12)
    assert float(result.rolling.speed_loss) == 2e-3
    assert np.all(np.isnan(np.asarray(result.rolling.normal)))
