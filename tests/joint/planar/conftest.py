"""Joint files of every type of planar drive."""

from pathlib import Path

import pytest

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
