"""Joint files of every type of planar drive."""

import pytest

from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.solved_document import solve_case


@pytest.fixture(scope="session")
def planar_joint(planar_case):
    """Joint of an example, with replaced pieces of its text."""
    return lambda name, replaced=None: planar_joint_from_case(planar_case(name, replaced=replaced or {}))


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
