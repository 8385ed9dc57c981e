"""A planar drive that stands under torques: the stiffness of its solution, no loop without slip, the paper's drive."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.either_kind import under_torque
from asperity.joint.planar.solve import solve_planar
from asperity.joint.rolling_onset import rolling_onset
from asperity.joint.windup import windup
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.planar_build import planar_joint_from_case

STAGES = (1.0 / 3.0, 2.0 / 3.0)


@pytest.fixture(scope="module")
def joint(planar_case):
    return planar_joint_from_case(planar_case("planetary"))


def curve_of(joint, torque):
    return windup(joint, largest_torque=torque, level="assembly", stage_shares=STAGES)


@pytest.fixture(scope="module")
def curve(joint):
    return curve_of(joint, 10.0)


def test_the_slope_of_the_curve_is_the_stiffness_of_the_solution_there(joint, curve):
    torque, angle = np.asarray(curve.torque), np.asarray(curve.angle)
    for k in (10, 50, -10):
        found = float(solve_planar(under_torque(joint, torque[k])).result.assembly.stiffness.output)
        assert float(curve.stiffness[k]) == pytest.approx(found, rel=1e-9)
        slope = (angle[k + 1] - angle[k - 1]) / (torque[k + 1] - torque[k - 1])
        assert 1.0 / slope == pytest.approx(found, rel=1e-3)
    assert angle[torque.size // 2] == 0.0


def test_no_slip_no_loop_and_the_same_forces(joint, curve):
    """A millionfold friction: T/(mu N) is below 1e-6, and so is what is left of the loop."""
    sticking = dataclasses.replace(joint, friction_coefficients=(1e6,))
    held = curve_of(sticking, 10.0)
    assert abs(float(held.hysteresis)) < 1e-6 * float(curve.hysteresis)
    assert float(held.dissipated_energy) < 1e-6 * float(curve.dissipated_energy)
    assert float(held.angle[-1]) < float(curve.angle[-1])
    middle = len(curve.torque) // 2
    assert float(held.stiffness[middle]) == pytest.approx(float(curve.stiffness[middle]), rel=1e-9)


def test_the_drift_begins_as_that_of_its_rolling(joint, curve):
    """The torque that drives loses as much as the one that is driven; both contacts by their power."""
    forward, reverse = (solve_planar(under_torque(joint, torque)).result for torque in (10.0, -10.0))
    both = [
        rolling_onset(joint=joint, result=result, windup=curve.angle[-1], creep_share=0.05)
        for result in (forward, reverse)
    ]
    one, other = (onset.contacts for onset in both)
    assert float(one.drift_per_output_turn) == pytest.approx(
        float(forward.rolling.drift_per_output_turn), rel=1e-9
    )
    assert float(other.drift_per_output_turn) == pytest.approx(float(one.drift_per_output_turn), rel=1e-6)
    # equal forces on sun and ring: by their creepages
    creep = np.asarray(forward.rolling.creepage)
    np.testing.assert_allclose(one.share, creep / creep.sum(), rtol=1e-3)
    # the sun turns six times as far; the planet rolls 50 mm of the ring in a radian of the carrier
    assert float(one.sun_angle) == pytest.approx(6.0, rel=1e-2)
    assert float(one.distance[1]) == pytest.approx(50e-3, rel=1e-3)


@pytest.mark.slow
def test_the_papers_drive_agrees_with_its_own_chain(case, as_planar):
    """Its own chain shares the traction equally between both sides of a planet, the general one by the springs."""
    own = joint_from_case(case)
    expected, found = (curve_of(each, 5.0) for each in (own, as_planar(own)))
    np.testing.assert_allclose(found.stiffness, expected.stiffness, rtol=5e-3)
    np.testing.assert_allclose(found.angle, expected.angle, rtol=5e-3, atol=1e-12)
    np.testing.assert_allclose(found.stage_stiffness, expected.stage_stiffness, rtol=5e-3)
    assert float(found.lost_motion) == pytest.approx(float(expected.lost_motion), rel=5e-3)
