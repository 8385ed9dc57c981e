"""Curves of the joint that turns: their points are those of the joint itself under that load, and Carter's."""

import dataclasses
import math

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.rolling.curves import rolling_curves

FRICTION = 0.12


@pytest.fixture(scope="module")
def joint(paper_joint):
    """Smooth bodies of a steel that stays elastic, so that they have a life."""
    return paper_joint(fractal_dimension=1.9, fractal_roughness=1e-16, sun_speed=200.0, yield_strength=1.2e9)


@pytest.fixture(scope="module")
def solution(joint):
    return solve_joint(joint)


@pytest.fixture(scope="module")
def curves(joint, solution):
    capacity = float(solution.rolling_capacity.output_torque)
    return rolling_curves(joint=joint, result=solution.result, laws=solution.laws, torque_capacity=capacity)


@pytest.mark.slow
def test_creep_curves_of_smooth_bodies_are_carters(curves, solution):
    """xi = mu a/R (1 - sqrt(1 - q)) with Hertz's a, by hand."""
    normal = np.asarray(solution.result.rolling.normal)
    radius = np.array([4 * 13.5 / 17.5, 13.5 * 5 / 18.5, 13.5 * 5 / 18.5, 5 * 40 / 35, 5 * 40 / 35]) * 1e-3
    width = np.sqrt(4 * normal / 5e-3 * radius / (math.pi * 206e9 / 1.82))
    share = np.asarray(curves.contact_traction) / FRICTION
    carter = (FRICTION * width / radius)[:, None] * (1.0 - np.sqrt(1.0 - share))
    np.testing.assert_allclose(curves.contact_creepage, carter, rtol=1e-2, atol=1e-12)
    assert share[:, 0] == pytest.approx(0.0, abs=1e-12)
    assert np.all(share[:, -1] > 0.95)


@pytest.mark.slow
def test_working_points_lie_on_the_creep_curves(curves, solution):
    rolling = solution.result.rolling
    for k in range(5):
        on_curve = np.interp(
            rolling.traction_coefficient[k], curves.contact_traction[k], curves.contact_creepage[k]
        )
        assert float(rolling.creepage[k]) == pytest.approx(on_curve, rel=5e-3)


@pytest.mark.slow
def test_curves_over_torque_and_the_map_are_the_joint_at_that_load(curves, joint):
    assert curves.torque[0] == 0.0
    assert curves.drift_per_output_turn[0] == pytest.approx(0.0, abs=1e-12)
    assert curves.torque[-1] == pytest.approx(float(curves.torque_capacity))
    np.testing.assert_allclose(curves.map_speed, 200.0 * 1.5 * np.arange(1, 18) / 17, rtol=1e-12)
    place = 20
    torque, speed = float(curves.map_torque[place]), float(curves.map_speed[3])
    assert torque == curves.torque[place + 1]
    own = solve_joint(dataclasses.replace(joint, output_torque=torque)).result.rolling
    assert curves.drift_per_output_turn[place + 1] == pytest.approx(
        float(own.drift_per_output_turn), rel=1e-9
    )
    assert curves.life_turns[place + 1] == pytest.approx(float(own.life_turns.drive), rel=1e-9)
    assert curves.life_hours[place + 1] == pytest.approx(float(own.life_hours.drive), rel=1e-9)
    there = solve_joint(dataclasses.replace(joint, output_torque=torque, input_speed=speed)).result.rolling
    assert curves.efficiency[3, place] == pytest.approx(float(there.power.efficiency), rel=1e-9)


@pytest.mark.slow
def test_a_standing_sun_has_no_map_and_no_hours(joint):
    standing = dataclasses.replace(joint, input_speed=0.0)
    solved = solve_joint(standing)
    found = rolling_curves(joint=standing, result=solved.result, laws=solved.laws, torque_capacity=math.inf)
    assert found.map_speed.size == found.efficiency.size == 0
    assert np.all(np.isnan(found.life_hours))
    assert np.all(np.isfinite(found.life_turns[:20]))
    assert found.torque[-1] == 10.0  # no capacity: to twice the torque
