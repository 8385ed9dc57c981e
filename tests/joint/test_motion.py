"""Matrices, speeds and angles that a drive knows: those that a program finds, and what comes out of them."""

import jax
import numpy as np
import pytest

from asperity.drive.layout.drive import contact_angles, incidence, speeds
from asperity.engine.arrays import as_numbers
from asperity.joint.description import in_motion


@pytest.mark.parametrize("example", ["planetary", "multiroller", "stepped_planet"])
def test_what_a_drive_knows_is_what_a_program_finds(example, planar_joint):
    joint = as_numbers(planar_joint(example))

    def found(drive):
        return incidence(drive), speeds(drive), contact_angles(drive)

    known = in_motion(joint).drive
    expected = jax.jit(found)(joint.drive)
    for own, other in zip(jax.tree.leaves(found(known)), jax.tree.leaves(expected), strict=True):
        assert isinstance(own, np.ndarray)
        np.testing.assert_allclose(own, other, rtol=1e-12, atol=1e-14)


def test_a_joint_that_knows_it_asks_no_more(planar_joint):
    joint = in_motion(planar_joint("planetary"))
    drive = joint.drive
    assert incidence(drive) is drive.motion[0]
    assert speeds(drive) is drive.motion[1]
    assert contact_angles(drive) is drive.motion[2]
    assert in_motion(joint).drive.motion == drive.motion
