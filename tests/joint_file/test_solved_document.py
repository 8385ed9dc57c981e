"""A joint file solved in a script says what the command says, whatever the type of its drive."""

import json
from pathlib import Path

import pytest
from click.testing import CliRunner

from asperity.cli import asperity
from asperity.joint_file.reader import read_any_case
from asperity.joint_file.solved_document import solved_document

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["zou2025", "planetary"])
def test_the_document_is_that_of_the_command(name):
    file = EXAMPLES / f"{name}.toml"
    printed = CliRunner().invoke(asperity, ["joint", str(file), "--json"], catch_exceptions=False).stdout
    assert solved_document(read_any_case(file)) == json.loads(printed)
