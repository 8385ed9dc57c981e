"""Every type of drive has a model, an example, and as many bodies and contacts in all its tables."""

import pytest

from asperity.drive.types import TYPES
from asperity.joint_file.build import joint_from_case
from asperity.joint_file.case_types import CASES


@pytest.mark.parametrize("kind", CASES)
def test_every_type_has_its_contacts_and_bodies(kind, planar_case):
    case = planar_case(TYPES[kind].example or kind)
    assert type(case) is CASES[kind]
    joint = joint_from_case(case)
    assert joint.type == kind
    assert len(joint.shapes) == len(joint.materials) == len(joint.drive.bodies)
    assert len(joint.pattern) == len(joint.drive.contacts)
