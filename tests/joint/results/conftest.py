"""The paper's joint, solved once, as its rows see it."""

import pytest


@pytest.fixture(scope="session")
def solved(case):
    from asperity.joint.results import SolvedJoint
    from asperity.joint.solve import solve
    from asperity.joint_file.build import joint_from_case

    joint = joint_from_case(case)
    found = solve(joint)
    solved = SolvedJoint(joint, found.result, found.capacity)
    solved.capacity_of_direction = found.capacity  # the torque is positive
    return solved


@pytest.fixture(scope="session")
def value(solved):
    """A result by its name [SI]: a number, or one for each row."""
    import numpy as np

    from asperity.joint.results import RESULTS

    return lambda name: np.asarray(RESULTS[name].of(solved), dtype=float)
