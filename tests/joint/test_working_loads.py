"""Loads in the state in which the joint works: rolling where it turns, at rest where it stands."""

import dataclasses
from types import SimpleNamespace

import jax
import numpy as np
import pytest
from asperity.joint.working_loads import bearing_speeds, loads_at_rest, working_loads

from asperity.joint.planar.solve import solve_planar
from asperity.joint_file.planar_build import planar_joint_from_case


@pytest.fixture(scope="module")
def joint(case):
    return jax.tree.map(np.float64, planar_joint_from_case(case))


@pytest.fixture(scope="module")
def result(joint):
    return solve_planar(joint).result


def test_a_turning_joint_has_the_forces_of_rolling(joint, result):
    """Smooth bodies with Carter's creep have T = 25.4224 and 20.8739 N; the asperities shift them a little."""
    loads = working_loads(joint, result)
    sin_b, cos_b = np.sin(float(result.angles.wedge)), np.cos(float(result.angles.wedge))
    right = 657.80 * sin_b - 25.4224 * (cos_b + 1.0)
    left = 464.95 * sin_b + 20.8739 * (cos_b + 1.0)
    assert np.asarray(loads.pin_tangential) == pytest.approx([-right, left], rel=2.5e-2)
    standing = [abs(float(result.forces.pin_right)), float(result.forces.pin_left)]
    assert np.all(np.abs(np.asarray(loads.pin_resultant) / standing - 1.0) > 5e-3)
    assert float(loads.carrier_torque) == pytest.approx(5.0, rel=1e-9)
    assert float(loads.housing_torque) == pytest.approx(5.0 + 5.0 / 9.0, rel=1e-9)


def test_a_standing_joint_has_the_forces_of_the_balance(joint, result):
    loads = working_loads(dataclasses.replace(joint, input_speed=np.float64(0.0)), result)
    expected = [abs(float(result.forces.pin_right)), float(result.forces.pin_left)]
    assert np.asarray(loads.pin_resultant) == pytest.approx(expected, rel=1e-9)


def test_a_slipping_joint_has_none(joint, result):
    slips = dataclasses.replace(
        result,
        diagnostics=SimpleNamespace(slip_ratio=np.array([0.5, 1.2, 0.5, 0.5, 0.5])),
    )
    standing = dataclasses.replace(joint, input_speed=np.float64(0.0))
    assert np.all(np.isnan(np.asarray(working_loads(standing, slips).pin_tangential)))


def test_the_preload_alone_pushes_both_pins_alike(joint):
    """N_pw = N_0/(2 cos theta) = 561.5 N, of which sin beta stays on the pin; the paper's angles."""
    loads = loads_at_rest(joint)
    pin = 1000.0 / (2.0 * np.cos(np.radians(27.0831))) * np.sin(np.radians(13.1582))
    assert np.asarray(loads.pin_tangential) == pytest.approx([-pin, pin], rel=1e-5)
    assert float(loads.carrier_torque) == pytest.approx(0.0, abs=1e-12)
    assert (float(loads.sun_torque), float(loads.housing_torque)) == (0.0, 0.0)


def test_speeds_of_the_bearings(joint, result):
    """Relative to the carrier the rollers turn (R_s/R_w)(1 + 1/9) times the sun's speed, less creep."""
    speeds = bearing_speeds(joint, result)
    sun = 6000.0 * np.pi / 30.0
    loss = float(result.rolling.speed_loss)
    assert float(speeds.sun) == pytest.approx(sun)
    assert float(speeds.carrier) == pytest.approx(sun / 9.0 * (1.0 - loss), rel=1e-12)
    assert np.asarray(speeds.pin) == pytest.approx(np.full(2, sun * 4.0 / 5.0 * (1.0 + 1.0 / 9.0)), rel=3e-3)
    still = bearing_speeds(dataclasses.replace(joint, input_speed=np.float64(0.0)), result)
    assert [float(value) for value in (*still.pin, still.sun, still.carrier)] == [0.0] * 4
