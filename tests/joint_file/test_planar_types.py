"""Every type of drive has a model, an example, and as many bodies and contacts in all its tables."""

import pytest

from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.planar_types import PLANAR_CASES


@pytest.mark.parametrize("kind", PLANAR_CASES)
def test_every_type_has_its_contacts_and_bodies(kind, planar_case):
    case = planar_case(kind)
    assert type(case) is PLANAR_CASES[kind]
    joint = planar_joint_from_case(case)
    assert joint.type == kind
    assert len(joint.shapes) == len(joint.materials) == len(joint.drive.bodies)
    assert len(joint.pattern) == len(joint.drive.contacts)
