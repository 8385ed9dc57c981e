"""Joints that several of these files look at."""

import pytest


@pytest.fixture(scope="session")
def solved_example(case):
    """The joint of the paper's example file, solved."""
    from asperity.joint_file.solved_document import solved_case

    return solved_case(case)


@pytest.fixture(scope="session")
def solved_paper(paper_joint):
    """The paper's joint and its solution."""
    from asperity.joint.planar.solve import solve_planar

    joint = paper_joint()
    return joint, solve_planar(joint)


@pytest.fixture(scope="session")
def wedged(planar_case):
    """A joint whose left ring contact unloads with the torque."""
    from asperity.joint_file.planar_build import planar_joint_from_case

    return planar_joint_from_case(planar_case("tutorial_joint"))
