from pathlib import Path

import pytest

from asperity.joint_file.reader import parse_case

EXAMPLES = Path(__file__).parents[2] / "examples"
EXAMPLE = EXAMPLES / "zou2025.toml"


@pytest.fixture(scope="session")
def example_text() -> str:
    return EXAMPLE.read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def example_case(example_text):
    from asperity.joint_file.reader import parse_case

    return parse_case(example_text, source="zou2025.toml")


@pytest.fixture(scope="session")
def planar_case():
    """DefaultCase of an example with another drive, with replaced pieces of its text."""

    def case(name, *replaced):
        text = (EXAMPLES / f"{name}.toml").read_text(encoding="utf-8")
        for old, new in replaced:
            assert old in text, old
            text = text.replace(old, new)
        return parse_case(text, source="mine.toml")

    return case
