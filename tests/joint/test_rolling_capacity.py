"""The torque under which a joint still rolls: there one contact is at its friction limit."""

import dataclasses
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from asperity.drive.mechanism import Bearings
from asperity.errors import NoSolutionError
from asperity.joint.rolling_capacity import rolling_torque_capacity
from asperity.joint.rolling_refusal import refuse_no_rolling, rolling_capacity_of
from asperity.joint.solve import solve
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.reader import read_case


@pytest.fixture(scope="module")
def wedged():
    """A joint whose left ring contact unloads with the torque."""
    return joint_from_case(read_case(Path(__file__).parents[2] / "examples" / "tutorial_joint.toml"))


def test_at_the_capacity_one_contact_is_at_its_limit(wedged):
    solution = solve(wedged)
    capacity = rolling_capacity_of(wedged, solution, direction=1.0)
    assert 8.0 < capacity < 0.95 * float(solution.capacity.output_torque)
    at = solve(dataclasses.replace(wedged, output_torque=capacity * (1 - 1e-9))).result.rolling
    used = np.asarray(at.traction_coefficient) / 0.13
    assert np.argmax(used) == 4
    assert used[4] == pytest.approx(1.0, abs=1e-3)


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


@pytest.mark.slow
def test_root_search_and_halving_find_the_same_torque_in_either_direction(wedged):
    """Two ways: a search on the slip ratio with derivatives, and halving with the whole joint solved each time."""
    bearings = Bearings(*map(np.asarray, (0.002, 0.001, 0.01, 0.01, 2e-3)))
    joint = dataclasses.replace(wedged, bearings=bearings, sun_speed=np.asarray(100.0))
    direction = jnp.array([1.0, 1.0, 1.0, -1.0])

    def total(preload):
        found = rolling_torque_capacity(dataclasses.replace(joint, preload=preload), direction=direction)
        return jnp.sum(found), found

    slopes, found = jax.jit(jax.grad(total, has_aux=True))(jnp.array([999.0, 1000.0, 1001.0, 1000.0]))
    assert float(slopes[1]) == pytest.approx(float(found[2] - found[0]) / 2.0, rel=1e-6)
    for value, torque in zip(found[jnp.array([1, 3])], (8.0, -8.0), strict=True):
        loaded = dataclasses.replace(joint, output_torque=torque)
        assert float(value) == pytest.approx(
            rolling_capacity_of(loaded, solve(loaded), direction=np.sign(torque)), rel=1e-8
        )
    assert float(found[1]) != pytest.approx(float(found[3]), rel=1e-3)
