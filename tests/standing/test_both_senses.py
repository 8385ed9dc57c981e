"""Stiffness and drift over torques of either sign against joints that are solved one by one."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.solve import solve_joint
from asperity.standing.standing import both_senses

TORQUES = np.array([-6.0, -5.0, 0.0, 3.0, 5.0])


@pytest.fixture(scope="module")
def joint(paper_joint):
    return paper_joint(closure="constant_pin_force")


@pytest.fixture(scope="module")
def found(joint):
    return both_senses(joint=joint, torque=TORQUES)


@pytest.mark.long
def test_points_are_joints_solved_alone(joint, found):
    for index in (1, 4):
        torque = TORQUES[index]
        alone = solve_joint(
            dataclasses.replace(joint, output_torque=np.asarray(torque))
        ).result  # the sun turns forwards
        assert found.published[index] == pytest.approx(float(alone.published.output), rel=1e-10)
        assert found.series_with_bulk[index] == pytest.approx(float(alone.series_with_bulk.output), rel=1e-10)
        assert found.assembly[index] == pytest.approx(float(alone.assembly.stiffness.output), rel=1e-10)
        assert found.slip_ratio[index] == pytest.approx(
            float(np.max(alone.diagnostics.slip_ratio)), rel=1e-10
        )
        drift = (found.driving_drift if torque > 0.0 else found.braking_drift)[index]
        assert drift == pytest.approx(float(alone.rolling.drift_per_output_turn), rel=1e-8)


@pytest.mark.slow
def test_the_output_gives_way_to_the_torque_in_both_senses(found):
    for drift in (found.driving_drift, found.braking_drift):
        np.testing.assert_array_equal(np.sign(drift), np.sign(TORQUES))
    behind, ahead = (np.abs(np.asarray(each)) for each in (found.driving_drift, found.braking_drift))
    loaded = TORQUES != 0.0
    # the same creep, counted over a turn that is longer by it: of second order in the drift
    excess = behind[loaded] / ahead[loaded] - 1.0
    assert np.all((excess > 0.0) & (excess < behind[loaded] / np.pi))


@pytest.mark.slow
def test_two_directions_differ_with_a_constant_pin_force(found):
    assert found.assembly[4] > 1.04 * found.assembly[1]
