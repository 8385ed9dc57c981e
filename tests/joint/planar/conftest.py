"""Joint files of every type of planar drive."""

from pathlib import Path

import pytest

from asperity.cli.solved_case import solved_planar
from asperity.joint_file.planar_build import planar_joint_from_case
from asperity.joint_file.reader import parse_any_case

EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.fixture(scope="session")
def planar_case():
    """Case of an example, with replaced pieces of its text."""

    def case(name, **changes):
        text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
        for old, new in changes.get("replaced", {}).items():
            assert old in text, old
            text = text.replace(old, new)
        return parse_any_case(text, source=f"{name}.toml")

    return case


@pytest.fixture(scope="session")
def planar_joint(planar_case):
    """Joint of an example, with replaced pieces of its text."""
    return lambda name, replaced=None: planar_joint_from_case(planar_case(name, replaced=replaced or {}))


@pytest.fixture(scope="session")
def planetary(planar_case):
    """The planetary example: joint, solution and document."""
    return solved_planar(planar_case("planetary"))
