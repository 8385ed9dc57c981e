"""The torque under which a joint still rolls: there one contact is at its friction limit."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint.rolling_capacity import refuse_no_rolling, rolling_torque_capacity
from asperity.joint.solve import solve
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case


@pytest.fixture(scope="module")
def wedged():
    """A joint whose left ring contact unloads with the torque."""
    return joint_from_case(read_case(Path(__file__).parents[2] / "examples" / "tutorial_joint.toml"))


def test_at_the_capacity_one_contact_is_at_its_limit(wedged):
    solution = solve(wedged)
    capacity = rolling_torque_capacity(wedged, solution)
    assert 8.0 < capacity < 0.95 * float(solution.capacity.output_torque)
    at = solve(dataclasses.replace(wedged, output_torque=capacity * (1 - 1e-9))).result.rolling
    used = np.asarray(at.traction_coefficient) / 0.13
    assert np.argmax(used) == 4
    assert used[4] == pytest.approx(1.0, abs=1e-3)


def test_a_torque_beyond_is_refused_with_the_capacity(wedged):
    capacity = rolling_torque_capacity(wedged, solve(wedged))
    beyond = dataclasses.replace(wedged, output_torque=capacity * 1.001)
    with pytest.raises(NoSolutionError, match=r"the output torque is .*, the joint rolls up to .* N·m"):
        refuse_no_rolling(beyond, solve(beyond), capacity)


def test_the_sun_contact_slips_at_one_torque_at_rest_and_in_rolling(paper_joint):
    """Its force follows from the torque alone: mu N_sp 9 n R_s."""
    joint = paper_joint()
    solution = solve(joint)
    assert rolling_torque_capacity(joint, solution) == pytest.approx(
        float(solution.capacity.output_torque), rel=1e-3
    )
