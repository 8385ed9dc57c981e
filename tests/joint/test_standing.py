"""A joint that stands under given torques, and the same joint without slip."""

import jax.numpy as jnp
import numpy as np

from asperity.joint.standing import NO_SLIP_FRICTION, at_standstill, without_slip


def test_bearings_resist_the_motion_that_each_torque_begins(paper_joint):
    joint = paper_joint(sun_speed=-100.0)
    batch = at_standstill(joint, jnp.array([-3.0, 0.0, 4.0]))
    np.testing.assert_array_equal(batch.output_torque, [-3.0, 0.0, 4.0])
    np.testing.assert_array_equal(batch.sun_speed, [-100.0, 100.0, 100.0])


def test_without_slip_only_friction_changes(paper_joint):
    joint = paper_joint()
    changed = without_slip(joint)
    assert {float(friction) for friction in changed.friction_coefficients} == {NO_SLIP_FRICTION}
    assert changed.geometry is joint.geometry
    # 1 - T/(mu N) is exactly 1: no slip at all
    assert 1.0 - 1e6 / (NO_SLIP_FRICTION * 1.0) == 1.0
