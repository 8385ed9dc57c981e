"""One joint that is to roll: its capacity by halving, and the refusal beyond it."""

import dataclasses

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint.rolling_refusal import _largest, refuse_no_rolling, rolling_capacity_of
from asperity.joint.solve import solve


@pytest.mark.slow
def test_at_the_capacity_one_contact_is_at_its_limit(wedged):
    solution = solve(wedged)
    capacity = rolling_capacity_of(wedged, solution, direction=1.0)
    assert 8.0 < capacity < 0.95 * float(solution.capacity.output_torque)
    at = solve(dataclasses.replace(wedged, output_torque=capacity * (1 - 1e-9))).result.rolling
    used = np.asarray(at.traction_coefficient) / 0.13
    assert np.argmax(used) == 4
    assert used[4] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.slow
def test_a_torque_beyond_is_refused_with_the_capacity(wedged):
    capacity = rolling_capacity_of(wedged, solve(wedged), direction=1.0)
    beyond = dataclasses.replace(wedged, output_torque=capacity * 1.001)
    with pytest.raises(NoSolutionError, match=r"the output torque is .*, the joint rolls up to .* N·m"):
        refuse_no_rolling(beyond, solve(beyond), capacity)


def test_the_sun_contact_slips_at_one_torque_at_rest_and_in_rolling(paper_joint):
    """Its force follows from the torque alone: mu N_sp 9 n R_s."""
    joint = paper_joint()
    solution = solve(joint)
    assert rolling_capacity_of(joint, solution, direction=1.0) == pytest.approx(
        float(solution.capacity.output_torque), rel=1e-3
    )


@pytest.mark.parametrize("missing", [0.0, 1e-9, 1e-7, 1e-4, 0.3, 1.0])
def test_an_end_near_the_capacity_at_rest_is_found_with_few_joints(missing):
    asked = []

    def rolls(torque):
        asked.append(torque)
        return torque <= 10.0 * (1.0 - missing)

    found = _largest(rolls, 10.0)
    assert found == pytest.approx(10.0 * (1.0 - missing), abs=2e-8)
    assert found <= 10.0 * (1.0 - missing)
    assert len(asked) <= (15 if missing < 1e-6 else 35)


def test_halving_finds_the_end_of_the_interval():
    assert _largest(lambda torque: torque <= 4.321, 10.0) == pytest.approx(4.321, abs=1e-8)
    assert _largest(lambda torque: True, 10.0) == pytest.approx(10.0, abs=1e-8)
    assert _largest(lambda torque: False, 10.0) == 0.0
    assert _largest(lambda torque: True, np.inf) == np.inf
    assert np.isnan(_largest(lambda torque: True, np.nan))
