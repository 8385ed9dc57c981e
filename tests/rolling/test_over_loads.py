"""A drive over torques and speeds: its points are those of the joint itself under that load."""

import dataclasses

import numpy as np
import pytest

from asperity.engine.arrays import as_numbers
from asperity.engine.control import at_once
from asperity.joint.evaluation import evaluate
from asperity.rolling.curves import rolling_curves

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def curves(planetary):
    joint, solution, _ = planetary
    capacity = float(solution.rolling_capacity.output_torque)
    return rolling_curves(joint=joint, result=solution.result, laws=solution.laws, torque_capacity=capacity)


@pytest.mark.long
def test_a_load_of_the_curves_and_of_the_map_is_the_joint_under_it(curves, planetary):
    joint, _, _ = planetary
    place, row = 20, 11

    def under(torque, speed):
        there = dataclasses.replace(joint, output_torque=float(torque), input_speed=float(speed))
        numbers = as_numbers(there)
        return at_once(evaluate, numbers).rolling

    there = under(curves.torque[place], joint.input_speed)
    assert float(curves.drift_per_output_turn[place]) == pytest.approx(
        float(there.drift_per_output_turn), rel=1e-9
    )
    assert float(curves.life_hours[place]) == pytest.approx(float(there.life_hours.drive), rel=1e-9)
    assert float(curves.life_turns[place]) == pytest.approx(float(there.life_turns.drive), rel=1e-9)
    other = under(curves.map_torque[place], curves.map_speed[row])
    assert float(curves.efficiency[row, place]) == pytest.approx(float(other.power.efficiency), rel=1e-9)
    assert float(curves.torque[0]) == 0.0
    assert float(curves.drift_per_output_turn[0]) == pytest.approx(0.0, abs=1e-12)
    assert float(curves.map_speed[-1]) == pytest.approx(1.5 * float(joint.input_speed))


def test_working_points_lie_on_the_creep_curves(curves, planetary):
    _, solution, _ = planetary
    rolling = solution.result.rolling
    assert curves.contact_traction.shape == curves.contact_creepage.shape == (2, 60)
    for k in range(2):
        on_curve = np.interp(
            float(rolling.traction_coefficient[k]), curves.contact_traction[k], curves.contact_creepage[k]
        )
        assert float(rolling.creepage[k]) == pytest.approx(on_curve, rel=5e-3)
