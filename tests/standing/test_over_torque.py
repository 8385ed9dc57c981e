"""A drive that stands under torques: the stiffness of its solution, no loop without slip."""

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from asperity.joint.bodies import joint_inertias
from asperity.joint.machine import joint_machine
from asperity.joint.play import Play
from asperity.joint.solve import solve_joint
from asperity.rolling.onset import rolling_onset
from asperity.standing.dynamics import Inertias, dynamics
from asperity.standing.over_torque import _standing
from asperity.standing.standing import both_senses
from asperity.standing.windup import windup

STAGES = (1.0 / 3.0, 2.0 / 3.0)


def under_torque(joint, torque):
    return dataclasses.replace(joint, output_torque=torque)


@pytest.fixture(scope="module")
def joint(planar_joint):
    return planar_joint("planetary")


def curve_of(joint, torque):
    return windup(joint, largest_torque=torque, level="assembly", stage_shares=STAGES)


@pytest.fixture(scope="module")
def curve(joint):
    return curve_of(joint, 10.0)


@pytest.mark.slow
def test_the_slope_of_the_curve_is_the_stiffness_of_the_solution_there(joint, curve):
    torque, angle = np.asarray(curve.torque), np.asarray(curve.angle)
    for k in (10, 50, -10):
        found = float(solve_joint(under_torque(joint, torque[k])).result.assembly.stiffness.output)
        assert float(curve.stiffness[k]) == pytest.approx(found, rel=1e-9)
        slope = (angle[k + 1] - angle[k - 1]) / (torque[k + 1] - torque[k - 1])
        assert 1.0 / slope == pytest.approx(found, rel=1e-3)
    assert angle[torque.size // 2] == 0.0


@pytest.mark.slow
def test_no_slip_no_loop_and_the_same_forces(joint, curve):
    """A millionfold friction: T/(mu N) is below 1e-6, and so is what is left of the loop."""
    sticking = dataclasses.replace(joint, friction_coefficients=(1e6,))
    held = curve_of(sticking, 10.0)
    assert abs(float(held.hysteresis)) < 1e-6 * float(curve.hysteresis)
    assert float(held.dissipated_energy) < 1e-6 * float(curve.dissipated_energy)
    assert float(held.angle[-1]) < float(curve.angle[-1])
    middle = len(curve.torque) // 2
    assert float(held.stiffness[middle]) == pytest.approx(float(curve.stiffness[middle]), rel=1e-9)


@pytest.mark.slow
def test_play_at_once_is_its_angle_in_every_curve(joint, curve):
    """Half of it on either side of zero torque: all of it in the lost motion, nothing in the loop's work."""
    loose = curve_of(dataclasses.replace(joint, play=Play(angle=1e-4, take_up_torque=0.0)), 10.0)
    torque = np.asarray(curve.torque)
    np.testing.assert_allclose(loose.angle - curve.angle, 0.5e-4 * np.sign(torque), atol=1e-15)
    assert float(loose.lost_motion - curve.lost_motion) == pytest.approx(1e-4, rel=1e-9)
    assert float(loose.dissipated_energy) == pytest.approx(float(curve.dissipated_energy), rel=1e-9)


@pytest.mark.slow
def test_the_drift_begins_as_that_of_its_rolling(joint, curve):
    """Of a torque that drives and of one that is driven; both contacts by their power."""
    forward, reverse = (solve_joint(under_torque(joint, torque)).result for torque in (10.0, -10.0))
    both = [
        rolling_onset(joint=joint, result=result, windup=curve.angle[-1], creep_share=0.05)
        for result in (forward, reverse)
    ]
    one, other = (onset.contacts for onset in both)
    assert float(one.drift_per_output_turn) == pytest.approx(
        float(forward.rolling.drift_per_output_turn), rel=1e-9
    )
    # of a turn with and of one without creep
    assert abs(float(other.drift_per_output_turn)) == pytest.approx(
        abs(float(reverse.rolling.drift_per_output_turn)), rel=1e-3
    )
    # both contacts roll the same way over the planet: by the power of their creep, with the oil's drag in the forces
    power = np.abs(np.asarray(forward.rolling.tangential) * np.asarray(forward.rolling.creepage))
    np.testing.assert_allclose(one.share, power / power.sum(), rtol=1e-3)
    # the sun turns six times as far; the planet rolls 50 mm of the ring in a radian of the carrier
    assert float(one.input_angle) == pytest.approx(6.0, rel=1e-2)
    assert float(one.distance[1]) == pytest.approx(50e-3, rel=1e-3)


@pytest.mark.long
def test_creep_damps_as_the_slope_of_the_lost_speed(joint):
    found = dynamics(joint, Inertias(2e-5, 0.05, 0.0))
    at, torques = found.at_torque, np.array([9.995, 10.005])
    assert float(at.stiffness) == pytest.approx(
        float(solve_joint(joint).result.assembly.stiffness.output), rel=1e-9
    )
    output_speed = 1500.0 * np.pi / 30.0 / 6.0
    lost = [
        float(solve_joint(under_torque(joint, torque)).result.rolling.speed_loss) * output_speed
        for torque in torques
    ]
    assert float(at.creep_damping) == pytest.approx(np.diff(torques)[0] / np.diff(lost)[0], rel=1e-5)
    sun, *_ = joint_inertias(joint)
    assert float(at.input_inertia) == pytest.approx(36.0 * (2e-5 + float(sun)), rel=1e-9)


@pytest.mark.long
def test_both_senses_of_rotation(joint):
    """The drift has the sign of the torque; the oil adds to it where the drive drives, and takes where it brakes."""
    found = both_senses(joint=joint, torque=np.array([-10.0, 10.0]))
    drift = float(solve_joint(joint).result.rolling.drift_per_output_turn)
    np.testing.assert_allclose(found.driving_drift, [-drift, drift], rtol=1e-6)
    braking = float(solve_joint(under_torque(joint, -10.0)).result.rolling.drift_per_output_turn)
    np.testing.assert_allclose(found.braking_drift, [braking, -braking], rtol=1e-6)
    assert 0.9 * drift < abs(braking) < drift


def test_a_contact_that_slides_uses_all_its_friction(joint, monkeypatch):
    """mu = 0.08: 120 of 240 N, and 1 where a contact slides; without slip no contact slides."""

    def stiffness(machine, normal, tangential, slides, pins):
        level = SimpleNamespace(output=abs(slides).sum() + machine.contacts.pairs.friction_coefficient[0])
        return SimpleNamespace(
            published=level, series_with_bulk=level, assembly=SimpleNamespace(stiffness=level)
        )

    monkeypatch.setattr("asperity.standing.over_torque.loaded_stiffness", stiffness)
    rest = SimpleNamespace(normal=np.array([3000.0, 3000.0]))
    for worst, residual, balanced, solved in (
        (1e-12, np.inf, True, False),
        (1e-12, 1e-12, True, True),
        (1.0, 1.0, False, False),
    ):
        state = SimpleNamespace(
            normal=np.array([3000.0, 3000.0]),
            tangential=np.array([-120.0, 239.0]),
            slides=np.array([0.0, 1.0]),
            pin_force=np.zeros(0),
            worst=np.array(worst),
            residual=np.array(residual),
        )
        found = _standing(joint_machine(joint), 1e30, state, rest, None)
        np.testing.assert_allclose(found.slip_ratio, [0.5, 1.0], rtol=1e-12)
        np.testing.assert_allclose(found.assembly, [1.08, 1e30], rtol=1e-12)
        assert (bool(found.balanced), bool(found.solved)) == (balanced, solved)
