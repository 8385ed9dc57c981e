"""The joint of the paper as a file, and its parsed case."""

from pathlib import Path

import pytest

from asperity.case.reader import parse_case

FILE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


@pytest.fixture(scope="session")
def zou_file() -> Path:
    return FILE


@pytest.fixture(scope="session")
def joint_text():
    return FILE.read_text()


@pytest.fixture(scope="session")
def case(joint_text):
    return parse_case(joint_text, source="zou2025.toml")
