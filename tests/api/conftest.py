import json

import pytest

import asperity
from asperity.api.joint import DescribedJoint


@pytest.fixture(scope="session")
def joint(zou_file) -> DescribedJoint:
    return asperity.load(zou_file)


@pytest.fixture(scope="session")
def solution(joint):
    return joint.solve()


@pytest.fixture
def printed(call):
    """The JSON document that a command prints."""

    def document(*arguments):
        told = call(*arguments, "--json")
        assert told.code == 0, told.err
        return json.loads(told.out)

    return document
