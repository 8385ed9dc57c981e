"""Joints that several of these files look at."""

import pytest


@pytest.fixture(scope="session")
def wedged(zou_file):
    """A joint whose left ring contact unloads with the torque."""
    from asperity.joint_file.build import joint_from_case
    from asperity.joint_file.reader import read_case

    return joint_from_case(read_case(zou_file.with_name("tutorial_joint.toml")))
