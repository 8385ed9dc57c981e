"""Curves over torque against joints that are solved one by one."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.solve import solve
from asperity.joint.torque_curves import torque_curves


def test_points_are_joints_solved_alone(paper_joint):
    joint = paper_joint()
    capacity = float(solve(joint).capacity.output_torque)
    found = torque_curves(joint=joint, torque_capacity=capacity)
    assert found.torque[-1] == capacity
    for index in (10, 30):
        alone = solve(dataclasses.replace(joint, output_torque=np.asarray(found.torque)[index])).result
        assert found.published[index] == pytest.approx(float(alone.published.output), rel=1e-10)
        assert found.series_with_bulk[index] == pytest.approx(float(alone.series_with_bulk.output), rel=1e-10)
        assert found.assembly[index] == pytest.approx(float(alone.assembly.stiffness.output), rel=1e-10)
        drift = float(alone.rolling.drift_per_output_turn)
        assert found.drift_per_output_turn[index] == pytest.approx(drift, rel=1e-8)
        assert found.efficiency[index] == pytest.approx(float(alone.rolling.power.efficiency), rel=1e-10)
        assert found.total_loss[index] == pytest.approx(
            float(alone.rolling.power.loss), rel=1e-9, nan_ok=True
        )
        assert found.life_turns[index] == pytest.approx(float(alone.rolling.life_turns.drive), rel=1e-9)
        assert found.life_hours[index] == pytest.approx(
            float(alone.rolling.life_hours.drive), rel=1e-9, nan_ok=True
        )
        slip = float(np.max(alone.diagnostics.slip_ratio))
        assert found.slip_ratio[index] == pytest.approx(slip, rel=1e-10)


def test_ends_of_the_axis(paper_joint):
    backwards = torque_curves(joint=paper_joint(output_torque=-2.0), torque_capacity=10.0)
    assert backwards.torque[0] == 0.0
    assert backwards.torque[-1] == -10.0
    unlimited = torque_curves(joint=paper_joint(output_torque=2.0), torque_capacity=np.inf)
    assert unlimited.torque[-1] == 4.0
    without = torque_curves(joint=paper_joint(output_torque=0.0), torque_capacity=np.nan)
    assert without.torque[-1] == 1.0


def test_no_stiffness_where_a_contact_slips(paper_joint):
    beyond = torque_curves(joint=paper_joint(), torque_capacity=20.0)  # slips at 13 N·m
    slips = np.asarray(beyond.slip_ratio) >= 1.0
    assert slips.any()
    assert np.isnan(np.asarray(beyond.assembly)[slips]).all()
    assert np.isfinite(np.asarray(beyond.assembly)[~slips]).all()
