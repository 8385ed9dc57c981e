"""The torque under which a joint still rolls: there one contact is at its friction limit."""

import dataclasses

import numpy as np
import pytest

from asperity.errors import NoSolutionError
from asperity.joint.solve import refuse_no_rolling, solve_joint


@pytest.fixture(scope="module")
def solution(wedged):
    return solve_joint(wedged)


@pytest.mark.slow
def test_at_the_capacity_one_contact_is_at_its_limit(wedged, solution):
    """The left roller's ring contact, whose friction coefficient is 0.13; it slips before the standing joint does."""
    capacity = float(solution.rolling_capacity.output_torque)
    assert 8.0 < capacity < float(solution.standing_capacity.output_torque)
    at = solve_joint(dataclasses.replace(wedged, output_torque=capacity * (1.0 - 1e-9))).result.rolling
    used = np.asarray(at.traction_coefficient) / 0.13
    assert np.argmax(used) == 4
    assert used[4] == pytest.approx(1.0, abs=1e-3)


@pytest.mark.slow
def test_a_torque_beyond_is_refused_with_the_capacity(wedged, solution):
    refuse_no_rolling(wedged, solution)
    capacity = float(solution.rolling_capacity.output_torque)
    beyond = dataclasses.replace(wedged, output_torque=capacity * 1.001)
    with pytest.raises(
        NoSolutionError, match=r"no steady rolling under .*: the joint rolls up to .* N·m, at which"
    ):
        refuse_no_rolling(beyond, solve_joint(beyond))


def test_the_sun_contact_slips_at_one_torque_at_rest_and_in_rolling(solved_paper):
    """Its force follows from the torque alone: mu N_sp 9 n R_s."""
    _, solution = solved_paper
    assert float(solution.rolling_capacity.output_torque) == pytest.approx(
        float(solution.standing_capacity.output_torque), rel=1e-3
    )


@pytest.mark.long
def test_skew_takes_its_share_of_the_friction_at_the_capacity(wedged, solution):
    """At the capacity one contact uses all that skew leaves it, and skew that slips by itself leaves no capacity."""

    def skewed(angle, **changes):
        rolling = dataclasses.replace(wedged.rolling, skew=(np.asarray(angle),))
        return dataclasses.replace(wedged, rolling=rolling, **changes)

    parallel = float(solution.rolling_capacity.output_torque)
    none, half, whole = (
        float(solve_joint(skewed(angle)).rolling_capacity.output_torque) for angle in (0.0, 0.5e-3, 20e-3)
    )
    assert none == pytest.approx(parallel, rel=1e-9)
    assert 0.5 * parallel < half < 0.999 * parallel
    assert whole == 0.0
    at = solve_joint(skewed(0.5e-3, output_torque=half * (1.0 - 1e-9))).result.rolling
    left = (
        float(wedged.friction_coefficients[0]) * np.asarray(at.normal) * (1.0 - np.asarray(at.capacity_loss))
    )
    assert np.max(np.abs(np.asarray(at.tangential)) / left) == pytest.approx(1.0, abs=1e-6)
