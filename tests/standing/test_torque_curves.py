"""Curves over torque against joints that are solved one by one."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.joint_file.build import joint_from_case
from asperity.standing.standing import torque_curves


@pytest.mark.slow
def test_points_are_joints_solved_alone(paper_joint):
    joint = paper_joint(yield_strength=1.2e9)  # a steel that stays elastic, so that there is a life
    capacity = float(solve_joint(joint).standing_capacity.output_torque)
    found = torque_curves(joint=joint, torque_capacity=capacity)
    assert found.torque[-1] == capacity
    for index in (10, 30):
        alone = solve_joint(dataclasses.replace(joint, output_torque=np.asarray(found.torque)[index])).result
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


@pytest.mark.slow
def test_ends_of_the_axis(paper_joint):
    backwards = torque_curves(joint=paper_joint(output_torque=-2.0), torque_capacity=10.0)
    assert backwards.torque[0] == 0.0
    assert backwards.torque[-1] == -10.0
    unlimited = torque_curves(joint=paper_joint(output_torque=2.0), torque_capacity=np.inf)
    assert unlimited.torque[-1] == 4.0
    without = torque_curves(joint=paper_joint(output_torque=0.0), torque_capacity=np.nan)
    assert without.torque[-1] == 1.0


@pytest.mark.slow
def test_no_stiffness_where_a_contact_slips(paper_joint):
    beyond = torque_curves(joint=paper_joint(), torque_capacity=20.0)  # slips at 13 N·m
    slips = np.isnan(beyond.slip_ratio)
    assert beyond.torque[slips].min() == pytest.approx(
        13.2, abs=0.2
    )  # 27 R_s mu N, and a little for the wedge
    np.testing.assert_array_equal(np.isnan(beyond.assembly), slips)


@pytest.mark.parametrize("way", [1.0, -1.0])
def test_columns_of_another_drive_are_those_of_its_own_sense(planar_case, monkeypatch, way):
    """A negative torque on a drive that turns forwards is one against which it rolls; nan beyond its balance."""
    asked = []

    def made_up(joint, torques, *, no_slip_friction):
        size = np.abs(np.asarray(torques))
        asked.append(np.asarray(torques))
        two = np.stack([100.0 - size, 200.0 - size], axis=1)
        shown = dict.fromkeys(("efficiency", "total_loss", "life_hours", "life_turns"), size)
        return SimpleNamespace(
            solved=size <= 7.5,
            slip_ratio=np.stack([0.05 * size, 0.1 * size], axis=1),
            published=two,
            series_with_bulk=2.0 * two,
            assembly=3.0 * two,
            drift=np.stack([size, -size], axis=1),
            **shown,
        )

    monkeypatch.setattr("asperity.standing.standing.over_torque", made_up)
    joint = dataclasses.replace(joint_from_case(planar_case("planetary")), output_torque=4.0 * way)
    found = torque_curves(joint=joint, torque_capacity=10.0)
    size = np.abs(asked[0])
    np.testing.assert_array_equal(found.torque, asked[0])
    assert found.torque[-1] == 10.0 * way
    # steps fall linearly to the capacity: three quarters of it in the first half of the points
    assert size[24] == pytest.approx(7.5, rel=1e-12)
    np.testing.assert_allclose(found.drift_per_output_turn, way * size)
    np.testing.assert_allclose(found.assembly, np.where(size <= 7.5, 3.0 * (100.0 - size), np.nan))
    np.testing.assert_allclose(found.published, np.where(size <= 7.5, 100.0 - size, np.nan))
    np.testing.assert_allclose(found.slip_ratio, np.where(size <= 7.5, 0.1 * size, np.nan))
