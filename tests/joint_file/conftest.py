from pathlib import Path

import pytest

EXAMPLE = Path(__file__).parents[2] / "examples" / "zou2025.toml"


@pytest.fixture(scope="session")
def example_text() -> str:
    return EXAMPLE.read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def example_case(example_text):
    from asperity.joint_file.reader import parse_case

    return parse_case(example_text, source="zou2025.toml")
