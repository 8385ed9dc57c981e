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
def printed(monkeypatch, capsys):
    """The JSON document that a command prints."""
    from asperity.cli import main

    def document(*arguments):
        monkeypatch.setattr("sys.argv", ["asperity", *map(str, arguments), "--json"])
        capsys.readouterr()
        with pytest.raises(SystemExit) as ended:
            main()
        told = capsys.readouterr()
        assert ended.value.code == 0, told.err
        return json.loads(told.out)

    return document
