"""A joint that turns: the sense of its forces by hand, and rolling at a stated torque and speed."""

import dataclasses

import jax
import numpy as np
import pytest
from machines import laws_and_states

from asperity.drive.layout.drive import driving_sense
from asperity.drive.types.multiroller import two_row_multiroller
from asperity.drive.types.planetary import planetary_drive
from asperity.engine.arrays import as_numbers
from asperity.joint.assembled import Pressed
from asperity.joint.evaluation import evaluate
from asperity.joint.machine import joint_machine
from asperity.rolling.turning import rolling_at


def test_rollers_between_sun_and_ring_turn_against_the_sun():
    """Relative to the carrier each roller turns against its neighbour outside it, and like the ring around it."""
    planetary = planetary_drive(
        sun_radius=np.asarray(10e-3), planet_radius=np.asarray(20e-3), planet_count=np.asarray(3.0)
    )
    np.testing.assert_array_equal(driving_sense(planetary), [1.0, -1.0])
    two_rows = two_row_multiroller(
        sun_radius=np.asarray(12e-3),
        first_row_radii=(np.asarray(14e-3), np.asarray(7e-3)),
        second_row_radii=(np.asarray(21e-3), np.asarray(9.4e-3)),
        roller_count=np.asarray(4.0),
    )
    np.testing.assert_array_equal(driving_sense(two_rows), [1.0, -1.0, -1.0, 1.0])


@pytest.mark.long
def test_rolling_at_another_torque_is_that_of_a_joint_with_this_torque(planar_joint):
    joint = as_numbers(planar_joint("planetary"))

    def both(torque, speed):
        laws, states = laws_and_states(joint)
        rolled = rolling_at(joint_machine(joint), Pressed(laws, states.rest))
        there = dataclasses.replace(joint, output_torque=torque, input_speed=speed)
        return rolled(torque, speed), evaluate(there).rolling

    found, expected = jax.jit(both)(4.0, 50.0)
    for name in ("tangential", "creepage", "speed_loss", "flash_temperature"):
        np.testing.assert_allclose(getattr(found, name), getattr(expected, name), rtol=1e-9)
    assert float(expected.speed_loss) > 0.0
