"""One joint that is to roll: its capacity by extrapolation, and the refusal beyond it."""

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


@pytest.mark.slow
def test_the_sun_contact_slips_at_one_torque_at_rest_and_in_rolling(paper_joint):
    """Its force follows from the torque alone: mu N_sp 9 n R_s."""
    joint = paper_joint()
    solution = solve(joint)
    assert rolling_capacity_of(joint, solution, direction=1.0) == pytest.approx(
        float(solution.capacity.output_torque), rel=1e-3
    )


@pytest.mark.parametrize("missing", [0.0, 1e-9, 1e-7, 1e-4, 0.04, 0.3, 0.6])
@pytest.mark.parametrize(
    "curve", [lambda x: x, lambda x: x**3, np.sqrt, lambda x: max(0.9 * x, 1.0 + 4.0 * (x - 1.0))]
)
def test_the_end_is_where_the_slip_ratio_reaches_1_and_found_with_few_joints(curve, missing):
    """Slip ratios that grow evenly, late, early, or of another contact near the end; beyond it there is none."""
    asked, end = [], 10.0 * (1.0 - missing)

    def slip(torque):
        asked.append(torque)
        return curve(torque / end) if torque <= end else np.nan

    found = _largest(slip, 10.0)
    assert found == pytest.approx(end, abs=2e-8)
    assert found <= end
    assert len(asked) <= (1 if missing == 0.0 else 16)


@pytest.mark.parametrize("missing", [0.0, 1e-9, 1e-7, 1e-4, 0.04, 0.3, 0.6])
@pytest.mark.parametrize("share", [1e-3, 0.3, 0.99])
@pytest.mark.parametrize(
    "curve", [lambda x: x, lambda x: x**1.2, lambda x: x**0.8, lambda x: max(0.9 * x, 1.0 + 4.0 * (x - 1.0))]
)
def test_a_state_that_is_known_saves_joints(curve, share, missing):
    """At most three more than without it, where it tells nothing of the end."""
    asked, end = [], 10.0 * (1.0 - missing)

    def slip(torque):
        asked.append(torque)
        return curve(torque / end) if torque <= end else np.nan

    torque = share * end
    found = _largest(slip, 10.0, (torque, curve(share)))
    assert found == pytest.approx(end, abs=2e-8)
    assert found <= end
    with_it = len(asked)
    assert torque < min(asked)
    asked.clear()
    _largest(slip, 10.0)
    assert with_it <= len(asked) + 3


def test_a_line_through_the_known_state_ends_at_once():
    asked = []

    def slip(torque):
        asked.append(torque)
        return torque / 8.0 if torque <= 8.0 else np.nan

    assert _largest(slip, 10.0, (4.0, 0.5)) == pytest.approx(8.0, abs=1e-8)
    assert len(asked) == 2
    asked.clear()
    assert _largest(slip, 7.0, (4.0, 0.5)) == pytest.approx(7.0, abs=1e-8)
    assert len(asked) == 1


def test_an_end_without_a_warning_is_found_by_halving():
    """Where the balance ends while no contact slips."""
    for ratio in (0.0, 0.5, -1.0):
        for end in (4.321, 0.002):
            found = _largest(lambda torque, r=ratio, e=end: r if torque <= e else np.nan, 10.0)
            assert found == pytest.approx(end, abs=1e-8)
    growing = _largest(lambda torque: 0.05 * torque if torque <= 6.0 else np.nan, 10.0)  # a line says 20
    assert growing == pytest.approx(6.0, abs=1e-8)
    assert _largest(lambda torque: 0.9, 10.0) == pytest.approx(10.0, abs=1e-8)
    assert _largest(lambda torque: np.nan, 10.0) == pytest.approx(0.0, abs=1e-8)
    assert _largest(lambda torque: 1.0, 10.0) == pytest.approx(0.0, abs=1e-8)
    assert _largest(lambda torque: 0.9, np.inf) == np.inf
    assert np.isnan(_largest(lambda torque: 0.9, np.nan))
