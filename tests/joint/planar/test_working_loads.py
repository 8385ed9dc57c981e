"""Loads and speeds in the state in which a planar joint works: nothing is left over, and what stands does not turn."""

import dataclasses

import numpy as np
import pytest

from asperity.joint.planar.working_loads import (
    member_speeds,
    pin_speeds,
    planar_loads_without_torque,
    working_planar_loads,
)


def test_nothing_is_left_over(planetary):
    joint, solution, _ = planetary
    found = working_planar_loads(joint, solution.result)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-6)
    assert float(np.sum(found.moments)) == pytest.approx(0.0, abs=1e-9)


def test_without_torque_a_planet_between_sun_and_ring_leaves_its_pin_alone(planetary):
    joint, solution, _ = planetary
    found = planar_loads_without_torque(joint, solution.result)
    np.testing.assert_allclose(found.pin, 0.0, atol=1e-6)
    np.testing.assert_allclose(found.moments, 0.0, atol=1e-9)


def test_a_joint_that_stands_has_the_pins_of_its_balance_and_no_speeds(planetary):
    joint, solution, _ = planetary
    standing = dataclasses.replace(joint, input_speed=np.float64(0.0))
    found = working_planar_loads(standing, solution.result)
    # the result is that of the turning joint, whose centrifugal force pulls across the push
    np.testing.assert_allclose(np.abs(found.pin), np.abs(solution.result.forces.pins), rtol=1e-9)
    speeds = member_speeds(standing, solution.result)
    np.testing.assert_array_equal(speeds, 0.0)
    np.testing.assert_array_equal(pin_speeds(joint.drive, speeds), 0.0)


def test_a_joint_that_does_not_roll_has_neither_loads_nor_speeds(planetary):
    joint, solution, _ = planetary
    lost = dataclasses.replace(
        solution.result.rolling, residual=np.float64(np.nan), creepage=np.full(2, np.nan)
    )
    result = dataclasses.replace(solution.result, rolling=lost)
    assert np.all(np.isnan(np.asarray(working_planar_loads(joint, result).pin)))
    assert np.isnan(np.asarray(pin_speeds(joint.drive, member_speeds(joint, result)))).all()
