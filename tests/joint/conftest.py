"""Joints that several of these files look at."""

import pytest

from asperity.joint_file.build import joint_from_case
from asperity.joint_file.solved_document import solve_case


@pytest.fixture(scope="session")
def solved_example(case):
    """The joint of the paper's example file, solved."""
    from asperity.joint_file.solved_document import solved_case

    return solved_case(case)


@pytest.fixture(scope="session")
def solved_paper(paper_joint):
    """The paper's joint and its solution."""
    from asperity.joint.solve import solve_joint

    joint = paper_joint()
    return joint, solve_joint(joint)


@pytest.fixture(scope="session")
def wedged(planar_case):
    """A joint whose left ring contact unloads with the torque, its loading rollers as in the paper's closure."""
    from asperity.joint_file.build import joint_from_case

    split = {"[model]\n": '[model]\ntraction_split = "equal_coefficients"\n'}
    return joint_from_case(planar_case("tutorial_joint", replaced=split))


@pytest.fixture(scope="session")
def planar_joint(planar_case):
    """Joint of an example, with replaced pieces of its text."""
    return lambda name, replaced=None: joint_from_case(planar_case(name, replaced=replaced or {}))


@pytest.fixture(scope="session")
def planetary(planar_case):
    """The planetary example: joint, solution and document."""
    solved, document = solve_case(planar_case("planetary"))
    return solved.joint, solved.solution, document


@pytest.fixture(scope="session")
def skewed_planetary(planar_case):
    """The planetary example with springs as bodies and skewed axes: joint, solution and document."""
    replaced = {
        'bodies = "exact"': 'bodies = "springs"',
        'ring_support = "free"': 'ring_support = "rigid_housing"',
        "[lubrication]": '[rolling]\nskew = { sp = "0.5 mrad", pr = "-0.8 mrad" }\n\n[lubrication]',
    }
    solved, document = solve_case(planar_case("planetary", replaced=replaced))
    return solved.joint, solved.solution, document
