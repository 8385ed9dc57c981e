"""A joint that stands under given torques, and the same joint without slip."""

import numpy as np
import pytest

from asperity.joint.evaluation import evaluate
from asperity.standing.standing import NO_SLIP_FRICTION, standing_at


def test_with_the_friction_of_no_slip_there_is_none():
    assert 1.0 - 1e6 / (NO_SLIP_FRICTION * 1.0) == 1.0


@pytest.mark.long
def test_own_and_without_slip_are_those_of_single_joints(paper_joint):
    """Equal traction coefficients share the torque alike, whatever the friction: the forces are the same."""
    torques = np.array([-3.0, 4.0])
    found = standing_at(paper_joint(), torques)
    for k, torque in enumerate(torques):
        own, without = (
            evaluate(paper_joint(output_torque=torque, **friction))
            for friction in ({}, {"friction_coefficient": NO_SLIP_FRICTION})
        )
        for levels, alone in ((found.levels, own), (found.levels_without_slip, without)):
            expected = float(alone.assembly.stiffness.output)
            np.testing.assert_allclose(levels["assembly"][k], expected, rtol=1e-9)
        assert found.levels["assembly"][k] < found.levels_without_slip["assembly"][k]
    assert found.solved.all()
    assert found.slip_ratio.shape == (5, 2)
