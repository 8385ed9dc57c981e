"""Loads and speeds in the state in which a planar joint works: nothing is left over, and what stands does not turn."""

import dataclasses

import numpy as np
import pytest

from asperity.drive.structure.pin_beam import PinBeam
from asperity.errors import InputError
from asperity.joint.description import body_masses
from asperity.joint.solve import refuse_short_pins
from asperity.joint.working_loads import (
    loads_without_torque,
    member_speeds,
    pin_bending,
    pin_speeds,
    working_loads,
)


@pytest.mark.slow
def test_nothing_is_left_over(planetary):
    joint, solution, _ = planetary
    found = working_loads(joint, solution.result)
    np.testing.assert_allclose(found.unbalanced, 0.0, atol=1e-6)
    assert float(np.sum(found.moments)) == pytest.approx(0.0, abs=1e-9)


def test_without_torque_a_planet_between_sun_and_ring_leaves_its_pin_alone(planetary):
    joint, solution, _ = planetary
    found = loads_without_torque(joint, solution.result)
    np.testing.assert_allclose(found.pin, 0.0, atol=1e-6)
    np.testing.assert_allclose(found.moments, 0.0, atol=1e-9)


def test_a_joint_that_stands_has_the_pins_of_its_balance_and_no_speeds(planetary):
    joint, solution, _ = planetary
    standing = dataclasses.replace(joint, input_speed=np.float64(0.0))
    found = working_loads(standing, solution.result)
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
    assert np.all(np.isnan(np.asarray(working_loads(joint, result).pin)))
    assert np.isnan(np.asarray(pin_speeds(joint.drive, member_speeds(joint, result)))).all()


def with_pin(planar_joint, name, free_length, support):
    joint = planar_joint(name)
    return dataclasses.replace(joint, pin=PinBeam(free_length, support, 6e-3))


def test_bending_of_a_pin_that_one_end_holds(planar_joint):
    """The roller of 10 mm sits in the middle of 16 mm: 8 mm lever; 32 M/(pi d^3)."""
    joint = with_pin(planar_joint, "planetary", 16e-3, "one_end")
    moment, stress = pin_bending(joint, np.array([[-300.0, 120.0]]))
    np.testing.assert_allclose(moment, [[2.4, 0.96]], rtol=1e-12)
    np.testing.assert_allclose(stress, 32.0 * np.asarray(moment) / (np.pi * 6e-3**3), rtol=1e-12)


def test_a_pin_between_two_supports_bends_less_under_a_longer_roller(planar_joint):
    """F (2 l - b)/8: 100 N, 16 mm, rollers of 10 mm and of 14 mm."""
    joint = with_pin(planar_joint, "planetary", 16e-3, "both_ends")
    planet = dataclasses.replace(joint.shapes[1], length=14e-3)
    longer = dataclasses.replace(joint, shapes=(joint.shapes[0], planet, joint.shapes[2]))
    for each, by_hand in ((joint, 0.275), (longer, 0.225)):
        np.testing.assert_allclose(pin_bending(each, np.array([100.0]))[0], [by_hand], rtol=1e-12)
    masses, others = body_masses(longer), body_masses(joint)
    assert float(masses[1]) == pytest.approx(1.4 * float(others[1]), rel=1e-12)
    assert float(masses[0]) == float(others[0])


def test_without_a_pin_there_is_no_bending(planar_joint):
    assert np.all(np.isnan(pin_bending(planar_joint("planetary"), np.array([100.0]))))


def test_a_roller_does_not_overhang_its_pin(planar_joint):
    refuse_short_pins(with_pin(planar_joint, "planetary", 10e-3, "both_ends"))
    with pytest.raises(InputError, match=r"9.9 mm, less than the 10 mm of planet: lengthen the pins"):
        refuse_short_pins(with_pin(planar_joint, "planetary", 9.9e-3, "both_ends"))
